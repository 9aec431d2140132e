// The hyperbolic surface goes through all layers: map, fit, evaluation, measures, tessellation, files.

#include "../bodies.h"
#include "catch.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>
#include <CGAL/Simple_manifolds/embedding/Map_embedding.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <variant>

namespace test_hyperbolic_surface {

namespace {

namespace SM = CGAL::Simple_manifolds;
using Atlas = SM::Hyperbolic_atlas;
using Map = SM::Manifold_map<Atlas>;
using Surface = SM::Manifold_surface<Atlas>;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

const double pi = std::acos(-1.);

const Map& pretzel_map()
{
  static const Map map = [] {
    const bodies::Body body = bodies::pretzel();
    return SM::map_to_hyperbolic_surface(body.points, body.triangles);
  }();
  return map;
}

const Surface& pretzel()
{
  static const Surface surface =
    SM::fit_surface(pretzel_map(), SM::parameters::rms_error(2e-2).max_error(1e-1));
  return surface;
}

} // namespace

TEST_CASE("a surface of genus 2: all charts see the same, and Gauss and Bonnet hold")
{
  const Surface& surface = pretzel();
  const Atlas& atlas = surface.atlas();
  const auto points = SM::random_domain_points(300, 2, atlas);
  const SM::Closest_point_finder<Surface> finder(surface);
  std::vector<Eigen::Vector3d> positions;
  surface.points(points, std::back_inserter(positions));
  const double size = pretzel_map().diagonal();
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK((positions[i] - pretzel_map()(points[i])).norm() < 0.15 * size);
    const Eigen::Vector3d normal = surface.normal(points[i]);
    for (const auto& q : atlas.charts_at(points[i])) {
      const SM::Jet e = surface.jet(q);
      CHECK((e.value - positions[i]).norm() < 1e-13 * size);
      CHECK((SM::normal(e) - normal).norm() < 1e-11);
    }
    CHECK(finder(positions[i]).distance < 1e-9 * size);
  }
  const auto curvature = SM::integrate(
    surface, [](const SM::Jet& e) { return SM::gaussian_curvature(e); },
    SM::parameters::relative_error(1e-4));
  CHECK(curvature.value == Approx(-4 * pi).epsilon(1e-3));

  const SM::Manifold_surface<Atlas, SM::Map_embedding<Map>> facets(SM::map_embeddings(pretzel_map()), {},
                                                                   atlas);
  for (const auto& p : points) CHECK((facets.point(p) - pretzel_map()(p)).norm() < 1e-12 * size);

  Mesh uniform, adaptive;
  SM::tessellate(surface, uniform, SM::parameters::subdivisions(5));
  CHECK(CGAL::is_closed(uniform));
  CHECK(uniform.number_of_vertices() == 6 * 25 - 2);
  CHECK(int(uniform.number_of_vertices()) - int(uniform.number_of_edges()) + int(uniform.number_of_faces()) ==
        -2);
  SM::tessellate(surface, adaptive, SM::parameters::chord_error(5e-2));
  CHECK(CGAL::is_closed(adaptive));
}

TEST_CASE("files of hyperbolic maps and surfaces keep the genus; files of no genus are refused")
{
  const Temporary_folder folder;
  SM::write_map(folder("map.ply"), pretzel_map());
  const Map again = SM::read_map<Atlas>(folder("map.ply"));
  CHECK(again.atlas().genus() == 2);
  CHECK(again.domain_points() == pretzel_map().domain_points());
  CHECK(std::holds_alternative<Map>(SM::read_map(folder("map.ply"))));
  const Eigen::Vector3d p(4, 0.3, -0.7);
  for (const char* name : {"surface.json", "surface.cbor"}) {
    SM::write_surface(folder(name), pretzel());
    const Surface read = SM::read_surface<Surface>(folder(name));
    CHECK(read.atlas().genus() == 2);
    CHECK(read.point(p) == pretzel().point(p));
  }
  SM::write_samples(folder("samples.csv"), pretzel(), {p});
  std::string header;
  std::getline(std::ifstream(folder("samples.csv")) >> std::ws, header);
  CHECK(header == "domain_tile,domain_u,domain_v,x,y,z,nx,ny,nz,mean_curvature,gaussian_curvature");
  const auto with_genus = [&](const char* name, const std::string& from, const std::string& to) {
    std::ostringstream text;
    text << std::ifstream(folder(name), std::ios::binary).rdbuf();
    std::string s = text.str();
    const auto at = s.find(from);
    REQUIRE(at != std::string::npos);
    s.replace(at, from.size(), to);
    std::ofstream(folder(std::string("bad_") + name), std::ios::binary) << s;
  };
  for (const char* genus : {"1", "0", "3", "9999999"}) {
    CAPTURE(genus);
    with_genus("map.ply", "genus 2", std::string("genus ") + genus);
    CHECK_THROWS_AS(SM::read_map<Atlas>(folder("bad_map.ply")), SM::Error);
  }
  with_genus("surface.json", "\"genus\":2", "\"genus\":1");
  CHECK_THROWS_WITH(SM::read_surface<Surface>(folder("bad_surface.json")),
                    Catch::Matchers::ContainsSubstring("no hyperbolic surface with genus 1"));
}

} // namespace test_hyperbolic_surface
