// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_STEP_OPTIONS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_STEP_OPTIONS_H

#include <Eigen/Core>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// The unit of length of a STEP file.
enum class Step_unit { MILLIMETRE, CENTIMETRE, METRE, INCH };

/// \ingroup PkgSimpleManifoldsIO
///
/// The application protocol of a STEP file.
enum class Step_schema {
  AP214, ///< AUTOMOTIVE_DESIGN, ISO 10303-214: the older one, which all programs read
  AP242  ///< MANAGED_MODEL_BASED_3D_ENGINEERING, ISO 10303-242
};

/// \ingroup PkgSimpleManifoldsIO
///
/// How `write_step()` writes bodies.
struct Step_options {
  Step_unit unit = Step_unit::MILLIMETRE;    ///< what a coordinate of 1 is
  double scale = 1;                          ///< coordinates are multiplied by it, positive
  Step_schema schema = Step_schema::AP214;   ///< the application protocol
  Eigen::Vector3d colour = {0.7, 0.75, 0.8}; ///< red, green, blue, from 0 to 1
};

/// \ingroup PkgSimpleManifoldsIO
///
/// The length of a unit in millimetres, by which kernels measure: their tolerances are from 1e-7 to 1e-3, so that models
/// smaller than 1 or larger than 1e5 lose details there.
inline double millimetres(Step_unit unit)
{
  switch (unit) {
  case Step_unit::CENTIMETRE:
    return 10;
  case Step_unit::METRE:
    return 1000;
  case Step_unit::INCH:
    return 25.4;
  default:
    return 1;
  }
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_STEP_OPTIONS_H
