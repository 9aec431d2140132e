// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_GLTF_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_GLTF_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/IO/internal/Byte_buffer.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/IO/internal/vertex_colours.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Which axis of a mesh points upwards.
enum class Up_axis {
  Y, ///< as usual in OBJ, glTF and COLLADA files
  Z  ///< as usual in all others: STL, PLY, OFF, VTK, GIfTI, 3MF
};

namespace internal {

// A glTF 2.0 asset that grows part by part: the JSON text and the bytes that it refers to.
class Gltf_asset {
public:
  Gltf_asset(const Charted_mesh& mesh, Up_axis up) : mesh_(mesh), up_(up), colours_(colours_of(mesh))
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& x : mesh.points) box.extend(turned(x));
    if (!box.isEmpty()) centre_ = box.center();
    if (!mesh.images.empty()) colours_ = nullptr; // both would be multiplied
    if (colours_) written_.push_back(colours_);
    for (const Mesh_property& p : mesh.properties.vertex)
      if (&p != colours_ && p.name != "colour" && p.components <= 4 && is_in_single_precision(p)) {
        attributes_.push_back({attribute_name(p), &p});
        written_.push_back(&p);
      }
    json_["asset"] = {{"version", "2.0"}, {"generator", "Simple_manifolds"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", Json::array()}}};
    const std::vector<Charted_mesh::Part> bodies = bodies_of(mesh);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      json_["scenes"][0]["nodes"].push_back(b);
      // Positions are in single precision: relative to the centre they keep as many digits as they can.
      Json node = {{"mesh", b}, {"translation", {centre_.x(), centre_.y(), centre_.z()}}};
      if (!mesh.parts.empty()) node["name"] = bodies[b].name;
      json_["nodes"].push_back(node);
      json_["meshes"].push_back(
        {{"name", mesh.parts.empty() ? mesh.kind : bodies[b].name}, {"primitives", Json::array()}});
    }
  }

  void add(const Chart_part& part)
  {
    std::vector<Eigen::Vector3f> points, normals;
    std::vector<Eigen::Vector2f> coordinates;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const int v = part.vertices[i];
      points.push_back((turned(mesh_.points[v]) - centre_).cast<float>());
      if (!mesh_.normals.empty()) normals.push_back(valid_normal(turned(mesh_.normals[v])));
      const Eigen::Vector2d uv = part.coordinates[i];
      coordinates.push_back(Eigen::Vector2f(float(uv[0]), float(1 - uv[1]))); // v = 0 is the top of an image
    }
    Json primitive;
    Json& attributes = primitive["attributes"];
    attributes["POSITION"] = add_vectors(points);
    add_bounds(points);
    if (!normals.empty()) attributes["NORMAL"] = add_vectors(normals);
    if (part.has_coordinates()) attributes["TEXCOORD_0"] = add_vectors(coordinates);

    for (const auto& [name, property] : attributes_) // sets of coordinates are numbered from 0 without a gap
      attributes[name == "TEXCOORD_1" && !part.has_coordinates() ? "TEXCOORD_0" : name] =
        add_property(*property, part.vertices);

    Json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.7}};
    if (part.image) {
      surface["baseColorTexture"]["index"] = add_texture(*part.image);
    } else if (colours_) {
      attributes["COLOR_0"] = add_colours(part.vertices);
    } else {
      const Eigen::Vector3f colour = linear_colour(chart_colour(part.chart)).cast<float>();
      attributes["COLOR_0"] = add_vectors(std::vector<Eigen::Vector3f>(points.size(), colour));
    }
    primitive["indices"] = add_indices(part.triangles);
    primitive["material"] = json_["materials"].size();
    json_["materials"].push_back(
      {{"name", part.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}});
    json_["meshes"][part.body]["primitives"].push_back(primitive);
  }

  // The file: a header, and the text and the bytes as one chunk each.
  std::string glb(const std::string& file)
  {
    json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    Byte_buffer text;
    text.add(json_.dump(-1, ' ', false, Json::error_handler_t::replace)); // of names that are no UTF-8
    text.align(' ');
    const std::size_t size = 12 + 8 + text.size() + 8 + bytes_.size();
    if (size > (std::numeric_limits<std::uint32_t>::max)())
      throw IO_error(Error_code::cannot_write, file,
                     "a glTF file cannot have " + std::to_string(size) + " bytes");
    Byte_buffer glb;
    for (std::uint32_t x : {0x46546C67u, 2u, std::uint32_t(size), std::uint32_t(text.size()), 0x4E4F534Au})
      glb.add(x); // "glTF", version, size; size, "JSON"
    glb.add(text.bytes());
    for (std::uint32_t x : {std::uint32_t(bytes_.size()), 0x004E4942u}) glb.add(x); // size, "BIN"
    glb.add(bytes_.bytes());
    return glb.bytes();
  }

  // The names of the properties that are not in it.
  std::vector<std::string> dropped() const { return names_without(mesh_.properties, written_); }

private:
  using Json = nlohmann::ordered_json;
  enum {
    ARRAY_BUFFER = 34962,
    ELEMENT_ARRAY_BUFFER = 34963,
    UNSIGNED_INT = 5125,
    FLOAT = 5126,
    LINEAR_MIPMAP_LINEAR = 9987,
    LINEAR = 9729,
    CLAMP_TO_EDGE = 33071
  };

  // In glTF y points upwards.
  Eigen::Vector3d turned(const Eigen::Vector3d& x) const
  {
    return up_ == Up_axis::Y ? x : Eigen::Vector3d(x.x(), x.z(), -x.y());
  }

  // glTF allows no NaN.
  static bool is_in_single_precision(const Mesh_property& p)
  {
    return std::all_of(p.values.begin(), p.values.end(),
                       [](double x) { return std::abs(x) <= double((std::numeric_limits<float>::max)()); });
  }

  // Attributes of applications begin with an underscore and are in capitals.
  std::string attribute_name(const Mesh_property& p) const
  {
    const auto is_used = [this](const std::string& name) {
      return std::any_of(attributes_.begin(), attributes_.end(),
                         [&](const auto& a) { return a.first == name; });
    };
    if (p.name == "uv" && p.components == 2 && !is_used("TEXCOORD_1")) return "TEXCOORD_1"; // 0 is the chart
    std::string name = '_' + p.name;
    for (char& c : name)
      c = std::isalnum(static_cast<unsigned char>(c))
            ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
            : '_';
    while (is_used(name)) name += "_OF_INPUT";
    return name;
  }

  std::size_t add_property(const Mesh_property& p, const std::vector<int>& vertices)
  {
    const bool is_upside_down = p.name == "uv" && p.components == 2; // v = 0 is the top of an image
    const std::size_t begin = bytes_.size();
    for (const int v : vertices)
      for (std::size_t k = 0; k < std::size_t(p.components); ++k) {
        const double x = p(std::size_t(v), k);
        bytes_.add(float(is_upside_down && k == 1 ? 1 - x : x));
      }
    return add_accessor(add_view(begin, ARRAY_BUFFER), FLOAT, vertices.size(),
                        p.components == 1 ? "SCALAR" : "VEC" + std::to_string(p.components));
  }

  std::size_t add_colours(const std::vector<int>& vertices)
  {
    std::vector<Eigen::Vector4f> colours;
    for (const int v : vertices) {
      Eigen::Vector4d colour = colour_at(*colours_, std::size_t(v));
      colour.head<3>() = linear_colour(colour.head<3>());
      colours.push_back(colour.cast<float>());
    }
    return add_vectors(colours);
  }

  // Where the surface has no normal there may be anything of length 1.
  static Eigen::Vector3f valid_normal(const Eigen::Vector3d& n)
  {
    const Eigen::Vector3d unit = n.normalized();
    return (unit.allFinite() && !unit.isZero() ? unit : Eigen::Vector3d::UnitZ()).cast<float>();
  }

  // The bytes from `begin` to the end become a view of the buffer.
  std::size_t add_view(std::size_t begin, int target)
  {
    Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}};
    if (target) view["target"] = target;
    bytes_.align();
    json_["bufferViews"].push_back(view);
    return json_["bufferViews"].size() - 1;
  }

  std::size_t add_accessor(std::size_t view, int type, std::size_t count, const std::string& shape)
  {
    json_["accessors"].push_back(
      {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}});
    return json_["accessors"].size() - 1;
  }

  template <class Vector>
  std::size_t add_vectors(const std::vector<Vector>& vectors)
  {
    const std::size_t begin = bytes_.size();
    for (const Vector& x : vectors)
      for (int k = 0; k < x.size(); ++k) bytes_.add(float(x[k]));
    return add_accessor(add_view(begin, ARRAY_BUFFER), FLOAT, vectors.size(),
                        "VEC" + std::to_string(int(Vector::RowsAtCompileTime)));
  }

  // The least and the largest coordinates of the last accessor, which viewers rely on.
  void add_bounds(const std::vector<Eigen::Vector3f>& points)
  {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& x : points) box.extend(x);
    json_["accessors"].back()["min"] = {(box.min)().x(), (box.min)().y(), (box.min)().z()};
    json_["accessors"].back()["max"] = {(box.max)().x(), (box.max)().y(), (box.max)().z()};
  }

  std::size_t add_indices(const std::vector<Triangle>& triangles)
  {
    const std::size_t begin = bytes_.size();
    for (const Triangle& t : triangles)
      for (int v : t) bytes_.add(std::uint32_t(v));
    return add_accessor(add_view(begin, ELEMENT_ARRAY_BUFFER), UNSIGNED_INT, 3 * triangles.size(), "SCALAR");
  }

  std::size_t add_texture(const std::string& image)
  {
    const std::size_t begin = bytes_.size();
    bytes_.add(image);
    const std::size_t view = add_view(begin, 0);
    json_["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    json_["samplers"] = {{{"magFilter", int(LINEAR)},
                          {"minFilter", int(LINEAR_MIPMAP_LINEAR)},
                          {"wrapS", int(CLAMP_TO_EDGE)},
                          {"wrapT", int(CLAMP_TO_EDGE)}}};
    json_["textures"].push_back({{"source", json_["images"].size() - 1}, {"sampler", 0}});
    return json_["textures"].size() - 1;
  }

  const Charted_mesh& mesh_;
  Up_axis up_;
  const Mesh_property* colours_;
  std::vector<std::pair<std::string, const Mesh_property*>> attributes_; // further ones, and their names
  std::vector<const Mesh_property*> written_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Json json_;
  Byte_buffer bytes_;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a mesh as a binary glTF 2.0 file (.glb): one primitive and one material per chart, with normals
/// where the mesh has them, and with the coordinates in the chart as texture coordinates. With `mesh.images`
/// the images of the charts are in the file; without, vertices have the colour of the chart. A vertex on the
/// border of two charts comes once in each. Positions are in single precision relative to the centre of the
/// bounding box. Units are what they are: viewers take them for metres. Fields are not written. Each of several parts is a
/// node and a mesh with its name.
///
/// Of the properties of vertices, a `colour` is that of the vertices where there are no images, `uv` is `TEXCOORD_1` (on faces that are in no chart `TEXCOORD_0`), and
/// others with up to four finite components are attributes with an underscore and capitals, such as `_TEMPERATURE`.
///
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{up_axis} \cgalParamDescription{the axis of the mesh that points upwards, which is y in glTF: with
///     `Up_axis::Z` a point (x, y, z) is written as (x, z, -y)}
///     \cgalParamType{`Up_axis`} \cgalParamDefault{`Up_axis::Y`: axes as they are} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the names of the properties that have no place in the file
/// \pre `mesh.is_valid()`
/// \throw IO_error (`cannot_write`), also when a coordinate is too large for single precision; a file that
///   was there before is then as it was
template <class NamedParameters = parameters::Default_named_parameters>
std::vector<std::string> write_gltf(const std::string& file, const Charted_mesh& mesh,
                                    const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "up_axis");
  CGAL_precondition(mesh.is_valid());
  for (const Eigen::Vector3d& x : mesh.points)
    if (!(x.cwiseAbs().maxCoeff() < (std::numeric_limits<float>::max)() / 4))
      throw IO_error(Error_code::cannot_write, file,
                     "a coordinate is too large for the single precision of glTF");
  internal::Gltf_asset asset(mesh, internal::parameter(np, internal_np::up_axis, Up_axis::Y));
  for (const internal::Chart_part& part : internal::chart_parts(mesh)) asset.add(part);
  Atomic_file output(file);
  output.stream() << asset.glb(file);
  output.commit();
  return asset.dropped();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_GLTF_H
