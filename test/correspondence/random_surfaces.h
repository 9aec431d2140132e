// Random triangulated spheres, tori and disks, and small ones that are hard, all from fixed generators.

#ifndef SIMPLE_MANIFOLDS_TEST_RANDOM_SURFACES_H
#define SIMPLE_MANIFOLDS_TEST_RANDOM_SURFACES_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

struct Triangle_mesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
};

// The standard fixes the numbers of std::mt19937, but not those of the distributions.
class Random {
public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double real() { return generator_() / 4294967296.; }
  int below(int n) { return static_cast<int>(generator_() % static_cast<unsigned>(n)); }

private:
  std::mt19937 generator_;
};

// Positions that have nothing to do with the connectivity: random, over 20 decades, on a coarse grid, all equal.
inline void set_random_points(Triangle_mesh& mesh, int n, int kind, Random& random)
{
  mesh.points.resize(n);
  for (auto& p : mesh.points)
    for (int k = 0; k < 3; ++k) {
      const double x = random.real();
      p[k] = kind == 0 ? x : kind == 1 ? std::pow(10., 20 * x - 10) : kind == 2 ? std::floor(3 * x) : 1.;
    }
}

// Flips random edges, where the mesh stays simplicial.
inline void flip_random_edges(Triangle_mesh& mesh, int times, Random& random)
{
  std::map<std::pair<int, int>, int> face; // of each half-edge
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k)
      face[{mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]}] = static_cast<int>(f);
  for (int i = 0; i < times; ++i) {
    const int f = random.below(static_cast<int>(mesh.triangles.size())), k = random.below(3);
    const int a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3],
              c = mesh.triangles[f][(k + 2) % 3];
    const auto other = face.find({b, a});
    if (other == face.end()) continue; // an edge of the border
    const int g = other->second;
    int d = -1;
    for (int v : mesh.triangles[g]) d = v != a && v != b ? v : d;
    if (d == c || face.count({c, d}) || face.count({d, c})) continue;
    face.erase({a, b});
    face.erase({b, a});
    mesh.triangles[f] = {c, a, d};
    mesh.triangles[g] = {d, b, c};
    face[{a, d}] = face[{d, c}] = f;
    face[{b, c}] = face[{c, d}] = g;
  }
}

// Puts vertices into random faces; they have no points yet.
inline void stack_random_vertices(Triangle_mesh& mesh, int first, int last, Random& random)
{
  for (int v = first; v < last; ++v) {
    const int f = random.below(static_cast<int>(mesh.triangles.size()));
    const auto t = mesh.triangles[f];
    mesh.triangles[f] = {t[0], t[1], v};
    mesh.triangles.push_back({t[1], t[2], v});
    mesh.triangles.push_back({t[2], t[0], v});
  }
}

// A sphere of n >= 4 vertices: a tetrahedron, vertices put into random faces, then flips.
inline Triangle_mesh random_sphere(int n, int flips, int kind, Random& random)
{
  Triangle_mesh mesh;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  stack_random_vertices(mesh, 4, n, random);
  flip_random_edges(mesh, flips, random);
  set_random_points(mesh, n, kind, random);
  return mesh;
}

// A torus: an n x m grid with a twist, then flips. n, m >= 3.
inline Triangle_mesh grid_torus(int n, int m, int twist)
{
  Triangle_mesh mesh;
  const auto at = [&](int i, int j) {
    const int row = j + (i >= n ? twist : 0); // glued with a shift
    return (i % n) * m + ((row % m) + m) % m;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * 3.141592653589793 * i / n, v = 2 * 3.141592653589793 * j / m;
      mesh.points.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

inline Triangle_mesh random_torus(int n, int m, int flips, int kind, Random& random)
{
  Triangle_mesh mesh = grid_torus(n, m, 0);
  flip_random_edges(mesh, flips, random);
  set_random_points(mesh, n * m, kind, random);
  return mesh;
}

// Moebius' torus: seven vertices, every two of them joined by an edge.
inline Triangle_mesh seven_vertex_torus()
{
  Triangle_mesh mesh;
  for (int i = 0; i < 7; ++i) {
    mesh.points.emplace_back(std::cos(2. * i), std::sin(3. * i), std::cos(5. * i));
    mesh.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    mesh.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return mesh;
}

// A disk: a sphere without the faces round vertex `hole` (the vertex becomes the last and is dropped).
inline Triangle_mesh without_star(Triangle_mesh mesh, int hole)
{
  const int last = static_cast<int>(mesh.points.size()) - 1;
  for (auto& t : mesh.triangles)
    for (int& v : t) v = v == hole ? last : v == last ? hole : v;
  std::swap(mesh.points[hole], mesh.points[last]);
  mesh.triangles.erase(
    std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
                   [&](const auto& t) { return std::count(t.begin(), t.end(), last) > 0; }),
    mesh.triangles.end());
  mesh.points.pop_back();
  return mesh;
}

// Two poles over a ring of n vertices: valence n.
inline Triangle_mesh bipyramid(int n)
{
  Triangle_mesh mesh;
  for (int i = 0; i < n; ++i) {
    mesh.points.emplace_back(std::cos(2 * 3.141592653589793 * i / n), std::sin(2 * 3.141592653589793 * i / n),
                             0);
    mesh.triangles.push_back({i, (i + 1) % n, n});
    mesh.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  mesh.points.emplace_back(0, 0, 1);
  mesh.points.emplace_back(0, 0, -1);
  return mesh;
}

// A closed tube of `rings` rings of k vertices, length over radius `rings`.
inline Triangle_mesh tube(int rings, int k)
{
  Triangle_mesh mesh;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < k; ++j)
      mesh.points.emplace_back(i, std::cos(2 * 3.141592653589793 * j / k),
                               std::sin(2 * 3.141592653589793 * j / k));
  for (int i = 0; i + 1 < rings; ++i)
    for (int j = 0; j < k; ++j) {
      const int a = i * k + j, b = i * k + (j + 1) % k;
      mesh.triangles.push_back({a, b, b + k});
      mesh.triangles.push_back({a, b + k, a + k});
    }
  const int first = rings * k, last = first + 1;
  mesh.points.emplace_back(-0.5, 0, 0);
  mesh.points.emplace_back(rings - 0.5, 0, 0);
  for (int j = 0; j < k; ++j) {
    mesh.triangles.push_back({first, (j + 1) % k, j});
    mesh.triangles.push_back({last, (rings - 1) * k + j, (rings - 1) * k + (j + 1) % k});
  }
  return mesh;
}

#endif // SIMPLE_MANIFOLDS_TEST_RANDOM_SURFACES_H
