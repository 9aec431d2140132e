// The coloured meshes that CGAL::draw() shows; the window itself is tested by draw_window.cpp.

#include "catch.h"
#include "meshes.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/draw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <variant>

namespace SM = CGAL::Simple_manifolds;

namespace {

using Mesh = SM::Coloured_mesh;

std::map<std::array<int, 3>, std::size_t> faces_per_colour(const Mesh& mesh)
{
  std::map<std::array<int, 3>, std::size_t> count;
  const auto colour = SM::internal::face_colours(mesh);
  for (const auto f : mesh.faces()) ++count[{colour[f].red(), colour[f].green(), colour[f].blue()}];
  return count;
}

} // namespace

TEST_CASE("a map is drawn as mesh and canonical surface in the colours of the tiles")
{
  std::string file;
  int euler;
  std::size_t tiles;
  std::tie(file, euler, tiles) = GENERATE(table<std::string, int, std::size_t>(
    {{"hand.off", 4, 6}, {"knot1.off", 0, 9}, {"three_peaks.off", 2, 1}}));
  CAPTURE(file);
  Mesh input;
  SM::read_mesh(cgal_mesh(file), input);
  std::visit(
    [&](const auto& map) {
      const Mesh drawn = SM::coloured_mesh(map);
      CHECK(drawn.number_of_faces() == 2 * map.number_of_faces());
      CHECK(int(drawn.number_of_vertices() + drawn.number_of_faces()) - int(drawn.number_of_edges()) ==
            euler);
      const auto count = faces_per_colour(drawn);
      CHECK(count.size() == tiles);
      for (const auto& c : count) CHECK(c.second % 2 == 0); // half of them on the mesh, half on its domain

      // mesh and canonical surface lie side by side
      double left = -2, right = 4;
      const std::size_t half = drawn.number_of_vertices() / 2;
      for (const auto v : drawn.vertices()) {
        const double x = drawn.point(v).x();
        if (std::size_t(v) < half)
          left = (std::max)(left, x);
        else
          right = (std::min)(right, x);
      }
      CHECK(left <= 1);
      CHECK(right >= 1.2 - 1e-12);
    },
    SM::map_to_canonical_surface(input));
}

TEST_CASE("a surface is drawn with as many faces in each colour")
{
  using Level = SM::Hierarchical_embedding::Level;
  std::vector<SM::Hierarchical_embedding> charts;
  for (int c = 0; c < 9; ++c)
    charts.emplace_back(3, std::vector<Level>{{4, {24}, {Eigen::Vector3d(1, c, 2)}}});
  const SM::Manifold_surface<SM::Torus_atlas> surface(charts);
  const Mesh drawn = SM::coloured_mesh(surface, SM::parameters::subdivisions(5));
  CHECK(drawn.number_of_faces() == 2 * 9 * 25);
  const auto count = faces_per_colour(drawn);
  REQUIRE(count.size() == 9);
  for (const auto& c : count) CHECK(c.second == 50);
}
