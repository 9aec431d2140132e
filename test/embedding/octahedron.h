// A subdivided octahedron over the sphere, with a map by construction.

#ifndef SIMPLE_MANIFOLDS_TEST_OCTAHEDRON_H
#define SIMPLE_MANIFOLDS_TEST_OCTAHEDRON_H

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

/// The octahedron with 8 * 4^levels faces; vertices lie at f(domain point).
template <class Function>
CGAL::Simple_manifolds::Manifold_map<CGAL::Simple_manifolds::Sphere_atlas> octahedron_map(int levels,
                                                                                          const Function& f)
{
  namespace SM = CGAL::Simple_manifolds;
  std::vector<Eigen::Vector3d> q = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<SM::Triangle> faces;
  for (int k = 0; k < 4; ++k) {
    faces.push_back({k, (k + 1) % 4, 4});
    faces.push_back({(k + 1) % 4, k, 5});
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, is_new] = middles.try_emplace({(std::min)(a, b), (std::max)(a, b)}, int(q.size()));
      if (is_new) q.push_back((q[a] + q[b]).normalized());
      return it->second;
    };
    std::vector<SM::Triangle> fine;
    for (const SM::Triangle& t : faces) {
      const int a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
      fine.insert(fine.end(), {SM::Triangle{t[0], c, b}, {t[1], a, c}, {t[2], b, a}, {a, b, c}});
    }
    faces = fine;
  }
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : q) points.push_back(f(p));
  const std::size_t n = points.size();
  return {points, faces, q, n};
}

#endif // SIMPLE_MANIFOLDS_TEST_OCTAHEDRON_H
