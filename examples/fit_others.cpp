// What fit_mesh fits on demand: other smoothness, and the patches of the paper.

#include "fit_hierarchical.h"

#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tools {

int fit_smooth(Job& job, Parts maps)
{
  return fit_hierarchical(job, std::move(maps), SM::Any_smoothstep_bump(job.request.smoothness));
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

} // namespace tools
