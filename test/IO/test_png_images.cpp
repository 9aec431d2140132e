#include "catch.h"

#include "../tessellation/analytic_surfaces.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/png_images.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace test_png_images {

namespace {

struct Pixels {
  int width, height;
  std::vector<unsigned char> rgba;

  explicit Pixels(const std::string& file)
  {
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()));
    image.format = PNG_FORMAT_RGBA;
    width = int(image.width);
    height = int(image.height);
    rgba.resize(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, rgba.data(), 0, nullptr));
  }

  int at(int row, int column, int channel) const { return rgba[4 * (row * width + column) + channel]; }
};

} // namespace

TEST_CASE("an image has u to the right and v upwards")
{
  const int n = 10;
  const auto textures = SM::bake(ring(3, 1), n, [](const SM::Chart_point& a, const SM::Jet&) {
    return Eigen::Vector3d(a.uv[0], a.uv[1], a.chart / 51.);
  });
  const auto images = SM::png_images(textures);
  REQUIRE(images.size() == 9);
  for (int c = 0; c < 9; ++c) {
    const Pixels pixels(images[c]);
    REQUIRE(pixels.width == n);
    REQUIRE(pixels.height == n);
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        CHECK(pixels.at(row, column, 0) == std::lround(255 * (column + 0.5) / n));
        CHECK(std::abs(pixels.at(row, column, 1) - 255 * (1 - (row + 0.5) / n)) <= 0.5 + 1e-4);
        CHECK(pixels.at(row, column, 2) == 5 * c);
        CHECK(pixels.at(row, column, 3) == 255);
      }
  }
}

TEST_CASE("values beyond 0 to 1 become the nearest of these; grey and opacity are kept")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [value, byte] : {std::pair(-3., 0), {0.4, 102}, {7., 255}, {nan, 0}}) {
    const auto grey = SM::bake<SM::Plane_atlas>(2, [v = value](const Eigen::Vector2d&) { return v; });
    CHECK(Pixels(SM::png_images(grey)[0]).at(1, 1, 0) == byte);
    CHECK(Pixels(SM::png_images(grey)[0]).at(1, 1, 2) == byte);
  }
  const auto clear =
    SM::bake<SM::Plane_atlas>(2, [](const Eigen::Vector2d&) { return Eigen::Vector4d(1, 0, 1, 0.2); });
  CHECK(Pixels(SM::png_images(clear)[0]).at(0, 1, 3) == 51);
}

TEST_CASE("the images come into a folder together")
{
  const Temporary_folder folder;
  SM::write_images(folder("new"), {"first", "second"});
  CHECK(folder.entries() == std::vector<std::string>{"new", "new/chart0.png", "new/chart1.png"});
  CHECK(folder.read("new/chart1.png") == "second");
  folder.write("file", "");
  CHECK_THROWS_AS(SM::write_images(folder("file"), {"first"}), SM::IO_error);
}

} // namespace test_png_images
