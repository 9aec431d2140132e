// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_IMPL_H

#include <CGAL/Simple_manifolds/cad/Cad_tessellation.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The borders of the cells along one parameter.
inline std::vector<double> lines_of_cells(const std::vector<double>& knots, int n)
{
  std::vector<double> lines = {knots.front()};
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int i = 1; i <= n && knots[k] < knots[k + 1]; ++i)
      lines.push_back(i == n ? knots[k + 1] : knots[k] + (knots[k + 1] - knots[k]) * i / n);
  return lines;
}

class Cad_tessellator {
public:
  Cad_tessellator(const Cad_surface& surface, int n) : surface_(surface)
  {
    result_.points = surface.vertices();
    for (const Cad_face& face : surface.faces())
      lines_.push_back({lines_of_cells(face.knots_u, n), lines_of_cells(face.knots_v, n)});
    divide_edges();
    for (std::size_t f = 0; f < surface.faces().size(); ++f) add_face(int(f));
  }

  Cad_tessellation take() { return std::move(result_); }

private:
  using Line = std::vector<std::pair<double, int>>; // parameters with their points, or vertices

  void divide_edges()
  {
    std::vector<std::vector<double>> at(surface_.edges().size());
    for (std::size_t f = 0; f < surface_.faces().size(); ++f)
      for (const Cad_face::Use& use : surface_.faces()[f].border) {
        const std::vector<double>& lines = lines_[f][use.is_along_u ? 0 : 1];
        at[use.edge].insert(at[use.edge].end(), lines.begin(), lines.end());
      }
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Cad_surface::Edge& edge = surface_.edges()[k];
      const double first = edge.curve.knots.front(), last = edge.curve.knots.back();
      std::sort(at[k].begin(), at[k].end());
      at[k].erase(std::unique(at[k].begin(), at[k].end()), at[k].end());
      Line line = {{first, edge.vertices.first}};
      for (const double r : at[k])
        if (first < r && r < last) line.push_back({r, add_point(edge.curve.point(r))});
      line.push_back({last, edge.vertices.second});
      result_.edges.emplace_back();
      for (const auto& [r, point] : line) result_.edges.back().push_back(point);
      on_edge_.push_back(std::move(line));
    }
  }

  int add_point(const Eigen::Vector3d& x)
  {
    result_.points.push_back(x);
    return int(result_.points.size()) - 1;
  }

  int add_vertex(int f, const Eigen::Vector2d& uv, int point)
  {
    result_.vertices.push_back({f, uv, point});
    return int(result_.vertices.size()) - 1;
  }

  int add_inner_vertex(int f, const Eigen::Vector2d& uv)
  {
    return add_vertex(f, uv, add_point(surface_.faces()[f].jet(uv).value));
  }

  void add_face(int f)
  {
    const Cad_face& face = surface_.faces()[f];
    const std::vector<double>&us = lines_[f][0], &vs = lines_[f][1];
    // the sides, by increasing parameter: bottom, right, top, left
    std::array<Line, 4> sides;
    for (const Cad_face::Use& use : face.border) {
      const bool is_low = use.at == (use.is_along_u ? vs : us).front();
      Line& side = sides[use.is_along_u ? (is_low ? 0 : 2) : (is_low ? 3 : 1)];
      side.insert(side.end(), on_edge_[use.edge].begin(), on_edge_[use.edge].end());
    }
    for (int s = 0; s < 4; ++s) {
      std::sort(sides[s].begin(), sides[s].end());
      sides[s].erase(std::unique(sides[s].begin(), sides[s].end()), sides[s].end());
      for (auto& [r, point] : sides[s]) // corners are twice in the list of vertices, and have one point
        point = add_vertex(f,
                           s % 2 == 0 ? Eigen::Vector2d(r, s == 0 ? vs.front() : vs.back())
                                      : Eigen::Vector2d(s == 3 ? us.front() : us.back(), r),
                           point);
    }

    const int n = int(us.size()) - 1, m = int(vs.size()) - 1;
    std::vector<int> inner(us.size() * vs.size(), -1);
    for (int i = 1; i < n; ++i)
      for (int j = 1; j < m; ++j) inner[i * (m + 1) + j] = add_inner_vertex(f, {us[i], vs[j]});
    // the vertices on a side of a cell, from low to high, both ends included
    const auto between = [&](int s, double low, double high) {
      std::vector<int> list;
      for (auto k = std::lower_bound(sides[s].begin(), sides[s].end(), std::make_pair(low, -1));
           k != sides[s].end() && k->first <= high; ++k)
        list.push_back(k->second);
      return list;
    };
    const auto node = [&](int i, int j) {
      if (j == 0) return between(0, us[i], us[i])[0];
      if (j == m) return between(2, us[i], us[i])[0];
      if (i == 0) return between(3, vs[j], vs[j])[0];
      if (i == n) return between(1, vs[j], vs[j])[0];
      return inner[i * (m + 1) + j];
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        if (i > 0 && j > 0 && i + 1 < n && j + 1 < m) { // most
          add_polygon(f, {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
          continue;
        }
        std::vector<int> polygon;
        const auto append = [&](int s, bool is_border, int a, int b, int c, int d) { // from (a,b) to (c,d)
          std::vector<int> list = {node(a, b), node(c, d)};
          if (is_border) {
            list = s % 2 == 0 ? between(s, us[i], us[i + 1]) : between(s, vs[j], vs[j + 1]);
            if (s >= 2) std::reverse(list.begin(), list.end());
          }
          polygon.insert(polygon.end(), list.begin(), std::prev(list.end()));
        };
        append(0, j == 0, i, j, i + 1, j);
        append(1, i + 1 == n, i + 1, j, i + 1, j + 1);
        append(2, j + 1 == m, i + 1, j + 1, i, j + 1);
        append(3, i == 0, i, j + 1, i, j);
        add_polygon(f, polygon);
      }
  }

  // A cell: two triangles, or those from its centre to its border.
  void add_polygon(int f, const std::vector<int>& p)
  {
    const std::size_t n = p.size();
    if (n == 4) {
      result_.triangles.push_back({p[0], p[1], p[2]});
      result_.triangles.push_back({p[0], p[2], p[3]});
      return;
    }
    Eigen::Vector2d low = result_.vertices[p[0]].uv, high = low;
    for (const int v : p) {
      low = low.cwiseMin(result_.vertices[v].uv);
      high = high.cwiseMax(result_.vertices[v].uv);
    }
    const int centre = add_inner_vertex(f, (low + high) / 2);
    for (std::size_t k = 0; k < n; ++k) result_.triangles.push_back({centre, p[k], p[(k + 1) % n]});
  }

  const Cad_surface& surface_;
  std::vector<std::array<std::vector<double>, 2>> lines_; // of each face
  std::vector<Line> on_edge_;
  Cad_tessellation result_;
};

} // namespace internal

CGAL_SIMPLE_MANIFOLDS_INLINE Cad_tessellation cad_tessellation(const Cad_surface& surface, int n)
{
  CGAL_precondition(n >= 1 && (n & (n - 1)) == 0);
  return internal::Cad_tessellator(surface, n).take();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_TESSELLATION_IMPL_H
