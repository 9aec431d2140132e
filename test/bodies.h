// Bodies of several kinds as indexed triangles, and files full of them.

#ifndef SIMPLE_MANIFOLDS_TEST_BODIES_H
#define SIMPLE_MANIFOLDS_TEST_BODIES_H

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace bodies {

struct Body {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
};

inline Body moved(Body body, const Eigen::Vector3d& by)
{
  for (Eigen::Vector3d& p : body.points) p += by;
  return body;
}

/// Turned inside out.
inline Body reversed(Body body)
{
  for (auto& t : body.triangles) std::swap(t[1], t[2]);
  return body;
}

/// All in one, in the order of the list.
inline Body together(const std::vector<Body>& parts)
{
  Body all;
  for (const Body& part : parts) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return all;
}

/// n x m cells, closed up in u if `wraps[0]` and in v if `wraps[1]`; the point of (u,v) in [0,1]^2 is f(u,v).
template <class F>
Body grid(int n, int m, std::array<bool, 2> wraps, const F& f)
{
  Body body;
  const int rows = wraps[0] ? n : n + 1, columns = wraps[1] ? m : m + 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) body.points.push_back(f(i / double(n), j / double(m)));
  const auto vertex = [&](int i, int j) { return i % rows * columns + j % columns; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      body.triangles.push_back({a, b, c});
      body.triangles.push_back({a, c, d});
    }
  return body;
}

/// 2 n m triangles, outward oriented.
inline Body torus(int n, int m)
{
  const double pi = std::acos(-1);
  return grid(n, m, {true, true}, [pi](double u, double v) {
    const double r = 2 + std::cos(2 * pi * v);
    return Eigen::Vector3d(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), std::sin(2 * pi * v));
  });
}

/// 2 n n triangles of a saddle.
inline Body disk(int n)
{
  return grid(n, n, {false, false},
              [](double u, double v) { return Eigen::Vector3d(u, v, 0.3 * (u - 0.5) * (v - 0.5)); });
}

/// The boundary of cubes of an n x m x 1 block; is_filled(i, j) says which are there.
template <class F>
Body cubes(int n, int m, const F& is_filled)
{
  Body body;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](int i, int j, int k) {
    const auto [at, is_new] = index.try_emplace({i, j, k}, static_cast<int>(body.points.size()));
    if (is_new) body.points.emplace_back(i, j, k);
    return at->second;
  };
  const auto has = [&](int i, int j) { return 0 <= i && i < n && 0 <= j && j < m && is_filled(i, j); };
  const auto add = [&](std::array<int, 4> q) {
    body.triangles.push_back({q[0], q[1], q[2]});
    body.triangles.push_back({q[0], q[2], q[3]});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      if (!has(i, j)) continue;
      const auto v = [&](int a, int b, int c) { return vertex(i + a, j + b, c); };
      add({v(0, 0, 0), v(0, 1, 0), v(1, 1, 0), v(1, 0, 0)});
      add({v(0, 0, 1), v(1, 0, 1), v(1, 1, 1), v(0, 1, 1)});
      if (!has(i - 1, j)) add({v(0, 0, 0), v(0, 0, 1), v(0, 1, 1), v(0, 1, 0)});
      if (!has(i + 1, j)) add({v(1, 0, 0), v(1, 1, 0), v(1, 1, 1), v(1, 0, 1)});
      if (!has(i, j - 1)) add({v(0, 0, 0), v(1, 0, 0), v(1, 0, 1), v(0, 0, 1)});
      if (!has(i, j + 1)) add({v(0, 1, 0), v(0, 1, 1), v(1, 1, 1), v(1, 1, 0)});
    }
  return body;
}

/// A slab of 5 x 3 cubes with two holes: genus 2, 120 triangles.
inline Body pretzel()
{
  return cubes(5, 3, [](int i, int j) { return j != 1 || i % 2 == 0; });
}

/// The same without a triangle: no canonical surface has a handle and a border.
inline Body open_pretzel()
{
  Body body = pretzel();
  body.triangles.pop_back();
  return body;
}

/// A sphere of radius r: 12 n n triangles, outward oriented.
inline Body sphere(int n, double r = 1)
{
  Body body;
  std::map<std::array<int, 3>, int> index; // of the points of a cube of n^3 cells
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [at, is_new] = index.try_emplace(p, static_cast<int>(body.points.size()));
    if (is_new) {
      const Eigen::Vector3d x(p[0], p[1], p[2]);
      body.points.push_back(r * (2 * x - Eigen::Vector3d::Constant(n)).normalized());
    }
    return at->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int a, int b) {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = a;
            p[(axis + 2) % 3] = b;
            return vertex(p);
          };
          const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          if (side == n) {
            body.triangles.push_back({a, b, c});
            body.triangles.push_back({a, c, d});
          } else {
            body.triangles.push_back({a, c, b});
            body.triangles.push_back({a, d, c});
          }
        }
  return body;
}

} // namespace bodies

#endif // SIMPLE_MANIFOLDS_TEST_BODIES_H
