// Models of ChartEmbedding that are known in closed form: surfaces whose curvatures, areas and closest points
// are known, without any fit. All charts agree, so the blend is the surface itself.

#ifndef SIMPLE_MANIFOLDS_TEST_ANALYTIC_EMBEDDINGS_H
#define SIMPLE_MANIFOLDS_TEST_ANALYTIC_EMBEDDINGS_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace analytic {

using CGAL::Simple_manifolds::Chart_point;
using CGAL::Simple_manifolds::Jet;
using CGAL::Simple_manifolds::Manifold_surface;
using CGAL::Simple_manifolds::Plane_atlas;
using CGAL::Simple_manifolds::Scalar_jet;
using CGAL::Simple_manifolds::Sphere_atlas;
using CGAL::Simple_manifolds::Torus_atlas;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979324;

/// The rest of an embedding that has a jet.
template <class Derived>
struct By_jet {
  int smoothness() const { return 99; }
  Vector3d point(const Vector2d& uv) const
  {
    return static_cast<const Derived*>(this)->template jet<2>(uv).value;
  }
};

/// The ellipsoid with the given half axes round `centre`; `bump` makes its radius 1 + bump z (x^2 - y^2).
struct Ellipsoid : By_jet<Ellipsoid> {
  Ellipsoid(int c, const Vector3d& a, double b = 0, const Vector3d& m = Vector3d::Zero())
    : chart(c), axes(a), bump(b), centre(m)
  {
  }

  template <int Order = 2>
  Jet jet(const Vector2d& uv) const
  {
    const Jet p = Sphere_atlas().chart(chart).point_jet(uv);
    const auto coordinate = [&](int k) {
      return Scalar_jet{p.value[k], p.u[k], p.v[k], p.uu[k], p.uv[k], p.vv[k]};
    };
    const Scalar_jet x = coordinate(0), y = coordinate(1), z = coordinate(2);
    Scalar_jet square = product(x, x);
    Scalar_jet minus = product(y, y);
    minus = product(Scalar_jet{-1, 0, 0, 0, 0, 0}, minus);
    square += minus;
    Scalar_jet radius = product(Scalar_jet{bump, 0, 0, 0, 0, 0}, product(z, square));
    radius += Scalar_jet{1, 0, 0, 0, 0, 0};
    const Jet e = product(radius, p);
    const auto scaled = [&](const Vector3d& v) -> Vector3d { return axes.cwiseProduct(v); };
    return {centre + scaled(e.value), scaled(e.u), scaled(e.v), scaled(e.uu), scaled(e.uv), scaled(e.vv)};
  }

  int chart;
  Vector3d axes;
  double bump;
  Vector3d centre;
};

/// The torus of revolution about the z axis with outward normal; `bump` makes its small radius
/// r (1 + bump cos(3 a)), a the angle of revolution.
struct Ring : By_jet<Ring> {
  Ring(int c, double R, double r, double b = 0) : chart(c), large(R), small(r), bump(b) {}

  template <int Order = 2>
  Jet jet(const Vector2d& uv) const
  {
    const auto p = Torus_atlas().chart(chart).point_jet(uv);
    // functions of one of the two angles: value, first and second derivative by it
    const double w = 2 * pi * 2 / 3, a = 2 * pi * p.value[0], b = 2 * pi * p.value[1];
    const auto of_a = [w](double f, double f1, double f2) {
      return Scalar_jet{f, w * f1, 0, w * w * f2, 0, 0};
    };
    const auto of_b = [w](double f, double f1, double f2) {
      return Scalar_jet{f, 0, w * f1, 0, 0, w * w * f2};
    };
    const Scalar_jet cos_a = of_a(std::cos(a), -std::sin(a), -std::cos(a)),
                     sin_a = of_a(std::sin(a), std::cos(a), -std::sin(a)),
                     cos_b = of_b(std::cos(b), -std::sin(b), -std::cos(b)),
                     sin_b = of_b(std::sin(b), std::cos(b), -std::sin(b)),
                     radius = of_a(small * (1 + bump * std::cos(3 * a)), -3 * small * bump * std::sin(3 * a),
                                   -9 * small * bump * std::cos(3 * a));
    Scalar_jet ring = product(radius, cos_b);
    ring += Scalar_jet{large, 0, 0, 0, 0, 0};
    const Scalar_jet x = product(ring, cos_a), y = product(ring, sin_a), z = product(radius, sin_b);
    return {{x.value, y.value, z.value}, {x.u, y.u, z.u},    {x.v, y.v, z.v},
            {x.uu, y.uu, z.uu},          {x.uv, y.uv, z.uv}, {x.vv, y.vv, z.vv}};
  }

  int chart;
  double large, small, bump;
};

/// The graph (u, v, (a (u-1/2)^2 + b (v-1/2)^2) / 2) over the unit square.
struct Paraboloid : By_jet<Paraboloid> {
  Paraboloid(double a_, double b_) : a(a_), b(b_) {}

  template <int Order = 2>
  Jet jet(const Vector2d& uv) const
  {
    const double x = uv[0] - .5, y = uv[1] - .5;
    return {{uv[0], uv[1], (a * x * x + b * y * y) / 2},
            {1, 0, a * x},
            {0, 1, b * y},
            {0, 0, a},
            {0, 0, 0},
            {0, 0, b}};
  }

  double a, b;
};

using Ellipsoid_surface = Manifold_surface<Sphere_atlas, Ellipsoid>;
using Ring_surface = Manifold_surface<Torus_atlas, Ring>;
using Paraboloid_surface = Manifold_surface<Plane_atlas, Paraboloid>;

inline Ellipsoid_surface ellipsoid(const Vector3d& axes, double bump = 0,
                                   const Vector3d& centre = Vector3d::Zero())
{
  std::vector<Ellipsoid> charts;
  for (int c = 0; c < Sphere_atlas::number_of_charts(); ++c) charts.emplace_back(c, axes, bump, centre);
  return Ellipsoid_surface(charts);
}

inline Ring_surface ring(double large, double small, double bump = 0)
{
  std::vector<Ring> charts;
  for (int c = 0; c < Torus_atlas::number_of_charts(); ++c) charts.emplace_back(c, large, small, bump);
  return Ring_surface(charts);
}

inline Paraboloid_surface paraboloid(double a, double b) { return Paraboloid_surface({Paraboloid(a, b)}); }

} // namespace analytic

#endif // SIMPLE_MANIFOLDS_TEST_ANALYTIC_EMBEDDINGS_H
