// Maps a mesh onto the canonical surface of its genus, fits a smooth surface to it and writes both, a
// tessellation, figures and samples into a folder.

#include "cad_export.h"
#include "fit_files.h"
#include "fit_request.h"
#include "parts.h"
#include "program_tools.h"
#include "reshape.h"
#include "square_corners.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>
#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace tools;

namespace {

Json parameters_of(const Job& job)
{
  Json p = {{"method", job.options.get<std::string>("method")}};
  if (!is_paper(job.options)) {
    const SM::Map_options o = SM::map_options_for_fitting();
    p.update({{"energy", "amips"}, {"lambda", o.lambda}, {"area_floor", o.area_floor}});
  }
  p.update({{"surface", job.request.is_patches ? "patches" : "hierarchical"},
            {"tolerance", job.request.average},
            {"max_tolerance", job.request.maximum},
            {"degree", job.request.degree},
            {"bump", "smoothstep"},
            {"bump_smoothness", job.request.smoothness},
            {"samples", job.request.samples}});
  return p;
}

template <class Bump>
int fit_hierarchical(Job& job, Parts maps, const Bump& bump)
{
  const Fit_request& request = job.request;
  Fits<SM::Any_surface<Bump>> fits;
  std::vector<std::optional<Parts::value_type::Value>> moved;
  const auto fit = [&] {
    fits.surfaces = job.watch.time("fit", [&] {
      return SM::fit_components<CGAL::Parallel_if_available_tag>(
        maps, SM::parameters::rms_error(request.average)
                .max_error(request.maximum)
                .bump(bump)
                .spline_degree(request.degree)
                .max_controls(std::size_t(request.controls))
                .marking(request.marking)
                .joint_solve(request.joint)
                .fairness(request.fairness)
                .fit_target(request.target)
                .crease_angle(request.crease_angle)
                .fit_effort(request.effort)
                .fit_reports(std::ref(fits.reports))
                .fitted_maps(std::ref(moved))
                .visitor(std::ref(job.progress)));
    });
    for (std::size_t k = 0; k < maps.size(); ++k)
      if (moved[k]) maps[k].value() = std::move(*moved[k]);
  };
  fit();
  if (job.options.get<bool>("correct-parameters")) {
    job.watch.time("correct", [&] {
      for_each_part(maps, [&](auto& part, std::size_t k) {
        if (!fits.surfaces[k].has_value()) return;
        std::optional<Parts::value_type::Value> corrected;
        visit_both(part.value(), fits.surfaces[k].value(), [&](const auto& map, const auto& surface) {
          corrected.emplace(SM::correct_parameters(map, surface));
        });
        part.value() = std::move(*corrected);
      });
    });
    fit();
  }

  Json parameters = parameters_of(job);
  parameters.update({{"max_controls", request.controls},
                     {"fairness", request.fairness},
                     {"noise", request.noise},
                     {"target", job.options.get<std::string>("target")},
                     {"crease_angle", request.crease_angle},
                     {"fit_effort", job.options.get<std::string>("fit-effort")},
                     {"marking", job.options.get<std::string>("marking")},
                     {"economy", job.options.get<bool>("economy")},
                     {"correct_parameters", job.options.get<bool>("correct-parameters")}});
  const bool only_vertices = request.marking == SM::Marking::VERTICES;
  std::vector<Part_message> messages;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const SM::Fit_report& report = fits.reports[k];
    if (report.has_more_controls_than_vertices() && !job.options.get<bool>("quiet"))
      messages.push_back({maps.size() == 1 ? "" : maps[k].name,
                          std::to_string(report.controls) + " controls for a mesh of " +
                            std::to_string(report.vertices) +
                            " vertices: the surface reproduces facets; a larger tolerance" +
                            (only_vertices ? " needs fewer" : " or --marking vertices needs fewer")});
    fits.metrics.push_back(metrics_of_surface(report));
    fits.errors.push_back(std::string(only_vertices ? "at vertices " : "") + "rms error " +
                          shown(only_vertices ? report.vertex_rms_error : report.rms_error) + " (tolerance " +
                          shown(request.average) + "), max " +
                          shown(only_vertices ? report.vertex_max_error : report.max_error) + " (tolerance " +
                          shown(request.maximum) + ") of the diagonal, " + std::to_string(report.controls) +
                          " controls" + reason(report));
  }
  say_of_parts("fit_mesh", messages);
  return write_fits(job, maps, std::move(fits), parameters);
}

int fit_patches(Job& job, const Parts& maps)
{
  const Fit_request& request = job.request;
  using Any_stack = SM::Any_surface<SM::Smoothstep_bump<2>, SM::Patch_stack_embedding>;
  Fits<Any_stack> fits;
  for (const auto& part : maps) {
    SM::Patch_fit_report report;
    std::variant<Any_stack, SM::Error> result(std::in_place_index<1>, SM::Error_code::numeric_failure, "");
    try {
      if (!part.has_value()) throw SM::Error(part.error());
      result = std::visit(
        [&](const auto& map) -> Any_stack {
          return job.watch.time("fit", [&] {
            return SM::fit_patch_surface<CGAL::Parallel_if_available_tag>(
              map, SM::parameters::average_delta(request.average)
                     .max_delta(request.maximum)
                     .spline_degree(request.degree)
                     .max_patches(request.patches)
                     .patch_fit_report(std::ref(report))
                     .visitor(std::ref(job.progress)));
          });
        },
        part.value());
    } catch (const SM::Error& e) {
      result = SM::Error(e);
    }
    fits.surfaces.emplace_back(part, std::move(result));
    Json metrics = metrics_of_surface(report.surface);
    double average = 0, maximum = 0;
    for (std::size_t c = 0; c < report.charts.size(); ++c) {
      const SM::Patch_fit_report::Chart& chart = report.charts[c];
      metrics["charts"][c].update({{"patches", chart.patches},
                                   {"bins_per_side", chart.bins_per_side},
                                   {"has_fewer_bins", chart.has_fewer_bins},
                                   {"average_delta", chart.average_delta},
                                   {"max_delta", chart.max_delta},
                                   {"tolerance_reached", chart.tolerance_reached}});
      average = (std::max)(average, chart.average_delta);
      maximum = (std::max)(maximum, chart.max_delta);
    }
    fits.metrics.push_back(std::move(metrics));
    fits.reports.push_back(report.surface);
    fits.errors.push_back("weighted error of a chart at vertices " + shown(average) +
                          " on average (tolerance " + shown(request.average) + "), max " + shown(maximum) +
                          " (tolerance " + shown(request.maximum) + "), rms error " +
                          shown(report.surface.rms_error) + " of the diagonal, " +
                          std::to_string(report.surface.controls) + " controls");
  }
  Json parameters = parameters_of(job);
  parameters["max_patches"] = request.patches;
  return write_fits(job, maps, std::move(fits), parameters);
}

// Fits a body to a map.
template <class Map>
void add_fitted_part(const Map& map, const std::string& name, const Fit_request& request, Progress& progress,
                     Cad_parts& parts)
{
  SM::Cad_report report;
  SM::Cad_surface surface =
    SM::fit_cad_surface<CGAL::Parallel_if_available_tag>(map, SM::parameters::rms_error(request.average)
                                                                .max_error(request.maximum)
                                                                .cad_report(std::ref(report))
                                                                .visitor(std::ref(progress)));
  parts.add(name, std::move(surface), std::move(report));
}

// Fits the bodies for CAD systems to the maps, says which cannot be served, and writes them: they appear with the folder.
Cad_parts fit_cad(Job& job, const Parts& maps)
{
  Cad_parts parts;
  const std::string stem = std::filesystem::path(job.options.get<std::string>("cad")).stem().string();
  std::vector<std::size_t> maps_of_bodies;
  std::vector<Part_message> messages;
  job.watch.time("cad", [&] {
    for (std::size_t k = 0; k < maps.size(); ++k) {
      const auto& part = maps[k];
      if (!part.has_value()) continue;
      const std::string name = maps.size() == 1 ? stem : stem + ' ' + part.name;
      try {
        std::visit([&](const auto& map) { add_fitted_part(map, name, job.request, job.progress, parts); },
                   part.value());
        maps_of_bodies.push_back(k);
      } catch (const SM::Error& e) {
        messages.push_back({maps.size() == 1 ? "" : part.name, std::string("no CAD body: ") + e.what()});
      }
    }
  });
  say_of_parts("fit_mesh", messages);
  if (!parts.bodies.empty())
    SM::write_step(job.folder.file_elsewhere(job.options.get<std::string>("cad")), parts.bodies);
  for (std::size_t k = 0; k < parts.bodies.size(); ++k)
    job.cad[maps_of_bodies[k]] = &parts.bodies[k].surface; // where it stays when the vector is moved
  return parts;
}

// Says what became of them. Returns the status.
int say_cad(const Job& job, const Cad_parts& parts, std::size_t wanted)
{
  if (parts.bodies.empty()) return PARTLY_SERVED;
  if (!job.options.get<bool>("quiet"))
    std::cout << cad_figures(job.options.get<std::string>("cad"), parts) << std::flush;
  int status = parts.bodies.size() == wanted ? SUCCESS : PARTLY_SERVED;
  std::vector<Part_message> messages;
  for (std::size_t k = 0; k < parts.bodies.size(); ++k) {
    if (!parts.reports[k].tolerance_reached) status = TOLERANCE_NOT_REACHED;
    for (const std::string& warning : cad_warnings(parts.reports[k], job.request.average, SM::Step_options()))
      messages.push_back({parts.bodies[k].name, warning});
  }
  say_of_parts("fit_mesh", messages);
  return status;
}

int fit(Job& job, Parts maps)
{
  if (job.request.is_patches) return fit_patches(job, maps);
  if (job.request.smoothness == 2) // the fastest
    return fit_hierarchical(job, std::move(maps), SM::Smoothstep_bump<2>());
  return fit_hierarchical(job, std::move(maps), SM::Any_smoothstep_bump(job.request.smoothness));
}

} // namespace

int main(int argc, char** argv)
{
  return run("fit_mesh", [&]() -> int {
    Command_line options = fit_command_line();
    options.parse(argc, argv);
    const Fit_request request = fit_request(options);
    const std::size_t asked = asked_parts(options);
    require_outputs(options, request, 1);
    if (options.has("cad")) {
      const std::string extension =
        std::filesystem::path(options.get<std::string>("cad")).extension().string();
      if (extension != ".step" && extension != ".stp") throw Usage_error("--cad writes a .step or .stp file");
      require_not_input(options, options.get<std::string>("cad"));
      SM::Atomic_folder trial(options.get<std::string>("output")); // neither leaves a trace
      SM::Atomic_file file(trial.file_elsewhere(options.get<std::string>("cad")));
    }

    Stopwatch watch;
    Input input = watch.time("read", [&] { return read_input(options); });
    watch.time("reshape", [&] { reshape(request, options, input); });
    const std::vector<Mesh::Vertex_index> square_corners = corners(options, input);
    require_outputs(options, request, (std::min)(asked, input.topology.components));
    SM::Atomic_folder folder(options.get<std::string>("output"));
    Progress progress(options.get<bool>("quiet"));
    std::vector<Json> partitions;
    Parts maps = watch.time("map", [&] {
      return map_parts(options, input, SM::map_options_for_fitting(), square_corners, partitions, progress);
    });
    if (SM::number_of_values(maps) == 0) report_errors("fit_mesh", maps, input); // throws
    Job job{options, request,  input, partitions,
            folder,  progress, watch, std::vector<const SM::Cad_surface*>(maps.size())};
    if (!options.has("cad")) return fit(job, std::move(maps));
    const Cad_parts cad = fit_cad(job, maps);
    const std::size_t wanted = maps.size();
    const int status = fit(job, std::move(maps));
    return (std::max)(status, say_cad(job, cad, wanted));
  });
}
