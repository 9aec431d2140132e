// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_MESH_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Read_warning.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What a mesh file holds: points and polygons of indices, in the form whose topology can be computed
// before there is a mesh.
class File_mesh : public Mesh_soup {
public:
  Mesh_properties properties;
  std::string unit;                   // of lengths, if the file names one
  bool is_single_precision = false;   // whether the coordinates are stored with 32 bits
  std::vector<Read_warning> warnings; // at most one of each kind, in the order of their first places

  // One more, or `count` more, of what is passed over.
  void warn(Read_warning::Kind kind, const std::string& first, std::size_t count = 1)
  {
    for (Read_warning& w : warnings)
      if (w.kind == kind) {
        w.count += count;
        return;
      }
    warnings.push_back({kind, count, first});
  }

  // The triangles of strips of vertices, which -1 ends; each other one is turned.
  void add_strip(const std::vector<int>& vertices)
  {
    int length = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      length = vertices[k] == -1 ? 0 : length + 1;
      if (length < 3) continue;
      const bool is_turned = length % 2 == 0;
      add_corner(vertices[k - 2 + is_turned]);
      add_corner(vertices[k - 1 - is_turned]);
      add_corner(vertices[k]);
      end_face();
    }
  }
};

// An index as it stands in a file; -1 stands for everything that cannot be an index.
inline int to_index(double x)
{
  return x >= 0 && x <= (std::numeric_limits<int>::max)() && x == double(int(x)) ? int(x) : -1;
}

inline void require_existing_vertices(const std::string& file, const File_mesh& mesh)
{
  for (int h = 0; h < mesh.number_of_half_edges(); ++h)
    if (mesh.source(h) < 0 || mesh.source(h) >= mesh.number_of_vertices())
      throw IO_error(
        Error_code::syntax_error, file,
        "face " + std::to_string(mesh.face(h)) + " refers to vertex " +
          (mesh.source(h) < 0 ? "number below 0 or beyond 2^31" : std::to_string(mesh.source(h))) +
          ", but there are " + std::to_string(mesh.number_of_vertices()) + " vertices",
        0, Mesh_element::face(mesh.face(h)));
}

inline void require_finite_points(const std::string& file, const File_mesh& mesh)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!mesh.points[v].allFinite())
      throw Geometry_error(Error_code::non_finite_coordinate,
                           file + ": vertex " + std::to_string(v) + " of " +
                             std::to_string(mesh.points.size()) + " has a coordinate that is NaN or infinite",
                           Mesh_element::vertex(v));
}

// The topology of an oriented manifold mesh, possibly with border, several components and isolated
// vertices, and its opposite half-edges; errors name the file and the first offending element.
inline Mesh_topology checked_topology(const std::string& file, const File_mesh& mesh,
                                      std::vector<int>& opposite)
{
  require_existing_vertices(file, mesh);
  require_finite_points(file, mesh);
  try {
    return topology_of_soup(mesh, opposite);
  } catch (const Topology_error& e) {
    throw Topology_error(e.code(), file + ": " + e.what(), e.element());
  }
}

inline Mesh_topology checked_topology(const std::string& file, const File_mesh& mesh)
{
  std::vector<int> opposite;
  return checked_topology(file, mesh, opposite);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_FILE_MESH_H
