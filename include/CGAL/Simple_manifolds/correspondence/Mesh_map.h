// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_MAP_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_MAP_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Mesh_elements.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The map of a mesh: a `Manifold_map`, which takes the descriptors of the mesh beside positions. What
/// `map_to_sphere()` and the others return for a mesh.
///
/// It keeps the descriptors, not the mesh: it may be asked when the mesh has moved or is gone. But it knows them
/// only as they were when it was made; descriptors of elements that were added or renumbered later mean nothing to
/// it.
///
/// \tparam FaceListGraph  the type of the mesh; its descriptors are no integers
/// \tparam Atlas_  a model of `ManifoldAtlas`
/// \cgalModels{ManifoldMap}
template <class FaceListGraph, class Atlas_>
class Mesh_map : public Manifold_map<Atlas_> {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);

  using Graph_traits = boost::graph_traits<FaceListGraph>;

public:
  /// The same map without the mesh. Functions that take any map are instantiated for this type.
  using Map_on_arrays = Manifold_map<Atlas_>;
  using Domain_point = typename Map_on_arrays::Domain_point; ///< a point of the canonical surface
  using Location = typename Map_on_arrays::Location;         ///< a triangle with barycentric coordinates
  using vertex_descriptor = typename Graph_traits::vertex_descriptor; ///< of the mesh
  using face_descriptor = typename Graph_traits::face_descriptor;     ///< of the mesh

  /// A point of the mesh, which knows the mesh's face. Where that is a triangle that was not split, the barycentric
  /// coordinates are those of its corners in the order of `vertices_around_face(halfedge(face, mesh), mesh)`;
  /// else they are of the triangle `face` of the map.
  struct Mesh_location : Location {
    face_descriptor mesh_face = Graph_traits::null_face(); ///< the face of the mesh; the null face if virtual
    bool is_virtual = false; ///< whether it lies where a border was closed, outside of the mesh
  };

  static_assert(!std::is_integral_v<vertex_descriptor> && !std::is_integral_v<face_descriptor>,
                "a Mesh_map could not tell descriptors that are integers from positions");

  /// A map of this mesh that was made elsewhere, for example read from a file.
  /// \throw Topology_error  `element_not_mapped`: the map has vertices or faces that the mesh has not
  Mesh_map(const FaceListGraph& mesh, Map_on_arrays map)
    : Mesh_map(std::move(map), std::make_shared<const internal::Mesh_elements<FaceListGraph>>(mesh))
  {
    require_same_mesh();
  }

  /// Another map of the same mesh: moved or refined.
  /// \pre its `input_indices()` come from those of this map
  Mesh_map with(Map_on_arrays map) const { return Mesh_map(std::move(map), elements_); }

  /// \name Descriptors and positions
  /// @{

  /// The position of a vertex in the arrays of the map.
  /// \throw Topology_error  `element_not_mapped`: the vertex is of no face, or of another mesh or component
  std::size_t index(vertex_descriptor v) const
  {
    const int i = position_of_input(elements_->vertex.find(v));
    if (i == -1)
      throw Topology_error(Error_code::element_not_mapped,
                           "a vertex is not in the map: it is of no face, or of another mesh or component");
    return static_cast<std::size_t>(i);
  }

  /// The triangles of the map, by position, that are parts of a face of the mesh, at least one.
  /// \throw Topology_error  `element_not_mapped`: the face is of another mesh, or of another component
  std::vector<int> parts(face_descriptor f) const { return parts_of_input(number_of(f)); }

  /// The vertex of the mesh at a position, the null vertex for one that was added.
  /// \pre `v < number_of_vertices()`
  template <class Position>
  vertex_descriptor mesh_vertex(Position v) const
  {
    const int i = this->input_vertex(v);
    return i == -1 ? Graph_traits::null_vertex() : elements_->vertex[i];
  }

  /// The face of the mesh that a triangle of the map is a part of, the null face for a virtual one.
  /// \pre `f < number_of_faces()`
  template <class Position>
  face_descriptor mesh_face(Position f) const
  {
    const int i = this->input_face(f);
    return i == -1 ? Graph_traits::null_face() : elements_->face[i];
  }
  /// @}

  /// \name The map at a vertex
  /// @{
  using Map_on_arrays::domain_point;
  using Map_on_arrays::point;

  /// \throw Topology_error  as `index()`
  const Domain_point& domain_point(vertex_descriptor v) const { return domain_point(index(v)); }
  /// The position in space. \throw Topology_error  as `index()`
  const Eigen::Vector3d& point(vertex_descriptor v) const { return point(index(v)); }
  /// @}

  /// \name From the mesh to the domain and back
  /// @{
  using Map_on_arrays::to_domain;
  using Map_on_arrays::to_mesh;

  /// The domain point of a point of a triangle of the mesh, also where the map has split it.
  /// \param f  a triangle; of a polygon take one of its `parts()`
  /// \param barycentric  for the corners in the order of `vertices_around_face(halfedge(f, mesh), mesh)`
  /// \pre `f` is a triangle; the barycentric coordinates are not negative and have sum 1
  /// \throw Topology_error  `element_not_mapped`: the face is of another mesh, or of another component
  /// \throw Geometry_error  `zero_extent`: the face was split, and has no area that tells its parts apart
  Domain_point to_domain(face_descriptor f, const Eigen::Vector3d& barycentric) const
  {
    const int i = number_of(f);
    const Triangle& corner = elements_->corners[i];
    CGAL_precondition_msg(corner[0] != -1, "the face is a polygon, which the map cuts into parts");
    const std::vector<int> parts = parts_of_input(i);
    if (parts.size() == 1) return to_domain(Location{parts[0], barycentric});
    Eigen::Vector3d x(0, 0, 0);
    for (int k = 0; k < 3; ++k) x += barycentric[k] * point(position_of_input(corner[k]));
    return to_domain(nearest_location(parts, x));
  }

  /// As `Manifold_map::to_mesh()`, with the face of the mesh.
  Mesh_location to_mesh(const Domain_point& p) const { return on_mesh(Map_on_arrays::to_mesh(p)); }
  /// The same, faster when `p` lies near the triangle `face_hint` of the map, which is tried first; -1 is no hint.
  Mesh_location to_mesh(const Domain_point& p, int face_hint) const
  {
    return on_mesh(Map_on_arrays::to_mesh(p, face_hint));
  }
  /// A location with the face of the mesh.
  Mesh_location on_mesh(const Location& location) const
  {
    return {location, mesh_face(location.face), this->is_virtual(location.face)};
  }
  /// @}

#ifndef DOXYGEN_RUNNING
  // For the functions that make maps, and have numbered the mesh.
  Mesh_map(Map_on_arrays map, std::shared_ptr<const internal::Mesh_elements<FaceListGraph>> elements)
    : Map_on_arrays(std::move(map)), elements_(std::move(elements))
  {
    const std::vector<int>& input = this->input_indices().faces;
    by_input_.resize(input.size());
    std::iota(by_input_.begin(), by_input_.end(), 0);
    std::stable_sort(by_input_.begin(), by_input_.end(), [&](int f, int g) { return input[f] < input[g]; });
  }
#endif

private:
  int number_of(face_descriptor f) const
  {
    const int i = elements_->face.find(f);
    if (i == -1)
      throw Topology_error(Error_code::element_not_mapped, "a face is not in the map: it is of another mesh");
    return i;
  }

  // The position of vertex i of the input, -1 if it has none.
  int position_of_input(int i) const
  {
    const std::vector<int>& input = this->input_indices().vertices;
    if (input.empty()) return i < static_cast<int>(this->number_of_input_vertices()) ? i : -1;
    const auto at = std::lower_bound(input.begin(), input.end(), i);
    return at != input.end() && *at == i ? static_cast<int>(at - input.begin()) : -1;
  }

  std::vector<int> parts_of_input(int i) const
  {
    std::vector<int> parts;
    if (by_input_.empty()) {
      if (i < static_cast<int>(this->number_of_faces() - this->number_of_virtual_faces())) parts = {i};
    } else {
      const std::vector<int>& input = this->input_indices().faces;
      const auto first =
        std::partition_point(by_input_.begin(), by_input_.end(), [&](int f) { return input[f] < i; });
      parts.assign(first, std::partition_point(first, by_input_.end(), [&](int f) { return input[f] == i; }));
    }
    if (parts.empty())
      throw Topology_error(Error_code::element_not_mapped,
                           "a face is not in the map: it is of another component");
    return parts;
  }

  // x lies in the plane of the parts: it is in the one that has it most.
  Location nearest_location(const std::vector<int>& parts, const Eigen::Vector3d& x) const
  {
    Location best;
    double most = 0;
    for (const int f : parts) {
      const Triangle& t = this->face(f);
      const Eigen::Vector3d a = point(t[0]) - x, b = point(t[1]) - x, c = point(t[2]) - x;
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      Eigen::Vector3d beta(b.cross(c).dot(normal), c.cross(a).dot(normal), a.cross(b).dot(normal));
      beta /= normal.squaredNorm();
      if (!beta.allFinite() || (best.face != -1 && beta.minCoeff() <= most)) continue;
      most = beta.minCoeff();
      best = {f, beta};
    }
    if (best.face == -1)
      throw Geometry_error(Error_code::zero_extent, "a face that the map splits has no area");
    best.barycentric = best.barycentric.cwiseMax(0.);
    best.barycentric /= best.barycentric.sum();
    return best;
  }

  // All vertices and faces exist, each face has a part, and the parts of a triangle have no other corners.
  void require_same_mesh() const
  {
    const auto require = [](bool is_same) {
      if (!is_same) throw Topology_error(Error_code::element_not_mapped, "the map is not one of this mesh");
    };
    const int n = static_cast<int>(elements_->vertex.size()), m = static_cast<int>(elements_->face.size());
    for (std::size_t v = 0; v < this->number_of_input_vertices(); ++v) require(this->input_vertex(v) < n);
    std::vector<char> has_part(m, false);
    for (std::size_t f = 0; f + this->number_of_virtual_faces() < this->number_of_faces(); ++f) {
      const int i = this->input_face(f);
      require(i < m);
      has_part[i] = true;
      const Triangle& corner = elements_->corners[i];
      for (const int v : this->face(f)) {
        const int c = this->input_vertex(v);
        require(c == -1 || corner[0] == -1 || c == corner[0] || c == corner[1] || c == corner[2]);
      }
    }
    require(std::find(has_part.begin(), has_part.end(), false) == has_part.end());
  }

  std::shared_ptr<const internal::Mesh_elements<FaceListGraph>> elements_;
  std::vector<int>
    by_input_; // the faces that are not virtual, by input face; empty where that is their order
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MESH_MAP_H
