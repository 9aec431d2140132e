#include "fit_cad.h"

#include "cad_export.h"

#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tools {

namespace {

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

// Fits the bodies to the maps, says which cannot be served, and writes them: they appear with the folder.
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

} // namespace

int fit_with_cad(Job& job, Parts maps, int (*fit)(Job&, Parts))
{
  const Cad_parts cad = fit_cad(job, maps);
  const std::size_t wanted = maps.size();
  const int status = fit(job, std::move(maps));
  return (std::max)(status, say_cad(job, cad, wanted));
}

} // namespace tools
