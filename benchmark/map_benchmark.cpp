// Times, memory and distortion of maps over size, domain, threads, effort and energy, as CSV; on disks also
// CGAL's own parameterizers in the same run, and on spheres its orbifolds. See README.md in this folder.

#include "Memory_clock.h"

#include <CGAL/Polygon_mesh_processing/measure.h> // longest_border()
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>

#include <boost/program_options.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <list>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace po = boost::program_options;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; } // of all threads
double wall_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Processor seconds by phase.
struct Phase_clock : SM::Default_visitor {
  void start_phase(const char* name)
  {
    phase_ = name;
    start_ = cpu_seconds();
  }
  void end_phase() { seconds[phase_] += cpu_seconds() - start_; }

  std::map<std::string, double> seconds;

private:
  std::string phase_;
  double start_ = 0;
};

struct Row {
  std::string mesh, domain, method;
  std::size_t faces = 0;
  int threads = 1;
  std::string energy, effort;
  double lambda = 0, wall = 0, cpu = 0, decimate = 0, embed = 0, certify = 0, bytes_per_face = 0;
  double queries_per_second = 0;
  std::size_t not_positive = 0;
  SM::Distortion distortion;
};

class Table {
public:
  explicit Table(const std::string& file) : out_(file)
  {
    out_ << "mesh,domain,method,faces,threads,energy,lambda,effort,wall_s,cpu_s,decimate_cpu_s,embed_cpu_s,"
            "certify_cpu_s,bytes_per_face,queries_per_cpu_s,faces_not_positive,angle,area,efficiency,"
            "symmetric_dirichlet,smallest_area\n";
    if (!out_) throw std::runtime_error("cannot write " + file);
  }

  void add(const Row& r)
  {
    out_ << r.mesh << ',' << r.domain << ',' << r.method << ',' << r.faces << ',' << r.threads << ','
         << r.energy << ',' << r.lambda << ',' << r.effort << ',' << r.wall << ',' << r.cpu << ','
         << r.decimate << ',' << r.embed << ',' << r.certify << ',' << r.bytes_per_face << ','
         << r.queries_per_second << ',' << r.not_positive << ',' << r.distortion.angle_mean << ','
         << r.distortion.area_mean_abs_log10 << ',' << r.distortion.l2_efficiency << ','
         << r.distortion.symmetric_dirichlet << ',' << r.distortion.smallest_domain_area << std::endl;
    std::cout << r.mesh << ' ' << r.faces << " faces, " << r.method << ' ' << r.energy;
    if (r.energy == "amips") std::cout << ' ' << r.lambda;
    std::cout << ' ' << r.effort << ", " << r.threads << " threads: " << r.wall << " s (cpu " << r.cpu
              << "), " << r.bytes_per_face << " bytes per face, energy " << r.distortion.symmetric_dirichlet
              << ", " << r.not_positive << " faces not positive" << std::endl;
  }

private:
  std::ofstream out_;
};

/// Distinct random points of the domain, found in the map.
template <class Map>
double queries_per_second(const Map& map)
{
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.; };
  std::vector<typename Map::Domain_point> points;
  for (int i = 0; i < 200000; ++i) {
    const int tile = static_cast<int>(random() % map.atlas().number_of_charts());
    const double s = number();
    points.push_back(map.atlas().tile_point(tile, s, number()));
  }
  const double start = cpu_seconds();
  long sum = 0;
  for (const auto& p : points) sum += map.to_mesh(p).face;
  const double seconds = cpu_seconds() - start;
  return sum < 0 ? 0 : static_cast<double>(points.size()) / seconds;
}

struct Setting {
  int threads = 1;
  SM::Energy energy = SM::Energy::SYMMETRIC_DIRICHLET;
  double lambda = 0.3;
  SM::Effort effort = SM::Effort::DEFAULT;
};

SM::Any_mesh_map<Mesh> map_mesh(const Mesh& mesh, const Setting& s, Phase_clock& phases)
{
  const auto np =
    SM::parameters::energy(s.energy).energy_lambda(s.lambda).effort(s.effort).visitor(std::ref(phases));
#ifdef CGAL_LINKED_WITH_TBB
  if (s.threads > 1) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(s.threads));
    return SM::map_to_canonical_surface<CGAL::Parallel_tag>(mesh, np);
  }
#endif
  return SM::map_to_canonical_surface<CGAL::Sequential_tag>(mesh, np);
}

void measure(const std::string& name, const Mesh& mesh, const Setting& s, Table& table)
{
#ifndef CGAL_LINKED_WITH_TBB
  if (s.threads > 1) return;
#endif
  Row r;
  r.mesh = name;
  r.method = "simple_manifolds";
  r.threads = s.threads;
  r.energy = s.energy == SM::Energy::AMIPS ? "amips" : "symmetric_dirichlet";
  r.lambda = s.energy == SM::Energy::AMIPS ? s.lambda : 0;
  r.effort = s.effort == SM::Effort::FAST ? "fast" : s.effort == SM::Effort::QUALITY ? "quality" : "default";
  Phase_clock phases;
  const Memory_clock memory;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const auto any = map_mesh(mesh, s, phases);
  r.wall = wall_seconds() - wall;
  r.cpu = cpu_seconds() - cpu;
  const double bytes = memory.bytes();
  r.decimate = phases.seconds["decimate"];
  r.embed = phases.seconds["lay out"];
  r.certify = phases.seconds["certify"];
  std::visit(
    [&](const auto& map) {
      r.domain = map.atlas().name;
      r.faces = map.number_of_faces();
      r.bytes_per_face = bytes / static_cast<double>(r.faces);
      r.not_positive = map.certificate().flipped + map.certificate().degenerate;
      r.distortion = SM::distortion(map);
      r.queries_per_second = queries_per_second(map);
    },
    any);
  table.add(r);
}

/// Adds the row of a map to the plane that is not ours.
template <class Graph, class Index, class Point, class UV_map>
void add_flat(Row& r, const Graph& mesh, const Index& index, const Point& point, const UV_map& uv,
              Table& table)
{
  std::vector<Eigen::Vector3d> points(num_vertices(mesh));
  std::vector<Eigen::Vector2d> domain_points(points.size());
  for (const auto v : vertices(mesh)) {
    const auto& p = point(v);
    points[index(v)] = Eigen::Vector3d(p.x(), p.y(), p.z());
    domain_points[index(v)] = Eigen::Vector2d(get(uv, v).x(), get(uv, v).y());
  }
  std::vector<SM::Triangle> triangles;
  for (const auto f : faces(mesh)) {
    SM::Triangle t;
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) t[k++] = index(v);
    triangles.push_back(t);
  }
  // Some parameterizers give mirror images: a face is wrong when most others are the other way round.
  std::size_t positive = 0, negative = 0;
  for (const SM::Triangle& t : triangles) {
    const int sign =
      SM::Plane_atlas().orientation(domain_points[t[0]], domain_points[t[1]], domain_points[t[2]]);
    positive += sign > 0;
    negative += sign < 0;
  }
  r.not_positive = triangles.size() - (std::max)(positive, negative);
  r.distortion = SM::distortion(SM::Plane_atlas(), points, domain_points, triangles);
  table.add(r);
}

/// CGAL's own way to a disk, on the same mesh.
template <class Parameterizer>
void measure_parameterizer(const std::string& name, Mesh mesh, const std::string& method,
                           const Parameterizer& parameterizer, Table& table)
{
  Row r;
  r.mesh = name;
  r.domain = "plane";
  r.method = method;
  r.faces = num_faces(mesh);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const Memory_clock memory;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const SMP::Error_code error = SMP::parameterize(mesh, parameterizer, border, uv);
  r.wall = wall_seconds() - wall;
  r.cpu = cpu_seconds() - cpu;
  r.bytes_per_face = memory.bytes() / static_cast<double>(r.faces);
  if (error != SMP::OK) {
    std::cout << name << ", " << method << ": CGAL's Error_code " << error << std::endl;
    return;
  }
  add_flat(
    r, mesh, [](Mesh::Vertex_index v) { return static_cast<int>(v); },
    [&](Mesh::Vertex_index v) { return mesh.point(v); }, uv, table);
}

/// Three vertices far from each other: the one farthest from the first vertex, and so on.
std::vector<Mesh::Vertex_index> far_vertices(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> chosen = {*mesh.vertices().begin()};
  for (int k = 0; k < 3; ++k) {
    const auto distance = [&](Mesh::Vertex_index v) {
      double least = 1e300;
      for (const auto c : chosen)
        least = (std::min)(least, CGAL::squared_distance(mesh.point(c), mesh.point(v)));
      return least;
    };
    chosen.push_back(*std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                                       [&](auto v, auto w) { return distance(v) < distance(w); }));
  }
  return {chosen.begin() + 1, chosen.end()};
}

/// CGAL's only way from a closed mesh: cut along paths between three cones, embedded in a Euclidean orbifold.
void measure_orbifold(const std::string& name, Mesh mesh, Table& table)
{
  using Seam_mesh = CGAL::Seam_mesh<Mesh, Mesh::Property_map<Mesh::Edge_index, bool>,
                                    Mesh::Property_map<Mesh::Vertex_index, bool>>;
  using Seam_vertex = boost::graph_traits<Seam_mesh>::vertex_descriptor;
  Row r;
  r.mesh = name;
  r.domain = "orbifold";
  r.method = "cgal_orbifold";
  r.faces = num_faces(mesh);
  const auto edge_on_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_seam", false).first;
  const auto vertex_on_seam = mesh.add_property_map<Mesh::Vertex_index, bool>("v:on_seam", false).first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const Memory_clock memory;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const std::vector<Mesh::Vertex_index> cones = far_vertices(mesh);
  std::list<Mesh::Edge_index> path;
  SMP::compute_shortest_paths_between_cones(mesh, cones.begin(), cones.end(), path);
  Seam_mesh cut(mesh, edge_on_seam, vertex_on_seam);
  for (const auto e : path) cut.add_seam(source(e, mesh), target(e, mesh));
  boost::unordered_map<Seam_vertex, int> index;
  int count = 0;
  for (const auto v : vertices(cut)) index[v] = count++;
  boost::unordered_map<Seam_vertex, SMP::Cone_type> cone_types;
  SMP::Error_code error = SMP::ERROR_WRONG_PARAMETER;
  if (SMP::locate_cones(cut, cones.begin(), cones.end(), cone_types))
    error = SMP::Orbifold_Tutte_parameterizer_3<Seam_mesh>(SMP::Triangle, SMP::Cotangent)
              .parameterize(cut, CGAL::Polygon_mesh_processing::longest_border(cut).first, cone_types, uv,
                            boost::associative_property_map<boost::unordered_map<Seam_vertex, int>>(index));
  r.wall = wall_seconds() - wall;
  r.cpu = cpu_seconds() - cpu;
  r.bytes_per_face = memory.bytes() / static_cast<double>(r.faces);
  if (error != SMP::OK) {
    std::cout << name << ", " << r.method << ": CGAL's Error_code " << error << std::endl;
    return;
  }
  add_flat(
    r, cut, [&](Seam_vertex v) { return index.at(v); },
    [&](Seam_vertex v) { return mesh.point(target(Mesh::Halfedge_index(v), mesh)); }, uv, table);
}

Mesh read(const std::string& folder, const std::string& name)
{
  Mesh mesh;
  SM::read_mesh(folder + "/meshes/" + name + ".off", mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

/// All settings for meshes up to 60,000 faces; for larger ones what shows how time grows.
void measure_all(const std::string& name, const Mesh& mesh, Table& table)
{
  const bool is_small = num_faces(mesh) <= 60000;
  measure(name, mesh, {}, table);
  Setting s;
  s.threads = 2;
  measure(name, mesh, s, table);
  s = Setting();
  s.effort = SM::Effort::FAST;
  measure(name, mesh, s, table);
  if (!is_small) return;
  s.effort = SM::Effort::QUALITY;
  measure(name, mesh, s, table);
  s = Setting();
  s.energy = SM::Energy::AMIPS;
  for (const double lambda : {1., 0.3, 0.1, 0.03}) {
    s.lambda = lambda;
    measure(name, mesh, s, table);
  }
  if (!CGAL::is_closed(mesh)) {
    using Border = SMP::Square_border_arc_length_parameterizer_3<Mesh>;
    measure_parameterizer(name, mesh, "cgal_mean_value",
                          SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border>(), table);
    measure_parameterizer(name, mesh, "cgal_arap", SMP::ARAP_parameterizer_3<Mesh>(), table);
  } else if (num_vertices(mesh) + num_faces(mesh) == num_edges(mesh) + 2) { // of genus 0
    measure_orbifold(name, mesh, table);
  }
}

int run(int argc, char** argv)
{
  po::options_description options("Usage: map_benchmark [options]\n\nOptions");
  std::string output = "map_benchmark.csv", data = CGAL_DATA_DIR;
  std::size_t largest = 1400000;
  std::vector<std::string> names = {"hand", "camel", "armadillo", "knot1", "elk", "three_peaks", "lion-head"};
  auto add = options.add_options();
  add("help", "print this and end");
  add("output", po::value(&output)->default_value(output), "the CSV file");
  add("data", po::value(&data)->default_value(data), "the folder that holds meshes/ of CGAL's data");
  add("mesh", po::value(&names)->multitoken(), "names of meshes there");
  add("largest", po::value(&largest)->default_value(largest), "subdivide as long as there are no more faces");
  add("quick", po::bool_switch(), "small meshes, not subdivided: less than a minute");
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, options), values);
  po::notify(values);
  if (values.count("help")) {
    std::cout << options;
    return 0;
  }
  const bool is_quick = values["quick"].as<bool>();
  if (is_quick && values["mesh"].empty()) names = {"hand", "knot1", "three_peaks"};

  Table table(output);
  for (const std::string& name : names) {
    Mesh mesh = read(data, name);
    for (int loop = 0;; ++loop) {
      measure_all(loop == 0 ? name : name + "_loop" + std::to_string(loop), mesh, table);
      if (is_quick || 4 * num_faces(mesh) > largest) break;
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "map_benchmark: " << e.what() << '\n';
    return 1;
  }
}
