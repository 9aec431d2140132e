// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PARTITION_ERROR_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PARTITION_ERROR_H

#include <CGAL/Simple_manifolds/Error.h>

#include <string>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The steps of the paper's partitions, in order.
enum class Partition_step {
  DISKS,     ///< growing disks: the two caps of a sphere, the four disks of a torus
  LOOPS,     ///< the three parallel loops of a torus
  CORNERS,   ///< accessible, evenly spaced points on a loop
  PATHS,     ///< paths between the corners that do not cross
  TILES,     ///< flood fill, and the test that the tiles are disks that adjoin as they should
  PROJECTION ///< the vertices inside of the tiles
};

/// \ingroup PkgSimpleManifoldsPaper
///
/// A step of the paper's partition failed, which the paper says may happen (section 5.4): on meshes with thin
/// parts of few vertices, mostly. The code is `Error_code::partition_failed`.
class Partition_error : public Error {
public:
  /// \param why  part of the message
  Partition_error(Partition_step step, const std::string& why)
    : Error(Error_code::partition_failed, "the partition of the paper failed at its step '" + name(step) +
                                            "': " + why + "; the certified method does not need a partition"),
      step_(step)
  {
  }

  /// The step that failed.
  Partition_step step() const { return step_; }

  /// E.g. "paths".
  static std::string name(Partition_step step)
  {
    switch (step) {
    case Partition_step::DISKS:
      return "disks";
    case Partition_step::LOOPS:
      return "loops";
    case Partition_step::CORNERS:
      return "corners";
    case Partition_step::PATHS:
      return "paths";
    case Partition_step::TILES:
      return "tiles";
    default:
      return "projection";
    }
  }

private:
  Partition_step step_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_PARTITION_ERROR_H
