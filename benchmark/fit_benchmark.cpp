// Errors of fitted surfaces over the number of their controls, as CSV: uniform and hierarchical splines,
// fitted chart by chart or jointly, beside simplified meshes with as many vertices. See README.md.

#include "Memory_clock.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace po = boost::program_options;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tag = CGAL::Parallel_if_available_tag;

double wall_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Root mean square, weighted, and maximum.
class Error {
public:
  void add(double x, double weight)
  {
    squares_ += weight * x * x;
    weights_ += weight;
    max_ = (std::max)(max_, x);
  }
  double rms() const { return std::sqrt(squares_ / weights_); }
  double max() const { return max_; }

private:
  double squares_ = 0, weights_ = 0, max_ = 0;
};

/// Three random points in each face of the mesh, weighted by area: independent of all fits.
template <class Map>
class Test_points {
public:
  using Domain_point = typename Map::Domain_point;

  struct Point {
    Domain_point domain;
    Eigen::Vector3d position, normal;
    double weight;
  };

  explicit Test_points(const Map& map)
  {
    std::mt19937 random(1);
    const auto number = [&] { return random() / 4294967296.; };
    for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
      if (map.is_virtual(f)) continue;
      const SM::Triangle& t = map.face(f);
      const Eigen::Vector3d& a = map.point(t[0]);
      const Eigen::Vector3d cross = (map.point(t[1]) - a).cross(map.point(t[2]) - a);
      if (!(cross.norm() > 0)) continue;
      for (int k = 0; k < 3; ++k) {
        const double s = std::sqrt(number()), r = number();
        typename Map::Location at;
        at.face = static_cast<int>(f);
        at.barycentric = {1 - s, s * (1 - r), s * r};
        points_.push_back({map.to_domain(at), map.position(at), cross.normalized(), cross.norm() / 6});
      }
    }
  }

  auto begin() const { return points_.begin(); }
  auto end() const { return points_.end(); }

private:
  std::vector<Point> points_;
};

struct Row {
  std::string mesh, domain;
  std::size_t faces = 0, vertices = 0;
  std::string method;
  double tolerance = 0;
  bool reached = true;
  std::size_t controls = 0; // of a simplified mesh: its vertices
  Error distance, parametric;
  double normal = 0; // root mean square angle in degrees
  double wall = 0;
  SM::Fit_report report;
  double peak_bytes = 0;
};

class Table {
public:
  explicit Table(const std::string& file) : out_(file)
  {
    out_ << "mesh,domain,faces,vertices,method,tolerance,reached,controls,rms,max,parametric_rms,"
            "parametric_max,normal_degrees,wall_s,sampling_s,alone_s,jointly_s,refining_s,measuring_s,"
            "closest_point_s,samples_bytes,equations_bytes,peak_bytes\n";
    if (!out_) throw std::runtime_error("cannot write " + file);
  }

  void add(const Row& r)
  {
    const auto& s = r.report.seconds;
    out_ << r.mesh << ',' << r.domain << ',' << r.faces << ',' << r.vertices << ',' << r.method << ','
         << r.tolerance << ',' << r.reached << ',' << r.controls << ',' << r.distance.rms() << ','
         << r.distance.max() << ',' << r.parametric.rms() << ',' << r.parametric.max() << ',' << r.normal
         << ',' << r.wall << ',' << s.sampling << ',' << s.solving_alone << ',' << s.solving_jointly << ','
         << s.refining << ',' << s.measuring << ',' << s.closest_point << ',' << r.report.bytes.samples << ','
         << r.report.bytes.equations << ',' << r.peak_bytes << std::endl;
    std::cout << r.mesh << ", " << r.method << ' ' << r.tolerance << ": " << r.controls << " controls, rms "
              << r.distance.rms() << ", max " << r.distance.max() << ", " << r.wall << " s"
              << (r.reached ? "" : " (tolerance not reached)") << std::endl;
  }

private:
  std::ofstream out_;
};

template <class Map>
void measure_fit(const Map& map, const Test_points<Map>& points, Row row, const std::string& method,
                 SM::Fit_options options, Table& table)
{
  options.rms_error = options.max_error; // the maximum decides
  row.method = method;
  row.tolerance = options.max_error;
  const Memory_clock memory;
  const double start = wall_seconds();
  SM::Surface_fitter<Map, SM::Smoothstep_bump<2>, Tag> fitter(map, options);
  SM::Default_visitor visitor;
  const auto surface = fitter.fit(visitor);
  row.wall = wall_seconds() - start;
  row.peak_bytes = memory.bytes();
  row.report = fitter.report();
  row.reached = row.report.tolerance_reached;
  row.controls = row.report.controls;
  Error angle;
  for (const auto& x : points) {
    const SM::Jet jet = surface.template jet<1>(x.domain);
    row.parametric.add((jet.value - x.position).norm() / map.diagonal(), x.weight);
    row.distance.add(SM::internal::closest_point_distance(surface, x.domain, x.position, 10) / map.diagonal(),
                     x.weight);
    const Eigen::Vector3d n = SM::normal(jet);
    if (!n.hasNaN())
      angle.add(std::atan2(n.cross(x.normal).norm(), n.dot(x.normal)) * 180 / 3.14159265358979324, x.weight);
  }
  row.normal = angle.rms();
  table.add(row);
}

/// Edge collapse ends with this number of edges: CGAL 5 and 6 have different names for that.
struct Number_of_edges {
  std::size_t least;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const
  {
    return current <= least;
  }
};

/// The mesh simplified with quadrics to about `vertices` vertices.
template <class Points>
void measure_quadrics(Mesh mesh, const Points& points, double diagonal, Row row, std::size_t vertices,
                      Table& table)
{
  row.method = "quadrics";
  const auto euler = static_cast<long>(num_vertices(mesh)) - static_cast<long>(num_edges(mesh)) +
                     static_cast<long>(num_faces(mesh));
  const auto edges = static_cast<std::size_t>((std::max)(3 * (static_cast<long>(vertices) - euler), 6L));
  const double start = wall_seconds();
  using Policies = SMS::GarlandHeckbert_plane_policies<Mesh, Kernel>;
  const Policies policies(mesh);
  const SMS::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  SMS::edge_collapse(mesh, Number_of_edges{edges},
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
  mesh.collect_garbage();
  row.wall = wall_seconds() - start;
  row.controls = num_vertices(mesh);

  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
  CGAL::AABB_tree<Traits> tree(faces(mesh).first, faces(mesh).second, mesh);
  tree.accelerate_distance_queries();
  Error angle;
  for (const auto& x : points) {
    const Kernel::Point_3 p(x.position.x(), x.position.y(), x.position.z());
    const auto closest = tree.closest_point_and_primitive(p);
    row.distance.add(std::sqrt(CGAL::squared_distance(p, closest.first)) / diagonal, x.weight);
    const auto n = PMP::compute_face_normal(closest.second, mesh, CGAL::parameters::geom_traits(Kernel()));
    const Eigen::Vector3d m(n.x(), n.y(), n.z());
    angle.add(std::atan2(m.cross(x.normal).norm(), m.dot(x.normal)) * 180 / 3.14159265358979324, x.weight);
  }
  row.parametric = row.distance; // it has no parameters
  row.normal = angle.rms();
  table.add(row);
}

void measure_all(const std::string& name, const Mesh& mesh, const std::vector<double>& tolerances,
                 std::size_t max_controls, Table& table)
{
  // angles rather than areas: 15 to 30 % less error than with the default map
  const auto any =
    SM::map_to_canonical_surface<Tag>(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
  std::visit(
    [&](const auto& map) {
      using Map = std::decay_t<decltype(map)>;
      const Test_points<Map> points(map);
      const bool has_one_chart = map.atlas().number_of_charts() == 1; // then there is nothing to do jointly
      Row row;
      row.mesh = name;
      row.domain = map.atlas().name;
      row.faces = num_faces(mesh);
      row.vertices = num_vertices(mesh);

      SM::Fit_options options;
      options.max_error = 0;
      options.refinement = SM::Refinement::UNIFORM;
      for (const std::size_t side : {7, 11, 19, 35, 67}) {
        options.max_controls = map.atlas().number_of_charts() * side * side;
        if (options.max_controls > max_controls) break;
        options.joint_solve = SM::Joint_solve::NEVER;
        measure_fit(map, points, row, "uniform", options, table);
        if (has_one_chart) continue;
        options.joint_solve = SM::Joint_solve::AT_END;
        measure_fit(map, points, row, "uniform_joint", options, table);
      }

      options = SM::Fit_options();
      options.max_controls = max_controls;
      for (const double tolerance : tolerances) {
        options.max_error = tolerance;
        options.joint_solve = SM::Joint_solve::NEVER;
        measure_fit(map, points, row, "hierarchical", options, table);
        if (has_one_chart) continue;
        options.joint_solve = SM::Joint_solve::AT_END;
        measure_fit(map, points, row, "hierarchical_joint", options, table);
      }
      for (std::size_t n = 250; n <= max_controls && n < 0.7 * num_vertices(mesh); n *= 2)
        measure_quadrics(mesh, points, map.diagonal(), row, n, table);
    },
    any);
}

int run(int argc, char** argv)
{
  po::options_description options("Usage: fit_benchmark [options]\n\nOptions");
  std::string output = "fit_benchmark.csv", data = CGAL_DATA_DIR;
  std::size_t max_controls = 30000;
  int threads = 2;
  std::vector<std::string> names = {"hand",        "homer",           "retinal",  "camel",
                                    "armadillo",   "bunny00",         "knot1",    "elk",
                                    "rotor_small", "mannequin-devil", "nefertiti"};
  std::vector<double> tolerances = {1e-2, 5e-3, 3e-3, 2e-3, 1e-3};
  auto add = options.add_options();
  add("help", "print this and end");
  add("output", po::value(&output)->default_value(output), "the CSV file");
  add("data", po::value(&data)->default_value(data), "the folder that holds meshes/ of CGAL's data");
  add("mesh", po::value(&names)->multitoken(), "names of meshes there");
  add("tolerance", po::value(&tolerances)->multitoken(), "of the largest error, fractions of the diagonal");
  add("max-controls", po::value(&max_controls)->default_value(max_controls), "limit of the controls");
  add("threads", po::value(&threads)->default_value(threads), "number of threads");
  add("quick", po::bool_switch(), "small meshes and coarse tolerances: less than a minute");
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, options), values);
  po::notify(values);
  if (values.count("help")) {
    std::cout << options;
    return 0;
  }
  if (values["quick"].as<bool>()) {
    names = {"retinal", "knot1", "three_peaks"};
    tolerances = {1e-2, 5e-3};
    max_controls = 2000;
  }
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
#endif

  Table table(output);
  const auto mesh_file = [&](const std::string& name) { return data + "/meshes/" + name + ".off"; };
  for (const std::string& name : names) {
    Mesh mesh;
    SM::read_mesh(mesh_file(name), mesh);
    PMP::triangulate_faces(mesh);
    measure_all(name, mesh, tolerances, max_controls, table);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "fit_benchmark: " << e.what() << '\n';
    return 1;
  }
}
