// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHART_PINS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHART_PINS_H

#include <CGAL/Simple_manifolds/embedding/internal/Spline_least_squares.h>
#include <CGAL/Simple_manifolds/embedding/internal/Target_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// What pins weigh against each other.
struct Pin_weights {
  double floor = 1e-3;   ///< added to b_c, so that cells at the border of the chart are not starved
  double vertices = 0.3; ///< weight of all vertices of a chart together; that of its grid is 1
};

/// The grid of `per_side` x `per_side` evenly spaced points of a chart, located in the mesh.
///
/// The measure of a point is half its share of the chart's area and half its share of the area of the
/// mesh over the chart: parts that the map makes small in the domain count, and so does all of the
/// domain.
template <class Map, class Bump>
std::vector<Pin> grid_pins(const Map& map, const Partition_of_unity<typename Map::Atlas, Bump>& partition,
                           int chart, int per_side, const Pin_weights& weights)
{
  const int n = per_side;
  std::vector<Pin> pins(std::size_t(n) * n);
  int face = -1; // no hint
  for(int i = 0; i < n; ++i)
    for(int step = 0; step < n; ++step) {
      const int j = i % 2 == 0 ? step : n - 1 - step; // to and fro: neighbours follow one another
      const Chart_point at{chart, Eigen::Vector2d((i + .5) / n, (j + .5) / n)};
      const typename Map::Domain_point p = map.atlas().point(at);
      const typename Map::Location location = map.to_mesh(p, face);
      face = location.face;
      double b = weights.floor;
      for(const auto& w : partition.weights(p))
        if(w.point.chart == chart)
          b += w.weight;
      if(map.is_virtual(location.face))
        b = 0; // nothing is known of the surface where a border was closed
      pins[std::size_t(i) * n + j] = {at.uv, map.position(location), b * b};
    }

  const auto x = [&](int i, int j) -> const Eigen::Vector3d& {
    const auto clamp = [n](int k) { return (std::min)((std::max)(k, 0), n - 1); };
    return pins[std::size_t(clamp(i)) * n + clamp(j)].target;
  };
  std::vector<double> area(pins.size());
  double total = 0;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      total += area[std::size_t(i) * n + j] =
        (x(i + 1, j) - x(i - 1, j)).cross(x(i, j + 1) - x(i, j - 1)).norm();
  for(std::size_t k = 0; k < pins.size(); ++k)
    pins[k].weight *= 0.5 / double(pins.size()) + (total > 0 ? 0.5 * area[k] / total : 0);
  return pins;
}

/// Appends the vertices that chart c sees.
template <class Map, class Bump>
void append_vertex_pins(const Target_points<Map, Bump>& points, int chart, const Pin_weights& weights,
                        std::vector<Pin>& pins)
{
  const std::size_t first = pins.size();
  for(std::size_t v = 0; v < points.number_of_vertices(); ++v)
    for(auto view = points.begin(v); view != points.end(v); ++view)
      if(view->at.chart == chart) {
        const double b = view->blend + weights.floor;
        pins.push_back({view->at.uv, points.target(v), b * b});
      }
  for(std::size_t k = first; k < pins.size(); ++k)
    pins[k].weight *= weights.vertices / double(pins.size() - first);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_CHART_PINS_H
