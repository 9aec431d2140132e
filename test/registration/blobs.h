#ifndef SIMPLE_MANIFOLDS_TEST_REGISTRATION_BLOBS_H
#define SIMPLE_MANIFOLDS_TEST_REGISTRATION_BLOBS_H

#include "../correspondence/sample_maps.h"

#include <CGAL/Simple_manifolds/Triangle.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <vector>

// Closed surfaces over the round sphere that are known at every point: a sphere with some bumps.
namespace blobs {

struct Bump {
  Eigen::Vector3d at; // a unit vector
  double height;
};

inline std::vector<Bump> four_bumps()
{
  return {{Eigen::Vector3d(1, 0, 0), 1.2},
          {Eigen::Vector3d(-0.2, 1, 0.1).normalized(), 0.8},
          {Eigen::Vector3d(0.1, -0.3, 1).normalized(), 0.5},
          {Eigen::Vector3d(-0.5, -0.6, -0.6).normalized(), 0.3}};
}

inline Eigen::Vector3d point(const std::vector<Bump>& bumps, const Eigen::Vector3d& p)
{
  double r = 1;
  for (const Bump& b : bumps) r += b.height * std::exp(-6 * (p - b.at).squaredNorm());
  return r * p;
}

struct Blob {
  std::vector<Eigen::Vector3d> sphere; // per vertex: the point of the round sphere
  std::vector<Eigen::Vector3d> points;
  std::vector<CGAL::Simple_manifolds::Triangle> faces;
};

// `turn` turns the triangulation, not the surface.
inline Blob blob(const std::vector<Bump>& bumps, int subdivisions,
                 const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  const auto m = sample::subdivided(sample::octahedron(), subdivisions);
  Blob b;
  b.faces = m.faces;
  for (const Eigen::Vector3d& p : m.domain_points) {
    b.sphere.push_back((turn * p).normalized());
    b.points.push_back(point(bumps, b.sphere.back()));
  }
  return b;
}

inline Eigen::Matrix3d some_turn()
{
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -3).normalized()).toRotationMatrix();
}

// The vertex next to a point of the round sphere.
inline int vertex_at(const Blob& b, const Eigen::Vector3d& p)
{
  int best = 0;
  for (int v = 1; v < static_cast<int>(b.sphere.size()); ++v)
    if ((b.sphere[v] - p).squaredNorm() < (b.sphere[best] - p).squaredNorm()) best = v;
  return best;
}

} // namespace blobs

#endif // SIMPLE_MANIFOLDS_TEST_REGISTRATION_BLOBS_H
