// A bump function of one's own blends the charts: here the infinitely smooth exp(4 - 1/(x (1-x))).

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// A model of `BumpFunction`: positive in (0,1), zero outside, with its first two derivatives.
//! [bump]
struct Exponential_bump {
  static constexpr int smoothness = 99; // of all orders
  static constexpr const char* type = "exponential";

  double operator()(double x) const { return jet(x)[0]; }

  std::array<double, 3> jet(double x) const
  {
    const double q = x * (1 - x), d = 1 - 2 * x;
    if (!(q > 1e-3)) return {0, 0, 0};                     // below the smallest double
    const double f = std::exp(4 - 1 / q), g = d / (q * q); // f' = g f
    return {f, f * g, f * (g * g - 2 / (q * q) - 2 * d * d / (q * q * q))};
  }
};
//! [bump]

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/icosahedron.off"), mesh);
    const auto map = SM::map_to_sphere(mesh);
    SM::Fit_report report;
    //! [use]
    const auto surface = SM::fit_surface(
      map, SM::parameters::bump(Exponential_bump()).spline_degree(5).fit_report(std::ref(report)));
    //! [use]
    std::cout << "rms error " << report.rms_error << " of the diagonal, the surface is C^"
              << surface.smoothness() << '\n';
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
