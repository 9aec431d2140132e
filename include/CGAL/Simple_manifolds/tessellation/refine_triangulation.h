// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_REFINE_TRIANGULATION_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_REFINE_TRIANGULATION_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// How an adaptive tessellation ended.
struct Tessellation_report {
  bool is_fine_enough = false; ///< whether the criteria are met everywhere
  double worst = 0;            ///< the largest excess of a face: at most 1 if they are met
  int faces_left = 0;          ///< the number of faces with an excess above 1
  int vertices = 0;            ///< of the triangulation
  int faces = 0;               ///< of the triangulation
  int levels = 0;              ///< how often a face of the start grid was split into four, at most
};

/// The number of faces at which adaptive tessellations stop by default.
/// \ingroup PkgSimpleManifoldsTessellation
inline constexpr std::size_t default_max_faces = std::size_t(1) << 22;

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Splits the faces of a triangulation until a criterion is met (Grimm 2002, section 4.1). In each round all
/// faces with an excess above 1 are split; where this would make too many, those with the largest excess,
/// as long as more than a hundredth of `max_faces` is left.
///
/// \param sizing     a model of `TessellationSizing`
/// \param max_faces  no round makes more faces; what the triangulation has already stays
template <class Atlas, class Sizing>
Tessellation_report refine_triangulation(Domain_triangulation<Atlas>& triangulation, const Sizing& sizing,
                                         std::size_t max_faces = default_max_faces)
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(Sizing, Atlas);
  Tessellation_report report;
  std::vector<double> excess; // per face
  std::vector<int> all(triangulation.number_of_faces()), failing;
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = int(f);
  excess = internal::excess_of(sizing, triangulation, all);

  for (;;) {
    failing.clear();
    for (int f = 0; f < triangulation.number_of_faces(); ++f)
      if (excess[f] > 1 && triangulation.level(f) < Domain_triangulation<Atlas>::max_level)
        failing.push_back(f);
    if (failing.empty()) break;

    // a face that is split makes three more at least; the last percent is not worth a round
    const std::size_t faces = triangulation.number_of_faces();
    std::size_t room = faces < max_faces - max_faces / 100 ? (max_faces - faces) / 3 : 0;
    if (failing.size() > room)
      std::stable_sort(failing.begin(), failing.end(), [&](int f, int g) { return excess[f] > excess[g]; });
    bool is_refined = false;
    while (!is_refined && room > 0) {
      if (failing.size() > room) failing.resize(room);
      Domain_triangulation<Atlas> next = triangulation;
      next.refine(failing);
      is_refined = std::size_t(next.number_of_faces()) <= max_faces;
      if (is_refined)
        triangulation = std::move(next);
      else
        room = failing.size() / 2;
    }
    if (!is_refined) break;

    std::vector<double> known(triangulation.number_of_faces());
    std::vector<int> fresh;
    for (int f = 0; f < triangulation.number_of_faces(); ++f)
      if (triangulation.previous(f) == -1)
        fresh.push_back(f);
      else
        known[f] = excess[triangulation.previous(f)];
    const std::vector<double> measured = internal::excess_of(sizing, triangulation, fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i) known[fresh[i]] = measured[i];
    excess = std::move(known);
  }

  report.vertices = triangulation.number_of_vertices();
  report.faces = triangulation.number_of_faces();
  for (int f = 0; f < report.faces; ++f) {
    report.worst = (std::max)(report.worst, excess[f]);
    report.faces_left += excess[f] > 1;
    report.levels = (std::max)(report.levels, triangulation.level(f));
  }
  report.is_fine_enough = report.faces_left == 0;
  return report;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_REFINE_TRIANGULATION_H
