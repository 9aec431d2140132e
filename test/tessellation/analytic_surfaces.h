// Surfaces with known area, volume and curvature, as embeddings of charts.

#ifndef SIMPLE_MANIFOLDS_TEST_ANALYTIC_SURFACES_H
#define SIMPLE_MANIFOLDS_TEST_ANALYTIC_SURFACES_H

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <cmath>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

constexpr double pi = 3.14159265358979323846;

/// The ellipsoid x = A p, p on the unit sphere, seen in one chart.
class Ellipsoid_embedding {
public:
  Ellipsoid_embedding(int chart, const Eigen::Vector3d& half_axes) : chart_(chart), half_axes_(half_axes) {}

  int smoothness() const { return 9; }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return jet(uv).value; }

  template <int Order = 2>
  SM::Jet jet(const Eigen::Vector2d& uv) const
  {
    const SM::Jet p = SM::Sphere_atlas().chart(chart_).point_jet(uv);
    const auto scale = half_axes_.asDiagonal();
    return {scale * p.value, scale * p.u, scale * p.v, scale * p.uu, scale * p.uv, scale * p.vv};
  }

private:
  int chart_;
  Eigen::Vector3d half_axes_;
};

/// The ring torus with radii R > r: u turns round the tube, v round the axis; the normal is outward.
class Ring_embedding {
public:
  Ring_embedding(int chart, double R, double r) : chart_(chart), R_(R), r_(r) {}

  int smoothness() const { return 9; }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return jet(uv).value; }

  template <int Order = 2>
  SM::Jet jet(const Eigen::Vector2d& uv) const
  {
    // The chart covers 2/3 of the turn, so that d/du = 4 pi / 3 d/dtheta.
    const Eigen::Vector2d p = SM::Torus_atlas().chart(chart_).point(uv);
    const double a = 4 * pi / 3, v = -2 * pi * p.x(), u = 2 * pi * p.y(); // reversed tube: outward normal
    const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v), w = R_ + r_ * cv;
    using V = Eigen::Vector3d;
    return {V(w * cu, w * su, r_ * sv),
            -a * V(-r_ * sv * cu, -r_ * sv * su, r_ * cv),
            a * V(-w * su, w * cu, 0),
            a * a * V(-r_ * cv * cu, -r_ * cv * su, -r_ * sv),
            -a * a * V(r_ * sv * su, -r_ * sv * cu, 0),
            a * a * V(-w * cu, -w * su, 0)};
  }

private:
  int chart_;
  double R_, r_;
};

/// The paraboloid z = (x^2 + y^2) / 2 over the unit square.
class Paraboloid_embedding {
public:
  int smoothness() const { return 9; }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return jet(uv).value; }

  template <int Order = 2>
  SM::Jet jet(const Eigen::Vector2d& x) const
  {
    using V = Eigen::Vector3d;
    return {
      V(x[0], x[1], x.squaredNorm() / 2), V(1, 0, x[0]), V(0, 1, x[1]), V(0, 0, 1), V(0, 0, 0), V(0, 0, 1)};
  }
};

/// The unit sphere with one narrow bump of height 0.3 in the direction (2,-3,6)/7.
class Bump_embedding {
public:
  explicit Bump_embedding(int chart) : chart_(chart) {}

  int smoothness() const { return 9; }

  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    const Eigen::Vector3d p = SM::Sphere_atlas().chart(chart_).point(uv), top = Eigen::Vector3d(2, -3, 6) / 7;
    return (1 + 0.3 * std::exp(-40 * (1 - p.dot(top)))) * p;
  }

  template <int Order = 2>
  SM::Jet jet(const Eigen::Vector2d& uv) const
  {
    const SM::Jet p = SM::Sphere_atlas().chart(chart_).point_jet(uv);
    const Eigen::Vector3d top = Eigen::Vector3d(2, -3, 6) / 7;
    const double g = 0.3 * std::exp(-40 * (1 - p.value.dot(top)));
    const double u = 40 * p.u.dot(top), v = 40 * p.v.dot(top);
    const SM::Scalar_jet height = {1 + g,
                                   g * u,
                                   g * v,
                                   g * (40 * p.uu.dot(top) + u * u),
                                   g * (40 * p.uv.dot(top) + u * v),
                                   g * (40 * p.vv.dot(top) + v * v)};
    return product(height, p);
  }

private:
  int chart_;
};

inline SM::Manifold_surface<SM::Sphere_atlas, Bump_embedding> sphere_with_bump()
{
  std::vector<Bump_embedding> charts;
  for (int c = 0; c < 6; ++c) charts.emplace_back(c);
  return SM::Manifold_surface<SM::Sphere_atlas, Bump_embedding>(charts);
}

inline SM::Manifold_surface<SM::Sphere_atlas, Ellipsoid_embedding> ellipsoid(const Eigen::Vector3d& half_axes)
{
  std::vector<Ellipsoid_embedding> charts;
  for (int c = 0; c < 6; ++c) charts.emplace_back(c, half_axes);
  return SM::Manifold_surface<SM::Sphere_atlas, Ellipsoid_embedding>(charts);
}

inline SM::Manifold_surface<SM::Torus_atlas, Ring_embedding> ring(double R, double r)
{
  std::vector<Ring_embedding> charts;
  for (int c = 0; c < 9; ++c) charts.emplace_back(c, R, r);
  return SM::Manifold_surface<SM::Torus_atlas, Ring_embedding>(charts);
}

inline SM::Manifold_surface<SM::Plane_atlas, Paraboloid_embedding> paraboloid()
{
  return SM::Manifold_surface<SM::Plane_atlas, Paraboloid_embedding>(std::vector<Paraboloid_embedding>(1));
}

#endif // SIMPLE_MANIFOLDS_TEST_ANALYTIC_SURFACES_H
