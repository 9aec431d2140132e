// Maps an indexed surface, and checks what came out beyond its certificate.

#ifndef SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_MAP_H
#define SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_MAP_H

#include "../correspondence/random_surfaces.h"
#include "../correspondence/sample_maps.h"

#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

namespace stress {

namespace SM = CGAL::Simple_manifolds;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

inline Mesh surface_mesh(const Triangle_mesh& t)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& p : t.points) v.push_back(mesh.add_vertex(Point_3(p[0], p[1], p[2])));
  std::vector<std::vector<Mesh::Vertex_index>> faces;
  for (const auto& f : t.triangles) faces.push_back({v[f[0]], v[f[1]], v[f[2]]});
  CGAL::Euler::add_faces(faces, mesh); // add_face() would be quadratic at hubs
  return mesh;
}

struct Figures {
  std::size_t faces = 0;
  double smallest_area = 0; ///< in the domain
  double round_trip = 0;    ///< from the domain to the mesh and back: the worst of some points
};

/// The faces, each from its smallest vertex on, in order: equal for equal sets of oriented faces.
inline std::vector<SM::Triangle> ordered(std::vector<SM::Triangle> faces)
{
  for (SM::Triangle& f : faces) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// \throw SM::Error  from the mapper
/// \throw std::logic_error  when the result is no map of the mesh
inline Figures map_and_check(const Triangle_mesh& t, SM::Energy energy = SM::Energy::SYMMETRIC_DIRICHLET)
{
  const auto require = [](bool is_so, const char* what) {
    if (!is_so) throw std::logic_error(what);
  };
  Figures figures;
  const auto any = SM::map_to_canonical_surface(surface_mesh(t), SM::parameters::energy(energy));
  std::visit(
    [&](const auto& map) {
      using Map = std::decay_t<decltype(map)>;
      require(SM::certify(map.atlas(), map.domain_points(), map.faces()).is_valid(),
              "the map is not one to one");
      require(map.number_of_input_vertices() == t.points.size(), "vertices are missing");
      require(map.number_of_faces() >= t.triangles.size(), "faces are missing");
      std::vector<SM::Triangle> missing;
      const auto before = ordered({t.triangles.begin(), t.triangles.end()}), after = ordered(map.faces());
      std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                          std::back_inserter(missing));
      require(missing.size() <= map.number_of_faces() - t.triangles.size(),
              "faces are others"); // than split ones
      require(std::equal(t.points.begin(), t.points.end(), map.points().begin()), "vertices have moved");
      figures.faces = map.number_of_faces();
      figures.smallest_area = map.certificate().smallest_domain_area;
      sample::Random_points random;
      for (int i = 0; i < 20; ++i) {
        const typename Map::Domain_point p = random.point(map.atlas());
        figures.round_trip =
          (std::max)(figures.round_trip, sample::distance(map.atlas(), p, map.to_domain(map.to_mesh(p))));
      }
      const auto v = static_cast<std::size_t>(random.number() * static_cast<double>(t.points.size()));
      require(map(map.domain_point(v)) == map.point(v), "a vertex is not found");
      require(figures.round_trip < 1e-12, "a point does not come back");
    },
    any);
  return figures;
}

} // namespace stress

#endif // SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_MAP_H
