#include "square_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace tools {

namespace {

// The longest border loop, which becomes that of the square: its vertices, counterclockwise.
std::vector<Mesh::Vertex_index> longest_border(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> longest;
  double longest_length = -1;
  std::vector<bool> is_seen(mesh.num_halfedges());
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_border(start) || is_seen[start]) continue;
    std::vector<Mesh::Vertex_index> loop;
    double length = 0;
    auto h = start;
    do {
      is_seen[h] = true;
      loop.push_back(mesh.target(h));
      const auto edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
      length += std::hypot(edge.x(), edge.y(), edge.z());
      h = mesh.prev(h); // faces lie on the left of a counterclockwise border
    } while (h != start);
    if (length > longest_length) {
      longest_length = length;
      longest = std::move(loop);
    }
  }
  return longest;
}

// Whether a vertex of the repaired mesh has this number in the file.
bool is_numbered(const SM::Input_indices& input, Mesh::Vertex_index v, std::size_t number)
{
  return input.vertices.empty() ? std::size_t(v) == number
                                : input.vertices[v] == static_cast<long long>(number);
}

} // namespace

std::vector<Mesh::Vertex_index> corners(const Command_line& options, const Input& input)
{
  if (!options.has("corners")) return {};
  const auto refuse = [](const std::string& why) { throw Usage_error("--corners: " + why); };
  if (is_paper(options)) refuse("the method paper has a rule of its own");
  std::vector<std::size_t> numbers;
  std::istringstream text(options.get<std::string>("corners"));
  for (std::string number; std::getline(text, number, ',');) {
    if (number.empty() || number.size() > 18 || number.find_first_not_of("0123456789") != std::string::npos)
      refuse('"' + number + "\" is no number of a vertex");
    numbers.push_back(std::stoull(number));
  }
  if (numbers.size() != 4) refuse("four vertices are needed, not " + std::to_string(numbers.size()));

  const SM::Mesh_topology& t = input.topology;
  const SM::Close_borders closing = close_borders(options);
  if (!t.is_connected() || t.genus != 0 || t.is_closed() || closing == SM::Close_borders::ALL ||
      (t.border_loops > 1 && closing == SM::Close_borders::NONE))
    refuse("only a disk has corners, and " + t.sentence() +
           (closing == SM::Close_borders::ALL ? "; all borders are to be closed" : ""));
  const std::vector<Mesh::Vertex_index> border = longest_border(input.mesh);
  std::vector<std::size_t> places;
  for (const std::size_t number : numbers) {
    if (input.repair.input.vertices.empty() && number >= input.mesh.number_of_vertices())
      refuse("there is no vertex " + std::to_string(number) + ", the mesh has " +
             std::to_string(input.mesh.number_of_vertices()) + ", numbered from 0");
    const auto place = std::find_if(border.begin(), border.end(), [&](Mesh::Vertex_index v) {
      return is_numbered(input.repair.input, v, number);
    });
    if (place == border.end()) refuse("vertex " + std::to_string(number) + " is not on the border");
    places.push_back(std::size_t(place - border.begin()));
  }
  int rounds = 0; // of the border from corner to corner
  for (int k = 0; k < 4; ++k) rounds += places[(k + 1) % 4] <= places[k];
  if (rounds != 1) refuse("the vertices do not go once round the border, counterclockwise");
  std::vector<Mesh::Vertex_index> result;
  for (const std::size_t place : places) result.push_back(border[place]);
  return result;
}

} // namespace tools
