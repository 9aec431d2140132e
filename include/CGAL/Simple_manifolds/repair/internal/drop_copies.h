// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_COPIES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_COPIES_H

#include <CGAL/Simple_manifolds/internal/Components.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Components each of whose faces coincides exactly with one of an earlier component, turned over or not: the back of a
// sheet with two sides, a body that is twice in a file, a triangle that is twice in a soup of triangles.
class Copy_finder {
public:
  explicit Copy_finder(const Mesh_soup& soup) : soup_(soup), components_(soup), lists_(components_.lists()) {}

  // Per face whether it belongs to no copy.
  std::vector<char> kept_faces()
  {
    std::vector<char> is_kept(soup_.number_of_faces(), true);
    if (components_.number < 2) return is_kept;
    for (int c = 0; c < components_.number; ++c) signatures_.push_back(signature(c));
    std::vector<int> order(components_.number);
    for (int c = 0; c < components_.number; ++c) order[c] = c;
    std::sort(order.begin(), order.end(),
              [&](int c, int d) { return std::tie(signatures_[c], c) < std::tie(signatures_[d], d); });
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
      for (end = begin + 1; end < order.size() && signatures_[order[end]] == signatures_[order[begin]];)
        ++end;
      if (end - begin > 1) mark_copies({order.begin() + begin, order.begin() + end}, is_kept);
    }
    return is_kept;
  }

private:
  using Point = std::array<double, 3>;
  using Signature = std::array<double, 7>; // the bounding box, and the number of faces

  Point point(int h) const
  {
    const Eigen::Vector3d& p = soup_.points[soup_.source(h)];
    return {p.x(), p.y(), p.z()};
  }

  // A component with a NaN is like no other.
  Signature signature(int c) const
  {
    Signature s;
    Eigen::AlignedBox3d box;
    for (int k = lists_.begin[c]; k < lists_.begin[c + 1]; ++k)
      for (int h = soup_.first(lists_.faces[k]); h <= soup_.last(lists_.faces[k]); ++h) {
        const Eigen::Vector3d& p = soup_.points[soup_.source(h)];
        if (!p.allFinite()) return {0, 0, 0, 0, 0, 0, -1. - c};
        box.extend(p);
      }
    for (int i = 0; i < 3; ++i) {
      s[i] = (box.min)()[i];
      s[i + 3] = (box.max)()[i];
    }
    s[6] = lists_.begin[c + 1] - lists_.begin[c];
    return s;
  }

  // The faces by the points of their corners, from the least one towards the lesser one beside it.
  std::vector<std::vector<Point>> faces_of(int c) const
  {
    std::vector<std::vector<Point>> faces;
    for (int k = lists_.begin[c]; k < lists_.begin[c + 1]; ++k) {
      std::vector<Point> corners;
      for (int h = soup_.first(lists_.faces[k]); h <= soup_.last(lists_.faces[k]); ++h)
        corners.push_back(point(h));
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      if (corners.size() > 1 && corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
      faces.push_back(std::move(corners));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void mark_copies(const std::vector<int>& components, std::vector<char>& is_kept) const
  {
    std::vector<std::pair<std::vector<std::vector<Point>>, int>> all;
    for (int c : components) all.emplace_back(faces_of(c), c);
    std::sort(all.begin(), all.end());
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i].first != all[i - 1].first) continue;
      const int c = all[i].second;
      for (int k = lists_.begin[c]; k < lists_.begin[c + 1]; ++k) is_kept[lists_.faces[k]] = false;
    }
  }

  const Mesh_soup& soup_;
  Components components_;
  Components::Lists lists_;
  std::vector<Signature> signatures_;
};

inline void drop_copies(Soup_in_repair& r)
{
  const std::vector<char> is_kept = Copy_finder(r.soup).kept_faces();
  bool is_clean = true;
  for (int f = 0; f < r.soup.number_of_faces(); ++f) {
    if (is_kept[f]) continue;
    r.note_face(r.report.dropped_duplicate, f);
    is_clean = false;
  }
  if (!is_clean) r.keep_faces(is_kept);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_DROP_COPIES_H
