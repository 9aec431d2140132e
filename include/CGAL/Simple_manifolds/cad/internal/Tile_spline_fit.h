// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_H

#include <CGAL/Simple_manifolds/cad/internal/Tile_spline.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_stiffness.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// What a spline is fitted to on a cell.
struct Cell_samples {
  std::vector<Eigen::Vector2d> places; ///< on the tile
  std::vector<Eigen::Vector3d> values;
  std::size_t measured = 0; ///< the first ones, which the errors are of; others only steady the fit
  double steadying = 1;     ///< the weight of these others; that of the first ones is 1

  double weight() const { return double(measured) + steadying * double(places.size() - measured); }
};

/// Least squares by hierarchical splines, with exact smoothness between tiles. Where the error is too large cells are
/// refined, and all is solved again.
class Tile_spline_fit {
public:
  /// Finds the samples of cells, one element per cell.
  using Sampler = std::function<std::vector<Cell_samples>(const std::vector<Tile_cell>&)>;

  struct Options {
    double max_error = 0; ///< at samples, in the units of the values
    double rms_error = 0; ///< the same; infinite: no matter
    std::size_t max_functions = 0;
    bool is_smooth_across_tiles = false;
    bool has_threads = false;
  };

  enum class Stop { TOLERANCE, FUNCTIONS, LEVELS };

  struct Solution {
    Tile_spline spline;
    double rms_error = 0, max_error = 0;
    Eigen::Vector3d worst_value = Eigen::Vector3d::Zero(); ///< the sample with the largest error
    Stop stop = Stop::TOLERANCE;                           ///< why it is not refined
  };

  /// \param check  more samples, which a fit that is within the tolerance at the others is tested at; may be empty
  Tile_spline_fit(const Tile_spline_space& space, const Options& options, Sampler sampler, Sampler check);

  /// Fits once, and finds the errors.
  void solve();

  /// Refines the cells whose error is too large.
  /// \return whether there were any, and cells that can be refined
  bool refine();

  /// Refines the cells with points at which something else has found too large an error.
  /// \return likewise
  bool refine_at(const std::vector<Tile_point>& points);

  /// Makes the spline stiffer round some points.
  /// \return whether it was not as stiff as it may be
  bool stiffen_at(const std::vector<Tile_point>& points)
  {
    return stiffness_.add(solution_.spline.space, points);
  }

  const Solution& solution() const { return solution_; }
  const Tile_spline& spline() const { return solution_.spline; }

private:
  struct Error {
    double sum = 0, max = 0; // of squares, of distances
    std::size_t count = 0;
    Eigen::Vector3d worst = Eigen::Vector3d::Zero();
  };

  Error error(const Tile_spline_space::Leaf& leaf, const Cell_samples& samples) const;
  std::vector<Error> errors(const Sampler& sampler, std::unordered_map<std::uint64_t, Cell_samples>& known);
  void find_samples(const Sampler& sampler, std::unordered_map<std::uint64_t, Cell_samples>& known) const;
  std::vector<Tile_cell> marked(const std::vector<Error>& errors, bool with_rms) const;
  bool refine(const std::vector<Tile_cell>& cells);

  Solution solution_;
  Options options_;
  Sampler sampler_, check_;
  Tile_stiffness stiffness_;
  std::unordered_map<std::uint64_t, Cell_samples> samples_, checks_;
  std::vector<Error> errors_; // per leaf
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_INTERNAL_TILE_SPLINE_FIT_H
