// Maps random triangulations and counts those without a certified map; each is made from its number alone.
//
//   fuzz_maps --surface sphere|torus|disk|handles [--count N] [--seed S] [--first I] [--write FILE.off]
//
// Exit status 0 when all are certified, else 1, with the numbers of the failed ones: repeat one alone with
// --first I --count 1, and --write it.

#include "stress_map.h"
#include "stress_surfaces.h"

#include <boost/program_options.hpp>

#include <ctime>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace po = boost::program_options;
namespace SM = CGAL::Simple_manifolds;

/// 4 to 400 vertices: a small base, vertices stacked into faces, flips; more of the small ones.
Triangle_mesh random_surface(const std::string& surface, Random& random)
{
  const int n = 4 + static_cast<int>(396 * std::pow(random.real(), 2));
  Triangle_mesh mesh;
  int base = 0;
  if (surface == "torus" && random.below(4) == 0) {
    mesh = seven_vertex_torus();
  } else if (surface == "torus") {
    const int a = 3 + random.below(4), b = 3 + random.below(1 + n / 10);
    mesh = grid_torus(b, a, random.below(a));
  } else {
    mesh.points.resize(4);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  }
  base = static_cast<int>(mesh.points.size());
  const int vertices = (std::max)(base, n);
  stack_random_vertices(mesh, base, vertices, random);
  const int flips = random.below(4) == 0 ? 0 : random.below(10 * vertices);
  flip_random_edges(mesh, flips, random);
  set_random_points(mesh, vertices, random.below(4), random);
  if (surface == "disk") {
    mesh = without_star(mesh, random.below(vertices));
    flip_random_edges(mesh, random.below(vertices), random); // also edges at the border
  }
  return mesh;
}

/// Genus 2 to 12, more of the small ones: handles of some rings join random faces of a sphere.
Triangle_mesh random_handles(Random& random)
{
  const int genus = 2 + static_cast<int>(11 * std::pow(random.real(), 2));
  const int vertices = 4 + random.below(200);
  Triangle_mesh mesh = random_sphere(vertices, random.below(4 * vertices), random.below(4), random);
  for (int i = 0; i < genus; ++i) {
    const int faces = static_cast<int>(mesh.triangles.size());
    const int from = random.below(faces), to = (from + 1 + random.below(faces - 1)) % faces;
    mesh = stress::with_handle(mesh, static_cast<std::size_t>(from), static_cast<std::size_t>(to),
                               2 + random.below(10)); // two rings: far enough from another face
  }
  flip_random_edges(mesh, random.below(static_cast<int>(mesh.points.size())), random);
  return mesh;
}

void write_off(const std::string& file, const Triangle_mesh& mesh)
{
  std::ofstream out(file);
  out << std::setprecision(17) << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const auto& p : mesh.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : mesh.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!out) throw std::runtime_error("cannot write " + file);
}

int run(int argc, char** argv)
{
  po::options_description options("Options");
  unsigned seed = 1;
  int count = 1000, first = 0;
  std::string surface = "sphere", file;
  auto add = options.add_options();
  add("help", "print this and end");
  add("seed", po::value(&seed), "of the generator");
  add("count", po::value(&count), "how many surfaces");
  add("first", po::value(&first), "the number of the first one");
  add("surface", po::value(&surface), "sphere, torus, disk or handles");
  add("write", po::value(&file), "write the first one to this OFF file, and do not map");
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, options), values);
  po::notify(values);
  if (values.count("help")) {
    std::cout << options;
    return 0;
  }
  if (surface != "sphere" && surface != "torus" && surface != "disk" && surface != "handles")
    throw po::error("--surface is sphere, torus, disk or handles, not \"" + surface + '"');

  int failed = 0;
  double smallest_area = 1e300, round_trip = 0;
  std::size_t faces = 0;
  for (int i = first; i < first + count; ++i) {
    Random random(seed * 1000003u + static_cast<unsigned>(i));
    const Triangle_mesh mesh =
      surface == "handles" ? random_handles(random) : random_surface(surface, random);
    const auto energy = random.below(2) ? SM::Energy::SYMMETRIC_DIRICHLET : SM::Energy::AMIPS;
    if (!file.empty()) {
      write_off(file, mesh);
      return 0;
    }
    try {
      const stress::Figures figures = stress::map_and_check(mesh, energy);
      faces += figures.faces;
      smallest_area = (std::min)(smallest_area, figures.smallest_area);
      round_trip = (std::max)(round_trip, figures.round_trip);
    } catch (const std::exception& e) {
      ++failed;
      std::cout << "number " << i << ", " << mesh.points.size() << " vertices: " << e.what() << std::endl;
    }
  }
  std::cout << surface << ", seed " << seed << ": " << count << " surfaces, " << failed << " without a map; "
            << faces << " faces, smallest area " << smallest_area << ", worst round trip " << round_trip
            << ", " << static_cast<double>(std::clock()) / CLOCKS_PER_SEC << " s" << std::endl;
  return failed != 0;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "fuzz_maps: " << e.what() << '\n';
    return 2;
  }
}
