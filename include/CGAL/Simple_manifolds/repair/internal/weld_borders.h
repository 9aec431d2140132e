// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WELD_BORDERS_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WELD_BORDERS_H

#include <CGAL/Simple_manifolds/internal/Union_find.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>
#include <CGAL/Simple_manifolds/repair/internal/coincident_points.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Joins the ends of border edges that coincide, within a distance.
//
// PMP::stitch_borders() pairs edges whose ends coincide exactly, of a mesh that is a manifold already;
// PMP::merge_duplicate_points_in_polygon_soup() joins inner points as well, which makes edges of four faces where bodies
// touch. Here points are joined only as ends of border edges: what coincides by chance, a corner on a corner, stays
// apart.
class Border_welder {
public:
  // distance: in each coordinate, >= 0.
  Border_welder(Soup_in_repair& r, double distance)
    : r_(r), soup_(r.soup), distance_(distance), sides_(soup_.number_of_faces()),
      joined_(soup_.number_of_vertices())
  {
  }

  // Returns whether anything was joined. is_joined: receives the vertices that have no face any more.
  bool operator()(std::vector<char>& is_joined)
  {
    find_border();
    if (border_.empty()) return false;
    find_coincident_points();
    weld_edges();
    if (!has_joined_) return false;
    is_joined.resize(soup_.number_of_vertices(), false);
    for (int v = 0; v < soup_.number_of_vertices(); ++v) {
      if (joined_.root(v) == v) continue;
      is_joined[v] = true;
      r_.note_vertex(r_.report.welded, v);
    }
    for (int h = 0; h < soup_.number_of_half_edges(); ++h) soup_.set_source(h, joined_.root(soup_.source(h)));
    return true;
  }

private:
  // Border edges as edges between classes of coincident points, for for_each_edge().
  struct Class_edges {
    const Border_welder& welder;
    int number_of_vertices() const { return welder.number_of_classes_; }
    int number_of_half_edges() const { return static_cast<int>(welder.border_.size()); }
    int source(int i) const { return welder.class_of_[welder.soup_.source(welder.border_[i])]; }
    int target(int i) const { return welder.class_of_[welder.soup_.target(welder.border_[i])]; }
  };

  // The half-edges on the border between finite points; the orientations of faces that are neighbours already.
  void find_border()
  {
    for_each_edge(soup_, [&](auto begin, auto end) {
      const int g = begin->second, h = (end - 1)->second;
      if (end - begin == 1 && r_.point(g).allFinite() && soup_.points[soup_.target(g)].allFinite())
        border_.push_back(g);
      if (end - begin == 2) sides_.join(soup_.face(g), soup_.face(h), soup_.source(g) == soup_.source(h));
    });
    std::sort(border_.begin(), border_.end());
  }

  void find_coincident_points()
  {
    class_of_.assign(soup_.number_of_vertices(), -1);
    std::vector<Eigen::Vector3d> points;
    std::vector<double> tolerance;
    for (int h : border_)
      for (int v : {soup_.source(h), soup_.target(h)}) {
        if (class_of_[v] != -1) continue;
        class_of_[v] = static_cast<int>(points.size());
        points.push_back(soup_.points[v]);
        tolerance.push_back(distance_);
      }
    // So that no edge collapses, and a fine part of a mesh does not suffer from its extent.
    for (int h : border_)
      for (int v : {soup_.source(h), soup_.target(h)}) {
        const double length = (r_.point(h) - soup_.points[soup_.target(h)]).cwiseAbs().maxCoeff();
        if (length > 0) tolerance[class_of_[v]] = (std::min)(tolerance[class_of_[v]], length / 4);
      }
    const std::vector<int> root = coincident_points(points, std::move(tolerance));
    for (int& c : class_of_)
      if (c != -1) c = root[c];
    number_of_classes_ = static_cast<int>(points.size());
  }

  void join(int v, int w) { has_joined_ = joined_.join(v, w) || has_joined_; }

  void weld_edges()
  {
    for_each_edge(Class_edges{*this}, [&](auto begin, auto end) {
      const int g = border_[begin->second];
      if (class_of_[soup_.source(g)] == class_of_[soup_.target(g)]) {
        for (auto i = begin; i != end; ++i) {
          const int h = border_[i->second];
          if (r_.point(h) == soup_.points[soup_.target(h)]) join(soup_.source(h), soup_.target(h));
        }
        return;
      }
      const auto is_opposite = [&](int h) {
        return class_of_[soup_.source(g)] != class_of_[soup_.source(h)];
      };
      if (end - begin == 2) { // else it is not manifold, whatever the orientation
        const int h = border_[(begin + 1)->second];
        if (!sides_.join(soup_.face(g), soup_.face(h), !is_opposite(h))) {
          r_.note_edge(r_.report.left.coincident_borders, g);
          return;
        }
      }
      for (auto i = begin + 1; i != end; ++i) {
        const int h = border_[i->second];
        join(soup_.source(g), is_opposite(h) ? soup_.target(h) : soup_.source(h));
        join(soup_.target(g), is_opposite(h) ? soup_.source(h) : soup_.target(h));
      }
    });
  }

  Soup_in_repair& r_;
  Mesh_soup& soup_;
  double distance_;
  std::vector<int> border_;   // half-edges
  std::vector<int> class_of_; // per vertex: of coincident points, -1 inside
  int number_of_classes_ = 0;
  Two_sided_union_find sides_; // of faces: which of them a consistent orientation turns over
  Union_find joined_;          // of vertices
  bool has_joined_ = false;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_WELD_BORDERS_H
