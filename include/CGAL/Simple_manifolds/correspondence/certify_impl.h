// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_IMPL_H

#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <string>

namespace CGAL {
namespace Simple_manifolds {

CGAL_SIMPLE_MANIFOLDS_INLINE std::string Certificate::sentence() const
{
  if (is_valid())
    return "the map is one to one: all " + std::to_string(faces) + " faces are positive, degree 1" +
           (area_is_exact ? ", total area exactly 1" : "");
  std::string s = "the map is not one to one";
  const char* separator = ": ";
  const auto add = [&](bool wrong, const std::string& what) {
    if (wrong) {
      s += separator + what;
      separator = "; ";
    }
  };
  add(!topology_ok, topology_message);
  std::string names;
  for (int v : offending_vertices) names += " " + std::to_string(v);
  add(out_of_range > 0,
      std::to_string(out_of_range) + " vertices have no point of the domain, first:" + names);
  names.clear();
  for (int f : offending_faces) names += " " + std::to_string(f);
  const std::string lifts = unliftable > 0 ? ", " + std::to_string(unliftable) + " not liftable" : "";
  add(flipped + degenerate + unliftable > 0, std::to_string(flipped) + " flipped, " +
                                               std::to_string(degenerate) + " degenerate" + lifts + " of " +
                                               std::to_string(faces) + " faces, first:" + names);
  add(flipped == faces && faces > 0, "all faces are negative, the map has the opposite orientation");
  add(!border_ok && !border_message.empty(), border_message);
  add(!degree_is_one && topology_ok && out_of_range == 0, "degree " + std::to_string(degree));
  return s;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_IMPL_H
