// What every triangulation of a domain must be, checked without the class that made it.

#ifndef SIMPLE_MANIFOLDS_TEST_TRIANGULATION_CHECKS_H
#define SIMPLE_MANIFOLDS_TEST_TRIANGULATION_CHECKS_H

#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace SM = CGAL::Simple_manifolds;

/// Whether the faces are positive by exact signs and cover the domain once, without a vertex within an edge:
/// that would be a border, inside the square or on a closed surface.
template <class Atlas>
bool is_conforming(const SM::Domain_triangulation<Atlas>& t)
{
  const auto topology = SM::topology(t.number_of_vertices(), t.triangles());
  if (topology.components != 1 || topology.isolated_vertices != 0 ||
      topology.euler_characteristic != (Atlas::is_closed ? 2 - 2 * Atlas::genus() : 1) ||
      topology.border_loops != !Atlas::is_closed)
    return false;
  std::map<std::pair<int, int>, int> sides;
  for (const auto& f : t.triangles())
    for (int k = 0; k < 3; ++k) ++sides[{f[k], f[(k + 1) % 3]}];
  for (const auto& side : sides)
    if (side.second != 1)
      return false;
    else if (sides.count({side.first.second, side.first.first}) == 0) {
      const auto &p = t.domain_points()[side.first.first], &q = t.domain_points()[side.first.second];
      bool is_on_border = false;
      for (int k = 0; k < 2; ++k) is_on_border = is_on_border || (p[k] == q[k] && (p[k] == 0 || p[k] == 1));
      if (Atlas::is_closed || !is_on_border) return false;
    }
  return SM::certify(Atlas(), t.domain_points(), t.triangles()).is_valid();
}

/// The smallest angle of the red or of the green faces, in degrees.
template <class Atlas>
double smallest_angle(const SM::Domain_triangulation<Atlas>& t, bool green)
{
  double smallest = 180;
  const auto& p = t.domain_points();
  for (int f = 0; f < t.number_of_faces(); ++f)
    if (t.is_green(f) == green)
      for (int k = 0; k < 3; ++k) {
        const auto& v = t.triangles()[f];
        const auto [d, e] = Atlas().flat_edges(p[v[k]], p[v[(k + 1) % 3]], p[v[(k + 2) % 3]]);
        smallest =
          (std::min)(smallest, std::acos(d.normalized().dot(e.normalized())) * 180 / 3.14159265358979);
      }
  return smallest;
}

#endif // SIMPLE_MANIFOLDS_TEST_TRIANGULATION_CHECKS_H
