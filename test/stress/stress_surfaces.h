// Surfaces that are hard to map: long, thin, crowded, degenerate or without any sensible shape; all from
// fixed generators. The names say what they are, `sphere_cases()` and its like list them.

#ifndef SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_SURFACES_H
#define SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_SURFACES_H

#include "../correspondence/random_surfaces.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <string>

namespace stress {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

inline Triangle_mesh scaled(Triangle_mesh mesh, const Vector3d& factor,
                            const Vector3d& offset = Vector3d::Zero())
{
  for (auto& p : mesh.points) p = p.cwiseProduct(factor) + offset;
  return mesh;
}

template <class Position> // (point) -> point
Triangle_mesh moved(Triangle_mesh mesh, const Position& position)
{
  for (auto& p : mesh.points) p = position(p);
  return mesh;
}

inline Triangle_mesh with_random_points(Triangle_mesh mesh, int kind)
{
  Random random(5);
  set_random_points(mesh, static_cast<int>(mesh.points.size()), kind, random);
  return mesh;
}

inline Triangle_mesh tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Triangle_mesh octahedron()
{
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Grows a three-sided arm of `rings` rings out of a face; the face becomes its end.
inline void extrude(Triangle_mesh& mesh, std::size_t face, int rings, double length, double shrink)
{
  auto t = mesh.triangles[face];
  Vector3d normal = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
  if (normal.norm() > 0) normal.normalize();
  for (int i = 0; i < rings; ++i) {
    const int n = static_cast<int>(mesh.points.size());
    const Vector3d centre = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    for (int k = 0; k < 3; ++k)
      mesh.points.push_back(centre + shrink * (mesh.points[t[k]] - centre) + length * normal);
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      mesh.triangles.push_back({t[k], t[l], n + l});
      mesh.triangles.push_back({t[k], n + l, n + k});
    }
    t = {n, n + 1, n + 2};
  }
  mesh.triangles[face] = t;
}

inline Triangle_mesh octopus(int rings)
{
  Triangle_mesh mesh = octahedron();
  for (std::size_t f = 0; f < 8; ++f) extrude(mesh, f, rings, 0.5, 0.98);
  return mesh;
}

inline Triangle_mesh extrusion_tree(int branches)
{
  Triangle_mesh mesh = tetrahedron();
  Random random(11);
  for (int i = 0; i < branches; ++i)
    extrude(mesh, static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size()))), 4, 0.7,
            0.8);
  return mesh;
}

enum class Order { RANDOM, LAST, BREADTH };

/// Each new vertex at the centre of a face: of a random one, of the newest one, or of the oldest one.
inline Triangle_mesh stacked(int vertices, Order order)
{
  Triangle_mesh mesh = tetrahedron();
  Random random(3);
  std::deque<std::size_t> oldest = {0, 1, 2, 3};
  for (int v = 4; v < vertices; ++v) {
    std::size_t f = mesh.triangles.size() - 1;
    if (order == Order::RANDOM)
      f = static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size())));
    if (order == Order::BREADTH) {
      f = oldest.front();
      oldest.pop_front();
      oldest.insert(oldest.end(), {f, mesh.triangles.size(), mesh.triangles.size() + 1});
    }
    const auto t = mesh.triangles[f];
    mesh.points.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
    mesh.triangles[f] = {t[0], t[1], v};
    mesh.triangles.push_back({t[1], t[2], v});
    mesh.triangles.push_back({t[2], t[0], v});
  }
  return mesh;
}

/// Puts a vertex of the given valence into the first face, with as many new neighbours of low valence.
inline Triangle_mesh with_hub(Triangle_mesh mesh, int valence)
{
  const auto add = [&](std::size_t f) { // replaces (hub, x, y) by (hub, x, w), (hub, w, y) and (w, x, y)
    const auto t = mesh.triangles[f];
    const int w = static_cast<int>(mesh.points.size());
    mesh.points.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
    mesh.triangles[f] = {t[0], t[1], w};
    mesh.triangles.push_back({t[0], w, t[2]});
    mesh.triangles.push_back({w, t[1], t[2]});
  };
  add(0);
  const int hub = static_cast<int>(mesh.points.size()) - 1;
  std::deque<std::size_t> fan = {0, mesh.triangles.size() - 2, mesh.triangles.size() - 1};
  for (std::size_t f : fan) {
    auto& t = mesh.triangles[f];
    std::rotate(t.begin(), std::find(t.begin(), t.end(), hub), t.end());
  }
  for (int i = 3; i < valence; ++i) {
    const std::size_t f = fan.front();
    fan.pop_front();
    add(f);
    fan.push_back(f);
    fan.push_back(mesh.triangles.size() - 2);
  }
  return mesh;
}

inline Triangle_mesh snake(int rings)
{
  return moved(tube(rings, 6), [](const Vector3d& p) {
    const double s = 0.15 * p.x();
    return Vector3d(10 * std::sin(s) + p.y(), 2 * s + p.z(), 5 * std::cos(2 * s) + p.z());
  });
}

/// A tube whose radius falls by `ratio` from ring to ring, with rings as far apart as they are wide.
inline Triangle_mesh exponential_cone(int rings, double ratio)
{
  return moved(tube(rings, 6), [=](const Vector3d& p) {
    const double radius = std::pow(ratio, p.x());
    return Vector3d(-radius / (1 - ratio), radius * p.y(), radius * p.z());
  });
}

inline Triangle_mesh spikes(int n, double length)
{
  Triangle_mesh mesh = tube(n, n);
  Random random(9);
  for (auto& p : mesh.points) {
    const double angle = pi * (p.x() + 0.5) / n;
    p = Vector3d(std::cos(angle), std::sin(angle) * p.y(), std::sin(angle) * p.z());
    if (random.below(5) == 0) p *= length;
  }
  return mesh;
}

/// The point at parameter t in [0,1) of a tube round the (p,q) torus knot; `y` and `z` lie in its section.
inline Vector3d knot_point(double t, double y, double z, int p, int q)
{
  const auto centre = [=](double s) {
    const double r = 2 + std::cos(2 * pi * q * s);
    return Vector3d(r * std::cos(2 * pi * p * s), r * std::sin(2 * pi * p * s), std::sin(2 * pi * q * s));
  };
  const Vector3d tangent = (centre(t + 1e-4) - centre(t - 1e-4)).normalized();
  const Vector3d side = tangent.cross(Vector3d::UnitZ()).normalized();
  return centre(t) + 0.1 * (y * side + z * side.cross(tangent));
}

/// A closed tube, knotted.
inline Triangle_mesh knotted_torus(int n, int m, int p, int q)
{
  Triangle_mesh mesh = grid_torus(n, m, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      mesh.points[static_cast<std::size_t>(i) * m + j] =
        knot_point(static_cast<double>(i) / n, std::cos(2 * pi * j / m), std::sin(2 * pi * j / m), p, q);
  return mesh;
}

/// A tube with two ends, or of a bottle, bent to a knot that is not quite closed.
inline Triangle_mesh knotted(const Triangle_mesh& tube, int rings, int p, int q)
{
  return moved(tube, [=](const Vector3d& x) { return knot_point(0.98 * x.x() / rings, x.y(), x.z(), p, q); });
}

/// Joins two faces without common neighbourhood by a handle of `rings` three-sided rings.
inline Triangle_mesh with_handle(Triangle_mesh mesh, std::size_t from, std::size_t to, int rings)
{
  extrude(mesh, from, rings, 0, 0.1);
  const auto t = mesh.triangles[from], b = mesh.triangles[to];
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, x = b[static_cast<std::size_t>((3 - k) % 3)],
              y = b[static_cast<std::size_t>((3 - l) % 3)], v = t[static_cast<std::size_t>(k)],
              w = t[static_cast<std::size_t>(l)];
    mesh.triangles.push_back({v, w, y});
    mesh.triangles.push_back({v, y, x});
  }
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>((std::max)(from, to)));
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>((std::min)(from, to)));
  return mesh;
}

/// A ring torus with n x m quadrilaterals, radii `R` and `r`, twisted `twist` times on the way round.
inline Triangle_mesh ring_torus(int n, int m, double R, double r, int twist = 0)
{
  Triangle_mesh mesh = grid_torus(n, m, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * (j + static_cast<double>(m) * twist * i / n) / m;
      mesh.points[static_cast<std::size_t>(i) * m + j] =
        Vector3d((R + r * std::cos(v)) * std::cos(u), (R + r * std::cos(v)) * std::sin(u), r * std::sin(v));
    }
  return mesh;
}

/// A rectangle of n x m cells.
inline Triangle_mesh grid_disk(int n, int m)
{
  Triangle_mesh mesh;
  const auto at = [m](int i, int j) { return i * (m + 1) + j; };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) mesh.points.emplace_back(i, j, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// A centre with n neighbours.
inline Triangle_mesh fan_disk(int n) { return without_star(bipyramid(n), n + 1); }

/// A convex polygon without interior vertices, all its triangles at one vertex.
inline Triangle_mesh polygon_fan(int n)
{
  Triangle_mesh mesh;
  for (int i = 0; i < n; ++i) mesh.points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
  for (int i = 1; i + 1 < n; ++i) mesh.triangles.push_back({0, i, i + 1});
  return mesh;
}

/// The same polygon, its triangles in a zigzag.
inline Triangle_mesh polygon_zigzag(int n)
{
  Triangle_mesh mesh = polygon_fan(n);
  mesh.triangles.clear();
  for (int low = 0, high = n - 1; high - low > 1;) {
    mesh.triangles.push_back({low, low + 1, high});
    if (++low; high - low > 1) {
      mesh.triangles.push_back({low, high - 1, high});
      --high;
    }
  }
  return mesh;
}

/// A tube that is open at one end.
inline Triangle_mesh bottle(int rings, int k) { return without_star(tube(rings, k), rings * k); }

struct Case {
  std::string name;
  bool is_big; ///< too slow for every day
  std::function<Triangle_mesh()> make;
};

inline std::vector<Case> sphere_cases()
{
  const auto sphere = [](int n, int kind) {
    Random random(17);
    return random_sphere(n, 2 * n, kind, random);
  };
  const auto tens = [](double a, double b, double c) { return Vector3d(a, b, c); };
  return {
    {"tetrahedron", false, tetrahedron},
    {"tube, length / radius 200", false, [] { return tube(200, 8); }},
    {"tube, length / radius 20000", false, [=] { return scaled(tube(2000, 6), tens(10, 1, 1)); }},
    {"tube, length / radius 20000, 20000 rings", true, [] { return tube(20000, 6); }},
    {"three-sided tube", false, [] { return tube(2000, 3); }},
    {"three-sided tube, 50000 rings", true, [] { return tube(50000, 3); }},
    {"flat tube", false, [=] { return scaled(tube(200, 12), tens(1, 1, 1e-7)); }},
    {"needle tube", false, [=] { return scaled(tube(200, 12), tens(1, 1e-7, 1e-7)); }},
    {"octopus", false, [] { return octopus(100); }},
    {"octopus, arms of 2000 rings", true, [] { return octopus(2000); }},
    {"tree of extrusions", false, [] { return extrusion_tree(300); }},
    {"tree of 10000 extrusions", true, [] { return extrusion_tree(10000); }},
    {"bipyramid, valence 1000", false, [] { return bipyramid(1000); }},
    {"bipyramid, valence 100000", true, [] { return bipyramid(100000); }},
    {"stacked at random", false, [] { return stacked(2500, Order::RANDOM); }},
    {"stacked into the last face", false, [] { return stacked(2500, Order::LAST); }},
    {"stacked breadth first", false, [] { return stacked(2500, Order::BREADTH); }},
    {"stacked at random, 200000 faces", true, [] { return stacked(100000, Order::RANDOM); }},
    {"stacked into the last face, 20000 faces", true, [] { return stacked(10000, Order::LAST); }},
    {"stacked into the last face, 200000 faces", true, [] { return stacked(100000, Order::LAST); }},
    {"stacked breadth first, 200000 faces", true, [] { return stacked(100000, Order::BREADTH); }},
    {"snake", false, [] { return snake(800); }},
    {"spikes", false, [] { return spikes(50, 100); }},
    {"exponential cone", false, [] { return exponential_cone(60, 0.5); }},
    {"exponential cone that underflows", false, [] { return exponential_cone(400, 0.1); }},
    {"all vertices equal", false, [=] { return sphere(1500, 3); }},
    {"vertices on a 3 x 3 x 3 grid", false, [=] { return sphere(1500, 2); }},
    {"vertices over 20 decades", false, [=] { return sphere(1500, 1); }},
    {"random positions", false, [=] { return sphere(1500, 0); }},
    {"all collinear", false, [=] { return scaled(sphere(1500, 0), tens(1, 0, 0)); }},
    {"coordinates of 1e150", false, [=] { return scaled(octopus(20), tens(1e150, 1e150, 1e150)); }},
    {"coordinates of 1e-150", false, [=] { return scaled(octopus(20), tens(1e-150, 1e-150, 1e-150)); }},
    {"offset 1e8", false, [=] { return scaled(octopus(20), tens(1, 1, 1), tens(1e8, 1e8, 1e8)); }},
    {"hub of valence 5000", false, [] { return with_hub(octahedron(), 5000); }},
    {"hub of valence 100000", true, [] { return with_hub(octahedron(), 100000); }},
    {"offset 1e8 of coordinates of 1e-150", false,
     [=] { return scaled(octopus(20), tens(1e-150, 1e-150, 1e-150), tens(1e8, 1e8, 1e8)); }},
    {"coordinates of 1e150 and 1e-150", false, [=] { return scaled(octopus(20), tens(1e150, 1, 1e-150)); }},
    {"tube knotted to a trefoil", false, [] { return knotted(tube(600, 6), 600, 2, 3); }},
    {"tube knotted (7,11), 20000 rings", true, [] { return knotted(tube(20000, 6), 20000, 7, 11); }},
    {"20 flips per vertex", false,
     [] {
       Random random(23);
       return random_sphere(2000, 40000, 0, random);
     }},
  };
}

inline std::vector<Case> torus_cases()
{
  return {
    {"seven vertices", false, seven_vertex_torus},
    {"3 x 3", false, [] { return grid_torus(3, 3, 0); }},
    {"3 x 2000", false, [] { return grid_torus(2000, 3, 0); }},
    {"3 x 20000", true, [] { return grid_torus(20000, 3, 0); }},
    {"needle, R / r = 3e5", false, [] { return ring_torus(300, 8, 3e5, 1); }},
    {"fat, R / r = 1.003", false, [] { return ring_torus(60, 60, 1.003, 1); }},
    {"aspect 1e4 of the cells", false, [] { return ring_torus(10, 300, 1e3, 1); }},
    {"glued with a shift", false, [] { return grid_torus(60, 30, 7); }},
    {"one Dehn twist", false, [] { return ring_torus(100, 20, 3, 1, 1); }},
    {"seven Dehn twists", false, [] { return ring_torus(300, 12, 3, 1, 7); }},
    {"hub of valence 3000", false, [] { return with_hub(grid_torus(20, 20, 0), 3000); }},
    {"hub of valence 100000", true, [] { return with_hub(grid_torus(20, 20, 0), 100000); }},
    {"trefoil", false, [] { return knotted_torus(300, 8, 2, 3); }},
    {"knot (7,11)", false, [] { return knotted_torus(1500, 8, 7, 11); }},
    {"knot (7,11), 300000 faces", true, [] { return knotted_torus(15000, 10, 7, 11); }},
    {"sphere with a thin handle", false, [] { return with_handle(spikes(30, 1), 0, 900, 300); }},
    {"sphere with a handle of 10000 rings", true, [] { return with_handle(spikes(30, 1), 0, 900, 10000); }},
    {"stacked, then a handle", false, [] { return with_handle(stacked(1500, Order::RANDOM), 0, 2000, 3); }},
    {"20 flips per vertex", false,
     [] {
       Random random(29);
       return random_torus(40, 40, 32000, 0, random);
     }},
    {"coordinates of 1e150", false,
     [] { return scaled(ring_torus(40, 20, 3, 1), Vector3d::Constant(1e150)); }},
    {"coordinates of 1e-150", false,
     [] { return scaled(ring_torus(40, 20, 3, 1), Vector3d::Constant(1e-150)); }},
    {"offset 1e8", false,
     [] { return scaled(ring_torus(40, 20, 3, 1), Vector3d::Ones(), Vector3d::Constant(1e8)); }},
    {"all collinear", false, [] { return scaled(ring_torus(40, 20, 3, 1), Vector3d::UnitX()); }},
    {"vertices on a 3 x 3 x 3 grid", false, [] { return with_random_points(grid_torus(25, 25, 3), 2); }},
    {"with a tail", false,
     [] {
       Triangle_mesh mesh = grid_torus(30, 30, 0);
       extrude(mesh, 0, 300, 0.2, 0.99);
       return mesh;
     }},
    {"all vertices equal", false, [] { return with_random_points(grid_torus(25, 25, 3), 3); }},
    {"random positions", false, [] { return with_random_points(grid_torus(25, 25, 3), 0); }},
    {"vertices over 20 decades", false, [] { return with_random_points(grid_torus(25, 25, 3), 1); }},
  };
}

inline std::vector<Case> disk_cases()
{
  const auto minus_star = [](const Triangle_mesh& mesh, int v) { return without_star(mesh, v); };
  return {
    {"one triangle", false, [] { return polygon_fan(3); }},
    {"two triangles", false, [] { return grid_disk(1, 1); }},
    {"fan of valence 5000", false, [] { return fan_disk(5000); }},
    {"three triangles", false, [] { return polygon_fan(5); }},
    {"three triangles round a vertex", false, [] { return fan_disk(3); }},
    {"fan of valence 100000", true, [] { return fan_disk(100000); }},
    {"bottle knotted to a trefoil", false, [] { return knotted(bottle(600, 6), 600, 2, 3); }},
    {"rectangle of aspect 1e8", false, [] { return scaled(grid_disk(30, 30), Vector3d(1e8, 1, 1)); }},
    {"20 flips per vertex", false,
     [=] {
       Random random(31);
       return minus_star(random_sphere(1500, 30000, 0, random), 5);
     }},
    {"coordinates of 1e150", false, [] { return scaled(bottle(30, 8), Vector3d::Constant(1e150)); }},
    {"coordinates of 1e-150", false, [] { return scaled(bottle(30, 8), Vector3d::Constant(1e-150)); }},
    {"offset 1e8", false, [] { return scaled(bottle(30, 8), Vector3d::Ones(), Vector3d::Constant(1e8)); }},
    {"all collinear", false, [] { return scaled(bottle(30, 8), Vector3d::UnitX()); }},
    {"vertices on a 3 x 3 x 3 grid", false, [=] { return with_random_points(bottle(40, 12), 2); }},
    {"polygon fan without interior vertices", false, [] { return polygon_fan(1000); }},
    {"polygon zigzag", false, [] { return polygon_zigzag(1000); }},
    {"strip 2000 x 1", false, [] { return grid_disk(2000, 1); }},
    {"strip 20000 x 1", true, [] { return grid_disk(20000, 1); }},
    {"bottle of 30 rings", false, [] { return bottle(30, 8); }},
    {"bottle of 120 rings", false, [] { return bottle(120, 8); }},
    {"bottle of 1000 rings", false, [] { return bottle(1000, 8); }},
    {"tetrahedron minus a star", false, [=] { return minus_star(tetrahedron(), 1); }},
    {"octopus minus a star", false, [=] { return minus_star(octopus(60), 0); }},
    {"octopus minus the star of a tip", false, [=] { return minus_star(octopus(60), 6 + 3 * 60 - 1); }},
    {"bipyramid minus a star", false, [=] { return minus_star(bipyramid(1000), 5); }},
    {"stacked at random minus a star", false, [=] { return minus_star(stacked(2500, Order::RANDOM), 0); }},
    {"stacked, 50000 faces, minus a star", true,
     [=] { return minus_star(stacked(25000, Order::RANDOM), 0); }},
    {"spikes minus a star", false, [=] { return minus_star(spikes(40, 100), 7); }},
    {"all vertices equal", false, [=] { return with_random_points(bottle(40, 12), 3); }},
    {"random positions", false, [=] { return with_random_points(bottle(40, 12), 0); }},
    {"vertices over 20 decades", false, [=] { return with_random_points(bottle(40, 12), 1); }},
  };
}

} // namespace stress

#endif // SIMPLE_MANIFOLDS_TEST_STRESS_STRESS_SURFACES_H
