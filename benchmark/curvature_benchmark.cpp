// The table of curvatures in the manual: errors of mean curvature, Gaussian curvature and principal directions of fits
// and of local quadrics, on meshes of surfaces that are known. CSV; errors of curvatures in percent of the larger
// principal one, of directions in degrees.
//
//   curvature_benchmark [--quick] [NOISE, fraction of the diagonal]

#include "../test/embedding/curvature_samples.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace curvature_samples;

namespace {

void add_row(const std::string& name, const Sampled_surface& s, const std::string& method,
             std::size_t controls, const Curvature_errors& e)
{
  std::cout << name << ',' << s.points.size() << ',' << method << ',' << controls;
  for (const auto& [errors, unit] : {std::pair(&e.mean, 100.), std::pair(&e.gaussian, 100.),
                                     std::pair(&e.direction, 180 / 3.14159265358979324)})
    for (const double part : {0.5, 0.95}) std::cout << ',' << share(*errors, part) * unit;
  std::cout << std::endl;
}

template <class Map>
void measure(const std::string& name, const Sampled_surface& s, const Map& map,
             const std::vector<const char*>& tolerances)
{
  add_row(name, s, "quadric", 0, errors_of_quadrics(s));
  for (const char* tolerance : tolerances) {
    SM::Fit_report report;
    const auto surface =
      SM::fit_surface(map, SM::parameters::rms_error(std::atof(tolerance)).fit_report(std::ref(report)));
    add_row(name, s, tolerance, report.controls,
            curvature_errors(s, [&](int v) { return surface.jet(map.domain_point(v)); }));
  }
}

} // namespace

int main(int argc, char** argv)
{
  const bool is_quick = argc > 1 && argv[1] == std::string("--quick");
  const double noise = argc > 1 + is_quick ? std::atof(argv[1 + is_quick]) : 0;
  const std::vector<const char*> tolerances =
    is_quick ? std::vector<const char*>{"1e-3"} : std::vector<const char*>{"2e-4", "5e-5", "1e-5"};
  const int levels = is_quick ? 3 : 4, grid = is_quick ? 12 : 40, ring = is_quick ? 20 : 50;
  const auto mapping = SM::parameters::map_options(SM::map_options_for_fitting());
  std::cout
    << "surface,vertices,method,controls,H median,H 95 %,K median,K 95 %,directions median,directions 95 %\n";
  for (const auto& [name, vertices] :
       {std::pair("uniform", Vertices::UNIFORM), std::pair("graded", Vertices::GRADED),
        std::pair("random", Vertices::RANDOM)}) {
    const auto noisy = [&](Sampled_surface s) {
      if (noise > 0) s.add_noise(noise);
      return s;
    };
    const auto named = [&](const char* surface) { return std::string(surface) + ' ' + name; };
    const auto ball = [&](const char* surface, const Sampled_surface& s) {
      measure(named(surface), s, SM::map_to_sphere(s.points, s.faces, mapping), tolerances);
    };
    const auto patch = [&](const char* surface, const Sampled_surface& s) {
      measure(named(surface), s, SM::map_to_plane(s.points, s.faces, mapping), tolerances);
    };
    ball("ellipsoid", noisy(superquadric({3, 2, 1}, 2, levels, vertices)));
    ball("superquadric", noisy(superquadric({1, 1, 1}, 4, levels, vertices)));
    const Sampled_surface s = noisy(torus(2, .8, ring, vertices));
    measure(named("torus"), s, SM::map_to_torus(s.points, s.faces, mapping), tolerances);
    patch("paraboloid", noisy(paraboloid(1, grid, vertices)));
    patch("saddle", noisy(paraboloid(-1, grid, vertices)));
    patch("enneper", noisy(enneper(grid, vertices)));
  }
}
