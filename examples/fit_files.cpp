#include "fit_files.h"

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
