// Whether maps and fits keep to the memory that the manual promises: at a million faces by default. Exit
// status 1 when they do not; Linux only. Usage: memory_limits sphere|torus|square [FACES]

#include "Memory_clock.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A wavy surface of about `faces` triangles: a rolled up grid, whose seams and ends are joined or not.
Mesh surface(const std::string& domain, int faces)
{
  const int n = int(std::sqrt(faces / 2.));
  const bool is_torus = domain == "torus", is_sphere = domain == "sphere";
  const int rows = is_torus ? n : n + 1, columns = is_torus || is_sphere ? n : n + 1;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      if (is_sphere && j > 0 && (i == 0 || i == n)) { // a pole
        v.push_back(v.back());
        continue;
      }
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / n;
      const double r = 1 + 0.1 * std::sin(9 * a) * std::sin(7 * b), x = 3 + r * std::cos(b);
      if (is_torus)
        v.push_back(mesh.add_vertex(Mesh::Point(x * std::cos(a), x * std::sin(a), r * std::sin(b))));
      else if (is_sphere)
        v.push_back(mesh.add_vertex(Mesh::Point(r * std::sin(a / 2) * std::cos(b),
                                                r * std::sin(a / 2) * std::sin(b), r * std::cos(a / 2))));
      else
        v.push_back(mesh.add_vertex(Mesh::Point(a, b, r)));
    }
  const auto at = [&](int i, int j) { return v[std::size_t(i % rows) * columns + j % columns]; };
  const auto add = [&](Mesh::Vertex_index p, Mesh::Vertex_index q, Mesh::Vertex_index r) {
    if (p != q && q != r && r != p) // not at a pole
      mesh.add_face(p, q, r);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
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
    if (name == std::string("certify")) bytes = clock.bytes();
  }
};

// Says what was needed; whether it is within the limit.
bool is_within(const std::string& what, double bytes, double limit)
{
  std::cout << what << ": " << bytes << " bytes, limit " << limit << std::endl;
  return bytes <= limit;
}

int run(const std::string& domain, int faces)
{
  const Mesh mesh = surface(domain, faces);
  const double n = double(mesh.number_of_faces());
  const Memory_clock map_clock;
  Embedding_visitor visitor(map_clock);
  const auto any = SM::map_to_canonical_surface(mesh, CGAL::parameters::visitor(std::ref(visitor)));
  const double peak = map_clock.bytes() / n;
  std::cout << domain << ", " << n << " faces\nbefore the result is made, per face: " << visitor.bytes / n
            << " bytes" << std::endl;
  const bool is_good = is_within("map, with its copy of the mesh and its tree, per face", peak, 250);
  return std::visit(
    [&](const auto& map) {
      const Memory_clock fit_clock;
      SM::Fit_report report;
      const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3).fit_report(std::ref(report)));
      const double bytes = fit_clock.bytes();
      // What is fitted are the vertices and 9 points per leaf; the errors are measured there and at 3 points per face.
      double fitted = double(map.number_of_vertices());
      for (int c = 0; c < map.atlas().number_of_charts(); ++c)
        fitted += 9. * double(surface.chart_embedding(c).number_of_leaves());
      const double measured = fitted + 3. * double(map.number_of_faces());
      std::cout << report.controls << " controls, " << fitted << " points fitted, " << measured
                << " measured; " << bytes / fitted << " bytes per point fitted" << std::endl;
      return is_within("fit, per point measured", bytes / measured, 300) && is_good ? 0 : 1;
    },
    any);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string domain = argc > 1 ? argv[1] : "";
  if (domain != "sphere" && domain != "torus" && domain != "square") {
    std::cerr << "usage: memory_limits sphere|torus|square [FACES]\n";
    return 2;
  }
  try {
    return run(domain, argc > 2 ? std::atoi(argv[2]) : 1000000);
  } catch (const std::exception& e) {
    std::cerr << "memory_limits: " << e.what() << '\n';
    return 2;
  }
}
