#include "fit_files.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>

#include <filesystem>

namespace tools {

namespace {

// The files of a body, in the folder or in one of its own.
std::vector<std::string> files_of_body(const Fit_request& request)
{
  std::vector<std::string> names = {"map.ply", "surface.json", "surface.ply", "metrics.json"};
  if (has_report) names.push_back("report.html");
  if (request.samples > 0) names.push_back("samples.csv");
  return names;
}

} // namespace

Json parameters_of(const Job& job)
{
  Json p = {{"method", job.options.get<std::string>("method")}};
  if (!is_paper(job.options)) {
    const SM::Map_options o = SM::map_options_for_fitting();
    p.update({{"energy", "amips"}, {"lambda", o.lambda}, {"area_floor", o.area_floor}});
  }
  p["position"] = job.options.get<std::string>("position");
  p.update({{"surface", job.request.is_patches ? "patches" : "hierarchical"},
            {"tolerance", job.request.average},
            {"max_tolerance", job.request.maximum},
            {"degree", job.request.degree},
            {"bump", "smoothstep"},
            {"bump_smoothness", job.request.smoothness},
            {"samples", job.request.samples}});
  return p;
}

void require_cad_output(const Command_line& options)
{
  if (!options.has("cad")) return;
  require_not_demo("bodies for CAD systems");
  const std::string file = options.get<std::string>("cad");
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".step" && extension != ".stp") throw Usage_error("--cad writes a .step or .stp file");
  require_not_input(options, file);
  SM::Atomic_folder folder(options.get<std::string>("output")); // neither leaves a trace
  SM::Atomic_file trial(folder.file_elsewhere(file));
}

void require_outputs(const Command_line& options, const Fit_request& request, std::size_t parts)
{
  const std::filesystem::path folder = options.get<std::string>("output");
  SM::Atomic_folder trial(folder.string()); // leaves no trace
  const auto require = [&](const std::string& name) {
    trial.file(name);
    require_not_input(options, (folder / name).string());
  };
  for (const std::string& name : files_of_body(request)) require(name);
  if (parts == 1) return;
  const std::string input = std::filesystem::path(options.get<std::string>("input")).filename().string();
  for (std::size_t k = 0; k < parts; ++k)
    for (const std::string& name : files_of_body(request))
      if (name == "map.ply" || name == input) require(folder_of_part(k) + '/' + name);
}

} // namespace tools
