// The fits of fit_mesh: that of the default smoothness is made in fit_mesh.cpp, the others in fit_others.cpp.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIT_HIERARCHICAL_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIT_HIERARCHICAL_H

#include "fit_files.h"

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tools {

/// Fits with the smoothness that is asked for, and writes all files. Returns the status.
int fit_smooth(Job& job, Parts maps);

/// Fits patches as in the paper, and writes all files. Returns the status.
int fit_patches(Job& job, const Parts& maps);

/// Fits with a bump, and writes all files. Returns the status.
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

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIT_HIERARCHICAL_H
