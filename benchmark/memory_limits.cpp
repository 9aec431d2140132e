// Whether maps and fits keep to the memory that the manual promises: at a million faces by default. Exit
// status 1 when they do not; Linux only. Usage: memory_limits [FACES]

#include "Memory_clock.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A wavy torus of 2 n^2 triangles.
Mesh torus(int n)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / n;
      const double r = 1 + 0.1 * std::sin(9 * a) * std::cos(7 * b);
      const double x = 3 + r * std::cos(b);
      v.push_back(mesh.add_vertex(Mesh::Point(x * std::cos(a), x * std::sin(a), r * std::sin(b))));
    }
  const auto at = [&](int i, int j) { return v[std::size_t(i % n) * n + j % n]; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// Notes how much has been needed when the embedding ends: the result is made after that.
struct Embedding_visitor : SM::Default_visitor {
  const Memory_clock& clock;
  double bytes = 0;
  explicit Embedding_visitor(const Memory_clock& clock) : clock(clock) {}
  void start_phase(const char* name)
  {
    if(name == std::string("certify"))
      bytes = clock.bytes();
  }
};

// Says what was needed; whether it is within the limit.
bool is_within(const std::string& what, double bytes, double limit)
{
  std::cout << what << ": " << bytes << " bytes, limit " << limit << std::endl;
  return bytes <= limit;
}

int run(int faces)
{
  const Mesh mesh = torus(int(std::sqrt(faces / 2.)));
  const double n = double(mesh.number_of_faces());
  const Memory_clock map_clock;
  Embedding_visitor visitor(map_clock);
  const auto map = SM::map_to_torus(mesh, CGAL::parameters::visitor(std::ref(visitor)));
  // The copy of the mesh as arrays: 24 bytes per vertex, 12 per face, 4 per vertex for its number.
  const double peak = map_clock.bytes() / n, input = 12 + 28 / 2.;
  std::cout << "engine beside its input, per face: " << visitor.bytes / n - input << " bytes" << std::endl;
  const bool is_good = is_within("map, with its copy of the mesh and its tree, per face", peak, 350);

  const Memory_clock fit_clock;
  SM::Fit_report report;
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3).fit_report(std::ref(report)));
  const double bytes = fit_clock.bytes();
  // The vertices, 9 points per leaf, and 3 points per face at which the errors are measured.
  double samples = double(map.number_of_vertices()) + 3. * double(map.number_of_faces());
  for(int c = 0; c < SM::Torus_atlas::number_of_charts; ++c)
    samples += 9. * double(surface.chart_embedding(c).number_of_leaves());
  std::cout << report.controls << " controls, " << samples << " samples" << std::endl;
  return is_within("fit, per sample", bytes / samples, 300) && is_good ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc > 1 ? std::atoi(argv[1]) : 1000000);
  } catch(const std::exception& e) {
    std::cerr << "memory_limits: " << e.what() << '\n';
    return 2;
  }
}
