// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_PAIR_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_PAIR_FACES_H

#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/repair/internal/extent_of_faces.h>
#include <CGAL/Simple_manifolds/repair/internal/orient_faces.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Decides which faces stay together where an edge belongs to more than two of them.
//
// Where as many run through the edge in one direction as in the other, they are taken for borders of solid bodies: the
// two faces with matter between them stay together, so that bodies that touch come apart and stay closed. Else a patch
// of faces is glued to itself where it can be, as at a body that something is stuck to, and then to the patch that
// continues it best. As a rule patches meet in a whole chain of edges, and the chain decides as one.
//
// (PMP::orient_polygon_soup() separates all faces at such an edge, which opens bodies that only touch.)
class Face_pairing {
public:
  Face_pairing(const Mesh_soup& soup, const Patches& patches)
    : soup_(soup), patches_(patches), scale_(scale_of_faces(soup))
  {
  }

  // Glues half-edges with each other. glued: knows those of manifold edges.
  void operator()(std::vector<int>& glued)
  {
    std::vector<std::vector<Wing>> open; // edges whose patches have to be asked
    for_each_edge(soup_, [&](auto begin, auto end) {
      if (end - begin < 3) return;
      std::vector<Wing> wings = wings_of(begin, end);
      if (has_balance(wings))
        pair_round_matter(std::move(wings), glued);
      else if (end - begin > most_voters)
        pair_neighbours(std::move(wings), glued);
      else
        open.push_back(std::move(wings));
    });
    for (const auto& wings : open) vote(wings);
    for (auto& wings : open) pair_by_votes(wings, glued);
  }

private:
  // A face at an edge, by its half-edge there.
  struct Wing {
    int half_edge, patch;
    bool is_up;   // whether it runs from the lesser end to the larger one
    double angle; // round the edge in this direction, counterclockwise
  };
  using Patch_pair = std::pair<int, int>;
  static constexpr int most_voters = 32; // cubic time

  Eigen::Vector3d point(int v) const { return scale_ * soup_.points[v]; }

  Eigen::Vector3d normal(int f) const // Newell's
  {
    Eigen::Vector3d n(0, 0, 0);
    const Eigen::Vector3d origin = point(soup_.source(soup_.first(f)));
    for (int h = soup_.first(f); h <= soup_.last(f); ++h)
      n += (point(soup_.source(h)) - origin).cross(point(soup_.target(h)) - origin);
    return n;
  }

  template <class Iterator>
  std::vector<Wing> wings_of(Iterator begin, Iterator end) const
  {
    const auto ends = std::minmax({soup_.source(begin->second), soup_.target(begin->second)});
    const Eigen::Vector3d axis = point(ends.second) - point(ends.first);
    Eigen::Vector3d x(0, 0, 0), y(0, 0, 0);
    std::vector<Wing> wings;
    for (auto i = begin; i != end; ++i) {
      const int h = i->second, f = soup_.face(h);
      const bool is_up = soup_.source(h) == ends.first;
      const Eigen::Vector3d n = is_up ? normal(f) : Eigen::Vector3d(-normal(f));
      const Eigen::Vector3d into = n.cross(axis); // from the edge into the face
      if (x == Eigen::Vector3d(0, 0, 0)) {
        x = into.stableNormalized();
        y = axis.cross(x).stableNormalized();
      }
      const double angle = std::atan2(into.dot(y), into.dot(x));
      wings.push_back(
        {h, patches_.of_face[f], is_up, std::isfinite(angle) ? angle : 0.}); // of any coordinates
    }
    return wings;
  }

  static bool has_balance(const std::vector<Wing>& wings)
  {
    return 2 * std::count_if(wings.begin(), wings.end(), [](const Wing& w) { return w.is_up; }) ==
           static_cast<std::ptrdiff_t>(wings.size());
  }

  static void glue(const Wing& a, const Wing& b, std::vector<int>& glued)
  {
    glued[a.half_edge] = b.half_edge;
    glued[b.half_edge] = a.half_edge;
  }

  // In the same place the end of matter comes before its beginning.
  static void sort_by_angle(std::vector<Wing>& wings)
  {
    std::sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
      return std::make_tuple(a.angle, !a.is_up, a.half_edge) <
             std::make_tuple(b.angle, !b.is_up, b.half_edge);
    });
  }

  static void pair_neighbours(std::vector<Wing> wings, std::vector<int>& glued)
  {
    sort_by_angle(wings);
    for (std::size_t i = 1; i < wings.size(); i += 2) glue(wings[i - 1], wings[i], glued);
  }

  // The outside of a face that runs up is on its counterclockwise side: matter lies between one that runs down and
  // the next one that runs up.
  static void pair_round_matter(std::vector<Wing> wings, std::vector<int>& glued)
  {
    sort_by_angle(wings);
    std::vector<Wing> begun;                // matter that has no end yet
    for (int round = 0; round < 2; ++round) // the second one for what reaches over the first angle
      for (Wing& w : wings) {
        if (glued[w.half_edge] != -1) continue;
        if (!w.is_up) {
          if (round == 0) begun.push_back(w);
        } else if (!begun.empty()) {
          glue(begun.back(), w, glued);
          begun.pop_back();
        }
      }
  }

  // How far two faces are from continuing each other.
  static double bend(const Wing& a, const Wing& b) { return std::abs(std::abs(a.angle - b.angle) - CGAL_PI); }
  static Patch_pair patches_of(const Wing& a, const Wing& b) { return std::minmax({a.patch, b.patch}); }

  double length(const Wing& w) const
  {
    return (point(soup_.target(w.half_edge)) - point(soup_.source(w.half_edge))).norm();
  }

  void vote(const std::vector<Wing>& wings)
  {
    for (std::size_t i = 0; i < wings.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        auto& [sum, weight] = bends_[patches_of(wings[i], wings[j])];
        sum += length(wings[i]) * bend(wings[i], wings[j]);
        weight += length(wings[i]);
      }
  }

  void pair_by_votes(std::vector<Wing>& wings, std::vector<int>& glued) const
  {
    while (wings.size() > 1) {
      std::pair<double, double> least;
      std::size_t first = 0, second = 0;
      for (std::size_t i = 0; i < wings.size(); ++i)
        for (std::size_t j = i + 1; j < wings.size(); ++j) {
          const bool is_one_patch = wings[i].patch == wings[j].patch; // e.g. of a body, which stays closed
          const auto& [sum, weight] = bends_.at(patches_of(wings[i], wings[j]));
          const std::pair<double, double> cost(is_one_patch ? -1
                                               : weight > 0 ? sum / weight
                                                            : 0,
                                               bend(wings[i], wings[j]));
          if (second != 0 && !(cost < least)) continue;
          least = cost;
          first = i;
          second = j;
        }
      glue(wings[first], wings[second], glued);
      wings.erase(wings.begin() + static_cast<std::ptrdiff_t>(second));
      wings.erase(wings.begin() + static_cast<std::ptrdiff_t>(first));
    }
  }

  const Mesh_soup& soup_;
  const Patches& patches_;
  double scale_;
  std::map<Patch_pair, std::pair<double, double>> bends_; // sum of lengths times bends, sum of lengths
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_PAIR_FACES_H
