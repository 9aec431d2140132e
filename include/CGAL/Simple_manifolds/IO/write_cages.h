// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_CAGES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_CAGES_H

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/cad/subdivision_cage.h>

#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes control meshes of quads as an OBJ file, as programs that model by subdivision read them, each as an object of its name, with all digits.
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
inline void write_cages(const std::string& file, const std::vector<std::pair<std::string, Quad_cage>>& cages)
{
  Atomic_file output(file);
  std::ostream& out = output.stream();
  int first = 1;
  for (const auto& [name, cage] : cages) {
    out << "o " << internal::word_of(name) << '\n';
    for (const Eigen::Vector3d& x : cage.points)
      out << "v " << internal::shortest(x[0]) << ' ' << internal::shortest(x[1]) << ' '
          << internal::shortest(x[2]) << '\n';
    for (const auto& q : cage.quads)
      out << "f " << q[0] + first << ' ' << q[1] + first << ' ' << q[2] + first << ' ' << q[3] + first
          << '\n';
    first += int(cage.points.size());
  }
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_CAGES_H
