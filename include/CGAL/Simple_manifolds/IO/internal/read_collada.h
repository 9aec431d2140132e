// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_COLLADA_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_COLLADA_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Collada_document.h>
#include <CGAL/Simple_manifolds/IO/internal/Corner_values.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Placement.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The meshes in the scene of a COLLADA 1.4 or 1.5 document, each in its place, with axes and units as they are. Skins are
// in the pose in which they were bound; materials, animations and lines are not read.
class Collada_reader {
  using Source = Collada_document::Source;
  using Input = Collada_document::Input;
  using Primitive = Collada_document::Primitive;
  using Geometry = Collada_document::Geometry;
  using Skin = Collada_document::Skin;
  using Node = Collada_document::Node;

public:
  Collada_reader(const std::string& file, std::string_view text)
    : file_(file), document_(file, text), left_(Collada_document::most_values + text.size())
  {
  }

  File_mesh read()
  {
    const auto& scenes = document_.scenes;
    const auto scene = document_.scene.empty() ? scenes.begin() : scenes.find(document_.scene);
    if (scene != scenes.end())
      place(scene->second, Placement(), 0);
    else
      for (const auto& [id, geometry] : document_.geometries) place(geometry, Placement());
    colours_.add_to(mesh_.properties, mesh_.points.size());
    normals_.add_to(mesh_.properties, mesh_.points.size());
    uv_.add_to(mesh_.properties, mesh_.points.size());
    if (document_.has_animations) mesh_.properties.dropped.push_back("animations");
    for (const std::string& name : document_.skipped) mesh_.warn(Read_warning::SKIPPED_ELEMENTS, name);
    mesh_.unit = document_.unit;
    return std::move(mesh_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what);
  }

  void place(const Node& node, const Placement& parent, int level)
  {
    if (level == Collada_document::most_levels) fail("nodes are nested too deeply, or in a circle");
    take(1);
    const Placement placement = parent * node.placement;
    for (const std::string& id : node.geometries)
      place(found(document_.geometries, id, "geometry"), placement);
    for (const std::string& id : node.skins) {
      const Skin& skin = found(document_.skins, id, "controller");
      place(found(document_.geometries, skin.geometry, "geometry"), placement * skin.bound);
    }
    for (const std::string& id : node.nodes) place(found(document_.nodes, id, "node"), placement, level + 1);
    for (const Node& child : node.children) place(child, placement, level + 1);
  }

  template <class Library>
  const typename Library::mapped_type& found(const Library& library, const std::string& id,
                                             const char* what) const
  {
    const auto at = library.find(id);
    if (at == library.end()) fail(std::string("there is no ") + what + " \"" + Text_scanner::shown(id) + '"');
    return at->second;
  }

  void take(std::size_t values)
  {
    if (values > left_) fail("copies of the geometries are too many for so small a file");
    left_ -= values;
  }

  void place(const Geometry& geometry, const Placement& placement)
  {
    std::map<std::string, std::size_t> first; // vertex of each element <vertices>
    for (const auto& [id, inputs] : geometry.vertices)
      for (const Input& input : inputs)
        if (input.semantic == "POSITION" && first.count(id) == 0) {
          const Source& source = found(geometry.sources, input.source, "source");
          take(source.size());
          first[id] = mesh_.points.size();
          for (std::size_t i = 0; i < source.size(); ++i) {
            const std::vector<double> x = source.row(i, 3);
            mesh_.points.push_back(placement(Eigen::Vector3d(x[0], x[1], x[2])));
          }
        }
    for (const Primitive& primitive : geometry.primitives) add_faces(geometry, primitive, first, placement);
  }

  // Values at corners: an index at this place of each corner, into rows that begin with this one.
  struct Corner_input {
    Corner_values* values;
    std::size_t offset, first;
  };

  void add_faces(const Geometry& geometry, const Primitive& primitive,
                 const std::map<std::string, std::size_t>& first_vertices, const Placement& placement)
  {
    std::size_t stride = 1, offset = 0, first = 0, size = 0;
    bool has_vertices = false;
    std::vector<Corner_input> corners;
    for (const Input& input : primitive.inputs) {
      stride = (std::max)(stride, input.offset + 1);
      if (input.semantic != "VERTEX") {
        add_corner_input(corners, geometry, input, placement);
        continue;
      }
      has_vertices = true;
      offset = input.offset;
      const auto vertices = first_vertices.find(input.source);
      if (vertices == first_vertices.end())
        fail("there are no vertices \"" + Text_scanner::shown(input.source) + "\" with positions");
      first = vertices->second;
      for (Input of_vertex : found(geometry.vertices, input.source, "element of vertices")) {
        if (of_vertex.semantic == "POSITION")
          size = found(geometry.sources, of_vertex.source, "source").size();
        else {
          of_vertex.offset = input.offset;
          add_corner_input(corners, geometry, of_vertex, placement);
        }
      }
    }
    if (!has_vertices && !primitive.indices.empty()) fail("faces have no vertices");

    const bool is_mirrored = placement.is_mirrored();
    for (const std::vector<double>& indices : primitive.indices) {
      take(indices.size());
      const std::size_t n = indices.size() / stride;
      const auto add_face = [&](const std::vector<std::size_t>& of_face) {
        for (std::size_t k = 0; k < of_face.size(); ++k) {
          const std::size_t c = of_face[is_mirrored ? of_face.size() - 1 - k : k];
          const int v = to_index(indices[c * stride + offset]);
          if (v < 0 || std::size_t(v) >= size)
            fail("face " + std::to_string(mesh_.number_of_faces()) + " refers to vertex " +
                 (v < 0 ? "number below 0 or beyond 2^31" : std::to_string(v)) + ", but there are " +
                 std::to_string(size) + " vertices");
          const int vertex = static_cast<int>(first) + v;
          mesh_.add_corner(vertex);
          for (const Corner_input& input : corners)
            if (const int i = to_index(indices[c * stride + input.offset]); i >= 0)
              input.values->put(vertex, static_cast<int>(input.first) + i);
        }
        mesh_.end_face();
      };
      if (primitive.kind == "triangles") {
        for (std::size_t c = 0; c + 2 < n; c += 3) add_face({c, c + 1, c + 2});
      } else if (primitive.kind == "tristrips") {
        for (std::size_t c = 0; c + 2 < n; ++c) add_face({c + c % 2, c + 1 - c % 2, c + 2});
      } else if (primitive.kind == "trifans") {
        for (std::size_t c = 1; c + 1 < n; ++c) add_face({0, c, c + 1});
      } else { // a polygon for each list, or for each count
        const std::vector<double> counts =
          primitive.kind == "polygons" ? std::vector<double>{double(n)} : primitive.counts;
        std::size_t begin = 0;
        for (const double x : counts) {
          if (!(x >= 0 && x <= double(n - begin))) fail("the polygons have fewer corners than they count");
          std::vector<std::size_t> face(static_cast<std::size_t>(x));
          for (std::size_t& c : face) c = begin++;
          add_face(face);
        }
      }
    }
  }

  // The first input of a kind that there is a place for.
  void add_corner_input(std::vector<Corner_input>& corners, const Geometry& geometry, const Input& input,
                        const Placement& placement)
  {
    const std::array<std::pair<const char*, Corner_values*>, 3> kinds = {
      {{"NORMAL", &normals_}, {"TEXCOORD", &uv_}, {"COLOR", &colours_}}};
    for (const auto& [semantic, values] : kinds) {
      if (input.semantic != semantic) continue;
      Corner_values* const of_kind = values;
      if (std::any_of(corners.begin(), corners.end(), [&](const auto& c) { return c.values == of_kind; }))
        return;
      const Source& source = found(geometry.sources, input.source, "source");
      take(source.size());
      corners.push_back({values, input.offset, values->size()});
      for (std::size_t i = 0; i < source.size(); ++i) {
        std::vector<double> x = source.row(i, values == &uv_ ? 2 : 3);
        if (values == &normals_) {
          const Eigen::Vector3d n = placement.normal(Eigen::Vector3d(x[0], x[1], x[2]));
          x.assign(n.data(), n.data() + 3);
        }
        values->add(x);
      }
    }
  }

  const std::string& file_;
  Collada_document document_;
  std::size_t left_; // values that may still be copied
  Corner_values normals_{"normal", 3}, uv_{"uv", 2}, colours_{"colour", 3};
  File_mesh mesh_;
};

inline File_mesh read_collada(const std::string& file, std::string_view text)
{
  return Collada_reader(file, text).read();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_COLLADA_H
