// The steps of ../tutorial.py in C++: tutorial MESH FOLDER. Prints the same lines and writes the same files.

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

int main(int argc, char** argv)
{
  if (argc != 3) return 2;
  const std::string folder = argv[2];
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  SM::read_mesh(argv[1], mesh);
  for (const SM::Inspected_component& c : SM::inspect_mesh(mesh).components)
    std::printf("%s: %zu faces, %s\n", c.name.c_str(), c.faces, c.sentence().c_str());

  const auto map = SM::map_to_sphere(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
  std::printf("domain sphere\nsymmetric dirichlet %.17g\n",
              SM::distortion<SM::Sphere_atlas>(map).symmetric_dirichlet);
  const std::vector<Eigen::Vector3d> places = SM::random_domain_points<SM::Sphere_atlas>(1000);

  SM::Fit_report report;
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3).fit_report(std::ref(report)));
  std::printf("controls %zu\nrms error %.17g\nmax error %.17g\n", report.controls, report.rms_error,
              report.max_error);

  std::vector<SM::Jet> jets;
  surface.jets(places, std::back_inserter(jets));
  std::vector<Eigen::Vector3d> points;
  surface.points(places, std::back_inserter(points));
  const SM::Closest_point_finder<std::decay_t<decltype(surface)>> finder(surface);
  const double infinity = std::numeric_limits<double>::infinity();
  double mean = -infinity, gaussian = infinity, distance = -infinity;
  for (std::size_t i = 0; i < jets.size(); ++i) {
    mean = (std::max)(mean, SM::mean_curvature(jets[i]));
    gaussian = (std::min)(gaussian, SM::gaussian_curvature(jets[i]));
    const Eigen::Vector3d x = points[i] + 1e-3 * map.diagonal() * SM::normal(jets[i]);
    distance = (std::max)(distance, finder(x).signed_distance);
  }
  std::printf("largest mean curvature %.17g\nleast gaussian curvature %.17g\nlargest distance %.17g\n", mean,
              gaussian, distance);

  const SM::Charted_mesh tessellation = SM::charted_tessellation(surface, SM::parameters::chord_error(1e-3));
  std::printf("triangles %zu\n", tessellation.triangles.size());
  SM::write_gltf(folder + "/surface.glb", tessellation);
  SM::write_surface(folder + "/surface.json", surface, SM::parameters::rms_error(1e-3));
  SM::Cad_report cad;
  const SM::Cad_surface body = SM::cad_surface(surface, SM::parameters::cad_report(std::ref(cad)));
  std::printf("CAD faces %zu controls %zu\n", cad.faces, cad.controls);
  SM::write_step(folder + "/surface.step", body);
}
