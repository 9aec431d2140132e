// Maps a mesh one to one onto the canonical surface of its genus and writes the map as a PLY file.

#include "inspect.h"
#include "program_tools.h"
#include "square_corners.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <functional>
#include <string>
#include <variant>
#include <vector>

using namespace tools;

namespace {

// The paper's four criteria of a good correspondence.
template <class Map>
Json metrics_of_criteria(const Map& map)
{
  const SM::Criteria_report r = SM::criteria_report(map);
  return {{"chart_variation", r.charts.variation},
          {"largest_deviation", r.largest_deviation},
          {"stars_without_chart", r.charts.stars_without_chart},
          {"vertices_outside_of_their_star", r.vertices_outside},
          {"convex_share", r.convex_share()}};
}

// Found out before the work: every file can be written, and none of them takes the place of another.
void require_outputs(const Command_line& options)
{
  std::vector<std::string> outputs;
  for (const char* name : {"output", "metrics", "report"}) {
    if (!options.has(name)) continue;
    const std::string file = options.get<std::string>(name);
    {
      const SM::Atomic_file attempt(file);
    } // throws, or leaves no trace
    require_not_input(options, file);
    for (const std::string& other : outputs)
      if (is_same_file(file, other))
        throw Usage_error(std::string("--") + name + ": another result is written to " + other);
    outputs.push_back(file);
  }
}

} // namespace

int main(int argc, char** argv)
{
  return run("map_mesh", [&]() -> int {
    Command_line options(
      "map_mesh INPUT -o OUT.ply [options], or map_mesh INPUT --inspect [--json]",
      "Maps a mesh (OFF, OBJ, PLY, STL; closed of genus 0 or 1, or a disk) one to one onto the unit sphere,\n"
      "the flat torus or the unit square, and writes the map.\n"
      "Exit status: 0 success, 2 usage, or the file cannot be written, 3 unreadable input, 4 unsupported\n"
      "topology or geometry, or too little memory, 129, 130 or 143 ended by SIGHUP,\n"
      "ctrl-C or kill.");
    options.add("energy", po::value<std::string>()->default_value("symmetric_dirichlet"),
                "the distortion to minimise: symmetric_dirichlet, amips");
    options.add("lambda", po::value<double>()->default_value(SM::Map_options().lambda, "0.3"),
                "weight of area against angle in amips");
    options.add("area-floor", po::value<double>()->default_value(SM::Map_options().area_floor, "0.05"),
                "share of uniform area in the target areas, above 0, at most 1");
    options.add("effort", po::value<std::string>()->default_value("default"),
                "how long the map is relaxed: fast, default, quality");
    options.add("balance", po::bool_switch(), "give the charts equal numbers of vertices");
    options.add("refine", po::bool_switch(), "split edges so that every star lies in a chart");
    options.add("metrics", po::value<std::string>(), "also write figures to this JSON file");
    options.add("report", po::value<std::string>(), "also write a page that shows the map in a browser");
    add_inspect_options(options);
    options.parse(argc, argv);
    options.require_choice("energy", {"symmetric_dirichlet", "amips"});
    const double lambda = options.get<double>("lambda");
    options.require(lambda > 0 && std::isfinite(lambda), "lambda", "a positive number");
    const double area_floor = options.get<double>("area-floor");
    options.require(area_floor > 0 && area_floor <= 1, "area-floor", "above 0 and at most 1");
    options.require_choice("effort", {"fast", "default", "quality"});
    const std::string effort = options.get<std::string>("effort");
    const bool is_amips = options.get<std::string>("energy") == "amips";
    if (options.has("report") && !has_report)
      throw Usage_error("--report needs zlib and three.js, which were missing when map_mesh was built");
    if (is_inspection(options)) return inspect(options);
    const bool is_quiet = options.get<bool>("quiet");
    require_outputs(options);

    Stopwatch watch;
    const Input input = watch.time("read", [&] { return read_input(options); });
    const std::vector<Mesh::Vertex_index> square_corners = corners(options, input);
    Progress progress(is_quiet);
    Json partition; // how the paper's method made the map
    SM::Any_mesh_map<Mesh> any_map = watch.time("map", [&] {
      if (is_paper(options)) return map_by_partition(options, input, partition, progress);
      return SM::map_to_canonical_surface<CGAL::Parallel_if_available_tag>(
        input.mesh, SM::parameters::energy(is_amips ? SM::Energy::AMIPS : SM::Energy::SYMMETRIC_DIRICHLET)
                      .energy_lambda(lambda)
                      .area_floor(area_floor)
                      .effort(effort == "fast"      ? SM::Effort::FAST
                              : effort == "quality" ? SM::Effort::QUALITY
                                                    : SM::Effort::DEFAULT)
                      .close_borders(close_borders(options))
                      .corners(square_corners)
                      .visitor(std::ref(progress)));
    });
    const auto np = CGAL::parameters::visitor(std::ref(progress));
    const auto improve = [&](const char* phase, const auto& f) { // f: a map to a map of the same surface
      if (options.get<bool>(phase))
        watch.time(phase, [&] { std::visit([&](auto& map) { map = f(map); }, any_map); });
    };
    improve("balance", [&](const auto& map) { return SM::balance(map, np); });
    improve("refine", [&](const auto& map) { return SM::refine(map, np); });

    return std::visit(
      [&](const auto& map) -> int {
        Json metrics;
        metrics["input"] = metrics_of_input(input, map);
        metrics["repair"] = metrics_of_repair(input.repair);
        metrics["map"] = metrics_of_map(map, watch);
        metrics["parameters"] = {{"method", options.get<std::string>("method")},
                                 {"energy", options.get<std::string>("energy")},
                                 {"lambda", lambda},
                                 {"area_floor", area_floor},
                                 {"effort", effort},
                                 {"balance", options.get<bool>("balance")},
                                 {"refine", options.get<bool>("refine")}};
        metrics["map"]["criteria"] = metrics_of_criteria(map);
        if (is_paper(options)) metrics["partition"] = partition;
        SM::Atomic_files files;
        const auto file = [&](const char* name) { return files.file(options.get<std::string>(name)); };
        if (options.has("report"))
          watch.time("report",
                     [&] { write_page(file("report"), completed(metrics, "map_mesh", watch), map); });
        watch.time("write", [&] {
          const SM::Mesh_properties properties = SM::map_properties(map, input.read.properties);
          SM::write_map(
            file("output"), map,
            SM::parameters::repair_report(std::cref(input.repair)).mesh_properties(std::cref(properties)));
        });
        metrics = completed(std::move(metrics), "map_mesh", watch);
        if (options.has("metrics")) write_metrics(file("metrics"), metrics);
        throw_if_interrupted();
        files.commit();
        if (!is_quiet) std::cout << figures(metrics) << std::flush;
        return SUCCESS;
      },
      any_map);
  });
}
