// A surface that is fine in one place: its faces have T-junctions.

#ifndef SIMPLE_MANIFOLDS_TEST_THORNY_SPHERE_H
#define SIMPLE_MANIFOLDS_TEST_THORNY_SPHERE_H

#include "../embedding/analytic_embeddings.h"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace analytic {

/// The sphere with a thorn at (2,-1,2)/3: the radius is 1 + exp(-50 |p - thorn|^2).
struct Thorn : By_jet<Thorn> {
  explicit Thorn(int c) : chart(c) {}

  template <int Order = 2>
  Jet jet(const Vector2d& uv) const
  {
    const Jet p = Sphere_atlas().chart(chart).point_jet(uv);
    const Vector3d d = p.value - Vector3d(2, -1, 2) / 3;
    const double f = std::exp(-50 * d.squaredNorm());
    const auto slope = [&](const Vector3d& a) { return -100 * d.dot(a); };
    const auto second = [&](const Vector3d& a, const Vector3d& b, const Vector3d& ab) {
      return f * (slope(a) * slope(b) - 100 * (a.dot(b) + d.dot(ab)));
    };
    return product(Scalar_jet{1 + f, f * slope(p.u), f * slope(p.v), second(p.u, p.u, p.uu),
                              second(p.u, p.v, p.uv), second(p.v, p.v, p.vv)},
                   p);
  }

  int chart;
};

inline Manifold_surface<Sphere_atlas, Thorn> thorny_sphere()
{
  std::vector<Thorn> charts;
  for (int c = 0; c < Sphere_atlas::number_of_charts(); ++c) charts.emplace_back(c);
  return Manifold_surface<Sphere_atlas, Thorn>(charts);
}

} // namespace analytic

#endif // SIMPLE_MANIFOLDS_TEST_THORNY_SPHERE_H
