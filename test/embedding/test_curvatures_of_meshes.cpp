// Curvatures of surfaces that were fitted to meshes, against the true ones and those of local quadrics.

#include "catch.h"
#include "embedding/curvature_samples.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <algorithm>
#include <vector>

namespace test_curvatures_of_meshes {

using namespace curvature_samples;

namespace {

using Member = std::vector<double> Curvature_errors::*;
const Member members[] = {&Curvature_errors::mean, &Curvature_errors::gaussian, &Curvature_errors::direction};

const auto mapping = SM::parameters::map_options(SM::map_options_for_fitting());

template <class Map>
Curvature_errors errors_of_fit(const Sampled_surface& s, const Map& map, double tolerance)
{
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(tolerance));
  return curvature_errors(s, [&](int v) { return surface.jet(map.domain_point(v)); });
}

// Half of the errors, and nineteen of twenty, are not larger than those of quadrics, nor than with a looser tolerance;
// `floor`: what is as good as exact.
void check_errors(const Curvature_errors& quadrics, const Curvature_errors& loose,
                  const Curvature_errors& tight, double per_quadric, double per_loose)
{
  for (int k = 0; k < 3; ++k)
    for (const double part : {0.5, 0.95}) {
      const double floor = part == 0.5 ? 0.005 : 0.02;
      const double q = share(quadrics.*members[k], part), e = share(tight.*members[k], part),
                   before = share(loose.*members[k], part);
      CAPTURE(k, part, q, e, before);
      CHECK(e < (std::max)(per_quadric * q, floor));
      CHECK(e < (std::max)(per_loose * before, floor));
    }
}

template <class Map>
void check_against_quadrics(const Sampled_surface& s, const Map& map)
{
  check_errors(errors_of_quadrics(s), errors_of_fit(s, map, 1e-4), errors_of_fit(s, map, 2e-5), 1.05, 1.5);
}

} // namespace

TEST_CASE("Curvatures of fitted balls are better than those of quadrics")
{
  const Vertices vertices = GENERATE(Vertices::UNIFORM, Vertices::GRADED, Vertices::RANDOM);
  CAPTURE(int(vertices));
  const auto check = [](const Sampled_surface& s) {
    check_against_quadrics(s, SM::map_to_sphere(s.points, s.faces, mapping));
  };
  check(superquadric({3, 2, 1}, 2, 4, vertices));
  check(superquadric({1, 1, 1}, 4, 4, vertices));
}

TEST_CASE("Curvatures of fitted tori are better than those of quadrics")
{
  const Vertices vertices = GENERATE(Vertices::UNIFORM, Vertices::GRADED, Vertices::RANDOM);
  CAPTURE(int(vertices));
  const Sampled_surface s = torus(2, .8, 36, vertices);
  check_against_quadrics(s, SM::map_to_torus(s.points, s.faces, mapping));
}

TEST_CASE("Curvatures of fitted patches are better than those of quadrics, borders included")
{
  const Vertices vertices = GENERATE(Vertices::UNIFORM, Vertices::GRADED, Vertices::RANDOM);
  CAPTURE(int(vertices));
  const auto check = [](const Sampled_surface& s) {
    check_against_quadrics(s, SM::map_to_plane(s.points, s.faces, mapping));
  };
  check(paraboloid(1, 30, vertices));
  check(paraboloid(-1, 30, vertices));
  check(enneper(30, vertices));
}

// With a tolerance of twice the noise and more: one below it is met by following the noise.
TEST_CASE("Curvatures of slightly noisy meshes are about as good as those of quadrics")
{
  const Vertices vertices = GENERATE(Vertices::UNIFORM, Vertices::RANDOM);
  CAPTURE(int(vertices));
  const auto check = [](Sampled_surface s, double tolerance, const auto& map) {
    s.add_noise(5e-5);
    const auto m = map(s);
    const Curvature_errors errors = errors_of_fit(s, m, tolerance);
    check_errors(errors_of_quadrics(s), errors, errors, 2, 2);
  };
  check(superquadric({3, 2, 1}, 2, 4, vertices), 1e-4,
        [](const auto& s) { return SM::map_to_sphere(s.points, s.faces, mapping); });
  check(torus(2, .8, 36, vertices), 1e-4,
        [](const auto& s) { return SM::map_to_torus(s.points, s.faces, mapping); });
  check(paraboloid(1, 30, vertices), 3e-4,
        [](const auto& s) { return SM::map_to_plane(s.points, s.faces, mapping); });
}

} // namespace test_curvatures_of_meshes
