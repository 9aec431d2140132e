// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_SIZING_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_SIZING_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/internal/triangle_distance.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The diagonal of the bounding box of a surface: the unit of the tolerances of a tessellation. It is taken
/// at the vertices of a grid of about 6000 cells.
/// \throw Geometry_error  `zero_extent` when all of these coincide, `extent_out_of_range` when their squared distances
///   leave the range of doubles
template <class Surface>
double surface_diagonal(const Surface& surface)
{
  using Grid = Tile_grid<typename Surface::Atlas>;
  std::vector<Eigen::Vector3d> points;
  const Grid grid(Grid::subdivisions_for(6000, surface.atlas()), surface.atlas());
  surface.points(grid.domain_points(), std::back_inserter(points));
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : points) box.extend(x);
  const double diagonal = box.diagonal().norm();
  if (!(diagonal > 0))
    throw Geometry_error(Error_code::zero_extent,
                         "the surface is a point: tolerances relative to its diagonal "
                         "have no meaning");
  if (!std::isfinite(diagonal))
    throw Geometry_error(Error_code::extent_out_of_range, "the diagonal of the surface is not finite");
  return diagonal;
}

namespace internal {

// The corners of some faces on the surface: evaluated once per vertex.
template <class Surface>
class Corner_points {
public:
  using Triangulation = Domain_triangulation<typename Surface::Atlas>; ///< what it measures faces of

  Corner_points(const Surface& surface, const Triangulation& t, const std::vector<int>& faces)
    : triangulation_(t), place_(t.number_of_vertices(), -1)
  {
    std::vector<typename Surface::Domain_point> domain_points;
    for (const int f : faces)
      for (const int v : t.triangles()[f])
        if (place_[v] == -1) {
          place_[v] = int(domain_points.size());
          domain_points.push_back(t.domain_points()[v]);
        }
    points_.reserve(domain_points.size());
    surface.points(domain_points, std::back_inserter(points_));
  }

  const Eigen::Vector3d& operator()(int f, int corner) const
  {
    return points_[place_[triangulation_.triangles()[f][corner]]];
  }

private:
  const Triangulation& triangulation_;
  std::vector<int> place_; // per vertex
  std::vector<Eigen::Vector3d> points_;
};

// Calls receive(i, d) for each of n faces with the largest distance d of its seven points, see `Chord_error`.
// corner(i, k): of face i; domain_point(i, b): at barycentric coordinates in it
template <class Surface, class Corner, class Domain_point, class Receive>
void chord_errors(const Surface& surface, std::size_t n, const Corner& corner,
                  const Domain_point& domain_point, const Receive& receive)
{
  static const std::array<Eigen::Vector3d, 7> places = {Eigen::Vector3d(.5, .5, 0),
                                                        Eigen::Vector3d(0, .5, .5),
                                                        Eigen::Vector3d(.5, 0, .5),
                                                        Eigen::Vector3d(1. / 3, 1. / 3, 1. / 3),
                                                        Eigen::Vector3d(2. / 3, 1. / 6, 1. / 6),
                                                        Eigen::Vector3d(1. / 6, 2. / 3, 1. / 6),
                                                        Eigen::Vector3d(1. / 6, 1. / 6, 2. / 3)};
  std::vector<typename Surface::Domain_point> domain_points;
  std::vector<Eigen::Vector3d> points;
  constexpr std::size_t batch = 1 << 12; // bounds the memory
  for (std::size_t first = 0; first < n; first += batch) {
    const std::size_t last = (std::min)(n, first + batch);
    domain_points.clear();
    points.clear();
    for (std::size_t i = first; i < last; ++i)
      for (const Eigen::Vector3d& b : places) domain_points.push_back(domain_point(i, b));
    surface.points(domain_points, std::back_inserter(points));
    auto x = points.begin();
    for (std::size_t i = first; i < last; ++i) {
      double squared = 0;
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double d = squared_distance_to_triangle(*x++, corner(i, 0), corner(i, 1), corner(i, 2));
        if (!(d <= squared) && !std::isnan(squared)) squared = d; // keeps what is not a number
      }
      receive(i, std::sqrt(squared));
    }
  }
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Faces must not be farther from the surface than a tolerance: the *chord error*, the distance from the
/// surface to the flat face, is measured at seven points of each face, the middles of its edges, its centre
/// and the points with barycentric coordinates (2/3,1/6,1/6) and its rotations.
///
/// Where a face is small against the radii of curvature, the surface is nowhere in it farther away than 1.1
/// times the largest of the seven distances. What lies between the points of faces that are larger than the
/// details of the surface can be missed: start with a finer grid.
///
/// \cgalModels{TessellationSizing}
template <class Surface>
class Chord_error {
public:
  using Triangulation = Domain_triangulation<typename Surface::Atlas>; ///< what it measures faces of

  /// \param surface    must outlive this
  /// \param tolerance  as a fraction of the diagonal of the bounding box of the surface
  /// \pre `tolerance > 0`
  Chord_error(const Surface& surface, double tolerance)
    : Chord_error(surface, tolerance, surface_diagonal(surface))
  {
  }

  /// The same with the tolerance as a fraction of the given length: of 1, when it is a length itself.
  Chord_error(const Surface& surface, double tolerance, double unit)
    : surface_(&surface), tolerance_(tolerance * unit)
  {
    CGAL_precondition(tolerance > 0 && unit > 0);
  }
  Chord_error(const Surface&&, double) = delete;
  Chord_error(const Surface&&, double, double) = delete;

  /// Sets `excess[i]` to the excess of face `faces[i]`, see `TessellationSizing`.
  void operator()(const Triangulation& t, const std::vector<int>& faces, std::vector<double>& excess) const
  {
    const internal::Corner_points<Surface> corner(*surface_, t, faces);
    internal::chord_errors(
      *surface_, faces.size(), [&](std::size_t i, int k) -> const auto& { return corner(faces[i], k); },
      [&](std::size_t i, const Eigen::Vector3d& b) { return t.point(faces[i], b); },
      [&](std::size_t i, double error) { excess[i] = error / tolerance_; });
  }

private:
  const Surface* surface_;
  double tolerance_;
};

/// \ingroup PkgSimpleManifoldsTessellation
///
/// How far a triangulation of the domain is from a surface: the largest chord error of its faces, see `Chord_error`, in the
/// units of the surface; not a number where the surface is none.
/// \param domain_points  the vertices
/// \param triangles      positions in `domain_points`; small against the domain
template <class Surface>
double largest_chord_error(const Surface& surface,
                           const std::vector<typename Surface::Domain_point>& domain_points,
                           const std::vector<Triangle>& triangles)
{
  std::vector<Eigen::Vector3d> points;
  points.reserve(domain_points.size());
  surface.points(domain_points, std::back_inserter(points));
  double largest = 0;
  internal::chord_errors(
    surface, triangles.size(), [&](std::size_t f, int k) -> const auto& { return points[triangles[f][k]]; },
    [&](std::size_t f, const Eigen::Vector3d& b) {
      const Triangle& t = triangles[f];
      return surface.atlas().interpolate(domain_points[t[0]], domain_points[t[1]], domain_points[t[2]], b);
    },
    [&](std::size_t, double error) {
      if (!(error <= largest) && !std::isnan(largest)) largest = error;
    });
  return largest;
}

/// \ingroup PkgSimpleManifoldsTessellation
///
/// The straight edges of faces must not be longer than a limit.
/// \cgalModels{TessellationSizing}
template <class Surface>
class Edge_length {
public:
  using Triangulation = Domain_triangulation<typename Surface::Atlas>; ///< what it measures faces of

  /// \param surface  must outlive this
  /// \param limit    as a fraction of the diagonal of the bounding box of the surface
  /// \pre `limit > 0`
  Edge_length(const Surface& surface, double limit) : Edge_length(surface, limit, surface_diagonal(surface))
  {
  }

  /// The same with the limit as a fraction of the given length: of 1, when it is a length itself.
  Edge_length(const Surface& surface, double limit, double unit) : surface_(&surface), limit_(limit * unit)
  {
    CGAL_precondition(limit > 0 && unit > 0);
  }
  Edge_length(const Surface&&, double) = delete;
  Edge_length(const Surface&&, double, double) = delete;

  /// Sets `excess[i]` to the excess of face `faces[i]`, see `TessellationSizing`.
  void operator()(const Triangulation& t, const std::vector<int>& faces, std::vector<double>& excess) const
  {
    const internal::Corner_points<Surface> corner(*surface_, t, faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Eigen::Vector3d &a = corner(faces[i], 0), &b = corner(faces[i], 1), &c = corner(faces[i], 2);
      excess[i] =
        std::sqrt((std::max)({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()})) / limit_;
    }
  }

private:
  const Surface* surface_;
  double limit_;
};

namespace internal {

// Whether a type has either form of a TessellationSizing.
template <class Sizing, class Atlas>
inline constexpr bool measures_many = std::is_invocable_v<const Sizing&, const Domain_triangulation<Atlas>&,
                                                          const std::vector<int>&, std::vector<double>&>;
template <class Sizing, class Atlas>
inline constexpr bool is_sizing =
  measures_many<Sizing, Atlas> ||
  std::is_invocable_r_v<double, const Sizing&, const Domain_triangulation<Atlas>&, int>;

// The excess of each of the faces, by either form of a TessellationSizing; infinite where it is not a number.
template <class Sizing, class Atlas>
std::vector<double> excess_of(const Sizing& sizing, const Domain_triangulation<Atlas>& t,
                              const std::vector<int>& faces)
{
  std::vector<double> excess(faces.size());
  if constexpr (measures_many<Sizing, Atlas>)
    sizing(t, faces, excess);
  else
    std::transform(faces.begin(), faces.end(), excess.begin(), [&](int f) { return double(sizing(t, f)); });
  for (double& e : excess)
    if (std::isnan(e)) e = std::numeric_limits<double>::infinity();
  return excess;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Several criteria at once: all must be met.
/// \tparam Sizings  models of `TessellationSizing`
/// \cgalModels{TessellationSizing}
template <class... Sizings>
class Combined_sizing {
public:
  /// The criteria are copied.
  explicit Combined_sizing(Sizings... sizings) : sizings_(std::move(sizings)...) {}

  /// Sets `excess[i]` to the largest excess of face `faces[i]`.
  template <class Atlas>
  void operator()(const Domain_triangulation<Atlas>& t, const std::vector<int>& faces,
                  std::vector<double>& excess) const
  {
    std::fill(excess.begin(), excess.end(), 0.);
    const auto add = [&](const auto& sizing) {
      const std::vector<double> e = internal::excess_of(sizing, t, faces);
      for (std::size_t i = 0; i < excess.size(); ++i) excess[i] = (std::max)(excess[i], e[i]);
    };
    std::apply([&](const auto&... sizing) { (add(sizing), ...); }, sizings_);
  }

private:
  std::tuple<Sizings...> sizings_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_SIZING_H
