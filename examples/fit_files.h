// The files that fit_mesh writes.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIT_FILES_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIT_FILES_H

#include "fit_figures.h"
#include "fit_request.h"
#include "parts.h"
#include "program_tools.h"
#include "written_distances.h"

#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/component_surfaces_io.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/embedding/Fit_confidence.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tools {

/// What all steps of a run of the program need.
struct Job {
  const Command_line& options;
  const Fit_request& request;
  const Input& input;
  const std::vector<Json>& partitions; // how the paper's method made the maps
  SM::Atomic_folder& folder;
  Progress& progress;
  Stopwatch& watch;
  std::vector<const SM::Cad_surface*> cad; // of each map what is written for CAD systems; null: nothing
};

/// What was fitted to the maps: the surfaces, and of each the report, its metrics, and what is said of its errors.
template <class AnySurface>
struct Fits {
  std::vector<SM::Component<AnySurface>> surfaces;
  std::vector<SM::Fit_report> reports;
  std::vector<Json> metrics;
  std::vector<std::string> errors;
};

/// What the metrics say of the options, whatever is fitted.
Json parameters_of(const Job& job);

/// The folder of a body among several.
inline std::string folder_of_part(std::size_t k) { return "part-" + std::to_string(k + 1); }

/// Found out before the work: the files can be written, and none of them takes the place of INPUT.
/// \throw Usage_error, SM::IO_error
void require_outputs(const Command_line& options, const Fit_request& request, std::size_t parts);

/// The same of the file of --cad, if there is one.
/// \throw Usage_error, SM::IO_error
void require_cad_output(const Command_line& options);

/// The field `confidence` at points of a surface; none for stacks of patches, which have no cells.
template <class Surface>
std::vector<SM::Charted_mesh::Field>
confidence_fields([[maybe_unused]] const SM::Fit_confidence& confidence,
                  [[maybe_unused]] const Surface& surface,
                  [[maybe_unused]] const std::vector<typename Surface::Domain_point>& points)
{
  std::vector<SM::Charted_mesh::Field> fields;
  if constexpr (std::is_same_v<typename Surface::Chart_embedding, SM::Hierarchical_embedding>) {
    fields.push_back({"confidence", {}});
    for (const auto& p : points) fields.back().values.push_back(confidence(surface, p));
  }
  return fields;
}

/// Writes the files of a body, those of several each in its folder. `least` is the number of vertices that the
/// tessellation has at least, roughly. Returns the metrics and the tessellation.
template <class Map, class Surface>
std::pair<Json, SM::Charted_mesh> write_body(Job& job, const Map& map, const Surface& surface,
                                             const SM::Fit_report& report, const SM::Cad_surface* cad,
                                             Json metrics, const std::string& folder, double least)
{
  const auto file = [&](const char* name) { return job.folder.file(folder + name); };
  // The grid it starts from has a quarter as many vertices as the mesh, roughly; then no face is farther from the
  // surface than half the tolerance.
  const int subdivisions = SM::Tile_grid<typename Map::Atlas>::subdivisions_for(
    std::clamp(double(map.number_of_vertices()) / 4, least, 50000.), map.atlas());
  const double chord_error = job.request.average / 2;
  metrics["parameters"].update({{"subdivisions", subdivisions}, {"chord_error", chord_error}});
  const SM::Mesh_properties properties = SM::map_properties(map, job.input.read.properties);
  const SM::Fit_confidence confidence(map, crease_angle_of(job.request));
  SM::Tessellation_report tessellated;
  SM::Charted_mesh tessellation = job.watch.time("tessellate", [&] {
    SM::Charted_mesh mesh = SM::charted_tessellation(surface, map,
                                                     SM::parameters::subdivisions(subdivisions)
                                                       .chord_error(chord_error)
                                                       .tessellation_report(std::ref(tessellated))
                                                       .mesh_properties(std::cref(properties)));
    std::vector<typename Map::Domain_point> points;
    for (const SM::Chart_point& p : mesh.chart_points) points.push_back(map.atlas().point(p));
    for (SM::Charted_mesh::Field& field : confidence_fields(confidence, surface, points))
      mesh.fields.push_back(std::move(field));
    SM::write_ply(file("surface.ply"), mesh);
    return mesh;
  });
  metrics["written"] = job.watch.time("distances", [&] { return written_distances(map, tessellation); });
  metrics["written"]["chord_error"] = number(tessellated.worst * chord_error);
  metrics["written"]["within_tolerance"] =
    is_within_tolerance(job.request, report, metrics["written"], chord_error);
  job.watch.time("write", [&] {
    SM::write_map(
      file("map.ply"), map,
      SM::parameters::repair_report(std::cref(job.input.repair)).mesh_properties(std::cref(properties)));
    SM::write_surface(file("surface.json"), surface, SM::parameters::rms_error(job.request.average));
    if (job.request.samples > 0) {
      const auto points = SM::random_domain_points(job.request.samples, 0, map.atlas());
      SM::write_samples(file("samples.csv"), surface, points, confidence_fields(confidence, surface, points));
    }
  });
  if (has_report)
    job.watch.time("report", [&] {
      write_page(file("report.html"), completed(metrics, "fit_mesh", job.watch), map, surface, report, cad);
    });
  metrics = completed(std::move(metrics), "fit_mesh", job.watch);
  write_metrics(file("metrics.json"), metrics);
  return {std::move(metrics), std::move(tessellation)};
}

/// Writes all files, and says what came of the fit.
template <class AnySurface>
int write_fits(Job& job, const Parts& maps, Fits<AnySurface> fits, const Json& parameters)
{
  const bool is_quiet = job.options.get<bool>("quiet"), is_one = maps.size() == 1;
  const double least =
    (std::max)(6000. / double(maps.size()), 600.); // so that of hundreds of bodies it is not huge
  std::vector<Json> metrics(maps.size());
  std::vector<char> written_is_within_tolerance(maps.size(), 1);
  std::vector<SM::Charted_mesh> tessellations;
  std::vector<std::string> names;
  for_each_part(fits.surfaces, [&](const auto& part, std::size_t k) {
    visit_both(maps[k].value(), part.value(), [&](const auto& map, const auto& surface) {
      Json own;
      own["input"] = metrics_of_input(job.input, part, map);
      if (!job.input.reshape.is_null()) own["reshape"] = job.input.reshape;
      own["repair"] = metrics_of_repair(job.input.repair);
      own["map"] = metrics_of_map(map, job.watch);
      if (!job.partitions.empty()) own["partition"] = job.partitions[k];
      own["surface"] = fits.metrics[k];
      own["surface"]["smoothness"] = surface.smoothness();
      own["parameters"] = parameters;
      auto [all, tessellation] = write_body(job, map, surface, fits.reports[k], job.cad[k], std::move(own),
                                            is_one ? std::string() : folder_of_part(k) + '/', least);
      written_is_within_tolerance[k] = all["written"]["within_tolerance"] == true;
      metrics[k] = std::move(all);
      tessellations.push_back(std::move(tessellation));
      names.push_back(part.name);
    });
  });
  report_errors("fit_mesh", fits.surfaces, job.input);
  Json shown = metrics[0];
  if (!is_one) {
    shown = metrics_of_parts(job.input, fits.surfaces, std::move(metrics));
    shown["parameters"] = parameters;
    for (std::size_t k = 0; k < maps.size(); ++k)
      if (fits.surfaces[k].has_value()) shown["parts"][k]["folder"] = folder_of_part(k);
    job.watch.time("write", [&] {
      SM::write_surfaces(job.folder.file("surface.json"), fits.surfaces,
                         SM::parameters::rms_error(job.request.average));
      SM::write_ply(job.folder.file("surface.ply"), SM::joined(std::move(tessellations), names));
    });
    if (has_report)
      job.watch.time("report", [&] {
        write_page(job.folder.file("report.html"), completed(shown, "fit_mesh", job.watch), maps,
                   fits.surfaces, fits.reports, job.cad);
      });
    shown = completed(std::move(shown), "fit_mesh", job.watch);
    write_metrics(job.folder.file("metrics.json"), shown);
  }
  throw_if_interrupted();
  job.folder.commit();

  if (!has_report && !is_quiet)
    say("fit_mesh", "no report.html: zlib or three.js was missing when fit_mesh was built");
  if (!is_quiet) std::cout << figures(shown) << std::flush;
  int status = SM::number_of_values(fits.surfaces) == maps.size() ? SUCCESS : PARTLY_SERVED;
  std::vector<Part_message> not_reached;
  const auto say_not_reached = [&](std::size_t k, const std::string& what) {
    not_reached.push_back({is_one ? "" : maps[k].name, what + "; the files are written"});
  };
  for (std::size_t k = 0; k < maps.size(); ++k)
    if (fits.surfaces[k].has_value()) {
      const SM::Fit_report& report = fits.reports[k];
      if (!fits.metrics[k]["tolerance_reached"])
        say_not_reached(k, "the tolerance was not reached: " + fits.errors[k]);
      else if (!written_is_within_tolerance[k])
        say_not_reached(k, "surface.ply is farther from the mesh than the tolerance");
      if (report.folds > 0) say_not_reached(k, folds_sentence(report));
    }
  say_of_parts("fit_mesh", not_reached);
  if (!not_reached.empty()) status = TOLERANCE_NOT_REACHED;
  return status;
}

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIT_FILES_H
