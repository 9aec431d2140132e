// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_CLOSEST_POINT_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_CLOSEST_POINT_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/embedding/internal/closest_point/Surface_box_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/closest_point/approach.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// A point of a surface that is close to a point x of space.
template <class Domain_point_>
struct Closest_point {
  using Domain_point = Domain_point_; ///< a point of the canonical surface

  Chart_point chart_point;   ///< the closest point, in its best chart
  Domain_point domain_point; ///< the same as a domain point
  Eigen::Vector3d point;     ///< its position
  double distance;           ///< |x - point|
  /// The distance, negative where x lies behind the tangent plane. On a closed surface without
  /// self-intersection, with outward normals, and for a globally closest point: negative inside.
  double signed_distance;
};

namespace internal {

template <class Surface>
Closest_point<typename Surface::Domain_point> closest_point_at(const Surface& surface, const Approach& a,
                                                               const Eigen::Vector3d& x)
{
  const Eigen::Vector3d r = x - a.jet.value;
  const double distance = r.stableNorm();
  return {a.at, surface.atlas().point(a.at), a.jet.value, distance,
          r.dot(a.jet.u.cross(a.jet.v)) < 0 ? -distance : distance};
}

/// The distance of x from the surface near the domain point p: a few Gauss-Newton steps, each of which comes
/// nearer. Never larger than |E(p) - x|.
template <class Surface>
double closest_point_distance(const Surface& surface, const typename Surface::Domain_point& p,
                              const Eigen::Vector3d& x, int steps = 4)
{
  return std::sqrt(approach<1>(surface, surface.best_chart_point(p), x, steps).square);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// A point of the surface where the distance from x is at a local minimum: the one that descent from the
/// domain point `start` leads to. Newton steps that must come nearer; on the border of a disk the border is
/// followed.
/// \param surface  a `Manifold_surface`, twice differentiable
template <class Surface>
Closest_point<typename Surface::Domain_point> closest_point(const Surface& surface, const Eigen::Vector3d& x,
                                                            const typename Surface::Domain_point& start)
{
  return internal::closest_point_at(surface,
                                    internal::approach<2>(surface, surface.best_chart_point(start), x), x);
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Finds the points of a surface that are closest to points of space.
///
/// The constructor covers the surface with cells, each two triangles with corners on the surface and a
/// *slack*: the surface over the cell is taken to lie within that distance of the triangles. Cells are
/// quartered until their slack is 0.04 of their size or 1e-4 of the diagonal. A query searches each cell that
/// this bound does not exclude, by Newton steps from the point of the triangles closest to x, and returns the
/// best point that they lead to.
///
/// What is guaranteed: no point of a cell is closer to x than the result by more than a billionth of the
/// diagonal of the surface, if that cell's slack is right and Newton steps find the minimum in it; the cell
/// is nearly flat. The slack is twice the largest deviation at 25 of its points, so it is an estimate,
/// for embeddings of any kind: it can fail for details smaller than 1/64 of a tile that leave no trace at the
/// samples.
///
/// All members are const and may be called from several threads.
template <class Surface_>
class Closest_point_finder {
public:
  using Surface = Surface_;                            ///< the surface
  using Domain_point = typename Surface::Domain_point; ///< a point of the canonical surface
  using Result = Closest_point<Domain_point>;          ///< what a query returns

  /// \param surface  a `Manifold_surface`, twice differentiable, which must outlive the finder
  explicit Closest_point_finder(const Surface& surface) : surface_(surface), tree_(surface) {}
  explicit Closest_point_finder(const Surface&&) = delete;

  /// The surface.
  const Surface& surface() const { return surface_; }
  /// The cells that cover it.
  std::size_t number_of_cells() const { return tree_.number_of_cells(); }

  /// The point of the surface closest to `x`, any point of space. Where there are several, it is one of them.
  /// \pre the coordinates of `x` are finite
  Result operator()(const Eigen::Vector3d& x) const
  {
    CGAL_precondition(x.allFinite());
    const double tolerance = 1e-9 * tree_.diagonal();
    double distance = std::numeric_limits<double>::infinity();
    internal::Approach best;
    bool is_first = true; // whose distance may be infinite, if x is so far that squares overflow
    for (const auto& c : tree_.candidates(x)) {
      if (c.bound > distance - tolerance) break; // they are in the order of their bounds
      // a descent that leaves for other cells is theirs to make
      const double limit = distance * distance, reach = std::pow(2 * tree_.size(c), 2);
      const auto stop = [&, from = tree_.corner(c)](const internal::Approach& a) {
        return a.square >= limit && (a.jet.value - from).squaredNorm() > reach;
      };
      const Chart_point start = surface_.best_chart_point(tree_.domain_point(c));
      const internal::Approach a = internal::approach<2>(surface_, start, x, 40, stop);
      if (const double d = std::sqrt(a.square); d < distance || is_first) {
        distance = d;
        best = a;
        is_first = false;
      }
    }
    return internal::closest_point_at(surface_, best, x);
  }

private:
  using Tree = internal::Surface_box_tree<Surface>;

  const Surface& surface_;
  Tree tree_;
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The point of a surface that is closest to x; see `Closest_point_finder`, which is much faster for more
/// than one point.
template <class Surface>
Closest_point<typename Surface::Domain_point> closest_point(const Surface& surface, const Eigen::Vector3d& x)
{
  return Closest_point_finder<Surface>(surface)(x);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_CLOSEST_POINT_H
