// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_3MF_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_3MF_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Placement.h>
#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Xml_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Zip_archive.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>
#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The meshes that a 3MF package builds, each in its place: 3MF core specification 1.3, with the paths of the production
// extension and the groups of colours of the materials extension. A face has a colour if it is the same at its corners.
// Textures, mixed materials, slices and beams are not read.
class Three_mf_reader {
public:
  // The contents of a part of the package by its path, or nothing.
  using Part_source = std::function<std::optional<std::string>(std::string_view)>;

  // size: of the package, to which memory and time are bounded.
  Three_mf_reader(const std::string& file, Part_source source, std::size_t size)
    : file_(file), source_(std::move(source)), left_(most_faces + size)
  {
  }

  File_mesh read()
  {
    const std::string path = path_of_model();
    const Part& root = part(path);
    if (root.items.empty()) // nothing is said of what is built: all
      for (const auto& [id, object] : root.objects)
        if (!object.is_component) place({path, id, Placement()}, Placement(), 0);
    for (const Reference& item : root.items) place(item, Placement(), 0);
    colours_.add_to(mesh_.properties.face, std::size_t(mesh_.number_of_faces()));
    if (has_other_materials_)
      mesh_.properties.dropped.push_back("materials of 3MF that are not one colour per face");
    return std::move(mesh_);
  }

private:
  // Copies of components can be many more than what is in the file: a million faces and one for each byte is the limit.
  static constexpr std::size_t most_faces = 1000000;
  static constexpr int most_levels = 100; // of components of components

  struct Reference {
    std::string path, id;
    Placement placement;
  };
  using Colour = std::array<double, 4>; // red, green, blue, opacity, from 0 to 255
  struct Object {
    std::vector<Eigen::Vector3d> points;
    std::vector<Triangle> faces;
    std::map<std::size_t, Colour> colours; // of faces
    std::vector<Reference> components;
    bool is_component = false; // of another one of its part
  };
  struct Part {
    std::map<std::string, Object> objects;
    std::vector<Reference> items;
  };

  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what);
  }

  // The relations of the package say which part is the model.
  std::string path_of_model() const
  {
    if (const std::optional<std::string> relations = source_("_rels/.rels")) {
      Xml_scanner xml(file_, *relations);
      for (;;) {
        const Xml_scanner::Tag tag = xml.next();
        constexpr std::string_view type = "/3dmodel";
        const std::string_view of_tag = tag["Type"];
        if (tag.begins("Relationship") && of_tag.size() >= type.size() &&
            of_tag.substr(of_tag.size() - type.size()) == type)
          return std::string(tag["Target"]);
        if (tag.ends("Relationships")) break;
      }
    }
    return "3D/3dmodel.model";
  }

  const Part& part(const std::string& path)
  {
    const auto known = parts_.find(path);
    if (known != parts_.end()) return known->second;
    const std::optional<std::string> text = source_(path);
    if (!text && parts_.empty())
      throw IO_error(Error_code::unsupported_format, file_,
                     "the archive is no 3MF package: it has no 3D model; unpack it");
    if (!text) fail("the part \"" + Text_scanner::shown(path) + "\" of the package is missing");
    return parts_[path] = part_of(path, *text);
  }

  Part part_of(const std::string& path, const std::string& text)
  {
    Part part;
    Xml_scanner xml(file_, text);
    std::string_view prefix; // of the names of the core specification, with its colon
    Object* object = nullptr;
    std::map<std::string, std::vector<Colour>> groups; // of colours
    std::vector<Colour>* group = nullptr;
    std::string group_of_object, index_of_object;
    for (bool is_first = true;; is_first = false) {
      Xml_scanner::Tag tag = xml.next();
      if (is_first) prefix = tag.name.substr(0, tag.name.find(':') + 1);
      const std::string_view name = tag.name.substr(tag.name.find(':') + 1); // of whatever extension
      if (tag.name.substr(0, prefix.size()) != prefix) tag.name = std::string_view();
      tag.name.remove_prefix((std::min)(prefix.size(), tag.name.size()));
      if (is_first && parts_.empty())
        mesh_.unit = tag["unit"].empty() ? "millimeter" : std::string(tag["unit"]);
      if (is_first && !tag.begins("model")) xml.fail("a part of the package is no model");
      if (tag.begins("object")) {
        const auto [at, is_new] = part.objects.try_emplace(std::string(tag["id"]));
        if (!is_new) xml.fail("object " + Text_scanner::shown(tag["id"]) + " comes twice");
        object = &at->second;
      }
      if (object && tag.begins("vertex"))
        object->points.emplace_back(number(xml, tag, "x"), number(xml, tag, "y"), number(xml, tag, "z"));
      if (object && tag.begins("triangle"))
        object->faces.push_back({to_index(number(xml, tag, "v1")), to_index(number(xml, tag, "v2")),
                                 to_index(number(xml, tag, "v3"))});
      if (object && tag.begins("component")) object->components.push_back(reference(xml, tag, path));
      if (tag.begins("item")) part.items.push_back(reference(xml, tag, path));
      if (tag.is_begin && (name == "basematerials" || name == "colorgroup"))
        group = &groups[std::string(tag["id"])];
      if (tag.is_begin && group && name == "base") group->push_back(colour(tag["displaycolor"]));
      if (tag.is_begin && group && name == "color") group->push_back(colour(tag["color"]));
      if (tag.is_end && (name == "basematerials" || name == "colorgroup")) group = nullptr;
      if (tag.begins("object")) {
        group_of_object = tag["pid"];
        index_of_object = tag["pindex"];
      }
      if (object && tag.begins("triangle")) {
        const std::string of_face(tag["pid"].empty() ? std::string_view(group_of_object) : tag["pid"]);
        const std::string_view index = tag["p1"].empty() ? std::string_view(index_of_object) : tag["p1"];
        const auto is_same = [&](const char* corner) { return tag[corner].empty() || tag[corner] == index; };
        const auto colours = groups.find(of_face);
        double i = -1;
        if (!Text_scanner::is_number(index, i)) i = -1;
        if (colours != groups.end() && i >= 0 && i < double(colours->second.size()) && is_same("p2") &&
            is_same("p3"))
          object->colours[object->faces.size() - 1] = colours->second[std::size_t(i)];
        else if (!of_face.empty())
          has_other_materials_ = true;
      }
      if (tag.ends("object")) object = nullptr;
      if (tag.ends("model")) break;
    }
    for (const auto& [id, other] : part.objects)
      for (const Reference& component : other.components)
        if (const auto at = part.objects.find(component.id);
            at != part.objects.end() && component.path == path)
          at->second.is_component = true;
    return part;
  }

  // "#RRGGBB" or "#RRGGBBAA"; what is none is white.
  static Colour colour(std::string_view text)
  {
    Colour c = {255, 255, 255, 255};
    for (std::size_t k = 0; k < 4 && 2 * k + 2 < text.size(); ++k) {
      int x = 0;
      const char* const begin = text.data() + 2 * k + 1;
      if (text[0] == '#' && std::from_chars(begin, begin + 2, x, 16).ptr == begin + 2 && x >= 0) c[k] = x;
    }
    return c;
  }

  static double number(const Xml_scanner& xml, const Xml_scanner::Tag& tag, const char* name)
  {
    double x = 0;
    if (!Text_scanner::is_number(tag[name], x))
      xml.fail(std::string(name) + " of a " + std::string(tag.name) +
               " is expected to be a number, found \"" + Text_scanner::shown(tag[name]) + '"');
    return x;
  }

  // An item or a component: an object, of another part where there is a path, and its transform, three rows for x, y, z
  // and one for the shift.
  static Reference reference(const Xml_scanner& xml, const Xml_scanner::Tag& tag, const std::string& path)
  {
    Reference r{path, std::string(tag["objectid"]), Placement()};
    for (const auto& [name, value] : tag.attributes)
      if (name == "path" || (name.size() > 5 && name.substr(name.size() - 5) == ":path"))
        r.path = std::string(value);
    const std::string_view transform = tag["transform"];
    if (transform.empty()) return r;
    std::vector<double> x;
    const std::string no_file;
    for (Text_scanner in(no_file, transform, false); !in.at_end();) {
      x.emplace_back();
      if (!Text_scanner::is_number(in.word("a number"), x.back()))
        xml.fail("a transform holds what is no number");
    }
    if (x.size() != 12) xml.fail("a transform has " + std::to_string(x.size()) + " numbers, not 12");
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) r.placement.linear(k, row) = x[std::size_t(3 * row + k)];
      r.placement.shift[row] = x[std::size_t(9 + row)];
    }
    return r;
  }

  // Adds an object with all its components to the mesh.
  void place(const Reference& reference, const Placement& outer, int level)
  {
    const Part& of_object = part(reference.path);
    const auto at = of_object.objects.find(reference.id);
    if (at == of_object.objects.end())
      fail("object " + Text_scanner::shown(reference.id) + " of the package is missing");
    if (level == most_levels) fail("components are nested too deeply, or in a circle");
    const Object& object = at->second;
    const std::size_t size = 1 + object.points.size() + object.faces.size();
    if (size > left_) fail("copies of the components are too many for so small a file");
    left_ -= size;
    const Placement placement = outer * reference.placement;
    const std::size_t first = mesh_.points.size(), first_face = std::size_t(mesh_.number_of_faces());
    for (const Eigen::Vector3d& x : object.points) mesh_.points.push_back(placement(x));
    const bool is_mirrored = placement.is_mirrored();
    for (const Triangle& t : object.faces) {
      for (const int k : {0, is_mirrored ? 2 : 1, is_mirrored ? 1 : 2}) {
        const int v = t[std::size_t(k)];
        if (v < 0 || std::size_t(v) >= object.points.size())
          fail("a triangle of object " + Text_scanner::shown(reference.id) + " refers to vertex " +
               (v < 0 ? "number below 0 or beyond 2^31" : std::to_string(v)) + ", but there are " +
               std::to_string(object.points.size()) + " vertices");
        mesh_.add_corner(static_cast<int>(first) + v);
      }
      mesh_.end_face();
    }
    for (const auto& [f, colour] : object.colours) colours_.put(first_face + f, colour.begin(), colour.end());
    for (const Reference& component : object.components) place(component, placement, level + 1);
  }

  const std::string& file_;
  Part_source source_;
  std::size_t left_; // vertices, faces and components that may still be added
  std::map<std::string, Part> parts_;
  bool has_other_materials_ = false;
  Property_rows colours_{"colour", 4, Scalar_type::UINT8};
  File_mesh mesh_;
};

inline File_mesh read_3mf(const std::string& file, std::string_view bytes)
{
  Zip_archive archive(file, bytes);
  return Three_mf_reader(
           file, [&](std::string_view path) { return archive.read(path); }, bytes.size())
    .read();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_3MF_H
