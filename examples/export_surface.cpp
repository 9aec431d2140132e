// Writes surfaces or the meshes of maps, as fit_mesh leaves them, in a format that other programs read: OBJ with
// materials, binary glTF, VTK, PLY; with images of their normals, their curvature or a checkerboard. Surfaces also as
// CAD systems have them: STEP.

#include "cad_export.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/component_maps_io.h>
#include <CGAL/Simple_manifolds/IO/component_surfaces_io.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/png_images.h>
#include <CGAL/Simple_manifolds/IO/write_cages.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_obj.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_vtp.h>
#include <CGAL/Simple_manifolds/cad/subdivision_cage.h>
#include <CGAL/Simple_manifolds/tessellation/Chart_textures.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
namespace po = boost::program_options;
using Colour = Eigen::Vector3d; // 0 to 1

struct Request {
  std::string input, output, map, texture, up;
  int subdivisions; // 0: chosen by the program
  int texels;
  double chord_error; // 0: none
  std::size_t parts = 1;
  bool is_step;
  int subd;               // cells per side of a tile of a cage for subdivision; 0: none
  tools::Cad_request cad; // for STEP
};

/// What is written, and how far its triangles are from the surfaces, as a fraction of their diagonals.
struct Export {
  SM::Charted_mesh mesh;
  double deviation = 0;
};

/// Blue for -1 or less, light grey for 0, red for 1 or more.
Colour colour(double x)
{
  const Colour end = x < 0 ? Colour(0.23, 0.30, 0.75) : Colour(0.71, 0.02, 0.15);
  const double t = (std::min)(std::abs(x), 1.);
  return (1 - t) * Colour(0.87, 0.87, 0.87) + t * end;
}

//! [checker]
/// A checkerboard of 8 x 8 squares on each tile, in the coordinates of its chart.
template <class Atlas>
auto bake_checker(const Atlas& atlas, int texels)
{
  const auto colour = [&atlas](const typename Atlas::Domain_point& p) -> Colour {
    const int c = atlas.best_chart(p);
    const Eigen::Vector2d uv = atlas.coordinates(c, p);
    const bool is_dark = (int(16 * uv[0]) + int(16 * uv[1])) % 2;
    return (is_dark ? 0.75 : 1) * SM::chart_colour(c);
  };
  return SM::bake<Atlas>(texels, colour, SM::Smoothstep_bump<2>(), atlas);
}
//! [checker]

//! [normals]
/// The unit normal as a colour, as usual: x, y, z from -1 to 1 are red, green, blue from 0 to 1.
template <class Surface>
auto bake_normals(const Surface& surface, int texels)
{
  return SM::bake<CGAL::Parallel_if_available_tag>(surface, texels, [](const SM::Jet& e) -> Colour {
    return (SM::normal(e) + Eigen::Vector3d(1, 1, 1)) / 2;
  });
}
//! [normals]

/// The mean curvature; full colour for the strongest twentieth of the vertices.
template <class Surface>
auto bake_curvature(const Surface& surface, const SM::Charted_mesh& mesh, int texels)
{
  std::vector<double> sizes;
  for (double x : mesh.fields[0].values)
    if (std::isfinite(x)) sizes.push_back(std::abs(x)); // where the surface is a point or a line it is not
  double scale = 0;
  if (!sizes.empty()) {
    const auto strong = sizes.begin() + sizes.size() * 19 / 20;
    std::nth_element(sizes.begin(), strong, sizes.end());
    scale = *strong;
  }
  if (scale == 0) scale = 1;
  std::cout << "mean curvature: blue -" << scale << ", red " << scale << '\n';
  return SM::bake<CGAL::Parallel_if_available_tag>(
    surface, texels, [scale](const SM::Jet& e) { return colour(SM::mean_curvature(e) / scale); });
}

//! [write]
/// Returns the names of the properties that have no place in the file.
std::vector<std::string> write(const std::string& file, const SM::Charted_mesh& mesh, SM::Up_axis up)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".obj") return SM::write_obj(file, mesh);
  if (extension == ".glb") return SM::write_gltf(file, mesh, SM::parameters::up_axis(up));
  if (extension == ".vtp")
    SM::write_vtp(file, mesh);
  else
    SM::write_ply(file, mesh);
  return {};
}
//! [write]

template <class Atlas>
Export export_of(const SM::Manifold_map<Atlas>& map, const Request& request, const std::string& file)
{
  const SM::Mesh_properties properties = SM::read_map_properties(file);
  SM::Charted_mesh mesh = SM::charted_mesh(map, SM::parameters::mesh_properties(std::cref(properties)));
  if (request.texture == "checker")
    mesh.images = SM::png_images(bake_checker(map.atlas(), request.texels));
  else if (request.texture != "none")
    throw po::error("the mesh of a map has only --texture checker");
  return {std::move(mesh), 0};
}

/// The grid that a refinement starts from must not miss the details of the surface: a cell for each control.
template <class Surface>
int first_subdivisions(const Surface& surface, std::size_t parts)
{
  double controls = 0;
  if constexpr (std::is_same_v<typename Surface::Chart_embedding, SM::Hierarchical_embedding>)
    for (int c = 0; c < surface.atlas().number_of_charts(); ++c)
      controls += double(surface.chart_embedding(c).number_of_coefficients());
  const double least = (std::max)(6000. / double(parts), 600.);
  return SM::Tile_grid<typename Surface::Atlas>::subdivisions_for(std::clamp(controls, least, 50000.),
                                                                  surface.atlas());
}

//! [tessellation]
/// A grid, or triangles that are so near to the surface as is asked for.
template <class Surface, class... Map>
Export tessellation_of(const Surface& surface, const Request& request, const SM::Mesh_properties& properties,
                       const Map&... map)
{
  const int subdivisions =
    request.subdivisions > 0 ? request.subdivisions : first_subdivisions(surface, request.parts);
  const auto tessellate = [&](const auto& np) {
    if constexpr (sizeof...(Map) == 0)
      return SM::charted_tessellation(surface, np);
    else
      return SM::charted_tessellation(surface, map..., np.mesh_properties(std::cref(properties)));
  };
  if (request.chord_error > 0) {
    SM::Tessellation_report report;
    SM::Charted_mesh mesh = tessellate(SM::parameters::subdivisions(subdivisions)
                                         .chord_error(request.chord_error)
                                         .tessellation_report(std::ref(report)));
    return {std::move(mesh), report.worst * request.chord_error};
  }
  SM::Charted_mesh mesh = tessellate(SM::parameters::subdivisions(subdivisions));
  std::vector<typename Surface::Domain_point> domain_points;
  for (const SM::Chart_point& p : mesh.chart_points) domain_points.push_back(surface.atlas().point(p));
  const double error = SM::largest_chord_error(surface, domain_points, mesh.triangles);
  return {std::move(mesh), error / SM::surface_diagonal(surface)};
}
//! [tessellation]

template <class Atlas, class ChartEmbedding, class Bump>
Export export_of(const SM::Manifold_surface<Atlas, ChartEmbedding, Bump>& surface, const Request& request,
                 const std::string& map)
{
  Export result =
    map.empty() ? tessellation_of(surface, request, {})
                : tessellation_of(surface, request, SM::read_map_properties(map), SM::read_map<Atlas>(map));
  if (request.texture == "normals")
    result.mesh.images = SM::png_images(bake_normals(surface, request.texels));
  else if (request.texture == "curvature")
    result.mesh.images = SM::png_images(bake_curvature(surface, result.mesh, request.texels));
  else if (request.texture == "checker")
    result.mesh.images = SM::png_images(bake_checker(surface.atlas(), request.texels));
  return result;
}

/// The k-th of `n` maps, where `maps` is a file, the first of several, or a folder of fit_mesh; none if it is empty.
std::string map_of_part(const std::string& maps, const std::string& name, std::size_t k, std::size_t n)
{
  if (maps.empty()) return {};
  const std::filesystem::path path = maps;
  if (std::filesystem::is_directory(path)) return ((n == 1 ? path : path / name) / "map.ply").string();
  return SM::numbered_file(maps, k + 1);
}

/// The meshes of all parts of a file; several are one mesh with parts.
template <class Value>
Export export_of_parts(const std::vector<SM::Component<Value>>& parts, Request request,
                       const std::string& maps)
{
  request.parts = parts.size();
  std::vector<SM::Charted_mesh> meshes;
  std::vector<std::string> names;
  double deviation = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    names.push_back(parts[k].name);
    const std::string map = map_of_part(maps, names[k], k, parts.size());
    Export part =
      std::visit([&](const auto& value) { return export_of(value, request, map); }, parts[k].value());
    meshes.push_back(std::move(part.mesh));
    deviation = (std::max)(deviation, part.deviation);
  }
  return {parts.size() == 1 ? std::move(meshes[0]) : SM::joined(std::move(meshes), names), deviation};
}

bool is_map(const Request& request) { return std::filesystem::path(request.input).extension() == ".ply"; }

/// Calls f with the surfaces of a file. Those of fit_mesh are hierarchical, and their fine grids take little memory as
/// such; those of the paper's method are stacks of patches.
template <class Function>
auto visit_surfaces(const std::string& file, const Function& f)
{
  using Bump = SM::Any_smoothstep_bump;
  SM::Component_surfaces<Bump> hierarchical;
  try {
    hierarchical = SM::read_surfaces<Bump>(file);
  } catch (const SM::IO_error&) { // they may be stacks
  }
  return hierarchical.empty() ? f(SM::read_surfaces<Bump, SM::Patch_stack_embedding>(file)) : f(hierarchical);
}

Export export_of_file(Request request)
{
  if (is_map(request)) {
    if (!request.map.empty()) throw po::error("only a surface has --map");
    return export_of_parts(SM::read_maps(request.input), request, request.input);
  }
  if (request.subdivisions == 0 && request.chord_error == 0) {
    const double tolerance = SM::read_surface_header(request.input).tolerance;
    request.chord_error = tolerance > 0 ? (std::max)(tolerance / 2, 1e-6) : 1e-3;
  }
  return visit_surfaces(request.input,
                        [&](const auto& parts) { return export_of_parts(parts, request, request.map); });
}

//! [step]
/// Writes the surfaces of a file as the bodies of a STEP file.
/// \return the exit status: 1 if a tolerance was not reached, or a body could not be served, 4 if none could
int write_step(Request request)
{
  if (request.cad.cad.tolerance == 0) {
    const double tolerance = SM::read_surface_header(request.input).tolerance;
    request.cad.cad.tolerance = tolerance > 0 ? std::clamp(tolerance / 2, 1e-7, 1.) : 1e-3;
  }
  tools::Cad_parts parts;
  int status = 0;
  visit_surfaces(request.input, [&](const auto& surfaces) {
    for (const auto& part : surfaces) {
      const std::string name = surfaces.size() == 1 ? request.cad.name : request.cad.name + ' ' + part.name;
      try {
        std::visit([&](const auto& s) { tools::add_cad_part(s, name, request.cad.cad, parts); },
                   part.value());
      } catch (const SM::Error& e) { // what is wrong with one body does not lose the others
        std::cerr << "export_surface: " << e.what() << std::endl;
        status = 1;
      }
    }
  });
  if (parts.bodies.empty()) return 4;
  SM::write_step(request.output, parts.bodies, request.cad.step);
  //! [step]
  std::cout << tools::cad_figures(request.output, parts);
  tools::Json metrics = tools::Json::array();
  for (std::size_t k = 0; k < parts.bodies.size(); ++k) {
    const SM::Cad_report& report = parts.reports[k];
    metrics.push_back(tools::metrics_of_cad(report, request.cad.cad, request.cad.step));
    metrics.back()["name"] = parts.bodies[k].name;
    if (!report.tolerance_reached) status = 1;
    for (const std::string& warning :
         tools::cad_warnings(report, request.cad.cad.tolerance, request.cad.step))
      std::cerr << "export_surface: " << (parts.bodies.size() > 1 ? parts.bodies[k].name + ": " : "")
                << warning << std::endl;
  }
  if (!request.cad.metrics.empty()) {
    SM::Atomic_file file(request.cad.metrics);
    file.stream() << tools::Json{{"bodies", metrics}}.dump(2) << '\n';
    file.commit();
  }
  return status;
}

/// Writes cages whose surfaces of Catmull and Clark pass through the surfaces of a file.
void write_cages(const Request& request)
{
  std::vector<std::pair<std::string, SM::Quad_cage>> cages;
  visit_surfaces(request.input, [&](const auto& surfaces) {
    for (const auto& part : surfaces)
      std::visit(
        [&](const auto& s) {
          cages.push_back(
            {part.name, SM::subdivision_cage<CGAL::Parallel_if_available_tag>(s, request.subd)});
        },
        part.value());
  });
  SM::write_cages(request.output, cages);
  for (const auto& [name, cage] : cages)
    std::cout << (cages.size() == 1 ? request.output : name) << ": cage of " << cage.points.size()
              << " vertices, " << cage.quads.size() << " quads\n";
}

/// Whether both names lead to one file that exists.
bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code ignored; // of names that lead nowhere
  return std::filesystem::equivalent(a, b, ignored);
}

/// \throw po::error
Request request_of(int argc, char** argv)
{
  Request r;
  po::options_description options(
    "export_surface SURFACE.json|MAP.ply|FOLDER -o FILE.{obj,glb,vtp,ply,step} [options]", 100);
  options.add_options()("help", "print this and end")(
    "output,o", po::value(&r.output)->required(),
    "file to write: .obj (with .mtl), .glb, .vtp, .ply, or .step of a surface")(
    "map", po::value(&r.map),
    "map.ply that the surface was fitted to, or FOLDER of fit_mesh: adds the error as a field, and the "
    "properties "
    "of the mesh")(
    "up", po::value(&r.up)->default_value("z"),
    "the axis that points upwards, which is y in .glb: z, as usual in PLY, STL, OFF, VTK and GIfTI files, or "
    "y, "
    "as in OBJ, glTF and COLLADA. Units stay what they are; viewers take those of .glb for metres")(
    "texture", po::value(&r.texture)->default_value("none"),
    "images of the charts (.obj, .glb): none, normals, curvature or checker")(
    "texels", po::value(&r.texels)->default_value(256), "texels per side of the image of a chart")(
    "chord-error", po::value(&r.chord_error)->default_value(0, "half the tolerance of the fit"),
    "the largest distance between triangles and surface, fraction of the diagonal; 0.001 where the surface "
    "does not say what it was fitted to")(
    "subdivisions", po::value(&r.subdivisions)->default_value(0, "as needed"),
    "a grid of so many cells per side of a tile instead; with --chord-error what it starts from")(
    "input", po::value(&r.input)->required(),
    "surface.json or map.ply, as fit_mesh and map_mesh write them, also of several bodies; or FOLDER of "
    "fit_mesh, whose "
    "surface.json it is");
  options.add_options()(
    "subd", po::value<int>(&r.subd)->default_value(0, "none"),
    ".obj: instead a cage of so many quads per side of a tile, whose surface of Catmull and Clark "
    "passes through the surface");
  tools::add_cad_options(options);
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), values);
  if (values.count("help")) {
    std::cout << options
              << "Exit status: 0 success, 1 the STEP file is written, but a tolerance was not reached, 2 "
                 "usage, or the\n"
                 "file cannot be written, 3 unreadable input, 4 too little memory, or no surface for STEP.\n";
    std::exit(0);
  }
  po::notify(values);
  if (std::filesystem::is_directory(r.input))
    r.input = (std::filesystem::path(r.input) / "surface.json").string();
  const std::string extension = std::filesystem::path(r.output).extension().string();
  const bool has_images = extension == ".obj" || extension == ".glb";
  r.is_step = extension == ".step" || extension == ".stp";
  if (!has_images && extension != ".vtp" && extension != ".ply" && !r.is_step)
    throw po::error("the output is an .obj, .glb, .vtp, .ply or .step file");
  if (const std::string name = tools::given_cad_option(values); !r.is_step && !name.empty())
    throw po::error("only a .step file has --" + name);
  if (r.is_step) {
    for (const char* name : {"map", "up", "subdivisions", "chord-error"})
      if (values.count(name) && !values[name].defaulted())
        throw po::error(std::string("a .step file has no --") + name);
    if (is_map(r)) throw po::error("a .step file is made of a surface, not of a map");
    r.cad = tools::cad_request(values);
  }
  if (r.subd != 0) {
    if (r.subd < 2 || r.subd > 256) throw po::error("--subd must be from 2 to 256");
    if (extension != ".obj" || is_map(r)) throw po::error("--subd makes an .obj file of a surface");
    for (const char* name : {"map", "texture", "subdivisions", "chord-error", "up"})
      if (values.count(name) && !values[name].defaulted())
        throw po::error(std::string("a cage has no --") + name);
  }
  const auto textures = {"none", "normals", "curvature", "checker"};
  if (std::find(textures.begin(), textures.end(), r.texture) == textures.end())
    throw po::error("--texture is one of none, normals, curvature, checker");
  if (r.up != "y" && r.up != "z") throw po::error("--up is one of z, y");
  if (!has_images && r.texture != "none") throw po::error("only .obj and .glb have a texture");
  if (r.texels < 2 || r.texels > 8192) throw po::error("--texels must be from 2 to 8192");
  if (!values["subdivisions"].defaulted() && (r.subdivisions < 1 || r.subdivisions > 4096))
    throw po::error("--subdivisions must be from 1 to 4096");
  if (!values["chord-error"].defaulted() && !(r.chord_error >= 1e-6))
    throw po::error("--chord-error must be at least 0.000001");
  std::string materials = r.output;
  if (extension == ".obj") materials.replace(materials.size() - 4, 4, ".mtl");
  for (const std::string& file : {r.input, r.map})
    for (const std::string& output : {r.output, materials, r.cad.metrics})
      if (is_same_file(file, output)) throw po::error("the output would replace the input " + file);
  if (!r.cad.metrics.empty() && (r.cad.metrics == r.output || is_same_file(r.cad.metrics, r.output)))
    throw po::error("the metrics would replace the output");
  return r;
}

int main(int argc, char** argv)
{
  const auto fail = [](const std::string& message, int status) {
    std::cerr << "export_surface: " << message << std::endl;
    return status;
  };
  try {
    const Request request = request_of(argc, argv);
    if (request.is_step) return write_step(request);
    if (request.subd > 0) {
      write_cages(request);
      return 0;
    }
    const auto [mesh, deviation] = export_of_file(request);
    const std::vector<std::string> dropped =
      write(request.output, mesh, request.up == "y" ? SM::Up_axis::Y : SM::Up_axis::Z);
    std::cout << request.output << ": " << mesh.atlas << ", "
              << (mesh.parts.empty() ? "" : std::to_string(mesh.parts.size()) + " parts, ")
              << mesh.points.size() << " vertices, " << mesh.triangles.size() << " triangles, "
              << mesh.images.size() << " images\n";
    if (!is_map(request)) std::cout << "  at most " << deviation << " of the diagonal from the surface\n";
    for (const std::string& name : dropped)
      std::cout << "  dropped, without a place in the format: " << name << '\n';
  } catch (const po::error& e) {
    return fail(std::string(e.what()) + " (see export_surface --help)", 2);
  } catch (const SM::IO_error& e) {
    return fail(e.what(), e.code() == SM::Error_code::cannot_write ? 2 : 3);
  } catch (const SM::Topology_error& e) {
    return fail(e.what(), 4);
  } catch (const SM::Error& e) {
    return fail(e.what(), 3);
  } catch (const std::bad_alloc&) {
    return fail("the memory is not sufficient", 4);
  } catch (const std::exception& e) {
    return fail(e.what(), 4);
  }
  return 0;
}
