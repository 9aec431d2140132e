// Maps a mesh one to one onto the canonical surface of its genus and writes the map as a PLY file.

#include "inspect.h"
#include "parts.h"
#include "program_tools.h"
#include "square_corners.h"

#include <CGAL/Simple_manifolds/IO/component_maps_io.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
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
void require_outputs(const Command_line& options, std::size_t maps)
{
  std::vector<std::string> named; // by an option; the numbered ones differ from each other
  const auto require = [&](const char* name, const std::string& file) {
    {
      const SM::Atomic_file attempt(file);
    } // throws, or leaves no trace
    require_not_input(options, file);
    for (const std::string& other : named)
      if (is_same_file(file, other))
        throw Usage_error(std::string("--") + name + ": another result is written to " + other);
  };
  for (const char* name : {"output", "metrics", "report"})
    if (options.has(name)) {
      require(name, options.get<std::string>(name));
      named.push_back(options.get<std::string>(name));
    }
  for (std::size_t k = 2; k <= maps; ++k)
    require("output", SM::numbered_file(options.get<std::string>("output"), k));
}

Json metrics_of_part(const Input& input, const Parts::value_type& part, Stopwatch& watch)
{
  return std::visit(
    [&](const auto& map) {
      Json metrics;
      metrics["input"] = metrics_of_input(input, part, map);
      metrics["repair"] = metrics_of_repair(input.repair);
      metrics["map"] = metrics_of_map(map, watch);
      metrics["map"]["criteria"] = metrics_of_criteria(map);
      return metrics;
    },
    part.value());
}

} // namespace

int main(int argc, char** argv)
{
  return run("map_mesh", [&]() -> int {
    Command_line options(
      "map_mesh INPUT -o OUT.ply [options], or map_mesh INPUT --inspect [--json]",
      "Maps a mesh (OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF, COLLADA, with assimp glTF; closed,\n"
      "or a disk) one to one onto the unit sphere, the flat torus, a surface of\n"
      "hyperbolic squares (genus 2 and more) or the unit square, and writes the map. Of several bodies each "
      "has its map: the "
      "largest\n"
      "in OUT.ply, the others in OUT.2.ply, OUT.3.ply, ...\n"
      "Exit status: 0 success, 1 some bodies could not be mapped (the others are written), 2 usage, or the\n"
      "file cannot be written, 3 unreadable input, 4 unsupported topology or geometry of all bodies, or too\n"
      "little memory, 129, 130 or 143 ended by SIGHUP, ctrl-C or kill. Above 1 no file is written.");
    options.add("energy", po::value<std::string>()->default_value("symmetric_dirichlet"),
                "the distortion to minimise: symmetric_dirichlet, amips");
    options.add("lambda", po::value<double>()->default_value(SM::Map_options().lambda, "0.3"),
                "weight of area against angle in amips");
    options.add("area-floor", po::value<double>()->default_value(SM::Map_options().area_floor, "0.05"),
                "share of uniform area in the target areas, above 0, at most 1");
    options.add("effort", po::value<std::string>()->default_value("default"),
                "how long the map is relaxed: fast, default, quality");
    add_position_option(options);
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
    position_frame(options); // which refuses other words
    const std::string effort = options.get<std::string>("effort");
    const bool is_amips = options.get<std::string>("energy") == "amips";
    if (options.has("report") && !has_report)
      throw Usage_error("--report needs zlib and three.js, which were missing when map_mesh was built");
    if (is_inspection(options)) return inspect(options);
    const bool is_quiet = options.get<bool>("quiet");
    const std::size_t asked = asked_parts(options);
    require_outputs(options, 1);

    Stopwatch watch;
    const Input input = watch.time("read", [&] { return read_input(options); });
    const std::vector<Mesh::Vertex_index> square_corners = corners(options, input);
    require_outputs(options, (std::min)(asked, input.topology.components));
    Progress progress(is_quiet);
    SM::Map_options map_options;
    map_options.energy = is_amips ? SM::Energy::AMIPS : SM::Energy::SYMMETRIC_DIRICHLET;
    map_options.lambda = lambda;
    map_options.area_floor = area_floor;
    map_options.effort = effort == "fast"      ? SM::Effort::FAST
                         : effort == "quality" ? SM::Effort::QUALITY
                                               : SM::Effort::DEFAULT;
    std::vector<Json> partitions; // how the paper's method made the maps
    Parts parts = watch.time(
      "map", [&] { return map_parts(options, input, map_options, square_corners, partitions, progress); });
    const auto np = CGAL::parameters::visitor(std::ref(progress));
    const auto improve = [&](const char* phase, const auto& f) { // f: a map to a map of the same surface
      if (options.get<bool>(phase))
        for_each_part(parts, [&](auto& part, std::size_t) {
          watch.time(phase, [&] { std::visit([&](auto& map) { map = f(map); }, part.value()); });
        });
    };
    improve("balance", [&](const auto& map) { return SM::balance(map, np); });
    improve("refine", [&](const auto& map) { return SM::refine(map, np); });

    std::vector<Json> figures_of_parts(parts.size());
    for_each_part(parts, [&](const auto& part, std::size_t k) {
      figures_of_parts[k] = metrics_of_part(input, part, watch);
    });
    report_errors("map_mesh", parts, input);
    const bool is_one = parts.size() == 1;
    Json metrics = is_one ? figures_of_parts[0] : metrics_of_parts(input, parts, figures_of_parts);
    metrics["parameters"] = {{"method", options.get<std::string>("method")},
                             {"energy", options.get<std::string>("energy")},
                             {"lambda", lambda},
                             {"area_floor", area_floor},
                             {"effort", effort},
                             {"position", options.get<std::string>("position")},
                             {"balance", options.get<bool>("balance")},
                             {"refine", options.get<bool>("refine")}};
    for (std::size_t k = 0; k < partitions.size(); ++k)
      if (parts[k].has_value()) (is_one ? metrics : metrics["parts"][k])["partition"] = partitions[k];
    SM::Atomic_files files;
    const std::string output = options.get<std::string>("output");
    if (!is_one)
      for (std::size_t k = 0, n = 0; k < parts.size(); ++k)
        if (parts[k].has_value()) metrics["parts"][k]["file"] = SM::numbered_file(output, ++n);
    if (options.has("report"))
      watch.time("report", [&] {
        const std::string file = files.file(options.get<std::string>("report"));
        const Json shown = completed(metrics, "map_mesh", watch);
        if (is_one)
          std::visit([&](const auto& map) { write_page(file, shown, map); }, parts[0].value());
        else
          write_page(file, shown, parts);
      });
    watch.time("write", [&] {
      SM::write_maps(files, output, parts,
                     SM::parameters::repair_report(std::cref(input.repair))
                       .mesh_properties(std::cref(input.read.properties)));
    });
    metrics = completed(std::move(metrics), "map_mesh", watch);
    if (options.has("metrics")) write_metrics(files.file(options.get<std::string>("metrics")), metrics);
    throw_if_interrupted();
    files.commit();
    if (!is_quiet) std::cout << figures(metrics) << std::flush;
    return SM::number_of_values(parts) == parts.size() ? SUCCESS : PARTLY_SERVED;
  });
}
