#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/write_gltf.h>

#include <nlohmann/json.hpp>

#include <cstring>

namespace test_write_gltf {

// That the files follow the rules of glTF is checked with the validator of Khronos, see test/readers.

namespace {

using Json = nlohmann::json;

std::uint32_t integer(const std::string& bytes, std::size_t at)
{
  std::uint32_t x;
  std::memcpy(&x, bytes.data() + at, sizeof x); // on a little endian machine
  return x;
}

struct Glb {
  Json json;
  std::string data;

  explicit Glb(const std::string& bytes)
  {
    REQUIRE(bytes.substr(0, 4) == "glTF");
    REQUIRE(integer(bytes, 8) == bytes.size());
    const std::uint32_t text = integer(bytes, 12);
    REQUIRE(bytes.substr(16, 4) == "JSON");
    json = Json::parse(bytes.substr(20, text));
    REQUIRE(integer(bytes, 20 + text) == bytes.size() - 28 - text);
    data = bytes.substr(28 + text);
  }

  // The numbers of an accessor, of four bytes each.
  template <class Number>
  std::vector<Number> numbers(const Json& accessor_index) const
  {
    const Json& accessor = json["accessors"][accessor_index.get<int>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<int>()];
    std::vector<Number> values(view["byteLength"].get<std::size_t>() / 4);
    std::memcpy(values.data(), data.data() + view["byteOffset"].get<std::size_t>(), 4 * values.size());
    return values;
  }
};

} // namespace

TEST_CASE("each primitive of a glTF file is a tile with coordinates in its chart, v downwards")
{
  const Temporary_folder folder;
  const auto surface = ring(3, 1);
  SM::write_gltf(folder("r.glb"), SM::charted_tessellation(surface, SM::parameters::subdivisions(4)));
  const Glb glb(folder.read("r.glb"));
  const Json& primitives = glb.json["meshes"][0]["primitives"];
  REQUIRE(primitives.size() == 9);
  double worst = 0;
  for (int c = 0; c < 9; ++c) {
    const Json& attributes = primitives[c]["attributes"];
    const auto points = glb.numbers<float>(attributes["POSITION"]);
    const auto normals = glb.numbers<float>(attributes["NORMAL"]);
    const auto uvs = glb.numbers<float>(attributes["TEXCOORD_0"]);
    const auto colours = glb.numbers<float>(attributes["COLOR_0"]);
    const auto indices = glb.numbers<std::uint32_t>(primitives[c]["indices"]);
    REQUIRE(points.size() == 75);
    REQUIRE(normals.size() == 75);
    REQUIRE(uvs.size() == 50);
    CHECK(colours.size() == 75);
    CHECK(indices.size() == 96);
    CHECK(*std::max_element(indices.begin(), indices.end()) == 24);
    for (int i = 0; i < 25; ++i) {
      const SM::Chart_point a{c, {uvs[2 * i], 1 - uvs[2 * i + 1]}};
      const Eigen::Vector3f point(&points[3 * i]), normal(&normals[3 * i]);
      worst = (std::max)({worst, (surface.point(a) - point.cast<double>()).norm(),
                          (surface.normal(a) - normal.cast<double>()).norm()});
    }
  }
  CHECK(worst < 1e-5);
}

TEST_CASE("positions are relative to the centre, so that far from the origin no digits are lost")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  const Eigen::Vector3d far(1e9, -2e9, 3e9);
  for (auto& x : mesh.points) x += far;
  SM::write_gltf(folder("m.glb"), mesh);
  const Glb glb(folder.read("m.glb"));
  const auto points = glb.numbers<float>(glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"]);
  const Json& translation = glb.json["nodes"][0]["translation"];
  REQUIRE(points.size() == 27);
  Eigen::Vector3d low(9, 9, 9), high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = translation[i % 3].get<double>() + points[i] - far[i % 3];
    low[i % 3] = (std::min)(low[i % 3], x);
    high[i % 3] = (std::max)(high[i % 3], x);
  }
  CHECK((low - Eigen::Vector3d(0, 0, 0)).norm() < 1e-6);
  CHECK((high - Eigen::Vector3d(1, 1, 1)).norm() < 1e-6);
}

TEST_CASE("images are in the glTF file, instead of colours")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  mesh.images = {"the bytes of an image"};
  SM::write_gltf(folder("m.glb"), mesh);
  const Glb glb(folder.read("m.glb"));
  CHECK_FALSE(glb.json["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));
  CHECK(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
  CHECK(glb.data.find(mesh.images[0]) != std::string::npos);
}

TEST_CASE("what single precision cannot hold is an error, and no file")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  mesh.points[3].y() = 1e200;
  CHECK_THROWS_AS(SM::write_gltf(folder("m.glb"), mesh), SM::IO_error);
  CHECK(folder.entries().empty());
}

} // namespace test_write_gltf
