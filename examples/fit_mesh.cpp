// Maps a mesh onto the canonical surface of its genus, fits a smooth surface to it and writes both, a
// tessellation, figures and samples into a folder.

#include "fit_cad.h"
#include "fit_hierarchical.h"
#include "fit_request.h"
#include "parts.h"
#include "program_tools.h"
#include "reshape.h"
#include "square_corners.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>

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

int fit(Job& job, Parts maps)
{
#ifndef SIMPLE_MANIFOLDS_DEMO
  if (job.request.is_patches) return fit_patches(job, maps);
  if (job.request.smoothness != 2) return fit_smooth(job, std::move(maps));
#endif
  return fit_hierarchical(job, std::move(maps), SM::Smoothstep_bump<2>()); // the fastest
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
    require_cad_output(options);

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
#ifndef SIMPLE_MANIFOLDS_DEMO
    if (options.has("cad")) return fit_with_cad(job, std::move(maps), fit);
#endif
    return fit(job, std::move(maps));
  });
}
