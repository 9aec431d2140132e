// Maps between shapes: certified, with little distortion, landmarks met exactly; morphs, mean and modes.

#include "program_tools.h"
#include "shapes_page.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_landmarks.h>
#include <CGAL/Simple_manifolds/IO/refined_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/refined_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_shapes.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <CGAL/boost/graph/IO/PLY.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

using namespace tools;

namespace {

using Positions = std::vector<Eigen::Vector3d>;

// Whether shapes can be mapped to each other over that surface.
template <class Atlas>
constexpr bool has_registration =
  std::is_same_v<Atlas, SM::Sphere_atlas> || std::is_same_v<Atlas, SM::Torus_atlas> ||
  std::is_same_v<Atlas, SM::Plane_atlas>;

struct Shape {
  Input input;
  SM::Any_map map; // in canonical position
};

// The files that are named, and all of a folder in the order of their names.
std::vector<std::string> files_of(const Command_line& options)
{
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& name : options.get<std::vector<std::string>>("inputs")) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(name))
      if (entry.is_regular_file() && entry.path().filename().string()[0] != '.')
        inside.push_back(entry.path().string());
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  if (files.size() < 2) throw Usage_error("at least two shapes are needed");
  return files;
}

Shape read_shape(const Command_line& options, const std::string& file, Stopwatch& watch, Progress& progress)
{
  Input input = watch.time("read", [&] { return read_input(options, file); });
  SM::Any_map map = watch.time("map", [&] {
    try {
      return std::visit(
        [](auto&& m) -> SM::Any_map {
          using Map = SM::Manifold_map<typename std::decay_t<decltype(m)>::Atlas>;
          if constexpr (has_registration<typename Map::Atlas>)
            return SM::canonical_position(static_cast<Map&>(m));
          return static_cast<Map&>(m);
        },
        SM::map_to_canonical_surface<CGAL::Parallel_if_available_tag>(
          input.mesh, SM::parameters::close_borders(close_borders(options)).visitor(std::ref(progress))));
    } catch (const SM::Topology_error& e) {
      throw SM::Topology_error(e.code(), file + ": " + e.what(), e.element());
    }
  });
  return {std::move(input), std::move(map)};
}

// A landmark of a shape as a vertex of its map: a number of the file, or the vertex next to a point.
template <class Map>
std::size_t vertex_of(const Input& input, const Map& map, const SM::Landmark_place& place, double& distance)
{
  const std::vector<int> in_file = map.input_indices().within(input.repair.input).vertices;
  if (place.vertex >= 0) {
    const auto found = std::find(in_file.begin(), in_file.end(), static_cast<int>(place.vertex));
    const long long v = in_file.empty()          ? place.vertex
                        : found == in_file.end() ? -1
                                                 : found - in_file.begin();
    if (v < 0 || v >= static_cast<long long>(map.number_of_input_vertices()))
      throw Usage_error("--landmarks: " + input.file + " has no vertex " + std::to_string(place.vertex) +
                        " in a face");
    return static_cast<std::size_t>(v);
  }
  std::size_t best = 0;
  for (std::size_t v = 1; v < map.number_of_input_vertices(); ++v)
    if ((map.point(v) - place.point).squaredNorm() < (map.point(best) - place.point).squaredNorm()) best = v;
  distance = (std::max)(distance, (map.point(best) - place.point).norm() / map.diagonal());
  return best;
}

// Per landmark its vertices. snapped: the largest distance of a given point from its vertex, in diagonals.
std::vector<std::vector<std::size_t>> landmarks_of(const Command_line& options,
                                                   const std::vector<Shape>& shapes, double& snapped)
{
  if (!options.has("landmarks")) return {};
  const auto files = options.get<std::vector<std::string>>("landmarks");
  std::vector<std::vector<SM::Landmark_place>> table; // per landmark
  if (files.size() == 1) {
    table = SM::read_landmarks(files[0], shapes.size());
  } else {
    if (files.size() != shapes.size())
      throw Usage_error("--landmarks: one table, or one file for each of the " +
                        std::to_string(shapes.size()) + " shapes is expected");
    for (const std::string& file : files) {
      const auto places = SM::read_landmarks(file);
      if (table.empty()) table.resize(places.size());
      if (places.size() != table.size())
        throw Usage_error("--landmarks: " + file + " has " + std::to_string(places.size()) + " landmarks, " +
                          files[0] + " has " + std::to_string(table.size()));
      for (std::size_t k = 0; k < places.size(); ++k) table[k].push_back(places[k]);
    }
  }
  std::vector<std::vector<std::size_t>> rows;
  for (const auto& places : table) {
    if (std::any_of(places.begin(), places.end(), [](const auto& p) { return !p.point.allFinite(); }))
      continue;
    rows.emplace_back();
    for (std::size_t i = 0; i < shapes.size(); ++i)
      rows.back().push_back(std::visit(
        [&](const auto& map) { return vertex_of(shapes[i].input, map, places[i], snapped); }, shapes[i].map));
  }
  return rows;
}

template <class Atlas>
Json metrics_of_pair(const SM::Shape_set<Atlas>& set, std::size_t i, std::size_t j,
                     const std::vector<std::vector<std::size_t>>& landmarks)
{
  const auto c = set.correspondence(i, j);
  const SM::Correspondence_distortion d = SM::distortion(c), back = SM::distortion(c.inverse());
  double sum = 0, largest = 0;
  std::size_t exact = 0;
  Json errors = Json::array();
  for (const auto& row : landmarks) {
    const double error = (c.position(row[i]) - set.map(j).point(row[j])).norm() / set.map(j).diagonal();
    exact += set.map(i).domain_point(row[i]) == set.map(j).domain_point(row[j]);
    sum += error;
    largest = (std::max)(largest, error);
    errors.push_back(error);
  }
  const auto table = [](const SM::Correspondence_distortion& x) {
    return Json{{"mean", x.mean},
                {"median", x.median},
                {"p95", x.p95},
                {"p99", x.p99},
                {"max", number(x.max)},
                {"angle", x.angle_mean},
                {"area_log2", x.area_mean_abs_log2},
                {"samples", x.samples},
                {"not_positive", x.not_positive}};
  };
  return {{"a", i + 1},
          {"b", j + 1},
          {"sd_a", d.mean},
          {"sd_b", d.mean_on_target},
          {"median", d.median},
          {"p95", d.p95},
          {"p99", d.p99},
          {"a_to_b", table(d)},
          {"b_to_a", table(back)},
          {"landmarks",
           {{"used", landmarks.size()},
            {"exact", exact},
            {"mean", landmarks.empty() ? 0. : sum / double(landmarks.size())},
            {"max", largest},
            {"errors", errors}}}};
}

Json metrics_of_statistics(const SM::Common_mesh& mesh, const SM::Shape_statistics<>& s)
{
  Json variances = Json::array(), compactness = Json::array(), scores = Json::array();
  for (std::size_t m = 0; m < s.number_of_modes(); ++m) {
    variances.push_back(s.variances()[Eigen::Index(m)]);
    compactness.push_back(s.compactness(m + 1));
  }
  for (Eigen::Index i = 0; i < s.scores().rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index m = 0; m < s.scores().cols(); ++m) row.push_back(s.scores()(i, m));
    scores.push_back(row);
  }
  Json json = {{"variances", variances}, {"compactness", compactness}, {"scores", scores}};
  if (mesh.number_of_shapes() >= 3) {
    json["generalization"] = SM::Shape_statistics<>::generalization(mesh, 1);
    json["specificity"] = s.specificity(mesh, 1);
  }
  return json;
}

void write_mesh(const std::string& file, const std::vector<SM::Triangle>& faces, const Positions& points)
{
  Mesh mesh;
  for (const Eigen::Vector3d& x : points) mesh.add_vertex({x.x(), x.y(), x.z()});
  for (const SM::Triangle& t : faces)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if (!CGAL::IO::write_PLY(out, mesh) || !out.flush())
    throw SM::IO_error(SM::Error_code::cannot_write, file, "the file cannot be written");
}

// Where the vertices of a shape are on another one: faces and barycentric coordinates.
template <class Atlas>
void write_correspondence(const std::string& file, const SM::Correspondence<Atlas>& c)
{
  std::vector<typename SM::Manifold_map<Atlas>::Location> at;
  c.of_vertices(std::back_inserter(at));
  std::ofstream out(file);
  out.precision(17);
  out << "vertex,face,b0,b1,b2\n";
  for (std::size_t v = 0; v < c.source().number_of_input_vertices(); ++v)
    out << v << ',' << at[v].face << ',' << at[v].barycentric[0] << ',' << at[v].barycentric[1] << ','
        << at[v].barycentric[2] << '\n';
  if (!out.flush()) throw SM::IO_error(SM::Error_code::cannot_write, file, "the file cannot be written");
}

// Both meshes in one, on either shape; its numbers. from and to: the numbers of the shapes.
template <class Atlas>
Json write_overlay(SM::Atomic_folder& folder, const SM::Correspondence<Atlas>& c, const std::string& from,
                   const std::string& to)
{
  const auto overlay = SM::common_refinement<CGAL::Parallel_if_available_tag>(c);
  const std::string name = "overlay_" + from + "_" + to + "_on_";
  SM::write_ply(folder.file(name + from + ".ply"), SM::refined_source(c, overlay));
  SM::write_ply(folder.file(name + to + ".ply"), SM::refined_target(c, overlay));
  const auto of = [&](SM::Refinement_origin origin) {
    return std::count_if(overlay.vertices.begin(), overlay.vertices.end(),
                         [origin](const auto& v) { return v.origin() == origin; });
  };
  const SM::Correspondence_distortion d = SM::distortion(c, overlay);
  return {{"vertices", overlay.vertices.size()},
          {"common_vertices", of(SM::Refinement_origin::BOTH_VERTICES)},
          {"crossings", of(SM::Refinement_origin::CROSSING)},
          {"cells", overlay.cells.size()},
          {"triangles", overlay.faces.size()},
          {"sd_a", number(d.mean)},
          {"sd_b", number(d.mean_on_target)}};
}

void write_landmark_table(const std::string& file, const Json& pairs,
                          const std::vector<std::vector<std::size_t>>& landmarks)
{
  std::ofstream out(file);
  out << "a,b,landmark,vertex_a,vertex_b,error\n";
  for (const Json& pair : pairs)
    for (std::size_t k = 0; k < landmarks.size(); ++k)
      out << pair["a"] << ',' << pair["b"] << ',' << k << ','
          << landmarks[k][pair["a"].get<std::size_t>() - 1] << ','
          << landmarks[k][pair["b"].get<std::size_t>() - 1] << ',' << pair["landmarks"]["errors"][k] << '\n';
  if (!out.flush()) throw SM::IO_error(SM::Error_code::cannot_write, file, "the file cannot be written");
}

// Registers shapes, all of which have maps over that surface, and writes all that the program writes.
template <class Atlas>
int map_over(const Command_line& options, const std::vector<Shape>& shapes,
             const std::vector<std::vector<std::size_t>>& landmarks, double snapped,
             SM::Atomic_folder& folder, Stopwatch& watch, Progress& progress)
{
  const std::string effort = options.get<std::string>("effort");
  const bool is_quiet = options.get<bool>("quiet");
  const std::size_t first = options.get<std::size_t>("template") - 1;
  using Set = SM::Shape_set<Atlas>;
  std::vector<std::shared_ptr<const SM::Manifold_map<Atlas>>> maps;
  for (const Shape& shape : shapes) {
    const auto* map = std::get_if<SM::Manifold_map<Atlas>>(&shape.map);
    if (!map)
      throw SM::Topology_error(
        SM::Error_code::wrong_genus,
        shape.input.file + ": its canonical surface, by its genus and borders, is another one than that of " +
          shapes[0].input.file + ", the " + Atlas::name);
    maps.push_back(std::make_shared<const SM::Manifold_map<Atlas>>(*map));
  }
  std::unique_ptr<const Set> set;
  try {
    watch.time("register", [&] {
      set = std::make_unique<const Set>(SM::register_shapes<CGAL::Parallel_if_available_tag>(
        maps, SM::parameters::landmark_rows(landmarks)
                .template_shape(first)
                .effort(effort == "fast"      ? SM::Effort::FAST
                        : effort == "quality" ? SM::Effort::QUALITY
                                              : SM::Effort::DEFAULT)
                .visitor(std::ref(progress))));
    });
  } catch (const SM::Numeric_error& e) {
    if (e.code() != SM::Error_code::landmarks_not_met) throw;
    say("map_shapes", e.what());
    return TOLERANCE_NOT_REACHED;
  }

  Json metrics = {{"shapes", Json::array()}, {"pairs", Json::array()}};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    metrics["shapes"].push_back({{"input", metrics_of_input(shapes[i].input, set->map(i))},
                                 {"repair", metrics_of_repair(shapes[i].input.repair)},
                                 {"map", metrics_of_map(set->map(i), watch)}});
  watch.time("measure", [&] {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (std::size_t j = i + 1; j < shapes.size(); ++j)
        metrics["pairs"].push_back(metrics_of_pair(*set, i, j, landmarks));
  });
  metrics["landmarks"] = {{"count", landmarks.size()}, {"largest_distance_of_points_from_vertices", snapped}};
  metrics["parameters"] = {{"effort", effort}, {"template", first + 1}};

  SM::Common_mesh common = SM::common_mesh(*set);
  const SM::Common_mesh on_shapes = common; // where the shapes are
  const std::vector<SM::Similarity> motions = SM::align_shapes(common);
  const SM::Shape_statistics<> statistics(common);
  metrics["statistics"] = metrics_of_statistics(common, statistics);

  watch.time("write", [&] {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const std::string number_of = std::to_string(i + 1);
      SM::write_map(folder.file(number_of + ".map.ply"), set->map(i),
                    SM::parameters::repair_report(std::cref(shapes[i].input.repair)));
      if (i == 0) continue;
      write_mesh(folder.file("1_on_" + number_of + ".ply"), on_shapes.faces, on_shapes.positions[i]);
      write_correspondence(folder.file("1_on_" + number_of + ".csv"), set->correspondence(0, i));
      if (options.get<bool>("overlay"))
        metrics["pairs"][i - 1]["overlay"] = write_overlay(folder, set->correspondence(0, i), "1", number_of);
    }
    if (!landmarks.empty()) write_landmark_table(folder.file("landmarks.csv"), metrics["pairs"], landmarks);
    if (shapes.size() > 2) write_mesh(folder.file("mean.ply"), common.faces, statistics.mean());
  });
  metrics = completed(std::move(metrics), "map_shapes", watch);
  write_shapes_page(folder.file("report.html"), *set, common, motions, statistics, landmarks, metrics);
  write_metrics(folder.file("metrics.json"), metrics);
  throw_if_interrupted();
  folder.commit();
  if (!is_quiet)
    for (const Json& pair : metrics["pairs"]) {
      std::cout << pair["a"] << " and " << pair["b"] << ": distortion " << pair["sd_a"].get<double>() << ", "
                << pair["sd_b"].get<double>() << " (1 is an isometry), median "
                << pair["median"].get<double>() << ", 95 % below " << pair["p95"].get<double>();
      if (!landmarks.empty())
        std::cout << "; " << pair["landmarks"]["exact"] << " of " << landmarks.size() << " landmarks exact";
      std::cout << '\n';
    }
  return SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  return run("map_shapes", [&]() -> int {
    Command_line options(
      "map_shapes A B [C ...] -o DIR [options], or map_shapes FOLDER -o DIR [options]",
      "Maps shapes one to one onto each other (meshes of spheres, of tori, or of disks; small holes are "
      "closed), so\n"
      "that there is little distortion, and landmarks are met exactly. Writes the maps of all shapes over "
      "one\n"
      "canonical surface (1.map.ply, 2.map.ply, ...), the first shape's mesh on the others (1_on_2.ply, "
      "...), where "
      "its\n"
      "vertices are there (1_on_2.csv, ...), figures (metrics.json), and a page that shows the shapes, "
      "coloured\n"
      "alike, their morphs and modes (report.html). Of three or more shapes also mean.ply.\n"
      "Exit status: 0 success, 1 landmarks that cannot be met (nothing is written), 2 usage, or a file "
      "cannot be\n"
      "written, 3 unreadable input, 4 unsupported topology or geometry, or too little memory, 129, 130 or "
      "143\n"
      "ended by SIGHUP, ctrl-C or kill.",
      true);
    options.add(
      "landmarks", po::value<std::vector<std::string>>()->multitoken(),
      "a table (a line per landmark: its vertices of all shapes, numbers of the files from 0, or its\n"
      "coordinates on all shapes), or a file for each shape (.vts, .fcsv, .mrk.json or a table)");
    options.add("template", po::value<std::size_t>()->default_value(1),
                "of three or more shapes, which the others are registered to, from 1");
    options.add("effort", po::value<std::string>()->default_value("default"),
                "how long the maps are relaxed: fast, default, quality");
    options.add(
      "overlay", po::bool_switch(),
      "write the common refinement of the first shape with each other one, on both: overlay_1_2_on_1.ply\n"
      "and overlay_1_2_on_2.ply; faces and vertices have their numbers in both maps");
    options.parse(argc, argv);
    options.require_choice("effort", {"fast", "default", "quality"});
    for (const char* name : {"method", "corners", "components"})
      if (options.has(name)) throw Usage_error(std::string("--") + name + " is no option of map_shapes");
    const std::vector<std::string> files = files_of(options);
    options.require(options.get<std::size_t>("template") - 1 < files.size(), "template",
                    "from 1 to the number of shapes");
    for (const std::string& file : files) // names of outputs would replace shapes, or be taken for some
      if (is_same_file(std::filesystem::path(file).parent_path().string().empty()
                         ? "."
                         : std::filesystem::path(file).parent_path().string(),
                       options.get<std::string>("output")))
        throw Usage_error("--output is the folder of " + file + ": choose another one");
    SM::Atomic_folder folder(options.get<std::string>("output"));

    Stopwatch watch;
    Progress progress(options.get<bool>("quiet"));
    std::vector<Shape> shapes;
    for (const std::string& file : files) shapes.push_back(read_shape(options, file, watch, progress));
    double snapped = 0;
    const auto landmarks = landmarks_of(options, shapes, snapped);
    return std::visit(
      [&](const auto& map) -> int {
        using Atlas = typename std::decay_t<decltype(map)>::Atlas;
        if constexpr (has_registration<Atlas>) {
          return map_over<Atlas>(options, shapes, landmarks, snapped, folder, watch, progress);
        } else {
          throw SM::Topology_error(SM::Error_code::wrong_genus,
                                   files[0] + " has genus " + std::to_string(map.atlas().genus()) +
                                     ": shapes are mapped to each other over the sphere, the torus and the "
                                     "square only");
        }
      },
      shapes[0].map);
  });
}
