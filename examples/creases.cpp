// A part with sharp edges, fitted with and without creases: how near the surface is to the edges, and how flat its flat
// faces stay. Writes creases.ply, a tessellation with the confidence of its curvatures.

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/Fit_confidence.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <tuple>
#include <utility>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  try {
    Mesh mesh;
    SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"), mesh);
    const double angle = argc > 2 ? std::atof(argv[2]) : SM::Fit_options().crease_angle; // degrees
    const auto map = SM::map_to_sphere(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));

    auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
    PMP::detect_sharp_edges(mesh, angle, is_sharp);
    const auto is_on_edge = [&](Mesh::Vertex_index v) {
      for (const auto h : halfedges_around_target(v, mesh))
        if (is_sharp[mesh.edge(h)]) return true;
      return false;
    };

    //! [fit]
    const auto fit = [&](double crease_angle, SM::Fit_report& report) {
      return SM::fit_surface(
        map, SM::parameters::rms_error(1e-3).crease_angle(crease_angle).fit_report(std::ref(report)));
    };
    SM::Fit_report kept, rounded;
    const auto with_creases = fit(angle, kept), without = fit(180, rounded);
    //! [fit]

    // The largest distances from the vertices, on sharp edges and elsewhere, as fractions of the diagonal.
    const auto distances = [&](const auto& surface) {
      std::pair<double, double> largest(0, 0);
      for (const auto v : mesh.vertices()) {
        const Eigen::Vector3d x = surface.point(map.domain_point(v));
        const auto& y = mesh.point(v);
        const double d = (x - Eigen::Vector3d(y.x(), y.y(), y.z())).norm() / map.diagonal();
        double& l = is_on_edge(v) ? largest.first : largest.second;
        l = (std::max)(l, d);
      }
      return largest;
    };
    for (const auto& [name, report, d] : {std::tuple("creases kept", &kept, distances(with_creases)),
                                          std::tuple("no creases  ", &rounded, distances(without))})
      std::cout << name << ": " << report->controls << " controls, the target is " << report->target_max
                << " of the diagonal at most from the facets; the surface at most " << d.first
                << " from vertices of sharp edges, " << d.second << " from others\n";

    //! [confidence]
    const SM::Fit_confidence confidence(map, angle);
    SM::Charted_mesh fine = SM::charted_tessellation(with_creases, SM::parameters::chord_error(5e-4));
    SM::Charted_mesh::Field field{"confidence", {}};
    for (const SM::Chart_point& p : fine.chart_points)
      field.values.push_back(confidence(with_creases, map.atlas().point(p)));
    fine.fields.push_back(field);
    SM::write_ply("creases.ply", fine);
    //! [confidence]
    for (const double least : {1., 2., 4.})
      std::cout << std::count_if(field.values.begin(), field.values.end(),
                                 [&](double c) { return c >= least; })
                << " of " << fine.points.size() << " vertices in creases.ply are " << least
                << " or more cells from an edge\n";
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
