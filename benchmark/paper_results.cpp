// Section 6 of the paper on the meshes of data/: the paper's method and the default beside each other, as
// tables and as files that scripts/paper_results draws. See README.md in this folder.

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// The tolerances of the patches, as fractions of the diagonal; the paper does not say which it had.
constexpr double average_delta = 2e-3, max_delta = 1e-2;

struct Paper_mesh {
  const char* name;
  const char* patches; // per chart, in the paper
};
const Paper_mesh paper_meshes[] = {{"banana", "2-4"},
                                   {"fish", "2-5"},
                                   {"gumby", "no surface"},
                                   {"gumby_thin_arms", ""},
                                   {"torus", "no surface"}};

// A column of the tables: of that of the maps, or of that of the surfaces.
struct Figure {
  const char* name;
  const char* title;
  bool is_of_map;
};
const Figure figures[] = {{"valid", "certified", true},
                          {"subdivisions", "subdivisions", true},
                          {"largest_deviation", "1: deviation", true},
                          {"stars_without_chart", "2: without chart", true},
                          {"vertices_outside", "3: outside", true},
                          {"convex_share", "4: convex", true},
                          {"angle", "angle", true},
                          {"area", "area", true},
                          {"l2_efficiency", "L2 efficiency", true},
                          {"map_seconds", "seconds", true},
                          {"patches", "patches per chart", false},
                          {"paper_patches", "in the paper", false},
                          {"controls", "controls", false},
                          {"tolerance_reached", "within tolerances", false},
                          {"rms_error", "rms", false},
                          {"max_error", "max", false},
                          {"closest_point_rms", "closest rms", false},
                          {"closest_point_max", "closest max", false},
                          {"normal_degrees", "normals", false},
                          {"fit_seconds", "seconds", false}};

struct Row {
  std::string mesh, method;
  std::map<std::string, std::string> values; // of figures

  std::string value(const std::string& name) const
  {
    const auto found = values.find(name);
    return found == values.end() ? "" : found->second;
  }
};

std::string shown(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

// Calls f and says how long it was: processor time, which other programs do not change.
template <class F>
decltype(auto) timed(double& seconds, const F& f)
{
  struct Lap {
    double& seconds;
    std::clock_t start = std::clock();
    ~Lap() { seconds = double(std::clock() - start) / CLOCKS_PER_SEC; }
  } lap{seconds};
  return f();
}

// E.g. "2-4".
std::string range_of_patches(const std::vector<SM::Patch_fit_report::Chart>& charts)
{
  const auto has_fewer = [](const auto& a, const auto& b) { return a.patches < b.patches; };
  const auto [low, high] = std::minmax_element(charts.begin(), charts.end(), has_fewer);
  const std::string first = std::to_string(low->patches);
  return low->patches == high->patches ? first : first + '-' + std::to_string(high->patches);
}

template <class Map>
void add_figures_of_map(const Map& map, Row& row)
{
  const SM::Certificate certificate = SM::certify(map.atlas(), map.domain_points(), map.faces());
  const SM::Criteria_report criteria = SM::criteria_report(map);
  const SM::Distortion d = SM::distortion(map);
  row.values["valid"] = certificate.is_valid() ? "yes" : "no";
  row.values["largest_deviation"] = shown(criteria.largest_deviation);
  row.values["stars_without_chart"] = std::to_string(criteria.charts.stars_without_chart);
  row.values["vertices_outside"] = std::to_string(criteria.vertices_outside);
  row.values["convex_share"] = shown(criteria.convex_share());
  row.values["angle"] = shown(d.angle_mean);
  row.values["area"] = shown(d.area_mean_abs_log10);
  row.values["l2_efficiency"] = shown(d.l2_efficiency);
}

void add_figures_of_fit(const SM::Fit_report& fit, Row& row)
{
  row.values["controls"] = std::to_string(fit.controls);
  row.values["rms_error"] = shown(fit.rms_error);
  row.values["max_error"] = shown(fit.max_error);
  row.values["closest_point_rms"] = shown(fit.closest_point_rms);
  row.values["closest_point_max"] = shown(fit.closest_point_max);
  row.values["normal_degrees"] = shown(fit.normal_deviation * 180 / CGAL_PI);
}

template <class Map, class Surface>
void write_files(const std::filesystem::path& folder, const Map& map, const Surface& surface)
{
  std::filesystem::create_directories(folder);
  SM::write_map((folder / "map.ply").string(), map);
  SM::write_surface((folder / "surface.json").string(), surface);
  SM::write_tessellation((folder / "surface.ply").string(), surface, map, SM::parameters::subdivisions(40));
}

// Adds the paper's fit to a row; returns the number of controls.
template <class Map>
std::size_t fit_patches(const Map& map, const std::filesystem::path& folder, Row& row)
{
  double seconds = 0;
  SM::Patch_fit_report fit;
  const auto surface = timed(seconds, [&] {
    return SM::fit_patch_surface(
      map, SM::parameters::average_delta(average_delta).max_delta(max_delta).patch_fit_report(std::ref(fit)));
  });
  row.values["fit_seconds"] = shown(seconds);
  row.values["patches"] = range_of_patches(fit.charts);
  row.values["tolerance_reached"] = fit.tolerance_reached ? "yes" : "no";
  add_figures_of_fit(fit.surface, row);
  write_files(folder, map, surface);
  return fit.surface.controls;
}

// Adds the default fit, with as many controls.
template <class Map>
void fit_hierarchically(const Map& map, std::size_t controls, const std::filesystem::path& folder, Row& row)
{
  double seconds = 0;
  SM::Fit_report fit;
  const auto surface = timed(seconds, [&] {
    return SM::fit_surface(map,
                           SM::parameters::rms_error(1e-9).max_controls(controls).fit_report(std::ref(fit)));
  });
  row.values["fit_seconds"] = shown(seconds);
  add_figures_of_fit(fit, row);
  write_files(folder, map, surface);
}

// The rows of a mesh: the paper's method; its patches on the default map; the default method.
void add_rows(const std::string& name, const Mesh& mesh, const std::filesystem::path& folder,
              std::vector<Row>& rows)
{
  Row paper{name, "paper", {}}, mixed{name, "mixed", {}}, standard{name, "default", {}};
  for (const Paper_mesh& m : paper_meshes)
    if (m.name == name) paper.values["paper_patches"] = m.patches;

  double seconds = 0;
  SM::Partition_report partition;
  const auto paper_map = timed(seconds, [&] {
    return SM::map_by_partition(mesh, SM::parameters::partition_report(std::ref(partition)));
  });
  paper.values["map_seconds"] = shown(seconds);
  paper.values["subdivisions"] = std::to_string(partition.subdivisions);
  std::visit(
    [&](const auto& map) {
      add_figures_of_map(map, paper);
      fit_patches(map, folder / "paper", paper);
    },
    paper_map);

  const auto default_map = timed(seconds, [&] {
    return SM::map_to_canonical_surface(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
  });
  standard.values["map_seconds"] = shown(seconds);
  std::visit(
    [&](const auto& map) {
      add_figures_of_map(map, standard);
      const std::size_t controls = fit_patches(map, folder / "mixed", mixed);
      fit_hierarchically(map, controls, folder / "default", standard);
    },
    default_map);
  for (const Row& row : {paper, mixed, standard}) rows.push_back(row);
}

void write_csv(const std::string& file, const std::vector<Row>& rows)
{
  SM::Atomic_file output(file);
  output.stream() << "mesh,method";
  for (const Figure& f : figures) output.stream() << ',' << f.name;
  for (const Row& row : rows) {
    output.stream() << '\n' << row.mesh << ',' << row.method;
    for (const Figure& f : figures) output.stream() << ',' << row.value(f.name);
  }
  output.stream() << '\n';
  output.commit();
}

// The table of the maps or that of the surfaces, as Markdown.
void print_table(std::ostream& out, const std::vector<Row>& rows, bool is_of_maps)
{
  out << "| mesh | method |";
  std::string line = "|---|---|";
  for (const Figure& f : figures)
    if (f.is_of_map == is_of_maps) {
      out << ' ' << f.title << " |";
      line += "---|";
    }
  out << '\n' << line << '\n';
  for (const Row& row : rows) {
    if (is_of_maps && row.value("valid").empty()) continue; // a fit to the map of another row
    out << "| " << row.mesh << " | " << row.method << " |";
    for (const Figure& f : figures)
      if (f.is_of_map == is_of_maps) out << ' ' << row.value(f.name) << " |";
    out << '\n';
  }
}

int usage(int status)
{
  (status == EXIT_SUCCESS ? std::cout : std::cerr)
    << "Usage: paper_results [-o DIR] [MESH...]\n\n"
       "Maps meshes (default: those of data/) and fits surfaces to them by the paper's method and by the\n"
       "default one. Writes DIR/results.csv, the tables DIR/maps.md and DIR/surfaces.md and, for each mesh\n"
       "and method, map.ply, surface.json, surface.ply into DIR/MESH/METHOD (default DIR: out).\n";
  return status;
}

} // namespace

int main(int argc, char** argv)
try {
  std::filesystem::path folder = "out";
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "-h" || argument == "--help") return usage(EXIT_SUCCESS);
    if (argument == "-o" && i + 1 < argc)
      folder = argv[++i];
    else if (argument[0] == '-')
      return usage(2);
    else
      files.push_back(argument);
  }
  if (files.empty())
    for (const Paper_mesh& m : paper_meshes)
      files.push_back(SIMPLE_MANIFOLDS_DATA + std::string("/") + m.name + ".off");

  std::vector<Row> rows;
  for (const std::string& file : files) {
    Mesh mesh;
    SM::read_mesh(file, mesh);
    const std::string name = std::filesystem::path(file).stem().string();
    add_rows(name, mesh, folder / name, rows);
  }

  write_csv((folder / "results.csv").string(), rows);
  for (const bool is_of_maps : {true, false}) {
    SM::Atomic_file table((folder / (is_of_maps ? "maps.md" : "surfaces.md")).string());
    print_table(table.stream(), rows, is_of_maps);
    print_table(std::cout, rows, is_of_maps);
    std::cout << '\n';
    table.commit();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& e) {
  std::cerr << "paper_results: " << e.what() << '\n';
  return EXIT_FAILURE;
}
