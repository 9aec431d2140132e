// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PATCH_STACK_EMBEDDING_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PATCH_STACK_EMBEDDING_H

#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An embedding of one chart that is a sum of spline patches: a base patch over the whole unit square
/// and any number of offset patches over rectangles of it (Grimm 2002, section 5).
///
/// \cgalModels{ChartEmbedding}
class Patch_stack_embedding {
public:
  /// \pre there is at least one patch
  explicit Patch_stack_embedding(std::vector<Spline_patch> patches)
    : patches_(std::move(patches)), smoothness_(maximum_spline_degree)
  {
    CGAL_precondition(!patches_.empty());
    for (const Spline_patch& patch : patches_) smoothness_ = (std::min)(smoothness_, patch.smoothness());
  }

  /// The base patch, then the offset patches.
  const std::vector<Spline_patch>& patches() const { return patches_; }
  /// The number of active functions of all patches.
  std::size_t number_of_coefficients() const
  {
    std::size_t n = 0;
    for (const Spline_patch& patch : patches_) n += patch.number_of_coefficients();
    return n;
  }

  /// The number of continuous derivatives: that of the least smooth patch.
  int smoothness() const { return smoothness_; }

  /// The position at any point of the plane.
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    Eigen::Vector3d e = patches_.front().point(uv);
    for (std::size_t k = 1; k < patches_.size(); ++k) e += patches_[k].point(uv);
    return e;
  }

  /// Position and derivatives; those of order higher than `Order` are zero.
  template <int Order = 2>
  Jet jet(const Eigen::Vector2d& uv) const
  {
    Jet e = patches_.front().jet<Order>(uv);
    for (std::size_t k = 1; k < patches_.size(); ++k) e += patches_[k].jet<Order>(uv);
    return e;
  }

private:
  std::vector<Spline_patch> patches_;
  int smoothness_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_PATCH_STACK_EMBEDDING_H
