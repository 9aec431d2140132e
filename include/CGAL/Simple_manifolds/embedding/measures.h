// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MEASURES_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MEASURES_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An integral over a surface.
struct Integral {
  double value; ///< the integral
  /// An estimate of |value - integral over this surface|, on the safe side: the changes that the last refinement
  /// of the cells made, summed without signs, while `value` has that refinement in it. It says nothing of how
  /// far the surface is from the mesh that it was fitted to: see `Fit_report`.
  double quadrature_error;
};

namespace internal {

// Integrals over the tiles by Gauss-Legendre quadrature on quadtrees: each cell compares one rule of 4 x 4
// nodes with the four of its quarters, and the worst cells are quartered.
template <class ConcurrencyTag, int Order, class Surface, class Density>
class Tile_quadrature {
public:
  // density(jet) is the integrand per du dv of the chart of the jet
  Tile_quadrature(const Surface& surface, const Density& density) : surface_(surface), density_(density) {}

  Integral operator()(double relative_error) const
  {
    std::vector<Cell> cells;
    for (int tile = 0; tile < surface_.atlas().number_of_charts(); ++tile)
      for (int i = 0; i < first_cells; ++i)
        for (int j = 0; j < first_cells; ++j) cells.push_back({tile, i, j, 1. / first_cells, 0, {}});
    for (Cell& c : cells) c.coarse = rule(c.tile, c.i, c.j, c.size);
    refine(cells, 0);
    for (;;) {
      double value = 0, error = 0, scale = 0;
      for (const Cell& c : cells) {
        value += c.fine();
        error += c.error();
        scale += std::abs(c.fine());
      }
      const double target = relative_error * scale;
      if (!(error > target) || cells.size() > max_cells || !split_worst(cells, target / 2))
        return {value, error + rounding * scale};
    }
  }

private:
  using Atlas = typename Surface::Atlas;
  using Domain_point = typename Surface::Domain_point;
  static constexpr int first_cells = 4; // per side of a tile
  static constexpr std::size_t max_cells = 100000;
  static constexpr double smallest = 1. / (1 << 20);
  static constexpr double rounding = 1e-14;

  // The square [i,i+1] x [j,j+1], times its size, of a tile.
  struct Cell {
    int tile, i, j;
    double size, coarse;
    std::array<double, 4> quarters;

    double fine() const { return (quarters[0] + quarters[1]) + (quarters[2] + quarters[3]); }
    double error() const { return std::abs(coarse - fine()); }
  };

  // Quarters the worst cells, so that the errors of the others sum to at most `rest`; false if there are none.
  bool split_worst(std::vector<Cell>& cells, double rest) const
  {
    std::vector<int> order;
    for (int k = 0; k < int(cells.size()); ++k)
      if (cells[k].size > smallest) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return cells[a].error() < cells[b].error(); });
    std::size_t kept = 0;
    for (; kept < order.size() && cells[order[kept]].error() <= rest; ++kept)
      rest -= cells[order[kept]].error();
    order.erase(order.begin(), order.begin() + kept);
    if (order.empty()) return false;
    std::sort(order.begin(), order.end());
    const std::size_t first = cells.size();
    cells.reserve(first + 4 * order.size());
    for (int k : order)
      for (int q = 0; q < 4; ++q) {
        const Cell& c = cells[k];
        cells.push_back({c.tile, 2 * c.i + q / 2, 2 * c.j + q % 2, c.size / 2, c.quarters[q], {}});
      }
    refine(cells, first);
    std::size_t end = 0; // the quartered cells go
    for (std::size_t k = 0, next = 0; k < cells.size(); ++k) {
      if (next < order.size() && std::size_t(order[next]) == k)
        ++next;
      else
        cells[end++] = cells[k];
    }
    cells.resize(end);
    return true;
  }

  // fills in the quarters of the cells from `first` on
  void refine(std::vector<Cell>& cells, std::size_t first) const
  {
    parallel_for<ConcurrencyTag>(4 * int(first), 4 * int(cells.size()), [&](int begin, int end) {
      for (int k = begin; k < end; ++k) {
        Cell& c = cells[k / 4];
        const int q = k % 4;
        c.quarters[q] = rule(c.tile, 2 * c.i + q / 2, 2 * c.j + q % 2, c.size / 2);
      }
    });
  }

  double rule(int tile, int i, int j, double size) const
  {
    constexpr double x[] = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                            0.930568155797026288};
    constexpr double w[] = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                            0.173927422568726929};
    double sum = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) sum += w[a] * w[b] * value(tile, (i + x[a]) * size, (j + x[b]) * size);
    return sum * size * size;
  }

  // the integrand per ds dt
  double value(int tile, double s, double t) const
  {
    const Domain_point p = surface_.atlas().tile_point(tile, s, t);
    const auto chart = surface_.atlas().chart(surface_.atlas().best_chart(p)).jet_at(p);
    return density_(surface_.template jet<Order>(p)) * surface_.atlas().tile_area_element(tile, s, t) /
           surface_.atlas().area_element(chart);
  }

  const Surface& surface_;
  const Density& density_;
};

template <class ConcurrencyTag, int Order, class Surface, class Density, class NamedParameters>
Integral integrate_density(const Surface& surface, const Density& density, const NamedParameters& np)
{
  const double relative_error = parameter(np, internal_np::relative_error, 1e-6);
  CGAL_precondition(relative_error >= 0);
  return Tile_quadrature<ConcurrencyTag, Order, Surface, Density>(surface, density)(relative_error);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The integral of a function over the area of a surface, by adaptive Gauss-Legendre quadrature of the tiles.
///
/// The result has the same bits for any number of threads.
///
/// \tparam ConcurrencyTag  `Sequential_tag` (default), `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam Order           the highest order of the derivatives that `f` uses, 1 or 2
/// \param surface  a `Manifold_surface`
/// \param f        `double f(const Jet&)`; finite, and independent of the chart. With `Parallel_tag` it is
///                 called from several threads.
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{relative_error} \cgalParamDescription{the error of the quadrature at which refinement
///     stops, as a fraction of the integral of |f|. It also stops at 100,000 cells of 64 evaluations;
///     `Integral::quadrature_error` tells what was reached.} \cgalParamType{`double`, not negative}
///     \cgalParamDefault{1e-6} \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class ConcurrencyTag = Sequential_tag, int Order = 2, class Surface, class Function,
          class NamedParameters = parameters::Default_named_parameters>
Integral integrate(const Surface& surface, const Function& f,
                   const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "relative_error");
  return internal::integrate_density<ConcurrencyTag, Order>(
    surface, [&f](const Jet& e) { return f(e) * area_element(e); }, np);
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The area of a surface. Tag and named parameters are those of `integrate()`.
template <class ConcurrencyTag = Sequential_tag, class Surface,
          class NamedParameters = parameters::Default_named_parameters>
Integral area(const Surface& surface, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "relative_error");
  return internal::integrate_density<ConcurrencyTag, 1>(
    surface, [](const Jet& e) { return area_element(e); }, np);
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The volume inside of a closed surface, positive if its normals point outward: a third of the flux of the
/// position. Where the surface intersects itself, parts count with the number of times that they are
/// enclosed. Tag and named parameters are those of `integrate()`.
/// \pre the surface is closed: on other atlases this function does not compile
template <class ConcurrencyTag = Sequential_tag, class Surface,
          class NamedParameters = parameters::Default_named_parameters>
Integral volume(const Surface& surface, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "relative_error");
  using Atlas = typename Surface::Atlas;
  static_assert(Atlas::is_closed, "a surface with a border has no inside");
  // relative to a point in the middle, so that a body far from the origin keeps its digits
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const int tiles = surface.atlas().number_of_charts();
  for (int tile = 0; tile < tiles; ++tile)
    middle += surface.point(surface.atlas().tile_point(tile, 0.5, 0.5)) / tiles;
  return internal::integrate_density<ConcurrencyTag, 1>(
    surface, [&middle](const Jet& e) { return (e.value - middle).dot(e.u.cross(e.v)) / 3; }, np);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MEASURES_H
