// The paper's method beside the default, on every mesh of a folder that has a canonical surface, as CSV:
// success or the step that fails, time, the paper's four criteria, distortion. See README.md in this folder.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// Runs map() and prints its row.
template <class Make_map, class Details>
void row(const std::string& name, const Mesh& mesh, const char* method, const Make_map& make_map,
         const Details& details)
{
  const auto start = std::chrono::steady_clock::now();
  std::cout << name << ',' << num_faces(mesh) << ',' << method << ',';
  try {
    const auto any = make_map();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::visit(
      [&](const auto& map) {
        const SM::Criteria_report c = SM::criteria_report(map);
        const SM::Distortion d = SM::distortion(map);
        std::cout << "ok," << std::decay_t<decltype(map)>::Atlas::name << ',' << seconds;
        for (const double x : {c.largest_deviation, double(c.charts.stars_without_chart),
                               double(c.vertices_outside), c.convex_share(), d.angle_mean,
                               d.area_mean_abs_log10, d.symmetric_dirichlet, d.smallest_domain_area})
          std::cout << ',' << x;
      },
      any);
  } catch (const SM::Partition_error& e) {
    std::cout << SM::Partition_error::name(e.step()) << ",,,,,,,,,,";
  } catch (const SM::Numeric_error&) {
    std::cout << "numeric failure,,,,,,,,,,";
  }
  std::cout << ',' << details() << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string folder = argc > 1 ? argv[1] : std::string(SIMPLE_MANIFOLDS_CGAL_DATA) + "/meshes";
  const std::string only = argc > 2 ? argv[2] : ""; // a part of the file names
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off" &&
        entry.path().filename().string().find(only) != std::string::npos)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  std::cout << "mesh,faces,method,result,atlas,seconds,largest_deviation,stars_without_chart,"
               "vertices_outside,convex_share,angle,area,symmetric_dirichlet,smallest_domain_area,"
               "subdivisions,removed_vertices,rounds,stopped_by_rule\n";
  for (const auto& file : files) {
    Mesh mesh;
    SM::Mesh_topology topology;
    try {
      topology = SM::read_mesh(file.string(), mesh);
    } catch (const SM::Error&) {
      continue; // no surface
    }
    if (!topology.is_connected() || !(topology.is_disk() || (topology.is_closed() && topology.genus <= 1)))
      continue;
    const std::string name = file.stem().string();
    SM::Partition_report report;
    row(
      name, mesh, "paper",
      [&] { return SM::map_by_partition(mesh, SM::parameters::partition_report(std::ref(report))); },
      [&] {
        return std::to_string(report.subdivisions) + ',' + std::to_string(report.removed_vertices) + ',' +
               std::to_string(report.equalization.rounds) + ',' +
               (report.equalization.has_stopped_by_rule ? "yes" : "no");
      });
    row(
      name, mesh, "default", [&] { return SM::map_to_canonical_surface(mesh); }, [] { return ",,,"; });
  }
  return EXIT_SUCCESS;
}
