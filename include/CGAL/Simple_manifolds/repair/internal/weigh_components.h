// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WEIGH_COMPONENTS_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WEIGH_COMPONENTS_H

#include <CGAL/Simple_manifolds/internal/Components.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>
#include <CGAL/Simple_manifolds/repair/internal/extent_of_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/orient_faces.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What a component is as a body; lengths in the unit of scale_of_faces().
struct Component_measure {
  std::size_t faces = 0;
  double area = 0;
  double volume = 0; // six times; negative: the faces are turned inside
  bool is_closed = true;
  Eigen::AlignedBox3d box;
};

inline std::vector<Component_measure> measure_components(const Mesh_soup& soup, const Components& components,
                                                         const std::vector<int>& glued)
{
  std::vector<Component_measure> measures(components.number);
  const double scale = scale_of_faces(soup);
  std::vector<Eigen::Vector3d> origin(components.number); // near to the body, for the digits of its volume
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    const int c = components.of_face[f], first = soup.first(f);
    Component_measure& m = measures[c];
    if (soup.number_of_corners(f) == 0) continue;
    const auto point = [&](int h) { return Eigen::Vector3d(scale * soup.points[soup.source(h)]); };
    if (m.faces++ == 0) origin[c] = point(first);
    Eigen::Vector3d normal(0, 0, 0);
    for (int h = first; h <= soup.last(f); ++h) {
      m.box.extend(point(h));
      m.is_closed = m.is_closed && glued[h] != -1;
      normal += (point(h) - point(first)).cross(point(soup.next(h)) - point(first));
    }
    m.area += normal.norm() / 2;
    m.volume += (point(first) - origin[c]).dot(normal);
  }
  return measures;
}

// Turns closed components with a negative volume inside out, with all components in their bounding boxes.
inline void orient_outward(Soup_in_repair& r)
{
  std::vector<int> glued = glued_half_edges(r.soup);
  const Components components(r.soup);
  const std::vector<Component_measure> measures = measure_components(r.soup, components, glued);
  const auto size = [&](int c) { // a number for any coordinates
    const double d = measures[c].box.diagonal().norm();
    return d >= 0 ? d : 0;
  };
  std::vector<int> order; // the closed ones, the largest first
  for (int c = 0; c < components.number; ++c)
    if (measures[c].is_closed) order.push_back(c);
  std::stable_sort(order.begin(), order.end(), [&](int c, int d) { return size(c) > size(d); });

  // Outer components decide for those inside of them. Only the largest ones are asked, so that time stays linear.
  const std::size_t most_outer = 1000;
  std::vector<int> outer;
  std::vector<char> is_inverted(components.number, false), is_turned(r.soup.number_of_faces(), false);
  for (int c : order) {
    const auto around = std::find_if(outer.begin(), outer.end(), [&](int o) {
      return measures[o].box.contains(measures[c].box) && !measures[c].box.contains(measures[o].box);
    });
    is_inverted[c] = around != outer.end() ? is_inverted[*around] : measures[c].volume < 0;
    if (around == outer.end() && outer.size() < most_outer) outer.push_back(c);
  }
  for (int f = 0; f < r.soup.number_of_faces(); ++f) is_turned[f] = is_inverted[components.of_face[f]];
  turn_faces(r, is_turned, glued);
}

// Drops components that have both fewer faces and less area than a share of the largest ones. Returns whether there were
// any.
inline bool drop_debris(Soup_in_repair& r, double share)
{
  const Components components(r.soup);
  if (components.number < 2) return false;
  const std::vector<Component_measure> measures =
    measure_components(r.soup, components, std::vector<int>(r.soup.number_of_half_edges(), -1));
  Component_measure largest;
  for (const Component_measure& m : measures) {
    largest.faces = (std::max)(largest.faces, m.faces);
    largest.area = (std::max)(largest.area, m.area);
  }
  const auto is_debris = [&](const Component_measure& m) {
    return static_cast<double>(m.faces) < share * static_cast<double>(largest.faces) &&
           m.area < share * largest.area;
  };
  std::vector<char> is_kept(r.soup.number_of_faces(), true), is_noted(components.number, false);
  bool is_clean = true;
  for (int f = 0; f < r.soup.number_of_faces(); ++f) {
    const int c = components.of_face[f];
    if (!is_debris(measures[c])) continue;
    if (!is_noted[c]) r.note_face(r.report.dropped_debris, f);
    is_noted[c] = true;
    ++r.report.dropped_debris_faces;
    is_kept[f] = is_clean = false;
  }
  if (!is_clean) r.keep_faces(is_kept);
  return !is_clean;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WEIGH_COMPONENTS_H
