// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VTK_DATA_SET_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VTK_DATA_SET_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A data set of VTK, or a piece of one, as the arrays that its files hold: PolyData, or an unstructured grid, of which
// the cells that are faces are taken.
class Vtk_data_set {
public:
  // In the order in which VTK numbers the cells of PolyData.
  enum Cell_kind { VERTICES, LINES, POLYGONS, STRIPS, CELLS };
  struct Cells {
    std::vector<double> connectivity;
    std::vector<double> ends; // of the cells, in the connectivity
  };

  std::vector<double> coordinates;
  std::array<Cells, 5> cells;
  std::vector<double> cell_types; // of CELLS
  std::vector<Mesh_property> point_data, cell_data;

  // Adds the points and faces to a mesh. Throws IO_error where the arrays contradict each other.
  void add_to(const std::string& file, File_mesh& mesh) const
  {
    const std::size_t base = mesh.points.size(), faces_before = std::size_t(mesh.number_of_faces());
    const std::size_t points = coordinates.size() / 3;
    if (coordinates.size() % 3 != 0) fail(file, "the points have no three coordinates");
    for (std::size_t v = 0; v < points; ++v)
      mesh.points.emplace_back(coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]);

    std::vector<std::size_t> cell_of_face;
    std::size_t number_of_cells = 0;
    std::vector<int> corners;
    for (std::size_t kind = VERTICES; kind <= CELLS; ++kind) {
      std::size_t begin = 0;
      for (std::size_t i = 0; i < cells[kind].ends.size(); ++i, ++number_of_cells) {
        const double last = cells[kind].ends[i];
        if (!(last >= double(begin) && last <= double(cells[kind].connectivity.size())))
          fail(file, "the corners of cell " + std::to_string(number_of_cells) +
                       " are not among those that are listed");
        corners.clear();
        for (; begin < std::size_t(last); ++begin) {
          const int v = to_index(cells[kind].connectivity[begin]);
          if (v < 0 || std::size_t(v) >= points)
            fail(file, "cell " + std::to_string(number_of_cells) +
                         " refers to a point that does not exist: there are " + std::to_string(points));
          corners.push_back(int(base) + v);
        }
        add_cell(type_of_cell(file, Cell_kind(kind), i), corners, number_of_cells, mesh);
        cell_of_face.resize(std::size_t(mesh.number_of_faces()) - faces_before, number_of_cells);
      }
    }
    for (const Mesh_property& p : point_data)
      add_property(
        p, base, points, [](std::size_t v) { return v; }, mesh.properties.vertex, mesh.properties);
    for (const Mesh_property& p : cell_data)
      add_property(
        p, faces_before, cell_of_face.size(), [&](std::size_t f) { return cell_of_face[f]; },
        mesh.properties.face, mesh.properties, number_of_cells);
  }

  // Fills up what not all pieces have.
  static void complete(File_mesh& mesh)
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (Mesh_property& p : mesh.properties.vertex)
      p.values.resize(mesh.points.size() * std::size_t(p.components), none);
    for (Mesh_property& p : mesh.properties.face)
      p.values.resize(std::size_t(mesh.number_of_faces()) * std::size_t(p.components), none);
  }

private:
  // The numbers that VTK gives to cells of up to two dimensions.
  enum Vtk_type { LINE = 3, TRIANGLE = 5, TRIANGLE_STRIP = 6, POLYGON = 7, PIXEL = 8, QUADRILATERAL = 9 };

  [[noreturn]] static void fail(const std::string& file, const std::string& what)
  {
    throw IO_error(Error_code::syntax_error, file, what);
  }

  int type_of_cell(const std::string& file, Cell_kind kind, std::size_t i) const
  {
    if (kind == POLYGONS) return POLYGON;
    if (kind == STRIPS) return TRIANGLE_STRIP;
    if (kind != CELLS) return LINE;
    if (i >= cell_types.size()) fail(file, "there are fewer types of cells than cells");
    return to_index(cell_types[i]);
  }

  static void add_cell(int type, const std::vector<int>& corners, std::size_t number, File_mesh& mesh)
  {
    switch (type) {
    case TRIANGLE_STRIP:
      return mesh.add_strip(corners);
    case PIXEL: // the corners go row by row
      if (corners.size() != 4) break;
      for (std::size_t k : {0, 1, 3, 2}) mesh.add_corner(corners[k]);
      return mesh.end_face();
    case TRIANGLE:
    case QUADRILATERAL:
    case POLYGON:
      for (int v : corners) mesh.add_corner(v);
      return mesh.end_face();
    }
    mesh.warn(Read_warning::SKIPPED_ELEMENTS, "cell " + std::to_string(number));
  }

  // The property as all formats call it: the names that VTK itself and its users give to normals, colours and places
  // in images.
  static std::string common_name(const Mesh_property& p)
  {
    const auto is_one_of = [&](std::initializer_list<const char*> names) {
      return std::any_of(names.begin(), names.end(),
                         [&](const char* name) { return is_same_word(p.name, name); });
    };
    if (p.components == 3 && is_one_of({"normals", "normal"})) return "normal";
    if (p.components == 2 && is_one_of({"tcoords", "texturecoordinates", "texture coordinates", "uv"}))
      return "uv";
    if ((p.components == 3 || p.components == 4) &&
        is_one_of({"rgb", "rgba", "color", "colors", "colour", "colours"}))
      return "colour";
    return p.name;
  }

  template <class Source>
  static void add_property(const Mesh_property& p, std::size_t before, std::size_t elements,
                           const Source& source, std::vector<Mesh_property>& all, Mesh_properties& properties,
                           std::size_t sources = 0)
  {
    const auto n = std::size_t(p.components);
    if (p.values.size() != n * (sources ? sources : elements)) {
      properties.dropped.push_back(p.name + ", an array of another length");
      return;
    }
    const std::string name = common_name(p);
    auto at = std::find_if(all.begin(), all.end(), [&](const Mesh_property& q) { return q.name == name; });
    if (at == all.end()) at = all.insert(all.end(), Mesh_property{name, p.components, p.type, {}});
    if (at->components != p.components || at->values.size() > n * before) {
      properties.dropped.push_back(p.name + ", of which there are several");
      return;
    }
    at->values.resize(n * before, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < elements; ++i) {
      const auto first = p.values.begin() + std::ptrdiff_t(n * source(i));
      at->values.insert(at->values.end(), first, first + std::ptrdiff_t(n));
    }
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_VTK_DATA_SET_H
