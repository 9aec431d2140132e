// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_TO_TRIANGLES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_TO_TRIANGLES_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Mesh_arrays.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/internal/triangulate_polygon.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Cuts the faces of a soup into triangles so that no two edges have the same ends.
class Soup_triangulator {
public:
  Soup_triangulator(const Polygon_soup& soup, const std::vector<Eigen::Vector3d>& points)
    : soup_(soup), points_(points)
  {
    for (int h = 0; h < soup.number_of_half_edges(); ++h)
      sides_.push_back(key(soup.source(h), soup.target(h)));
    std::sort(sides_.begin(), sides_.end());
  }

  // A face that finds all its triangulations blocked by the diagonals of earlier ones comes first in
  // a new attempt; blocked again, or the hundredth of them, it cannot be cut.
  // Throws Topology_error (unsupported_face) naming such a face.
  // parents: receives the face of each triangle.
  std::vector<Triangle> operator()(std::vector<int>& parents)
  {
    std::deque<int> first;
    for (;;) {
      const int blocked = attempt(first);
      if (blocked == -1) break;
      if (first.size() == 100 || std::find(first.begin(), first.end(), blocked) != first.end())
        throw Topology_error(Error_code::unsupported_face,
                             "face " + std::to_string(soup_.names().face(blocked)) + " with " +
                               std::to_string(corners(blocked)) +
                               " corners cannot be cut into triangles "
                               "without joining two vertices by two edges",
                             Mesh_element::face(soup_.names().face(blocked)));
      first.push_front(blocked);
    }
    std::vector<Triangle> all;
    for (int f = 0; f < soup_.number_of_faces(); ++f) {
      const int h = soup_.first(f);
      if (corners(f) == 3) all.push_back({soup_.source(h), soup_.source(h + 1), soup_.source(h + 2)});
      for (const Triangle& t : pieces_[f])
        all.push_back({soup_.source(h + t[0]), soup_.source(h + t[1]), soup_.source(h + t[2])});
      parents.resize(all.size(), f);
    }
    return all;
  }

private:
  static std::uint64_t key(int v, int w)
  {
    return static_cast<std::uint64_t>((std::min)(v, w)) << 32 | static_cast<std::uint32_t>((std::max)(v, w));
  }
  int corners(int f) const { return soup_.last(f) - soup_.first(f) + 1; }

  // The first face that is blocked, or -1.
  int attempt(const std::deque<int>& first)
  {
    pieces_.assign(soup_.number_of_faces(), {});
    diagonals_.clear();
    for (int f : first)
      if (!cut(f)) return f;
    for (int f = 0; f < soup_.number_of_faces(); ++f)
      if (corners(f) > 3 && pieces_[f].empty() && !cut(f)) return f;
    return -1;
  }

  bool cut(int f)
  {
    const int h = soup_.first(f), n = corners(f);
    if (n > max_polygon_corners)
      throw Topology_error(Error_code::unsupported_face,
                           "face " + std::to_string(soup_.names().face(f)) + " has " + std::to_string(n) +
                             " corners, at most " + std::to_string(max_polygon_corners) + " are supported",
                           Mesh_element::face(soup_.names().face(f)));
    std::vector<Eigen::Vector3d> corner(n);
    for (int i = 0; i < n; ++i) corner[i] = points_[soup_.source(h + i)];
    pieces_[f] = triangulate_polygon(corner, [&](int i, int j) {
      const std::uint64_t k = key(soup_.source(h + i), soup_.source(h + j));
      return !std::binary_search(sides_.begin(), sides_.end(), k) && diagonals_.count(k) == 0;
    });
    for (const Triangle& t : pieces_[f])
      for (int i = 0; i < 3; ++i)
        diagonals_.insert(key(soup_.source(h + t[i]), soup_.source(h + t[(i + 1) % 3])));
    return !pieces_[f].empty();
  }

  const Polygon_soup& soup_;
  const std::vector<Eigen::Vector3d>& points_;
  std::vector<std::uint64_t> sides_;
  std::unordered_set<std::uint64_t> diagonals_; // only asked, never iterated over
  std::vector<std::vector<Triangle>> pieces_;   // per face with more than three corners
};

// soup: of triangles, or of polygons. points: of its vertices, isolated ones included.
// Throws Topology_error (see topology(), and unsupported_face) and Geometry_error
// (non_finite_coordinate naming the vertex).
template <class Soup>
Mesh_arrays mesh_to_triangles(const Soup& soup, const std::vector<Eigen::Vector3d>& points)
{
  Mesh_arrays arrays;
  std::vector<int> opposite;
  arrays.topology = topology_of_soup(soup, opposite);

  arrays.index.reserve(points.size());
  arrays.points.reserve(points.size());
  arrays.input.vertices.reserve(points.size());
  std::vector<char> used(points.size(), false);
  for (int h = 0; h < soup.number_of_half_edges(); ++h) used[soup.source(h)] = true;
  for (std::size_t v = 0; v < points.size(); ++v) {
    arrays.index.push_back(used[v] ? static_cast<int>(arrays.points.size()) : -1);
    if (!used[v]) continue;
    const int name = soup.names().vertex(static_cast<int>(v));
    if (!points[v].allFinite())
      throw Geometry_error(Error_code::non_finite_coordinate,
                           "vertex " + std::to_string(name) + " has a coordinate that is not finite",
                           Mesh_element::vertex(name));
    arrays.points.push_back(points[v]);
    arrays.input.vertices.push_back(name);
  }
  arrays.number_of_input_vertices = arrays.points.size();
  if (soup.number_of_half_edges() == 3 * soup.number_of_faces()) {
    arrays.triangles.reserve(soup.number_of_faces());
    arrays.input.faces.reserve(soup.number_of_faces());
    for (int f = 0; f < soup.number_of_faces(); ++f) {
      arrays.triangles.push_back({soup.source(3 * f), soup.source(3 * f + 1), soup.source(3 * f + 2)});
      arrays.input.faces.push_back(soup.names().face(f));
    }
  } else if constexpr (Soup::knows_edges) { // of polygons
    arrays.triangles = Soup_triangulator(soup, points)(arrays.input.faces);
    for (int& f : arrays.input.faces) f = soup.names().face(f);
  }
  arrays.input = std::move(arrays.input).compact();
  for (Triangle& t : arrays.triangles)
    for (int& v : t) v = arrays.index[v];
  return arrays;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MESH_MESH_TO_TRIANGLES_H
