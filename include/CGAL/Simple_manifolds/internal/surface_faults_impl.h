// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_IMPL_H

#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/internal/faces_of_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/surface_faults.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

class Fault_finder {
public:
  using Kind = Located_elements Surface_faults::*;

  // components, of_component: null where components are not asked for.
  Fault_finder(const Mesh_soup& soup, bool knows_points, const Components* components = nullptr,
               std::vector<Surface_faults>* of_component = nullptr)
    : soup_(soup), knows_points_(knows_points), components_(components), of_component_(of_component)
  {
    if (components) of_component->resize(components->number);
  }

  Surface_faults operator()()
  {
    look_at_faces();
    if (faults_.missing_vertices.count > 0) return std::move(faults_); // all else has no meaning
    if (knows_points_) look_at_points();
    look_at_edges();
    return std::move(faults_);
  }

private:
  Eigen::Vector3d place(int v) const
  {
    return knows_points_ && v >= 0 && v < soup_.number_of_vertices()
             ? soup_.points[v]
             : Eigen::Vector3d(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  // face: one that the element belongs to.
  void add(Kind kind, int face, Mesh_element element, const Eigen::Vector3d& where)
  {
    (faults_.*kind).add(element, where);
    if (components_) ((*of_component_)[components_->of_face[face]].*kind).add(element, where);
  }
  void add_face(Kind kind, int f)
  {
    Eigen::Vector3d centre(0, 0, 0);
    for (int h = soup_.first(f); h <= soup_.last(f); ++h) centre += place(soup_.source(h));
    add(kind, f, Mesh_element::face(f), centre / (soup_.last(f) - soup_.first(f) + 1));
  }
  void add_edge(Kind kind, int h)
  {
    const int a = soup_.source(h), b = soup_.target(h);
    add(kind, soup_.face(h), Mesh_element::edge(a, b), place(a) / 2 + place(b) / 2);
  }

  void look_at_points()
  {
    std::vector<int> face(soup_.number_of_vertices(), -1); // one that uses it
    for (int h = soup_.number_of_half_edges() - 1; h >= 0; --h) face[soup_.source(h)] = soup_.face(h);
    for (int v = 0; v < soup_.number_of_vertices(); ++v)
      if (face[v] != -1 && !soup_.points[v].allFinite())
        add(&Surface_faults::non_finite_vertices, face[v], Mesh_element::vertex(v), soup_.points[v]);
  }

  void look_at_faces()
  {
    for (int f = 0; f < soup_.number_of_faces(); ++f) {
      if (!has_its_vertices(soup_, f)) {
        add_face(&Surface_faults::missing_vertices, f);
        continue;
      }
      const int corners = soup_.last(f) - soup_.first(f) + 1;
      if (corners >= 3 && repeated_vertex(soup_, f) == -1) continue;
      add_face(vertices_of_face(soup_, f).size() < 3 ? &Surface_faults::degenerate_faces
                                                     : &Surface_faults::repeated_corners,
               f);
      is_improper_.resize(soup_.number_of_faces(), false);
      is_improper_[f] = true;
    }
  }
  bool is_improper(int h) const { return !is_improper_.empty() && is_improper_[soup_.face(h)]; }

  // Of the other faces: an edge that a face has twice tells nothing.
  void look_at_edges()
  {
    fans_ = Union_find(soup_.number_of_half_edges());
    is_on_bad_edge_.assign(soup_.number_of_vertices(), false);
    std::vector<std::pair<int, int>> proper;
    for_each_edge(soup_, [&](auto begin, auto end) {
      if (is_improper_.empty()) return look_at_edge(begin, end);
      proper.clear();
      std::copy_if(begin, end, std::back_inserter(proper),
                   [&](const auto& i) { return !is_improper(i.second); });
      if (!proper.empty()) look_at_edge(proper.begin(), proper.end());
    });

    std::vector<int> fan(soup_.number_of_vertices(), -1); // the first one; -2: there are several
    std::vector<int> corner(soup_.number_of_vertices(), -1);
    for (int h = 0; h < soup_.number_of_half_edges(); ++h) {
      if (is_improper(h)) continue;
      int& first = fan[soup_.source(h)];
      corner[soup_.source(h)] = h;
      const int root = fans_.root(h);
      if (first == -1)
        first = root;
      else if (first != root)
        first = -2;
    }
    for (int v = 0; v < soup_.number_of_vertices(); ++v)
      if (fan[v] == -2 && !is_on_bad_edge_[v])
        add(&Surface_faults::non_manifold_vertices, soup_.face(corner[v]), Mesh_element::vertex(v), place(v));
  }

  template <class Iterator>
  void look_at_edge(Iterator begin, Iterator end)
  {
    const int g = begin->second, h = (end - 1)->second;
    if (end - begin > 2) {
      add_edge(&Surface_faults::non_manifold_edges, g);
      is_on_bad_edge_[soup_.source(g)] = is_on_bad_edge_[soup_.target(g)] = true;
    } else if (end - begin == 2) {
      const bool is_opposite = soup_.source(g) != soup_.source(h);
      if (!is_opposite) add_edge(&Surface_faults::inconsistent_edges, g);
      fans_.join(g, is_opposite ? soup_.next(h) : h);
      fans_.join(soup_.next(g), is_opposite ? h : soup_.next(h));
    }
    for_each_duplicate(soup_, begin, end, [&](int, int f) {
      const bool is_pillow = end - begin == 2 && soup_.source(g) != soup_.source(h) &&
                             soup_.last(f) - soup_.first(f) > 2; // two sides of a polygon are a sphere
      if (!is_pillow) add_face(&Surface_faults::duplicate_faces, f);
    });
  }

  const Mesh_soup& soup_;
  bool knows_points_;
  const Components* components_;
  std::vector<Surface_faults>* of_component_;
  Surface_faults faults_;
  std::vector<char> is_improper_; // per face; empty: none is
  Union_find fans_{0};            // of corners, which neighbours in a face's edge join
  std::vector<char> is_on_bad_edge_;
};

CGAL_SIMPLE_MANIFOLDS_INLINE Surface_faults surface_faults(const Mesh_soup& soup, bool knows_points)
{
  return Fault_finder(soup, knows_points)();
}

CGAL_SIMPLE_MANIFOLDS_INLINE Surface_faults surface_faults(const Mesh_soup& soup,
                                                           const Components& components,
                                                           std::vector<Surface_faults>& of_component)
{
  return Fault_finder(soup, true, &components, &of_component)();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_IMPL_H
