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

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The parts of a mesh of several bodies; one without a name of a mesh that is one body.
inline std::vector<Charted_mesh::Part> bodies_of(const Charted_mesh& mesh)
{
  if (!mesh.parts.empty()) return mesh.parts;
  return {{"", mesh.atlas, mesh.points.size(), mesh.triangles.size(), mesh.images.size()}};
}

// A name as formats of lines and words take it: what is no letter, digit, point or dash becomes an underscore. Bytes of
// UTF-8 are letters.
inline std::string word_of(const std::string& name)
{
  std::string word = name.empty() ? "_" : name;
  for (char& c : word)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' &&
        static_cast<unsigned char>(c) < 128)
      c = '_';
  return word;
}

// The words of all parts, made different.
inline std::vector<std::string> words_of(const std::vector<Charted_mesh::Part>& parts)
{
  std::vector<std::string> words;
  for (const Charted_mesh::Part& part : parts) {
    const std::string word = word_of(part.name);
    std::string unused = word;
    for (int n = 2; std::find(words.begin(), words.end(), unused) != words.end(); ++n)
      unused = word + '_' + std::to_string(n);
    words.push_back(unused);
  }
  return words;
}

// Per vertex and per triangle of a mesh the number of its part, from 1.
struct Part_numbers {
  explicit Part_numbers(const Charted_mesh& mesh)
  {
    for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
      vertices.resize(vertices.size() + mesh.parts[k].vertices, int(k) + 1);
      triangles.resize(triangles.size() + mesh.parts[k].triangles, int(k) + 1);
    }
  }

  std::vector<int> vertices, triangles;
};

// The triangles of one chart of one body, with vertices of their own: a vertex of the mesh has one pair of coordinates
// in each chart that uses it.
struct Chart_part {
  int body;                                 // position in bodies_of()
  std::string name;                         // of the chart, after that of the body if there are several
  int chart;                                // -1: in no chart, without coordinates
  const std::string* image;                 // of the chart, or null
  std::vector<int> vertices;                // of the mesh
  std::vector<Eigen::Vector2d> coordinates; // per vertex
  std::vector<Triangle> triangles;          // positions in `vertices`

  bool has_coordinates() const { return chart >= 0; }
};

inline std::vector<Chart_part> chart_parts(const Charted_mesh& mesh)
{
  const std::vector<Charted_mesh::Part> bodies = bodies_of(mesh);
  const std::vector<std::string> words = words_of(bodies);
  std::vector<Chart_part> parts;
  std::vector<int> position(mesh.points.size(), -1);
  std::size_t first = 0, first_image = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::vector<std::vector<int>> faces; // per chart + 1
    for (std::size_t f = first; f < first + bodies[b].triangles; ++f) {
      const std::size_t c = std::size_t(mesh.charts[f]) + 1; // 0 for -1
      if (faces.size() <= c) faces.resize(c + 1);
      faces[c].push_back(int(f));
    }
    for (std::size_t c = 0; c < faces.size(); ++c) {
      if (faces[c].empty()) continue;
      const std::string name = c == 0 ? "no_chart" : "chart" + std::to_string(c - 1);
      const bool has_image = c > 0 && c - 1 < bodies[b].images;
      parts.push_back({int(b),
                       mesh.parts.empty() ? name : words[b] + '_' + name,
                       int(c) - 1,
                       has_image ? &mesh.images[first_image + c - 1] : nullptr,
                       {},
                       {},
                       {}});
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
    first += bodies[b].triangles;
    first_image += bodies[b].images;
  }
  return parts;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_CHART_PARTS_H
