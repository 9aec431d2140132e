// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_COLLADA_DOCUMENT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_COLLADA_DOCUMENT_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Placement.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Xml_scanner.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What a COLLADA document holds of geometries and of the nodes of its scenes.
class Collada_document {
public:
  struct Source {
    std::string array;
    std::vector<double> values;
    std::size_t stride = 1, offset = 0;
    std::vector<std::size_t> components; // which values of a row have a name; none: all

    std::size_t size() const { return values.size() < offset ? 0 : (values.size() - offset) / stride; }
    // The first n numbers of row i, 0 where it has fewer.
    std::vector<double> row(std::size_t i, std::size_t n) const
    {
      std::vector<double> x(n, 0);
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t at = k < components.size() ? components[k] : components.empty() ? k : stride;
        if (at < stride) x[k] = values[offset + i * stride + at];
      }
      return x;
    }
  };
  struct Input {
    std::string semantic, source;
    std::size_t offset;
  };
  struct Primitive {
    std::string kind;
    std::vector<Input> inputs;
    std::vector<double> counts;               // of the corners of polygons
    std::vector<std::vector<double>> indices; // one list, or one for each polygon, strip or fan
  };
  struct Geometry {
    std::map<std::string, Source> sources;
    std::map<std::string, std::vector<Input>> vertices;
    std::vector<Primitive> primitives;
  };
  struct Skin {
    std::string geometry;
    Placement bound;
  };
  struct Node {
    Placement placement;
    std::vector<std::string> geometries, skins, nodes; // instances
    std::vector<Node> children;
  };

  std::map<std::string, Geometry> geometries;
  std::map<std::string, Skin> skins;
  std::map<std::string, Node> nodes, scenes; // by their names
  std::string scene;                         // the one that is shown
  std::string unit;                          // of lengths
  std::vector<std::string> skipped;          // elements that are no faces
  bool has_animations = false;

  Collada_document(const std::string& file, std::string_view text)
    : file_(file), xml_(file, text), left_(most_values + text.size())
  {
    parse();
  }

  // Copies can be many more than what is in a document: a million values and one for each byte is the limit.
  static constexpr std::size_t most_values = 1000000;
  static constexpr int most_levels = 100; // of nodes in nodes

private:
  // What a reference leads to: "#id", or "id".
  static std::string id_of(std::string_view url) { return std::string(url.substr(url.substr(0, 1) == "#")); }

  void parse()
  {
    for (;;) {
      const Xml_scanner::Tag tag = xml_.next();
      if (tag.begins("unit")) unit = std::string(tag["name"].empty() ? tag["meter"] : tag["name"]);
      if (tag.begins("geometry") && !tag.is_end) parse_geometry(geometries[std::string(tag["id"])]);
      if (tag.begins("controller") && !tag.is_end) parse_skin(skins[std::string(tag["id"])]);
      if ((tag.begins("node") || tag.begins("visual_scene")) && !tag.is_end) {
        const std::string name(tag.name), id(tag["id"]);
        Node node;
        parse_node(node, name, 0);
        (name == "node" ? nodes : scenes)[id] = std::move(node);
      }
      if (tag.begins("instance_visual_scene")) scene = id_of(tag["url"]);
      if (tag.begins("animation")) has_animations = true;
      if (tag.ends("COLLADA")) break;
    }
  }

  std::vector<double> numbers() const
  {
    std::vector<double> x;
    for (Text_scanner in(file_, xml_.text(), false); !in.at_end();) {
      x.emplace_back();
      if (!Text_scanner::is_number(in.word("a number"), x.back()))
        xml_.fail("an array holds what is no number");
    }
    return x;
  }

  // An attribute that counts something, at most as much as the array that it is for has.
  std::size_t count(const Xml_scanner::Tag& tag, const char* name, int otherwise) const
  {
    double x = otherwise;
    if (!tag[name].empty() && !Text_scanner::is_number(tag[name], x)) x = -1;
    if (to_index(x) < 0)
      xml_.fail(std::string(name) + " of " + std::string(tag.name) + " is none that it can have");
    return std::size_t(x);
  }

  Input input(const Xml_scanner::Tag& tag) const
  {
    return {std::string(tag["semantic"]), id_of(tag["source"]), count(tag, "offset", 0)};
  }

  void parse_geometry(Geometry& geometry)
  {
    std::map<std::string, std::vector<double>> arrays;
    Source* source = nullptr;
    std::vector<Input>* vertices = nullptr;
    Primitive* primitive = nullptr;
    std::size_t parameter = 0; // of an accessor
    for (;;) {
      const Xml_scanner::Tag tag = xml_.next();
      const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), tag.name) != names.end();
      };
      if (tag.begins("source")) source = &geometry.sources[std::string(tag["id"])];
      if (tag.begins("float_array")) arrays[std::string(tag["id"])] = numbers();
      if (tag.begins("accessor") && source) {
        source->array = id_of(tag["source"]);
        source->stride = count(tag, "stride", 1);
        source->offset = count(tag, "offset", 0);
        if (source->stride == 0) xml_.fail("the stride of an accessor is 0");
        parameter = 0;
      }
      if (tag.begins("param") && source) {
        if (!tag["name"].empty()) source->components.push_back(parameter);
        ++parameter;
      }
      if (tag.begins("vertices")) vertices = &geometry.vertices[std::string(tag["id"])];
      if (tag.is_begin && is_one_of({"triangles", "polylist", "polygons", "tristrips", "trifans"})) {
        geometry.primitives.push_back({std::string(tag.name), {}, {}, {}});
        primitive = &geometry.primitives.back();
      }
      if (tag.is_begin && is_one_of({"lines", "linestrips"})) skipped.push_back(std::string(tag.name));
      if (tag.begins("h")) skipped.push_back("hole of a polygon");
      if (tag.begins("input") && vertices) vertices->push_back(input(tag));
      if (tag.begins("input") && primitive) primitive->inputs.push_back(input(tag));
      if (tag.begins("vcount") && primitive) primitive->counts = numbers();
      if (tag.begins("p") && primitive && !tag.is_end) primitive->indices.push_back(numbers());
      if (tag.ends("source")) source = nullptr;
      if (tag.ends("vertices")) vertices = nullptr;
      if (primitive && tag.ends(primitive->kind)) primitive = nullptr;
      if (tag.ends("geometry")) break;
    }
    for (auto& [id, of_id] : geometry.sources)
      if (const auto array = arrays.find(of_id.array); array != arrays.end()) {
        if (array->second.size() > left_) xml_.fail("arrays are used too often for so small a file");
        left_ -= array->second.size();
        of_id.values = array->second;
      }
  }

  void parse_skin(Skin& skin)
  {
    for (;;) {
      const Xml_scanner::Tag tag = xml_.next();
      if (tag.begins("skin") || tag.begins("morph")) skin.geometry = id_of(tag["source"]);
      if (tag.begins("bind_shape_matrix")) skin.bound = transform("matrix");
      if (tag.ends("controller")) break;
    }
  }

  // The transform of an element of this name, from the numbers in it.
  Placement transform(std::string_view name) const
  {
    const std::vector<double> x = numbers();
    const std::size_t n = name == "matrix" ? 16 : name == "lookat" ? 9 : name == "rotate" ? 4 : 3;
    if (x.size() != n)
      xml_.fail("a " + std::string(name) + " has " + std::to_string(x.size()) + " numbers, not " +
                std::to_string(n));
    const auto vector = [&](std::size_t k) { return Eigen::Vector3d(x[k], x[k + 1], x[k + 2]); };
    Placement p;
    if (name == "matrix") {
      for (std::size_t i = 0; i < 3; ++i) {
        p.linear.row(Eigen::Index(i)) = vector(4 * i);
        p.shift[Eigen::Index(i)] = x[4 * i + 3];
      }
    } else if (name == "translate") {
      p.shift = vector(0);
    } else if (name == "scale") {
      p.linear = vector(0).asDiagonal();
    } else if (name == "rotate") {
      constexpr double degree = 3.14159265358979324 / 180;
      if (!vector(0).isZero())
        p.linear = Eigen::AngleAxisd(x[3] * degree, vector(0).normalized()).toRotationMatrix();
    } else { // lookat: from an eye, to a point of interest, with a direction upwards
      const Eigen::Vector3d ahead = (vector(3) - vector(0)).normalized(),
                            right = ahead.cross(vector(6)).normalized();
      p.linear << right, right.cross(ahead), -ahead;
      p.shift = vector(0);
    }
    return p;
  }

  void parse_node(Node& node, const std::string& name, int level)
  {
    if (level == most_levels) xml_.fail("nodes are nested too deeply");
    for (;;) {
      const Xml_scanner::Tag tag = xml_.next();
      for (const char* kind : {"matrix", "translate", "rotate", "scale", "lookat"})
        if (tag.begins(kind)) node.placement = node.placement * transform(kind);
      if (tag.begins("skew"))
        throw IO_error(Error_code::unsupported_format, file_,
                       "a node is placed by a skew, which is not read");
      if (tag.begins("instance_geometry")) node.geometries.push_back(id_of(tag["url"]));
      if (tag.begins("instance_controller")) node.skins.push_back(id_of(tag["url"]));
      if (tag.begins("instance_node")) node.nodes.push_back(id_of(tag["url"]));
      if (tag.begins("node") && !tag.is_end) {
        const std::string id(tag["id"]);
        Node child;
        parse_node(child, "node", level + 1);
        if (!id.empty()) nodes[id] = child; // which may have instances
        node.children.push_back(std::move(child));
      }
      if (tag.ends(name)) break;
    }
  }

  const std::string& file_;
  Xml_scanner xml_;
  std::size_t left_; // values that may still be copied
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_COLLADA_DOCUMENT_H
