// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FOLDED_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FOLDED_POINTS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The points of the domain at which a surface shows its other side: its normal differs by more than a right angle from
/// the target's normals at all samples that are near in space. Near an edge of the target, where the surface only turns
/// earlier or later, some of them agree. Looks at points in every cell of the fit, also between the samples.
/// \param reach  how near: about the error of the fit; the nearest sample is asked in any case
template <class Surface>
std::vector<typename Surface::Atlas::Domain_point> folded_points(bool is_parallel, const Surface& surface,
                                                                 const Hierarchical_fit& fit, double reach)
{
  using Domain_point = typename Surface::Atlas::Domain_point;
  constexpr int per_side = 5, piece = 64;
  constexpr double most = -0.3; // cosine, at one of them at least
  const Fit_samples& samples = fit.samples();
  struct Sample {
    Eigen::Vector3d target, normal;
  };
  std::vector<Domain_point> folded;
  for (int c = 0; c < int(fit.splines().size()); ++c) {
    const Cell_tree& tree = fit.splines()[c].tree();
    std::vector<std::vector<Sample>> seen(tree.size());
    for (std::size_t s = 0; s < samples.size(); ++s)
      for (std::size_t u = samples.begin[s]; u < samples.begin[s + 1]; ++u)
        if (const Fit_samples::View& view = samples.views[u]; view.chart == c && !samples.normal[s].isZero())
          seen[view.cell].push_back({samples.target[s], samples.normal[s]});
    const int pieces = (tree.size() + piece - 1) / piece;
    std::vector<std::vector<Domain_point>> found(pieces);
    parallel_tasks(is_parallel, pieces, [&](int k) {
      std::vector<Domain_point> points;
      std::vector<int> leaf;
      for (int node = k * piece; node < (std::min)((k + 1) * piece, tree.size()); ++node) {
        if (seen[node].empty()) continue;
        const Cell& cell = tree.cell(node);
        for (int i = 0; i < per_side * per_side; ++i) {
          const Eigen::Vector2d uv((cell.i + (i / per_side + 0.5) / per_side) / tree.side(cell.level),
                                   (cell.j + (i % per_side + 0.5) / per_side) / tree.side(cell.level));
          const Domain_point p = surface.atlas().point(Chart_point{c, uv});
          if (surface.atlas().best_chart(p) != c) continue; // that chart's, then
          points.push_back(p);
          leaf.push_back(node);
        }
      }
      std::vector<Jet> jets;
      surface.template jets<1>(points, std::back_inserter(jets));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const std::vector<Sample>& around = seen[leaf[i]];
        const Eigen::Vector3d &x = jets[i].value, n = jets[i].u.cross(jets[i].v).stableNormalized();
        double nearest = std::numeric_limits<double>::infinity();
        for (const Sample& s : around) nearest = (std::min)(nearest, (s.target - x).norm());
        double largest = -1, least = 1; // cosines
        for (const Sample& s : around)
          if ((s.target - x).norm() <= (std::max)(reach, 1.2 * nearest)) {
            largest = (std::max)(largest, s.normal.dot(n));
            least = (std::min)(least, s.normal.dot(n));
          }
        if (largest < 0 && least < most) found[k].push_back(points[i]);
      }
    });
    for (const auto& part : found) folded.insert(folded.end(), part.begin(), part.end());
  }
  return folded;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FOLDED_POINTS_H
