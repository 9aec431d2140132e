// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CHART_PARTS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CHART_PARTS_H

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The triangles of one chart, with vertices of their own: a vertex of the mesh has one pair of coordinates
// in each chart that uses it.
struct Chart_part {
  int chart;                                // -1: in no chart, without coordinates
  std::vector<int> vertices;                // of the mesh
  std::vector<Eigen::Vector2d> coordinates; // per vertex
  std::vector<Triangle> triangles;          // positions in `vertices`

  bool has_coordinates() const { return chart >= 0; }
  std::string name() const { return chart < 0 ? "no_chart" : "chart" + std::to_string(chart); }
};

// The charts that have triangles, in increasing order.
inline std::vector<Chart_part> chart_parts(const Charted_mesh& mesh)
{
  std::vector<std::vector<int>> faces; // per chart + 1
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const std::size_t c = std::size_t(mesh.charts[f]) + 1; // 0 for -1
    if (faces.size() <= c) faces.resize(c + 1);
    faces[c].push_back(int(f));
  }
  std::vector<Chart_part> parts;
  std::vector<int> position(mesh.points.size(), -1);
  for (std::size_t c = 0; c < faces.size(); ++c) {
    if (faces[c].empty()) continue;
    parts.push_back({int(c) - 1, {}, {}, {}});
    Chart_part& part = parts.back();
    for (int f : faces[c]) {
      part.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        int& at = position[mesh.triangles[f][k]];
        if (at < 0) {
          at = int(part.vertices.size());
          part.vertices.push_back(mesh.triangles[f][k]);
          part.coordinates.push_back(mesh.coordinates[f][k]);
        }
        part.triangles.back()[k] = at;
      }
    }
    for (int v : part.vertices) position[v] = -1;
  }
  return parts;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CHART_PARTS_H
