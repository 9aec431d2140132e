// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_LAY_OUT_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_LAY_OUT_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Coarse_to_fine_layout.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a geometry has a metric that it finds by sums over all faces.
template <class Geometry, class = void>
inline constexpr bool geometry_sums_over_faces = false;
template <class Geometry>
inline constexpr bool geometry_sums_over_faces<Geometry, std::enable_if_t<Geometry::has_metric>> = true;

inline constexpr int number_of_attempts = 3;

// The order of the points along Morton's curve: neighbours in space become neighbours in memory.
inline std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points) // in [0,1]^3
{
  const auto spread = [](std::uint64_t x) {
    x = (x | x << 32) & 0x1f00000000ffffull;
    x = (x | x << 16) & 0x1f0000ff0000ffull;
    x = (x | x << 8) & 0x100f00f00f00f00full;
    x = (x | x << 4) & 0x10c30c30c30c30c3ull;
    return (x | x << 2) & 0x1249249249249249ull;
  };
  std::vector<std::pair<std::uint64_t, int>> keys(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
      key |= spread(static_cast<std::uint64_t>((std::min)((std::max)(points[v][k], 0.), 1.) * 2097151)) << k;
    keys[v] = {key, static_cast<int>(v)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].second;
  return order;
}

// A closed triangulated surface that is to be embedded, and what is wanted of it.
template <class Point>
struct Layout_problem {
  const std::vector<Eigen::Vector3d>& points;
  const std::vector<Triangle>& triangles;
  int apex = -1;                          // a virtual vertex, whose faces close the border of a disk
  std::vector<double> vertex_weight = {}; // relative area in the domain; empty: all 1
  std::vector<Indexed_landmark<Point>> landmarks = {};
  int rejected_attempts = 0; // restarts have not been needed yet: their tests reject the first results
};

// Target areas of the triangles, summing to `total`: shares of their own areas and, since triangles without area
// need room too, a share `floor` of uniform area; 0 for the virtual ones.
inline std::vector<float> target_areas(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<Triangle>& triangles, int apex,
                                       const std::vector<double>& vertex_weight, double floor, double total)
{
  std::vector<double> area(triangles.size(), 0.), share(triangles.size(), 0.);
  double area_sum = 0, share_sum = 0;
  double largest_weight = 0; // only their ratios count
  for (const double w : vertex_weight) largest_weight = (std::max)(largest_weight, w);
  const auto weight = [&](int v) { return largest_weight > 0 ? vertex_weight[v] / largest_weight : 1.; };
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (t[0] == apex || t[1] == apex || t[2] == apex) continue;
    share[f] = vertex_weight.empty() ? 1 : (std::max)((weight(t[0]) + weight(t[1]) + weight(t[2])) / 3, 1e-6);
    area[f] = share[f] * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
    area_sum += area[f];
    share_sum += share[f];
  }
  if (!(area_sum > 1e-150)) floor = 1;
  std::vector<float> result(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    result[f] = static_cast<float>(
      total * ((floor < 1 ? (1 - floor) * area[f] / area_sum : 0) + floor * share[f] / share_sum));
  return result;
}

// The surface with its vertices in the given order, and its triangles in the order of their first vertex. The copies
// that it takes to sort live no longer than this call.
template <class Point>
Collapse_hierarchy sorted_hierarchy(const Layout_problem<Point>& problem, const std::vector<int>& order,
                                    const std::vector<int>& rank, double area_floor, double total_area)
{
  std::vector<Eigen::Vector3d> points = normalized_points(problem.points), sorted_points(points.size());
  std::vector<double> vertex_weight(problem.vertex_weight.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    sorted_points[i] = points[order[i]];
    if (!vertex_weight.empty()) vertex_weight[i] = problem.vertex_weight[order[i]];
  }
  points = std::vector<Eigen::Vector3d>();
  std::vector<Triangle> triangles = problem.triangles;
  for (Triangle& t : triangles)
    for (int& v : t) v = rank[v];
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& s, const Triangle& t) {
    return std::make_pair(*std::min_element(s.begin(), s.end()), s) <
           std::make_pair(*std::min_element(t.begin(), t.end()), t);
  });
  const int apex = problem.apex < 0 ? -1 : rank[problem.apex];
  std::vector<float> areas =
    target_areas(sorted_points, triangles, apex, vertex_weight, area_floor, total_area);
  return Collapse_hierarchy(std::move(sorted_points), triangles, std::move(areas), apex);
}

// Embeds a surface in the domain of `Geometry` with `make_geometry(order)` as its initial state, where
// order[i] is the vertex of the input that comes i-th. read(mesh, geometry, number) reads the result off, where
// number(v) is the number that the hierarchy gives to vertex v of the input; accept(result) may refuse it. All
// tables are gone by then.
//
// The shape of the faces only guides the energy, so when doubles do not suffice the map is begun anew with
// better conditioned targets, down to the purely combinatorial problem. Returns false if that fails too.
template <class Make_geometry, class Read, class Accept, class Visitor, class Point>
bool lay_out(bool is_parallel, const Layout_problem<Point>& problem, Map_options options,
             const Make_geometry& make_geometry, const Read& read, const Accept& accept, Visitor& visitor)
{
  using Geometry = std::decay_t<decltype(make_geometry(std::vector<int>()))>;
  const int n = static_cast<int>(problem.points.size());
  const std::vector<int> order = morton_order(normalized_points(problem.points));
  std::vector<int> rank(n);
  for (int i = 0; i < n; ++i) rank[order[i]] = i;
  // Landmarks stay as long as possible, so that the coarse levels are drawn to them.
  std::vector<float> reluctance(problem.landmarks.empty() ? 0 : n, 1.f);
  for (const auto& l : problem.landmarks) reluctance[rank[l.vertex]] = 1e6f;

  double shape_floor = 1e-4;
  const auto embedded = [&](int attempt) {
    Geometry geometry = make_geometry(order);
    Collapse_hierarchy mesh = sorted_hierarchy(problem, order, rank, options.area_floor, geometry.total_area);
    visitor.start_phase("decimate");
    mesh.decimate(
      is_parallel, geometry.minimum_vertices, [&](int v) { return geometry.is_removable(v); },
      [&](int u, const std::vector<int>& ring, int i) { return geometry.is_admissible(u, ring, i); },
      [&](int v) { return reluctance.empty() ? 1.f : reluctance[v]; },
      [&](double fraction) { visitor.progress(fraction); },
      geometry_sums_over_faces<Geometry> ? Collapse_hierarchy::Face_order::BY_COLLAPSE
                                         : Collapse_hierarchy::Face_order::BY_VERTEX);
    visitor.end_phase();
    geometry.renumber(mesh);
    std::vector<Indexed_landmark<Point>> landmarks = problem.landmarks;
    for (auto& l : landmarks) l.vertex = mesh.number_of(rank[l.vertex]);
    visitor.start_phase("lay out");
    const auto number = [&](int v) { return mesh.number_of(rank[v]); };
    std::optional<std::decay_t<decltype(read(mesh, geometry, number))>> result;
    if (Coarse_to_fine_layout<Geometry>(mesh, geometry, options, shape_floor, landmarks, is_parallel)
          .run([&](double fraction) { visitor.progress(fraction); }) &&
        attempt >= problem.rejected_attempts)
      result = read(mesh, geometry, number);
    visitor.end_phase();
    return result;
  };
  for (int attempt = 0; attempt < number_of_attempts; ++attempt) {
    auto result = embedded(attempt);
    if (result && accept(std::move(*result))) return true;
    options.area_floor = attempt == 0 ? (std::min)(1., 10 * options.area_floor) : 1;
    shape_floor = attempt == 0 ? 1 : 100;
  }
  return false;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_ENGINE_LAY_OUT_H
