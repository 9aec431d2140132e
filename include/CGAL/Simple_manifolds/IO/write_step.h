// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_STEP_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_STEP_H

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Step_options.h>
#include <CGAL/Simple_manifolds/IO/internal/Step_writer.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// A body of a STEP file.
struct Step_body {
  std::string name;    ///< UTF-8
  Cad_surface surface; ///< with one face at least
};

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes bodies as a STEP file (ISO 10303-21), which CAD systems read: a closed surface is a solid
/// (`MANIFOLD_SOLID_BREP`) with its normals outward, another one an open shell. Each body is a product of its name.
/// Faces are `B_SPLINE_SURFACE_WITH_KNOTS` with common edges and vertices, and edges have their lines in the parameters
/// of both faces. Numbers have as many digits as they need to be read back bit for bit; equal bodies give equal files,
/// in which the time is therefore not that of writing.
///
/// STEP has no statement on the smoothness between faces: programs that look for it find it by measuring.
///
/// \pre there is a body; `options.scale` is positive, colours are from 0 to 1
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
inline void write_step(const std::string& file, const std::vector<Step_body>& bodies,
                       const Step_options& options = Step_options())
{
  CGAL_precondition(!bodies.empty() && options.scale > 0 && std::isfinite(options.scale));
  CGAL_precondition(options.colour.minCoeff() >= 0 && options.colour.maxCoeff() <= 1);
  Atomic_file output(file);
  internal::Step_writer writer(output.stream(), options, bodies.front().name);
  for (const Step_body& body : bodies) writer.body(body.surface, body.name, options.colour);
  writer.end();
  output.commit();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same for one body, by the name "surface".
inline void write_step(const std::string& file, const Cad_surface& surface,
                       const Step_options& options = Step_options())
{
  write_step(file, std::vector<Step_body>{{"surface", surface}}, options);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_STEP_H
