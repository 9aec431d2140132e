// Soups for the tests of repairs.

#ifndef SIMPLE_MANIFOLDS_TEST_SOUPS_H
#define SIMPLE_MANIFOLDS_TEST_SOUPS_H

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace soups {

using CGAL::Simple_manifolds::Mesh_soup;
using Faces = std::vector<std::vector<int>>;
using Points = std::vector<Eigen::Vector3d>;

/// Points whose coordinates mean nothing, but are all different and in no special position.
inline Points points(int n)
{
  Points p;
  for (int i = 0; i < n; ++i) p.emplace_back(std::sin(i + 1.), std::cos(3. * i), std::sin(5. * i + 2));
  return p;
}

inline Mesh_soup soup(const Faces& faces, int n) { return Mesh_soup(points(n), faces); }

/// The cube [0,1]^3, oriented outward.
inline Mesh_soup cube(const Eigen::Vector3d& corner = Eigen::Vector3d(0, 0, 0), double side = 1)
{
  Points p;
  for (int i = 0; i < 8; ++i) p.push_back(corner + side * Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2 & 1));
  return Mesh_soup(p,
                   Faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// A sphere of 2 n rings and 4 n slices, without seam, with triangles at the poles and quads between.
inline Mesh_soup sphere(int n = 4)
{
  Points p = {{0, 0, 1}};
  Faces f;
  const int rings = 2 * n, slices = 4 * n;
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < slices; ++j) {
      const double theta = 3.14159265358979 * i / rings, phi = 6.28318530717959 * j / slices;
      p.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  p.emplace_back(0, 0, -1);
  const auto at = [&](int i, int j) { return 1 + (i - 1) * slices + j % slices; };
  const int south = static_cast<int>(p.size()) - 1;
  for (int j = 0; j < slices; ++j) {
    f.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rings; ++i) f.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    f.push_back({at(rings - 1, j), south, at(rings - 1, j + 1)});
  }
  return Mesh_soup(p, f);
}

/// The vertices of the faces.
inline Faces faces_of(const Mesh_soup& s)
{
  Faces faces(s.number_of_faces());
  for (int h = 0; h < s.number_of_half_edges(); ++h) faces[s.face(h)].push_back(s.source(h));
  return faces;
}

/// One after the other.
inline Mesh_soup together(const std::vector<Mesh_soup>& parts)
{
  Points p;
  Faces f;
  for (const Mesh_soup& part : parts) {
    for (std::vector<int> face : faces_of(part)) {
      for (int& v : face) v += static_cast<int>(p.size());
      f.push_back(face);
    }
    p.insert(p.end(), part.points.begin(), part.points.end());
  }
  return Mesh_soup(p, f);
}

/// Points with equal coordinates become one vertex, as in the files of some programs.
inline Mesh_soup merged(const Mesh_soup& s)
{
  std::map<std::vector<double>, int> first;
  Points p;
  Faces f = faces_of(s);
  for (auto& face : f)
    for (int& v : face) {
      const Eigen::Vector3d& x = s.points[v];
      const auto [at, is_new] = first.emplace(std::vector<double>{x.x(), x.y(), x.z()}, int(p.size()));
      if (is_new) p.push_back(x);
      v = at->second;
    }
  return Mesh_soup(p, f);
}

/// Each face with points of its own.
inline Mesh_soup apart(const Mesh_soup& s)
{
  Points p;
  Faces f = faces_of(s);
  for (auto& face : f)
    for (int& v : face) {
      p.push_back(s.points[v]);
      v = static_cast<int>(p.size()) - 1;
    }
  return Mesh_soup(p, f);
}

inline Eigen::Vector3d area_vector(const Mesh_soup& s, int f)
{
  Eigen::Vector3d sum(0, 0, 0);
  const Eigen::Vector3d& origin = s.points[s.source(s.first(f))];
  for (int h = s.first(f); h <= s.last(f); ++h)
    sum += (s.points[s.source(h)] - origin).cross(s.points[s.target(h)] - origin) / 2;
  return sum;
}

inline double area(const Mesh_soup& s)
{
  double sum = 0;
  for (int f = 0; f < s.number_of_faces(); ++f) sum += area_vector(s, f).norm();
  return sum;
}

inline double volume(const Mesh_soup& s)
{
  double sum = 0;
  for (int f = 0; f < s.number_of_faces(); ++f)
    sum += area_vector(s, f).dot(s.points[s.source(s.first(f))]) / 3;
  return sum;
}

/// Bit for bit, unused points without coordinates too.
inline bool are_equal(const Mesh_soup& a, const Mesh_soup& b)
{
  if (faces_of(a) != faces_of(b) || a.points.size() != b.points.size()) return false;
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      if (!(a.points[v][i] == b.points[v][i] || (std::isnan(a.points[v][i]) && std::isnan(b.points[v][i]))))
        return false;
  return true;
}

} // namespace soups

#endif // SIMPLE_MANIFOLDS_TEST_SOUPS_H
