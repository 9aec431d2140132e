// Maps, fits and evaluates a mesh of each kind and prints the bits of all results. Compiled twice, with and without the
// compiled library: both have to print the same.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

namespace {

template <class Vector>
void print(const char* what, const Vector& x)
{
  std::printf("%s", what);
  for (int i = 0; i < x.size(); ++i) std::printf(" %a", x[i]);
  std::printf("\n");
}

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Mesh hill(int n)
{
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = 1. * i / n, y = 1. * j / n;
      mesh.add_vertex({x, y, 8 * x * (1 - x) * y * (1 - y)});
    }
  const auto vertex = [n](int i, int j) { return Mesh::Vertex_index((n + 1) * i + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return mesh;
}

template <class Map>
void run_map(const Map& map)
{
  std::vector<typename Map::Domain_point> points;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    points.push_back(map.domain_point(v));
    print("domain point", points.back());
  }
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(5e-3));
  for (int c = 0; c < map.atlas().number_of_charts(); ++c)
    for (const auto& level : surface.chart_embedding(c).levels())
      for (const auto& x : level.coefficients) print("control", x);
  std::vector<SM::Jet> jets, first;
  std::vector<Eigen::Vector3d> positions;
  surface.points(points, std::back_inserter(positions));
  surface.template jets<1>(points, std::back_inserter(first));
  surface.jets(points, std::back_inserter(jets));
  for (std::size_t k = 0; k < points.size(); ++k) {
    print("curvature direction", surface.jet(points[k]).uu);
    print("in batches", positions[k]);
    print("in batches", first[k].u);
    print("in batches", jets[k].uu);
  }
}

void run(const Mesh& mesh)
{
  std::visit([](const auto& map) { run_map(map); }, SM::map_to_canonical_surface(mesh));
}

} // namespace

int main()
{
  run(hill(12));
  for (const char* name : {"banana", "torus"}) {
    Mesh mesh;
    SM::read_mesh(std::string(SIMPLE_MANIFOLDS_DATA "/") + name + ".off", mesh);
    run(mesh);
  }
}
