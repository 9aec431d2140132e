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
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/surface_faults.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether all corners of a face are vertices.
template <class Soup>
bool has_its_vertices(const Soup& soup, int f)
{
  for (int h = soup.first(f); h <= soup.last(f); ++h)
    if (soup.source(h) < 0 || soup.source(h) >= soup.number_of_vertices()) return false;
  return true;
}

// The different vertices of a face, sorted.
template <class Soup>
std::vector<int> vertices_of_face(const Soup& soup, int f)
{
  std::vector<int> v;
  for (int h = soup.first(f); h <= soup.last(f); ++h) v.push_back(soup.source(h));
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
  return v;
}

// The corners of a face from its least vertex on, towards the lesser one of the two beside it: faces with the same
// corners in the same order, or in the opposite one, have the same.
// Precondition: no vertex comes twice.
template <class Soup>
std::vector<int> unoriented_face(const Soup& soup, int f)
{
  std::vector<int> v;
  for (int h = soup.first(f); h <= soup.last(f); ++h) v.push_back(soup.source(h));
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  if (v.back() < v[1]) std::reverse(v.begin() + 1, v.end());
  return v;
}

// Calls f(earlier, later) for faces with the same corners in the same or in the opposite order: the first of them with
// each other one. For an edge of for_each_edge(); each face is looked at with one of its edges only.
template <class Soup, class Iterator, class Function>
void for_each_duplicate(const Soup& soup, Iterator begin, Iterator end, const Function& f)
{
  if (end - begin < 2) return;
  const auto apex = [&](Iterator i) { // of a triangle
    const int face = soup.face(i->second);
    return soup.last(face) == soup.first(face) + 2 ? soup.source(soup.previous(i->second)) : -1;
  };
  if (end - begin == 2 && apex(begin) != apex(begin + 1)) return; // as nearly everywhere
  const auto [low, high] = std::minmax({soup.source(begin->second), soup.target(begin->second)});
  std::vector<std::pair<std::vector<int>, int>> faces; // whose corners begin with this edge
  for (auto i = begin; i != end; ++i) {
    const int face = soup.face(i->second);
    std::vector<int> corners = unoriented_face(soup, face);
    if (corners[0] == low && corners[1] == high) faces.emplace_back(std::move(corners), face);
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t same = 0, i = 1; i < faces.size(); ++i)
    if (faces[i].first != faces[same].first)
      same = i;
    else if (faces[i].second != faces[same].second) // a degenerate face has an edge twice
      f(faces[same].second, faces[i].second);
}

class Fault_finder {
public:
  Fault_finder(const Mesh_soup& soup, bool knows_points) : soup_(soup), knows_points_(knows_points) {}

  Surface_faults operator()()
  {
    look_at_faces();
    if (faults_.missing_vertices.count > 0) return std::move(faults_); // all else has no meaning
    if (knows_points_) look_at_points();
    if (faults_.degenerate_faces.count + faults_.repeated_corners.count == 0) look_at_edges();
    return std::move(faults_);
  }

private:
  Eigen::Vector3d place(int v) const
  {
    return knows_points_ && v >= 0 && v < soup_.number_of_vertices()
             ? soup_.points[v]
             : Eigen::Vector3d(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  void add_face(Located_elements& elements, int f) const
  {
    Eigen::Vector3d centre(0, 0, 0);
    for (int h = soup_.first(f); h <= soup_.last(f); ++h) centre += place(soup_.source(h));
    elements.add(Mesh_element::face(f), centre / (soup_.last(f) - soup_.first(f) + 1));
  }
  void add_edge(Located_elements& elements, int h) const
  {
    const int a = soup_.source(h), b = soup_.target(h);
    elements.add(Mesh_element::edge(a, b), place(a) / 2 + place(b) / 2);
  }

  void look_at_points()
  {
    std::vector<char> is_used(soup_.number_of_vertices(), false);
    for (int h = 0; h < soup_.number_of_half_edges(); ++h) is_used[soup_.source(h)] = true;
    for (int v = 0; v < soup_.number_of_vertices(); ++v)
      if (is_used[v] && !soup_.points[v].allFinite())
        faults_.non_finite_vertices.add(Mesh_element::vertex(v), soup_.points[v]);
  }

  void look_at_faces()
  {
    for (int f = 0; f < soup_.number_of_faces(); ++f) {
      if (!has_its_vertices(soup_, f)) {
        add_face(faults_.missing_vertices, f);
        continue;
      }
      const int corners = soup_.last(f) - soup_.first(f) + 1;
      if (corners < 3 || repeated_vertex(soup_, f) != -1)
        add_face(vertices_of_face(soup_, f).size() < 3 ? faults_.degenerate_faces : faults_.repeated_corners,
                 f);
    }
  }

  void look_at_edges()
  {
    Union_find fans(soup_.number_of_half_edges()); // of corners, which neighbours in a face's edge join
    std::vector<char> is_on_bad_edge(soup_.number_of_vertices(), false);
    for_each_edge(soup_, [&](auto begin, auto end) {
      const int g = begin->second, h = (end - 1)->second;
      if (end - begin > 2) {
        add_edge(faults_.non_manifold_edges, g);
        is_on_bad_edge[soup_.source(g)] = is_on_bad_edge[soup_.target(g)] = true;
      } else if (end - begin == 2) {
        const bool is_opposite = soup_.source(g) != soup_.source(h);
        if (!is_opposite) add_edge(faults_.inconsistent_edges, g);
        fans.join(g, is_opposite ? soup_.next(h) : h);
        fans.join(soup_.next(g), is_opposite ? h : soup_.next(h));
      }
      for_each_duplicate(soup_, begin, end, [&](int, int f) {
        const bool is_pillow = end - begin == 2 && soup_.source(g) != soup_.source(h) &&
                               soup_.last(f) - soup_.first(f) > 2; // two sides of a polygon are a sphere
        if (!is_pillow) add_face(faults_.duplicate_faces, f);
      });
    });

    std::vector<int> fan(soup_.number_of_vertices(), -1); // the first one; -2: there are several
    for (int h = 0; h < soup_.number_of_half_edges(); ++h) {
      int& first = fan[soup_.source(h)];
      const int root = fans.root(h);
      if (first == -1)
        first = root;
      else if (first != root)
        first = -2;
    }
    for (int v = 0; v < soup_.number_of_vertices(); ++v)
      if (fan[v] == -2 && !is_on_bad_edge[v])
        faults_.non_manifold_vertices.add(Mesh_element::vertex(v), place(v));
  }

  const Mesh_soup& soup_;
  bool knows_points_;
  Surface_faults faults_;
};

CGAL_SIMPLE_MANIFOLDS_INLINE Surface_faults surface_faults(const Mesh_soup& soup, bool knows_points)
{
  return Fault_finder(soup, knows_points)();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_SURFACE_FAULTS_IMPL_H
