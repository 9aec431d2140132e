// Usage: write_files FOLDER
//
// Writes a tessellation and the mesh of a map of each genus in all formats, and as expected.json what they
// hold; and surfaces as STEP files, with expected_step.json.

#include "../IO/sample_maps.h"
#include "../cad/thorny_sphere.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/internal/chart_parts.h>
#include <CGAL/Simple_manifolds/IO/png_images.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_obj.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/IO/write_vtp.h>

#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

void write(const std::string& folder, const std::string& name, const SM::Charted_mesh& mesh, Json& expected)
{
  const std::string file = folder + '/' + name;
  SM::write_obj(file + ".obj", mesh);
  SM::write_ply(file + ".ply", mesh);
  SM::write_gltf(file + ".glb", mesh);
  SM::write_vtp(file + ".vtp", mesh);

  Json& j = expected[name];
  const SM::internal::Part_numbers part(mesh);
  std::set<std::pair<int, int>> charts; // of parts
  std::set<std::pair<int, int>> wedges; // a vertex in one chart
  Eigen::AlignedBox3d box;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    charts.insert({mesh.parts.empty() ? 0 : part.triangles[f], mesh.charts[f]});
    for (int v : mesh.triangles[f]) {
      wedges.insert({v, mesh.charts[f]});
      box.extend(mesh.points[v]);
    }
  }
  j["vertices"] = mesh.points.size();
  j["faces"] = mesh.triangles.size();
  j["charts"] = charts.size();
  j["wedges"] = wedges.size();
  j["images"] = mesh.images.size();
  j["low"] = {box.min().x(), box.min().y(), box.min().z()};
  j["high"] = {box.max().x(), box.max().y(), box.max().z()};
  for (const auto& field : mesh.fields) j["fields"][field.name] = field.values;
  for (const auto& x : mesh.points) j["points"].push_back({x.x(), x.y(), x.z()});
  for (const auto& n : mesh.normals) j["normals"].push_back({n.x(), n.y(), n.z()});
  j["triangles"] = mesh.triangles;
  j["face_charts"] = mesh.charts;
  j["parts"] = part.triangles;
  for (const auto& p : mesh.parts) j["part_names"].push_back(p.name);
}

template <class Surface>
void write(const std::string& folder, const Surface& surface, Json& expected)
{
  const std::string name = Surface::Atlas::name;
  const auto map = grid_map(surface, 3);
  SM::Charted_mesh mesh = SM::charted_tessellation(surface, map, SM::parameters::subdivisions(5));
  write(folder, name, mesh, expected);
  mesh.images = SM::png_images(SM::bake(surface, 32, [](const SM::Jet& e) -> Eigen::Vector3d {
    return (SM::normal(e) + Eigen::Vector3d::Ones()) / 2;
  }));
  write(folder, name + "_textured", mesh, expected);
  write(folder, name + "_map", SM::charted_mesh(map, surface), expected);
}

// Surfaces as the bodies of a STEP file, in inches.
template <class NamedParameters, class... Surface>
void write_step(const std::string& folder, const std::string& name, Json& expected, const NamedParameters& np,
                const Surface&... surface)
{
  std::vector<SM::Step_body> bodies;
  Json& e = expected[name];
  e = {{"solids", 0}, {"shells", 0}, {"faces", 0}, {"volume", 0.}, {"diagonal", 0.}, {"unit", 25.4}};
  const auto add = [&](const auto& s) {
    SM::Cad_report report;
    bodies.push_back({name, SM::cad_surface(s, np.cad_report(std::ref(report)))});
    e["solids"] = e["solids"].template get<int>() + bodies.back().surface.is_closed();
    e["shells"] = e["shells"].template get<int>() + 1;
    e["faces"] = e["faces"].template get<std::size_t>() + report.faces;
    e["volume"] = e["volume"].template get<double>() + report.volume;
    e["diagonal"] = report.diagonal;
  };
  (add(surface), ...);
  SM::Step_options options;
  options.unit = SM::Step_unit::INCH;
  SM::write_step(folder + '/' + name + ".step", bodies, options);
}

} // namespace

int main(int, char** argv)
{
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder);
  Json expected;
  write(folder, paraboloid(), expected);
  write(folder, ellipsoid(Eigen::Vector3d(1, 2, 3)), expected);
  write(folder, ring(3, 1), expected);
  write(folder, "no_chart", SM::charted_mesh(tetrahedron_map()), expected);

  // Several bodies, with the fields that all have: JSON knows no NaN.
  SM::Charted_mesh several =
    SM::joined({SM::charted_tessellation(ellipsoid(Eigen::Vector3d(1, 2, 3))),
                SM::charted_tessellation(ring(9, 1)), SM::charted_mesh(tetrahedron_map())},
               {"part-1", "ring", "third"});
  several.fields.clear();
  write(folder, "several", several, expected);
  std::ofstream(folder + "/expected.json") << expected;

  Json steps;
  const auto tolerance = SM::parameters::cad_tolerance(1e-3);
  write_step(folder, "shell", steps, tolerance, paraboloid());
  write_step(folder, "solid", steps, tolerance, ellipsoid(Eigen::Vector3d(1, 2, 3)));
  write_step(folder, "finely_cut", steps, tolerance.face_cost(0.), analytic::thorny_sphere()); // T-junctions
  write_step(folder, "nine", steps, tolerance, ring(3, 1));
  write_step(folder, "one", steps, tolerance.max_faces(std::size_t(1)), ring(3, 1));
  write_step(folder, "two_bodies", steps, tolerance, ellipsoid(Eigen::Vector3d(1, 2, 3)), ring(9, 1));
  std::ofstream(folder + "/expected_step.json") << steps;
}
