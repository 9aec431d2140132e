// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_EMBED_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_EMBED_H

#include <CGAL/Simple_manifolds/correspondence/internal/Coarse_to_fine_embedding.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

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
      key |= spread(static_cast<std::uint64_t>(std::min(std::max(points[v][k], 0.), 1.) * 2097151)) << k;
    keys[v] = {key, static_cast<int>(v)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = keys[i].second;
  return order;
}

// The points in the unit cube: the cost of a collapse and the areas need no more, and coordinates of any
// size are harmless.
inline std::vector<Eigen::Vector3d> normalized_points(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d low = points[0], high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3d half = high / 2 - low / 2; // the difference itself may overflow
  const double extent = half.maxCoeff();
  std::vector<Eigen::Vector3d> result(points.size(), Eigen::Vector3d(0, 0, 0));
  if (extent > 0)
    for (std::size_t v = 0; v < points.size(); ++v)
      result[v] = (points[v] / 2 - low / 2) / extent;
  return result;
}

// Embeds a closed triangulated surface in the domain of `Geometry` with `make_geometry(order)` as its
// initial state; the vertex `apex` and its faces are virtual (-1: none). finish(mesh, geometry) reads
// the result off; the number that the hierarchy gives to vertex v of the input is number(v).
//
// The shape of the faces only guides the energy, so when doubles do not suffice the map is begun anew with
// better conditioned targets, down to the purely combinatorial problem. Returns false if that fails too.
template <class ConcurrencyTag, class Make_geometry, class Finish, class Visitor>
bool embed(const std::vector<Eigen::Vector3d>& input_points, const std::vector<std::array<int, 3>>& input_faces,
           int apex, Map_options options, const Make_geometry& make_geometry, const Finish& finish,
           Visitor& visitor)
{
  const int n = static_cast<int>(input_points.size());
  std::vector<Eigen::Vector3d> points = normalized_points(input_points);
  const std::vector<int> order = morton_order(points);
  std::vector<int> rank(n);
  for (int i = 0; i < n; ++i)
    rank[order[i]] = i;
  {
    std::vector<Eigen::Vector3d> sorted(n);
    for (int i = 0; i < n; ++i)
      sorted[i] = points[order[i]];
    points.swap(sorted);
  }
  std::vector<std::array<int, 3>> faces(input_faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k)
      faces[f][k] = rank[input_faces[f][k]];
  std::sort(faces.begin(), faces.end(), [](const auto& f, const auto& g) {
    return std::make_pair(*std::min_element(f.begin(), f.end()), f)
         < std::make_pair(*std::min_element(g.begin(), g.end()), g);
  });
  const int sorted_apex = apex < 0 ? -1 : rank[apex];

  double shape_floor = 1e-4;
  for (int attempt = 0; attempt < 3; ++attempt) {
    using Geometry = decltype(make_geometry(order));
    const Target_area unscaled{1, 0};
    double area = 0;
    std::size_t real_faces = 0;
    for (const auto& f : faces)
      if (f[0] != sorted_apex && f[1] != sorted_apex && f[2] != sorted_apex) {
        area += unscaled(points[f[0]], points[f[1]], points[f[2]]);
        ++real_faces;
      }
    const double floor = area > 1e-150 ? options.area_floor : 1;
    const Target_area target{floor < 1 ? (1 - floor) * Geometry::total_area / area : 0,
                             floor * Geometry::total_area / static_cast<double>(real_faces)};
    std::vector<double> mass(n, 0.);
    for (const auto& f : faces)
      if (f[0] != sorted_apex && f[1] != sorted_apex && f[2] != sorted_apex)
        for (int k = 0; k < 3; ++k)
          mass[f[k]] += target(points[f[0]], points[f[1]], points[f[2]]) / 3;

    Geometry geometry = make_geometry(order);
    Collapse_hierarchy mesh(points, faces, std::move(mass), sorted_apex);
    visitor.start_phase("decimate");
    mesh.decimate<ConcurrencyTag>(
      Geometry::minimum_vertices, [&](int v) { return geometry.is_removable(v); },
      [&](int u, const std::vector<int>& ring, int i) { return geometry.is_admissible(u, ring, i); },
      [&](double fraction) { visitor.progress(fraction); });
    visitor.end_phase();
    geometry.renumber(mesh);
    visitor.start_phase("embed");
    Coarse_to_fine_embedding<Geometry, ConcurrencyTag> embedding(mesh, geometry, options, target, shape_floor);
    const bool embedded = embedding.run([&](double fraction) { visitor.progress(fraction); });
    visitor.end_phase();
    if (embedded && finish(mesh, geometry, [&](int v) { return mesh.number_of(rank[v]); }))
      return true;
    options.area_floor = attempt == 0 ? std::min(1., 10 * options.area_floor) : 1;
    shape_floor = attempt == 0 ? 1 : 100;
  }
  return false;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_EMBED_H
