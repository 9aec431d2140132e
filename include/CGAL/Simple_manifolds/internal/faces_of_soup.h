// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_FACES_OF_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_FACES_OF_SOUP_H

#include <algorithm>
#include <cstddef>
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

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_FACES_OF_SOUP_H
