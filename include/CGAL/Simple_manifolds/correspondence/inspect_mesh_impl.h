// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_IMPL_H

#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/close_borders.h>
#include <CGAL/Simple_manifolds/internal/Components.h>
#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/faces_of_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/surface_faults.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

class Mesh_inspector {
public:
  explicit Mesh_inspector(const Mesh_soup& soup) : soup_(soup), components_(soup), parts_(components_.number)
  {
    whole_.faults = surface_faults(soup, components_, faults_);
  }

  Mesh_inspection operator()()
  {
    measure_faces();
    look_at_vertices();
    look_at_edges();
    find_loops();
    for (int c = 0; c < components_.number; ++c) {
      Inspected_component& part = parts_[c];
      part.faults = std::move(faults_[c]);
      std::stable_sort(part.loops.begin(), part.loops.end(),
                       [](const Border_loop& a, const Border_loop& b) { return a.length > b.length; });
      whole_.vertices += part.vertices;
      whole_.edges += part.edges;
      whole_.area += part.area;
      whole_.box.extend(part.box);
    }
    whole_.faces = static_cast<std::size_t>(soup_.number_of_faces());
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const auto& a, const auto& b) { return a.faces > b.faces; });
    for (std::size_t c = 0; c < parts_.size(); ++c) parts_[c].name = "part-" + std::to_string(c + 1);
    whole_.components = std::move(parts_);
    return std::move(whole_);
  }

private:
  const Eigen::Vector3d& point(int h) const { return soup_.points[soup_.source(h)]; }
  int component(int h) const { return components_.of_face[soup_.face(h)]; }

  void measure_faces()
  {
    for (int f = 0; f < soup_.number_of_faces(); ++f) {
      Inspected_component& part = parts_[components_.of_face[f]];
      if (part.faces++ == 0) part.first_face = static_cast<std::size_t>(f);
      if (soup_.number_of_corners(f) == 0) continue;
      Eigen::Vector3d normal(0, 0, 0);
      const Eigen::Vector3d& origin = point(soup_.first(f));
      for (int h = soup_.first(f) + 1; h < soup_.last(f); ++h)
        normal += (point(h) - origin).cross(point(h + 1) - origin);
      part.area += normal.stableNorm() / 2;
    }
  }

  void look_at_vertices()
  {
    std::vector<char> is_used(soup_.number_of_vertices(), false);
    for (int h = 0; h < soup_.number_of_half_edges(); ++h) {
      if (std::exchange(is_used[soup_.source(h)], true)) continue;
      Inspected_component& part = parts_[component(h)];
      ++part.vertices;
      if (point(h).allFinite()) part.box.extend(point(h));
    }
    whole_.unused_vertices =
      static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), static_cast<char>(false)));
  }

  // Whether an orientation of all faces agrees, as long as edges have two of them.
  void look_at_edges()
  {
    Two_sided_union_find sides(soup_.number_of_faces());
    std::vector<char> is_one_sided(components_.number, false);
    for_each_edge(soup_, [&](auto begin, auto end) {
      const int g = begin->second, h = (end - 1)->second, c = component(g);
      ++parts_[c].edges;
      if (end - begin == 1) border_.push_back(g);
      if (end - begin != 2 || soup_.source(g) == soup_.target(g)) return;
      if (!sides.join(soup_.face(g), soup_.face(h), soup_.source(g) == soup_.source(h)))
        is_one_sided[c] = true;
    });
    for (int c = 0; c < components_.number; ++c) {
      faults_[c].one_sided_components = is_one_sided[c];
      whole_.faults.one_sided_components += is_one_sided[c];
    }
  }

  // Border edges that hang together, whatever their directions.
  void find_loops()
  {
    std::sort(border_.begin(), border_.end());
    Union_find curves(soup_.number_of_vertices());
    for (int h : border_) curves.join(soup_.source(h), soup_.target(h));
    struct Curve {
      int component;
      Border_loop loop;
      Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // the sum, at first
      double cone = 0;
    };
    std::vector<int> number(soup_.number_of_vertices(), -1); // of a curve, by its root
    std::vector<Curve> found;
    const auto curve = [&](int h) -> Curve& { return found[number[curves.root(soup_.source(h))]]; };
    for (int h : border_) {
      int& n = number[curves.root(soup_.source(h))];
      if (n == -1) {
        n = static_cast<int>(found.size());
        found.push_back({component(h), {}});
      }
      Curve& c = curve(h);
      ++c.loop.edges;
      c.loop.length += (soup_.points[soup_.target(h)] - point(h)).stableNorm();
      c.centre += point(h) / 2 + soup_.points[soup_.target(h)] / 2;
    }
    for (Curve& c : found) c.centre /= static_cast<double>(c.loop.edges);
    for (int h : border_) {
      Curve& c = curve(h);
      c.cone += (point(h) - c.centre).cross(soup_.points[soup_.target(h)] - c.centre).stableNorm() / 2;
    }
    for (Curve& c : found) {
      c.loop.is_small = c.cone <= small_share_of_area * parts_[c.component].area;
      parts_[c.component].loops.push_back(c.loop);
    }
  }

  const Mesh_soup& soup_;
  Components components_;
  std::vector<Surface_faults> faults_; // per component
  std::vector<Inspected_component> parts_;
  std::vector<int> border_; // half-edges
  Mesh_inspection whole_;
};

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE long Inspected_component::genus() const
{
  CGAL_precondition(is_surface());
  return (2 - static_cast<long>(loops.size()) - euler_characteristic()) / 2;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::string_view
Inspected_component::canonical_surface(Close_borders closed) const
{
  if (!is_surface()) return {};
  const auto open = closed == Close_borders::ALL     ? 0
                    : closed == Close_borders::INNER ? static_cast<std::ptrdiff_t>(!loops.empty())
                    : closed == Close_borders::SMALL
                      ? std::count_if(loops.begin(), loops.end(), [](const auto& l) { return !l.is_small; })
                      : static_cast<std::ptrdiff_t>(loops.size());
  std::string_view surface;
  if (open <= 1)
    Canonical_surfaces::visit_topology(open == 0, genus(),
                                       [&](auto type) { surface = decltype(type)::Atlas::name; });
  return surface;
}

CGAL_SIMPLE_MANIFOLDS_INLINE std::string Inspected_component::sentence() const
{
  if (faults.one_sided_components > 0) return "one-sided";
  if (!is_surface()) return "no oriented surface";
  const std::string border = loops.empty()       ? "closed"
                             : loops.size() == 1 ? "1 border"
                                                 : std::to_string(loops.size()) + " borders";
  return border + ", genus " + std::to_string(genus());
}

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_inspection inspect_soup(const Mesh_soup& soup)
{
  for (int f = 0; f < soup.number_of_faces(); ++f)
    if (!internal::has_its_vertices(soup, f)) {
      Mesh_inspection result;
      result.faces = static_cast<std::size_t>(soup.number_of_faces());
      result.faults = internal::surface_faults(soup);
      return result;
    }
  return internal::Mesh_inspector(soup)();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INSPECT_MESH_IMPL_H
