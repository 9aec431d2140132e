// The bodies of a file: map_mesh and fit_mesh serve each connected component by itself.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_PARTS_H
#define SIMPLE_MANIFOLDS_EXAMPLES_PARTS_H

#include "program_tools.h"

#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/map_components.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace tools {

using Parts = SM::Component_mesh_maps<Mesh>;

/// The number of bodies that --components asks for, at most.
/// \throw Usage_error
std::size_t asked_parts(const Command_line& options);

/// The option --position: what says how maps lie.
void add_position_option(Command_line& options);
/// \throw Usage_error
SM::Position_frame position_frame(const Command_line& options);

/// The maps of the bodies that are asked for, as they are asked to lie, by the method that is asked for. `how` receives for each how the paper's
/// method came to its map.
Parts map_parts(const Command_line& options, const Input& input, const SM::Map_options& map_options,
                const std::vector<Mesh::Vertex_index>& corners, std::vector<Json>& how, Progress& progress);

/// f(part, k) for each part that has a value; an error becomes that of the part, unless no file can be written.
template <class Value, class F>
void for_each_part(std::vector<SM::Component<Value>>& parts, const F& f)
{
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!parts[k].has_value()) continue;
    try {
      f(parts[k], k);
    } catch (const SM::IO_error&) {
      throw;
    } catch (const SM::Error& e) {
      parts[k] = SM::Component<Value>(SM::Mesh_component(std::move(parts[k])), SM::Error(e));
    }
  }
}

/// f(map, surface) of a map and the surface over its atlas.
template <class AnyMap, class AnySurface, class F>
void visit_both(const AnyMap& any_map, const AnySurface& any_surface, const F& f)
{
  std::visit(
    [&](const auto& map) {
      std::visit(
        [&](const auto& surface) {
          if constexpr (std::is_same_v<typename std::decay_t<decltype(map)>::Atlas,
                                       typename std::decay_t<decltype(surface)>::Atlas>)
            f(map, surface);
        },
        any_surface);
    },
    any_map);
}

/// What the metrics say of a part of the input: of one body, or of what the file holds.
template <class Map>
Json metrics_of_input(const Input& input, const SM::Mesh_component& part, const Map& map)
{
  if (input.topology.is_connected()) return metrics_of_input(input, map);
  std::vector<SM::Triangle> faces = map.faces();
  faces.resize(faces.size() - map.number_of_virtual_faces());
  Input own;
  own.file = input.file;
  own.topology = SM::topology(map.number_of_vertices(), faces);
  own.topology.vertices = part.vertices.size();
  own.topology.faces = part.faces.size();
  own.topology.isolated_vertices = 0;
  Json metrics = metrics_of_input(own, map);
  metrics.update(metrics_of_reading(input.read)); // without a copy of it for each part
  metrics["components"] = input.topology.components;
  return metrics;
}

/// The figures of several bodies: those of each, or its error, and totals.
Json metrics_of_parts(const Input& input, const std::vector<SM::Mesh_component>& parts,
                      const std::vector<std::string>& errors, std::vector<Json> metrics);

/// What there is to say of a part.
struct Part_message {
  std::string part, message; // no part: of the only one
};

/// Says it on stderr: a line for each message, with the names of its parts; not hundreds of either.
void say_of_parts(const char* program, const std::vector<Part_message>& messages);

/// Says what is wrong with the parts that have no value, and if none has one, whether the numbers in the file can be the
/// cause.
/// \throw SM::Error  when no part has a value
template <class Value>
void report_errors(const char* program, const std::vector<SM::Component<Value>>& parts, const Input& input)
{
  if (SM::number_of_values(parts) == 0) {
    const SM::Error& first = parts.front().error();
    std::string message = first.what();
    if (parts.size() > 1)
      message = "none of the " + std::to_string(parts.size()) + " bodies can be served; " +
                parts.front().name + ": " + message;
    for (const SM::Read_warning& w : input.read.warnings)
      if (w.kind == SM::Read_warning::SINGLE_PRECISION) message += "; " + w.sentence();
    throw SM::Error(first.code(), message);
  }
  std::vector<Part_message> messages;
  for (const SM::Component<Value>& part : parts)
    if (!part.has_value()) messages.push_back({part.name, part.error().what()});
  say_of_parts(program, messages);
}

/// The arguments of metrics_of_parts() from parts with values or errors.
template <class Value>
Json metrics_of_parts(const Input& input, const std::vector<SM::Component<Value>>& parts,
                      std::vector<Json> metrics)
{
  std::vector<SM::Mesh_component> names;
  std::vector<std::string> errors;
  for (const SM::Component<Value>& part : parts) {
    names.push_back(part);
    errors.push_back(part.has_value() ? std::string() : part.error().what());
  }
  return metrics_of_parts(input, names, errors, std::move(metrics));
}

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_PARTS_H
