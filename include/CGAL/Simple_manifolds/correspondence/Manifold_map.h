// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MANIFOLD_MAP_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MANIFOLD_MAP_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/default_chart.h>
#include <CGAL/Simple_manifolds/correspondence/Point_locator.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The correspondence M between a canonical surface and a triangle mesh (Grimm 2002, section 4): each
/// vertex has a domain point, the faces are filled in by radial (sphere) or linear interpolation. Every
/// object of this class is one to one: the constructor proves it.
///
/// It consists of arrays: vertices and faces are named by their positions there, integers of any type. These are
/// not those of a mesh that has vertices of no face, or removed ones, or polygons; `input_vertex()` and
/// `input_face()` tell. A map of a mesh is a `Mesh_map`, which takes the descriptors of the mesh as well.
///
/// Immutable; all members are thread safe.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
/// \cgalModels{ManifoldMap}
template <class Atlas_>
class Manifold_map {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas_);

public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface

  /// A point of the mesh: a face and barycentric coordinates in it, none negative, with sum 1 up to rounding.
  struct Location {
    int face = -1;                                         ///< index of the face
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero(); ///< for its three corners, of sum 1
  };

  /// \param points  the vertices in space
  /// \param faces  positions in `points`, counterclockwise; positive in the domain
  /// \param domain_points  one per vertex: unit vectors, in [0,1)^2 (torus), in [0,1]^2 (plane)
  /// \param number_of_input_vertices  the vertices from here on were added: on edges of an input mesh, or to close
  ///   its borders
  /// \param number_of_virtual_faces  the last faces close borders of an input mesh, see `Close_borders`
  /// \param input  where the vertices and faces come from
  /// \param atlas  the canonical surface
  /// \pre `points.size() == domain_points.size()`, `number_of_input_vertices <= points.size()`,
  ///   `number_of_virtual_faces <= faces.size()`, `input` suits these numbers
  /// \throw Topology_error  when the mesh is no surface of the domain's genus and border
  /// \throw Geometry_error  `non_finite_coordinate` for a vertex in space
  /// \throw Numeric_error  `map_not_bijective`, with the sentence of the certificate and the first bad face
  Manifold_map(std::vector<Eigen::Vector3d> points, std::vector<Triangle> faces,
               std::vector<Domain_point> domain_points, std::size_t number_of_input_vertices,
               std::size_t number_of_virtual_faces = 0, Input_indices input = Input_indices(),
               Atlas atlas = Atlas())
    : atlas_(std::move(atlas)), points_(std::move(points)), faces_(std::move(faces)),
      domain_points_(std::move(domain_points)), number_of_input_vertices_(number_of_input_vertices),
      number_of_virtual_faces_(number_of_virtual_faces), input_(std::move(input).compact()),
      locator_(certified_locator())
  {
    CGAL_precondition(input_.suits(number_of_input_vertices_, faces_.size() - number_of_virtual_faces_));
    measure();
  }

  /// The same mesh with other domain points.
  /// \throw Numeric_error  `map_not_bijective`, with the sentence of the certificate and the first bad face
  Manifold_map with_domain_points(std::vector<Domain_point> domain_points) const
  {
    return Manifold_map(points_, faces_, std::move(domain_points), number_of_input_vertices_,
                        number_of_virtual_faces_, input_, atlas_);
  }

  /// \name The map as arrays
  /// @{

  /// The atlas of the domain.
  const Atlas& atlas() const { return atlas_; }
  /// Its vertices, virtual ones included.
  std::size_t number_of_vertices() const { return points_.size(); }
  /// Its triangles, virtual ones included.
  std::size_t number_of_faces() const { return faces_.size(); }
  /// The vertices from here on were added, see the constructor.
  std::size_t number_of_input_vertices() const { return number_of_input_vertices_; }
  /// The number of faces that close borders; they come last.
  std::size_t number_of_virtual_faces() const { return number_of_virtual_faces_; }
  /// Whether the face closes a border and is no part of the mesh, see `Close_borders`.
  /// \pre `f < number_of_faces()`
  template <class Position>
  bool is_virtual(Position f) const
  {
    return checked(f, faces_.size()) + number_of_virtual_faces_ >= faces_.size();
  }
  /// Whether all faces of the vertex are virtual.
  /// \pre `v < number_of_vertices()`
  template <class Position>
  bool is_virtual_vertex(Position v) const
  {
    return std::binary_search(virtual_vertices_.begin(), virtual_vertices_.end(),
                              static_cast<int>(checked(v, points_.size())));
  }

  /// \pre `v < number_of_vertices()`
  template <class Position>
  const Eigen::Vector3d& point(Position v) const
  {
    return points_[checked(v, points_.size())];
  }
  /// \pre `f < number_of_faces()`
  template <class Position>
  const Triangle& face(Position f) const
  {
    return faces_[checked(f, faces_.size())];
  }
  /// \pre `v < number_of_vertices()`
  template <class Position>
  const Domain_point& domain_point(Position v) const
  {
    return domain_points_[checked(v, points_.size())];
  }

  /// The positions of the vertices.
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  /// The vertices of the faces.
  const std::vector<Triangle>& faces() const { return faces_; }
  /// The domain points of the vertices.
  const std::vector<Domain_point>& domain_points() const { return domain_points_; }

  /// The default chart of a face: the chart that contains the whole face and whose centre is nearest to
  /// the face's centroid in the domain, or -1 where none does.
  /// \pre `f < number_of_faces()`
  template <class Position>
  int chart(Position f) const
  {
    const Triangle& t = face(f);
    return Simple_manifolds::default_chart(atlas_, domain_points_[t[0]], domain_points_[t[1]],
                                           domain_points_[t[2]]);
  }

  /// The number of the vertex in the input: a mesh in its iteration order, arrays, or a file; -1 for added ones.
  /// \pre `v < number_of_vertices()`
  template <class Position>
  int input_vertex(Position v) const
  {
    const std::size_t i = checked(v, points_.size());
    if (i >= number_of_input_vertices_) return -1;
    return input_.vertices.empty() ? static_cast<int>(i) : input_.vertices[i];
  }
  /// The number of the input face that the face is a part of, -1 for virtual ones. What was read from a file
  /// knows no input but the file: then it is `f`.
  /// \pre `f < number_of_faces()`
  template <class Position>
  int input_face(Position f) const
  {
    const std::size_t i = checked(f, faces_.size());
    if (is_virtual(i)) return -1;
    return input_.faces.empty() ? static_cast<int>(i) : input_.faces[i];
  }
  /// Both as arrays.
  const Input_indices& input_indices() const { return input_; }
  /// @}

  /// \name From the mesh to the domain and back
  /// @{

  /// M^-1: the domain point of a point of the mesh.
  /// \pre `location.face` is a face; the barycentric coordinates are not negative and have sum 1, up to 1e-9
  Domain_point to_domain(const Location& location) const
  {
    CGAL_precondition(is_in_mesh(location));
    const Triangle& t = faces_[location.face];
    for (int k = 0; k < 3; ++k)
      if (location.barycentric[k] == 1) // without the rounding of lifts
        return domain_points_[t[k]];
    return atlas_.interpolate(domain_points_[t[0]], domain_points_[t[1]], domain_points_[t[2]],
                              location.barycentric);
  }

  /// The point of the mesh that belongs to a domain point; always exists. Exact signs find the face, so
  /// a vertex is found with barycentric coordinate 1, and a point of an edge in one of its two faces.
  /// \param p  sphere: any vector but zero; torus and square: any point, brought into the domain first
  ///   (modulo 1, or to the nearest point of the square)
  /// \pre the coordinates are finite
  Location to_mesh(const Domain_point& p) const { return to_mesh(p, -1); }

  /// The same, faster when `p` lies near the face `face_hint`, which is tried first; -1 is no hint.
  Location to_mesh(const Domain_point& p, int face_hint) const
  {
    CGAL_precondition(p.allFinite());
    CGAL_precondition(-1 <= face_hint && face_hint < static_cast<int>(faces_.size()));
    const Domain_point x = atlas_.query(p);
    return location(locator_.locate(atlas_, domain_points_, faces_, x, face_hint), x);
  }

  /// The locations of a range of domain points, in order; each search starts at the one before.
  /// \tparam Range  of `Domain_point`
  /// \tparam OutputIterator  for `Location`
  template <
    class Range, class OutputIterator,
    std::enable_if_t<!std::is_convertible_v<const Range&, Domain_point>, int> = 0> // a point is no range
  OutputIterator to_mesh(const Range& points, OutputIterator out) const
  {
    static_assert(
      std::is_convertible_v<typename internal::Range_element<const Range>::type, const Domain_point&>,
      "the range is none of domain points");
    int hint = -1;
    for (const Domain_point& p : points) {
      const Location found = to_mesh(p, hint);
      hint = found.face;
      *out++ = found;
    }
    return out;
  }

  /// The point in space of a location.
  /// \pre as for `to_domain()`
  Eigen::Vector3d position(const Location& location) const
  {
    CGAL_precondition(is_in_mesh(location));
    const Triangle& t = faces_[location.face];
    return location.barycentric[0] * points_[t[0]] + location.barycentric[1] * points_[t[1]] +
           location.barycentric[2] * points_[t[2]];
  }

  /// M(p): the point in space of a domain point.
  Eigen::Vector3d operator()(const Domain_point& p) const { return position(to_mesh(p)); }
  /// @}

  /// \name What is known about it
  /// @{

  /// The proof that the map is one to one.
  const Certificate& certificate() const { return certificate_; }
  /// The diagonal of the bounding box of the input vertices: the unit of relative errors.
  double diagonal() const { return diagonal_; }
  /// Whether the mesh is closed and has a negative volume: its normals, and those of a surface fitted to
  /// it, point inward.
  bool is_inward_oriented() const { return is_inward_oriented_; }
  /// @}

private:
  // Descriptors of meshes convert to integers, but not to positions.
  template <class Position>
  static std::size_t checked(Position i, [[maybe_unused]] std::size_t size)
  {
    static_assert(
      std::is_integral_v<Position>,
      "a Manifold_map takes positions in its arrays: for descriptors of the mesh there is the Mesh_map "
      "that map_to_sphere(mesh) and the others return");
    CGAL_precondition(static_cast<std::size_t>(i) < size);
    return static_cast<std::size_t>(i);
  }

  Point_locator<Atlas> certified_locator()
  {
    CGAL_precondition(points_.size() == domain_points_.size());
    CGAL_precondition(number_of_input_vertices_ <= points_.size());
    CGAL_precondition(number_of_virtual_faces_ <= faces_.size());
    std::vector<int> opposite;
    const internal::Triangle_soup soup(static_cast<int>(points_.size()), faces_);
    const Mesh_topology topology = internal::topology_of_soup(soup, opposite);
    if constexpr (Atlas::is_closed)
      require_closed_genus(topology, atlas_.genus());
    else
      require_disk(topology);
    for (const Triangle& t : faces_)
      for (int v : t)
        if (!points_[v].allFinite())
          throw Geometry_error(Error_code::non_finite_coordinate,
                               "vertex " + std::to_string(v) + " has a coordinate that is not finite",
                               Mesh_element::vertex(v));
    certificate_ = internal::certify_surface(atlas_, domain_points_, faces_, opposite, topology);
    if (!certificate_.is_valid())
      throw Numeric_error(Error_code::map_not_bijective, certificate_.sentence(),
                          certificate_.offending_faces.empty()
                            ? Mesh_element()
                            : Mesh_element::face(certificate_.offending_faces.front()));
    return Point_locator<Atlas>(std::move(opposite));
  }

  void measure()
  {
    Eigen::AlignedBox3d box;
    double volume = 0; // six times, scaled
    const double scale = internal::unit_scale(points_);
    const Eigen::Vector3d origin = scale * points_[faces_[0][0]];
    for (const Triangle& t : faces_) {
      for (int v : t)
        if (v < static_cast<int>(number_of_input_vertices_)) box.extend(points_[v]);
      const Eigen::Vector3d a = scale * points_[t[0]] - origin, b = scale * points_[t[1]] - origin;
      volume += a.dot(b.cross(scale * points_[t[2]] - origin));
    }
    if (number_of_virtual_faces_ > 0) {
      std::vector<char> is_real(points_.size(), false);
      for (std::size_t f = 0; f + number_of_virtual_faces_ < faces_.size(); ++f)
        for (int v : faces_[f]) is_real[v] = true;
      for (std::size_t v = 0; v < is_real.size(); ++v)
        if (!is_real[v]) virtual_vertices_.push_back(static_cast<int>(v));
    }
    diagonal_ = box.isEmpty() ? 0. : (scale * (box.max)() - scale * (box.min)()).norm() / scale;
    is_inward_oriented_ = Atlas::is_closed && volume < 0;
  }

  bool is_in_mesh(const Location& location) const
  {
    return location.face >= 0 && location.face < static_cast<int>(faces_.size()) &&
           location.barycentric.minCoeff() >= 0 && std::abs(location.barycentric.sum() - 1) <= 1e-9;
  }

  Location location(const Located_face& found, const Domain_point& x) const
  {
    CGAL_assertion(found.face != -1); // the faces of a certified map cover the domain
    const Triangle& t = faces_[found.face];
    const auto& s = found.sign;
    Location location;
    location.face = found.face;
    for (int k = 0; k < 3; ++k)
      if (s[k] == 0 && s[(k + 2) % 3] == 0) { // both sides at corner k
        location.barycentric[k] = 1;
        return location;
      }
    Eigen::Vector3d beta =
      atlas_.barycentric(domain_points_[t[0]], domain_points_[t[1]], domain_points_[t[2]], x);
    for (int k = 0; k < 3; ++k)
      if (s[k] == 0 || !(beta[(k + 2) % 3] > 0)) // the signs know better than rounded coordinates
        beta[(k + 2) % 3] = 0;
    location.barycentric = beta / beta.sum();
    return location;
  }

  Atlas atlas_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> faces_;
  std::vector<Domain_point> domain_points_;
  std::size_t number_of_input_vertices_, number_of_virtual_faces_;
  Input_indices input_;
  Certificate certificate_;
  Point_locator<Atlas> locator_;      // after the members that it is made from
  std::vector<int> virtual_vertices_; // sorted
  double diagonal_ = 0;
  bool is_inward_oriented_ = false;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_MANIFOLD_MAP_H
