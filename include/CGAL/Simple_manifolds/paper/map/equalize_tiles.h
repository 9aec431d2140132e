// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_EQUALIZE_TILES_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_EQUALIZE_TILES_H

#include <CGAL/Simple_manifolds/paper/map/adjust_centroids.h>
#include <CGAL/Simple_manifolds/paper/map/project_tiles.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The number of faces in each tile, by their centroids.
template <class Atlas, class FaceGraph, class DomainPointMap>
std::vector<std::size_t> faces_per_tile(const Atlas& atlas, const FaceGraph& mesh,
                                        DomainPointMap domain_point)
{
  std::vector<std::size_t> count(atlas.number_of_charts(), 0);
  std::vector<typename Atlas::Domain_point> corners(3);
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    corners = {get(domain_point, source(h, mesh)), get(domain_point, target(h, mesh)),
               get(domain_point, target(next(h, mesh), mesh))};
    ++count[atlas.tile(internal::Domain_plane<Atlas>(atlas, corners[0]).centroid(corners))];
  }
  return count;
}

/// \ingroup PkgSimpleManifoldsPaper
///
/// What `equalize_tiles()` has reached.
struct Equalization_report {
  int rounds = 0;               ///< that were carried out
  int best_round = 0;           ///< the one whose map was kept; 0: the map that the tiles were projected to
  double largest_deviation = 0; ///< of the number of faces in a tile from its mean, over the mean
  /// All vertices lie in the polygons of their neighbours, and the deviation is below the limit.
  bool has_stopped_by_rule = false;
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// The iteration of Grimm 2002, section 5.4: reproject the chart with the fewest faces, that with the most,
/// then all of them, and adjust the centroids 30 times; until every vertex lies in the polygon of its
/// neighbours and the deviation of the number of faces per tile is below 0.2. The paper has no proof that
/// this converges: it works on copies, and the best map without a flip is kept.
///
/// \pre no face is flipped
template <class Atlas, class FaceGraph, class DomainPointMap>
Equalization_report equalize_tiles(const Atlas& atlas, const FaceGraph& mesh, DomainPointMap domain_point,
                                   Projection_weights weights = Projection_weights::CENTROID)
{
  constexpr int most_rounds = 20, centroid_iterations = 30;
  constexpr double deviation_limit = 0.2;
  const int n = atlas.number_of_charts();
  const double mean = double(num_faces(mesh)) / n;
  const auto deviation = [&] {
    double largest = 0;
    for (const std::size_t count : faces_per_tile(atlas, mesh, domain_point))
      largest = (std::max)(largest, std::abs(double(count) / mean - 1));
    return largest;
  };
  const auto reproject_chart = [&](int c) {
    const double share = double(faces_per_tile(atlas, mesh, domain_point)[c]) / mean;
    reproject(atlas, mesh, domain_point, c, (std::min)(2., (std::max)(0.5, share)), weights);
  };
  const auto extreme = [&](bool largest) {
    const auto count = faces_per_tile(atlas, mesh, domain_point);
    return static_cast<int>((largest ? std::max_element(count.begin(), count.end())
                                     : std::min_element(count.begin(), count.end())) -
                            count.begin());
  };

  Equalization_report report;
  std::vector<typename Atlas::Domain_point> best;
  for (const auto v : vertices(mesh)) best.push_back(get(domain_point, v));
  report.largest_deviation = deviation();
  report.has_stopped_by_rule = report.largest_deviation < deviation_limit;
  while (!report.has_stopped_by_rule && report.rounds < most_rounds) {
    ++report.rounds;
    reproject_chart(extreme(false));
    reproject_chart(extreme(true));
    for (int c = 0; c < n; ++c) reproject_chart(c);
    adjust_centroids(atlas, mesh, domain_point, centroid_iterations);
    const std::size_t flips = number_of_flips(atlas, mesh, domain_point);
    const double d = deviation();
    if (flips > 0 || d >= report.largest_deviation) continue;
    report.largest_deviation = d;
    report.best_round = report.rounds;
    report.has_stopped_by_rule = d < deviation_limit;
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) best[i++] = get(domain_point, v);
  }
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) put(domain_point, v, best[i++]);
  return report;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_EQUALIZE_TILES_H
