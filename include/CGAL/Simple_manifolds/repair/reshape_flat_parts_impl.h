// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_IMPL_H

#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/repair/reshape_flat_parts.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The triangles of a mesh as Polygon Mesh Processing needs it, and their planes.
class Flat_parts {
public:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

  explicit Flat_parts(const Mesh_soup& soup)
  {
    add_soup(soup, opposite_half_edges(soup), mesh_, [&](int i, Mesh::Vertex_index v) {
      mesh_.point(v) = Kernel::Point_3(soup.points[i].x(), soup.points[i].y(), soup.points[i].z());
    });
    Polygon_mesh_processing::triangulate_faces(mesh_);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : soup.points) box.extend(p);
    diagonal_ = box.isEmpty() ? 0 : box.diagonal().norm();
    for (const Mesh::Face_index f : mesh_.faces()) {
      const auto [a, b, c] = corners(f);
      normals_.push_back((b - a).cross(c - a));
    }
  }

  Mesh& mesh() { return mesh_; }
  double diagonal() const { return diagonal_; }

  Face_shapes shapes() const
  {
    Face_shapes s;
    double area = 0, length = 0;
    for (const Mesh::Face_index f : mesh_.faces()) {
      const auto [a, b, c] = corners(f);
      const double own = normals_[f].norm();
      const std::array<double, 3> square = {(b - a).squaredNorm(), (c - b).squaredNorm(),
                                            (a - c).squaredNorm()};
      const double longest = *std::max_element(square.begin(), square.end());
      if (!(own > 1e-12 * longest)) s.has_degenerate = true;
      area += own;
      if (longest > diagonal_ * diagonal_ / 400) s.large += own;
      if (own < 0.115 * (square[0] + square[1] + square[2]) / 2) s.slender += own;
    }
    for (const Mesh::Edge_index e : mesh_.edges()) {
      const Mesh::Halfedge_index h = mesh_.halfedge(e);
      const double own = (point(mesh_.source(h)) - point(mesh_.target(h))).norm();
      length += own;
      if (!mesh_.is_border(e) && is_flat(mesh_.face(h), mesh_.face(mesh_.opposite(h)))) s.flat += own;
    }
    s.has_degenerate = s.has_degenerate || !std::isfinite(area) || !(area > 0);
    if (s.has_degenerate) return s;
    s.flat /= length;
    s.large /= area;
    s.slender /= area;
    return s;
  }

  // Marks the edges between parts: a part has its largest face, and all that come with it in its plane.
  template <class EdgeMap>
  void mark_borders(const EdgeMap& is_border) const
  {
    std::vector<Mesh::Face_index> order(mesh_.faces().begin(), mesh_.faces().end());
    std::stable_sort(order.begin(), order.end(), [&](Mesh::Face_index f, Mesh::Face_index g) {
      return normals_[f].squaredNorm() > normals_[g].squaredNorm();
    });
    std::vector<int> part(order.size(), -1);
    std::vector<Mesh::Face_index> stack;
    for (const Mesh::Face_index seed : order) {
      if (part[seed] >= 0) continue;
      part[seed] = int(seed);
      stack.push_back(seed);
      while (!stack.empty()) {
        const Mesh::Face_index f = stack.back();
        stack.pop_back();
        for (const Mesh::Halfedge_index h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
          const Mesh::Face_index g = mesh_.face(mesh_.opposite(h));
          if (g == Mesh::null_face() || part[g] >= 0 || !is_in_plane(g, seed)) continue;
          part[g] = int(seed);
          stack.push_back(g);
        }
      }
    }
    for (const Mesh::Edge_index e : mesh_.edges()) {
      const Mesh::Halfedge_index h = mesh_.halfedge(e);
      put(is_border, e, mesh_.is_border(e) || part[mesh_.face(h)] != part[mesh_.face(mesh_.opposite(h))]);
    }
  }

private:
  static constexpr double tolerance = 1e-5; // of a plane, fraction of the diagonal

  Eigen::Vector3d point(Mesh::Vertex_index v) const
  {
    const auto& p = mesh_.point(v);
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  }

  std::array<Eigen::Vector3d, 3> corners(Mesh::Face_index f) const
  {
    const Mesh::Halfedge_index h = mesh_.halfedge(f);
    return {point(mesh_.source(h)), point(mesh_.target(h)), point(mesh_.target(mesh_.next(h)))};
  }

  bool is_in_plane(Mesh::Face_index g, Mesh::Face_index f) const
  {
    const Eigen::Vector3d n = normals_[f].normalized(), origin = corners(f)[0];
    if (!(normals_[g].dot(n) > 0)) return false;
    for (const Eigen::Vector3d& x : corners(g))
      if (!(std::abs(n.dot(x - origin)) <= tolerance * diagonal_)) return false;
    return true;
  }

  // The smaller one says less of the plane of the other.
  bool is_flat(Mesh::Face_index f, Mesh::Face_index g) const
  {
    return normals_[f].squaredNorm() > normals_[g].squaredNorm() ? is_in_plane(g, f) : is_in_plane(f, g);
  }

  Mesh mesh_;
  double diagonal_;
  std::vector<Eigen::Vector3d> normals_; // twice the area long
};

CGAL_SIMPLE_MANIFOLDS_INLINE Face_shapes face_shapes(const Mesh_soup& soup)
{
  return Flat_parts(soup).shapes();
}

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_soup reshape_flat_parts(const Mesh_soup& soup, double longest_edge)
{
  namespace PMP = Polygon_mesh_processing;
  Flat_parts parts(soup);
  Flat_parts::Mesh& mesh = parts.mesh();
  const double length = longest_edge * parts.diagonal();
  const auto is_border =
    mesh.add_property_map<Flat_parts::Mesh::Edge_index, bool>("e:is_border", false).first;
  parts.mark_borders(is_border);
  std::vector<Flat_parts::Mesh::Edge_index> borders;
  for (const auto e : mesh.edges())
    if (is_border[e]) borders.push_back(e);
  const auto constrained = CGAL::parameters::edge_is_constrained_map(is_border);
  PMP::split_long_edges(borders, length, mesh, constrained);
  PMP::isotropic_remeshing(
    mesh.faces(), length, mesh,
    CGAL::parameters::edge_is_constrained_map(is_border).protect_constraints(true).number_of_iterations(5));
  mesh.collect_garbage();
  return mesh_to_soup(mesh, mesh.points());
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_RESHAPE_FLAT_PARTS_IMPL_H
