#include "parts.h"

#ifndef SIMPLE_MANIFOLDS_DEMO
#include <CGAL/Simple_manifolds/paper/map/map_components_by_partition.h>
#endif

#include <algorithm>
#include <limits>
#include <utility>

namespace tools {

std::size_t asked_parts(const Command_line& options)
{
  const std::string which = options.get<std::string>("components");
  if (which == "all") return (std::numeric_limits<std::size_t>::max)();
  if (which == "largest") return 1;
  const bool is_number =
    !which.empty() && which.size() <= 9 && which.find_first_not_of("0123456789") == std::string::npos;
  options.require(is_number && std::stol(which) > 0, "components", "all, largest, or a positive number");
  return std::stoul(which);
}

void add_position_option(Command_line& options)
{
  options.add(
    "position", po::value<std::string>()->default_value("none"),
    "how maps lie on sphere, torus or square: none (as the last digits of the mesh have it), shape\n"
    "(by the shape's own axes of inertia and moments), space (the sphere by the axes of space); without\n"
    "effect on maps with --corners and of genus 2 and more");
}

SM::Position_frame position_frame(const Command_line& options)
{
  options.require_choice("position", {"none", "shape", "space"});
  const std::string position = options.get<std::string>("position");
  options.require(position == "none" || !is_paper(options), "position", "none with the method of the paper");
  return position == "shape"   ? SM::Position_frame::SHAPE
         : position == "space" ? SM::Position_frame::SPACE
                               : SM::Position_frame::NONE;
}

Parts map_parts(const Command_line& options, const Input& input, const SM::Map_options& map_options,
                const std::vector<Mesh::Vertex_index>& corners, [[maybe_unused]] std::vector<Json>& how,
                Progress& progress)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const SM::Position_frame frame = position_frame(options);
  if (!is_paper(options))
    return SM::map_components<Tag>(input.mesh, SM::parameters::map_options(map_options)
                                                 .position_frame(frame)
                                                 .close_borders(close_borders(options))
                                                 .corners(corners)
                                                 .max_components(asked_parts(options))
                                                 .visitor(std::ref(progress)));
  require_not_demo("the method of the paper");
#ifdef SIMPLE_MANIFOLDS_DEMO
  return {};
#else
  std::vector<SM::Partition_report> reports;
  Parts parts =
    SM::map_components_by_partition<Tag>(input.mesh, SM::parameters::partition_reports(std::ref(reports))
                                                       .close_borders(close_borders(options))
                                                       .max_components(asked_parts(options))
                                                       .visitor(std::ref(progress)));
  for (const SM::Partition_report& r : reports)
    how.push_back({{"attempts", r.attempts},
                   {"subdivisions", r.subdivisions},
                   {"removed_vertices", r.removed_vertices},
                   {"rounds", r.equalization.rounds},
                   {"largest_deviation_of_faces", r.equalization.largest_deviation},
                   {"stopped_by_rule", r.equalization.has_stopped_by_rule}});
  return parts;
#endif
}

void say_of_parts(const char* program, const std::vector<Part_message>& messages)
{
  constexpr std::size_t most_names = 3, most_lines = 10;
  std::vector<std::pair<std::string, std::vector<std::string>>>
    lines; // a message, and the parts that it is for
  for (const Part_message& m : messages) {
    auto line =
      std::find_if(lines.begin(), lines.end(), [&](const auto& other) { return other.first == m.message; });
    if (line == lines.end()) line = lines.insert(line, {m.message, {}});
    line->second.push_back(m.part);
  }
  for (std::size_t i = 0; i < lines.size() && i < most_lines; ++i) {
    const auto& [message, parts] = lines[i];
    std::string names = parts[0];
    for (std::size_t k = 1; k < parts.size() && k < most_names; ++k) names += ", " + parts[k];
    if (parts.size() > most_names) names += " and " + std::to_string(parts.size() - most_names) + " more";
    say(program, (names.empty() ? "" : names + ": ") + message);
  }
  if (lines.size() > most_lines)
    say(program, "and " + std::to_string(lines.size() - most_lines) + " more messages; the metrics have all");
}

Json metrics_of_parts(const Input& input, const std::vector<SM::Mesh_component>& parts,
                      const std::vector<std::string>& errors, std::vector<Json> metrics)
{
  const SM::Mesh_topology& t = input.topology;
  Json all;
  all["input"] = {
    {"file", input.file},        {"vertices", t.vertices},         {"faces", t.faces},
    {"genus", t.genus},          {"border_loops", t.border_loops}, {"isolated_vertices", t.isolated_vertices},
    {"components", t.components}};
  all["input"].update(metrics_of_reading(input.read));
  all["repair"] = metrics_of_repair(input.repair);
  std::size_t served = 0, faces = 0, flipped = 0, controls = 0;
  double rms_error = 0, max_error = 0;
  bool has_surfaces = false, has_reached = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Json part = {
      {"name", parts[k].name}, {"vertices", parts[k].vertices.size()}, {"faces", parts[k].faces.size()}};
    if (!errors[k].empty()) {
      part["error"] = errors[k];
    } else {
      ++served;
      faces += parts[k].faces.size();
      flipped += metrics[k]["map"]["flipped"].get<std::size_t>();
      if (metrics[k].contains("surface")) {
        const Json& s = metrics[k]["surface"];
        has_surfaces = true;
        has_reached = has_reached && s["tolerance_reached"].get<bool>();
        controls += s["controls"].get<std::size_t>();
        rms_error = (std::max)(rms_error, s["rms_error"].get<double>());
        max_error = (std::max)(max_error, s["max_error"].get<double>());
      }
      for (const char* of_all :
           {"repair", "parameters", "seconds", "peak_memory_bytes", "program", "version"})
        metrics[k].erase(of_all);
      for (const char* of_all :
           {"warnings", "vertex_properties", "face_properties", "dropped_properties", "unit"})
        metrics[k]["input"].erase(of_all);
      part.update(metrics[k]);
    }
    all["parts"].push_back(std::move(part));
  }
  all["totals"] = {{"parts", parts.size()}, {"served", served}, {"faces", faces}, {"flipped", flipped}};
  if (has_surfaces)
    all["totals"].update({{"controls", controls},
                          {"largest_rms_error", rms_error},
                          {"largest_max_error", max_error},
                          {"tolerance_reached", has_reached && served == parts.size()}});
  return all;
}

} // namespace tools
