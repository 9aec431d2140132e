// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_MESH_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/split_edges.h>
#include <CGAL/Simple_manifolds/registration/Shape_set.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// One triangulation for several shapes: the same faces with the positions that each shape has.
struct Common_mesh {
  std::vector<Triangle> faces;                         ///< positions in the vertices
  std::vector<std::vector<Eigen::Vector3d>> positions; ///< per shape, of the vertices

  std::size_t number_of_shapes() const { return positions.size(); } ///< how many there are
  std::size_t number_of_vertices() const                            ///< of the triangulation
  {
    return positions.empty() ? 0 : positions[0].size();
  }
};

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The weighted mean of the positions of all shapes: a morph between them. It depends on where the shapes are: align
/// them first (`align_shapes()`).
/// \param weights  one per shape; of sum 1 for a mean, negative ones or above 1 exaggerate
/// \pre there are as many weights as shapes
inline std::vector<Eigen::Vector3d> morph(const Common_mesh& mesh, const std::vector<double>& weights)
{
  CGAL_precondition(weights.size() == mesh.number_of_shapes());
  std::vector<Eigen::Vector3d> result(mesh.number_of_vertices(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t v = 0; v < result.size(); ++v) result[v] += weights[i] * mesh.positions[i][v];
  return result;
}

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The triangulation of one of the shapes as that of all: this shape is exact, the others are sampled.
/// \param i  the shape whose triangulation it is
/// \pre `i < set.size()`
template <class Atlas>
Common_mesh common_mesh(const Shape_set<Atlas>& set, std::size_t i = 0)
{
  Common_mesh mesh;
  mesh.faces = set.map(i).faces();
  mesh.faces.resize(mesh.faces.size() - set.map(i).number_of_virtual_faces());
  for (std::size_t j = 0; j < set.size(); ++j)
    mesh.positions.push_back(j == i ? set.map(i).points() : set.positions(j, set.map(i).domain_points()));
  return mesh;
}

namespace internal {

// Splits the edges of a triangulation over several shapes whose middle, or whose face's middle, lies too far from one of
// them.
template <class Atlas>
class Common_mesh_refinement {
public:
  using Domain_point = typename Atlas::Domain_point;

  Common_mesh_refinement(const Shape_set<Atlas>& set, std::size_t i)
    : set_(set), mesh_(common_mesh(set, i)), domain_points_(set.map(i).domain_points()),
      hints_(set.size(), -1)
  {
  }

  // One round; false if nothing is too far, or if there would be more than max_faces.
  bool refine(double chord_error, std::size_t max_faces)
  {
    std::map<std::pair<int, int>, int> middle; // of the edges to be split
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const Triangle& t = mesh_.faces[f];
      const bool is_whole = error(t, Eigen::Vector3d::Constant(1 / 3.)) > chord_error;
      for (int k = 0; k < 3; ++k) {
        const int v = t[k], w = t[(k + 1) % 3];
        Eigen::Vector3d half(0, 0, 0);
        half[k] = half[(k + 1) % 3] = 0.5;
        if (is_whole || error(t, half) > chord_error) middle[edge(v, w)] = -1;
      }
    }
    if (middle.empty() || mesh_.faces.size() + 2 * middle.size() > max_faces) return false;
    std::vector<Domain_point> added;
    for (auto& [ends, m] : middle) {
      m = static_cast<int>(domain_points_.size() + added.size());
      const Domain_point &a = domain_points_[ends.first], &b = domain_points_[ends.second];
      added.push_back(set_.map(0).atlas().interpolate(a, b, a, Eigen::Vector3d(0.5, 0.5, 0)));
    }
    for (std::size_t i = 0; i < set_.size(); ++i)
      for (const Eigen::Vector3d& x : set_.positions(i, added)) mesh_.positions[i].push_back(x);
    domain_points_.insert(domain_points_.end(), added.begin(), added.end());
    std::vector<Triangle> faces;
    for (const Triangle& t : mesh_.faces) {
      std::array<bool, 3> is_split;
      Triangle m;
      for (int k = 0; k < 3; ++k) {
        const auto found = middle.find(edge(t[k], t[(k + 1) % 3]));
        is_split[k] = found != middle.end();
        m[k] = is_split[k] ? found->second : -1;
      }
      split_triangle(t, is_split, m, faces);
    }
    mesh_.faces = std::move(faces);
    return true;
  }

  Common_mesh result() && { return std::move(mesh_); }

private:
  static std::pair<int, int> edge(int v, int w) { return {(std::min)(v, w), (std::max)(v, w)}; }

  // The largest distance between a point of the face and that of the surfaces which it stands for, in diagonals.
  double error(const Triangle& t, const Eigen::Vector3d& b)
  {
    const Domain_point p =
      set_.map(0).atlas().interpolate(domain_points_[t[0]], domain_points_[t[1]], domain_points_[t[2]], b);
    double largest = 0;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const auto at = set_.map(i).to_mesh(p, hints_[i]);
      hints_[i] = at.face;
      const auto& x = mesh_.positions[i];
      const Eigen::Vector3d flat = b[0] * x[t[0]] + b[1] * x[t[1]] + b[2] * x[t[2]];
      largest = (std::max)(largest, (set_.map(i).position(at) - flat).norm() / set_.map(i).diagonal());
    }
    return largest;
  }

  const Shape_set<Atlas>& set_;
  Common_mesh mesh_;
  std::vector<Domain_point> domain_points_;
  std::vector<int> hints_; // per shape
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsRegistration
///
/// The triangulation of one of the shapes, refined until the middles of its edges and faces are no farther than a
/// tolerance from the points of all shapes that they stand for.
/// \param i  the shape whose triangulation it starts from
/// \param chord_error  largest distance allowed, a fraction of the diagonal of each shape
/// \param max_faces  no round of refinement makes more faces: then it ends before the tolerance is met
/// \pre `i < set.size()`, `chord_error > 0`, no map has virtual faces
template <class Atlas>
Common_mesh common_mesh(const Shape_set<Atlas>& set, std::size_t i, double chord_error,
                        std::size_t max_faces = std::size_t(1) << 20)
{
  CGAL_precondition(chord_error > 0);
  for (std::size_t j = 0; j < set.size(); ++j) CGAL_precondition(set.map(j).number_of_virtual_faces() == 0);
  internal::Common_mesh_refinement<Atlas> refinement(set, i);
  while (refinement.refine(chord_error, max_faces)) {
  }
  return std::move(refinement).result();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_COMMON_MESH_H
