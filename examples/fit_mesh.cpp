// Maps a mesh onto the canonical surface of its genus, fits a smooth surface to it and writes both, a
// tessellation, figures and samples into a folder.

#include "parts.h"
#include "program_tools.h"
#include "square_corners.h"
#include "written_distances.h"

#include <CGAL/Simple_manifolds/IO/charted_components.h>
#include <CGAL/Simple_manifolds/IO/component_surfaces_io.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_tessellation.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>
#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

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

struct Fit_request {
  bool is_patches;
  double average, maximum; // tolerances
  int degree, smoothness, patches;
  long samples, controls;
  double fairness;
  SM::Marking marking;
  SM::Fit_target target;
  double crease_angle;
  SM::Joint_solve joint;
};

Fit_request fit_request(const Command_line& options)
{
  Fit_request r;
  const std::string surface = options.has("surface") ? options.get<std::string>("surface")
                              : is_paper(options)    ? "patches"
                                                     : "hierarchical";
  options.require(surface == "hierarchical" || surface == "patches", "surface", "hierarchical or patches");
  r.is_patches = surface == "patches";
  const auto refuse = [&](const char* name, const char* other) {
    if (options.has(name))
      throw Usage_error(std::string("--") + name + " is for --surface " + other + " only");
  };
  if (r.is_patches)
    for (const char* name : {"smoothness", "max-controls", "marking", "economy", "fairness",
                             "correct-parameters", "target", "crease-angle"})
      refuse(name, "hierarchical");
  else
    refuse("max-patches", "patches");
  r.patches = options.get<int>("max-patches");
  options.require(r.patches >= 1 && r.patches <= 100, "max-patches", "from 1 to 100");
  r.average = options.get<double>("tolerance");
  r.maximum = options.has("max-tolerance") ? options.get<double>("max-tolerance") : 10 * r.average;
  r.degree = options.get<int>("degree");
  r.smoothness = options.get<int>("smoothness");
  r.samples = options.get<long>("samples");
  options.require(r.average > 0 && std::isfinite(r.average), "tolerance", "a positive number");
  options.require(r.maximum > 0 && std::isfinite(r.maximum), "max-tolerance", "a positive number");
  options.require(r.degree >= 2 && r.degree <= 5, "degree", "from 2 to 5");
  options.require(r.smoothness >= 1 && r.smoothness <= 3, "smoothness", "from 1 to 3");
  r.controls = options.get<long>("max-controls");
  r.fairness = options.get<double>("fairness");
  const std::string target = r.is_patches ? "facets" : options.get<std::string>("target");
  options.require(target == "facets" || target == "curved" || target == "automatic", "target",
                  "facets, curved or automatic");
  r.target = target == "facets"   ? SM::Fit_target::FACETS
             : target == "curved" ? SM::Fit_target::CURVED
                                  : SM::Fit_target::AUTOMATIC;
  r.crease_angle = options.get<double>("crease-angle");
  options.require(r.crease_angle >= 0 && r.crease_angle <= 180, "crease-angle", "from 0 to 180 degrees");
  const std::string marking = options.get<std::string>("marking");
  r.marking = marking == "vertices" ? SM::Marking::VERTICES : SM::Marking::ALL_POINTS;
  r.joint = options.get<bool>("economy") ? SM::Joint_solve::ALWAYS : SM::Joint_solve::AT_END;
  options.require(marking == "all" || marking == "vertices", "marking", "all or vertices");
  options.require(r.controls == 0 || r.controls >= 1000, "max-controls", "at least 1000, or 0");
  options.require(r.fairness >= 0 && r.fairness <= 1e12, "fairness", "from 0 to 1e12");
  options.require(r.samples >= 0 && r.samples <= 100000000, "samples", "from 0 to 100000000");
  return r;
}

// The files of a body, in the folder or in one of its own.
std::vector<std::string> files_of_body(const Fit_request& request)
{
  std::vector<std::string> names = {"map.ply", "surface.json", "surface.ply", "metrics.json"};
  if (has_report) names.push_back("report.html");
  if (request.samples > 0) names.push_back("samples.csv");
  return names;
}

std::string folder_of_part(std::size_t k) { return "part-" + std::to_string(k + 1); }

// Found out before the work: the files can be written, and none of them takes the place of INPUT.
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

Json metrics_of_errors(const SM::Fit_errors& e)
{
  return {{"rms_error", e.rms_error},
          {"max_error", e.max_error},
          {"closest_point_rms", e.closest_point_rms},
          {"closest_point_max", e.closest_point_max},
          {"normal_deviation", e.normal_deviation},
          {"chart_disagreement", e.chart_disagreement}};
}

const char* name_of(SM::Fit_stop stop)
{
  switch (stop) {
  case SM::Fit_stop::CONTROLS:
    return "controls";
  case SM::Fit_stop::STAGNATION:
    return "stagnation";
  case SM::Fit_stop::RESOLUTION:
    return "resolution";
  default:
    return "tolerance";
  }
}

// Why it is no better, and where it is worst.
std::string reason(const SM::Fit_report& report)
{
  const Eigen::Vector3d& x = report.worst_point;
  const std::string what = report.stop == SM::Fit_stop::CONTROLS     ? ", their limit"
                           : report.stop == SM::Fit_stop::STAGNATION ? ", and more did not help"
                                                                     : ", with the smallest cells";
  return what + "; the largest error is near (" + shown(x[0]) + ", " + shown(x[1]) + ", " + shown(x[2]) + ")";
}

Json metrics_of_surface(const SM::Fit_report& report)
{
  Json metrics = metrics_of_errors(report);
  metrics["tolerance_reached"] = report.tolerance_reached;
  metrics["vertex_rms_error"] = report.vertex_rms_error;
  metrics["vertex_max_error"] = report.vertex_max_error;
  metrics["controls"] = report.controls;
  metrics["stop"] = report.tolerance_reached && report.folds == 0 ? "tolerance" : name_of(report.stop);
  metrics["worst_point"] = {report.worst_point[0], report.worst_point[1], report.worst_point[2]};
  metrics["target_rms"] = report.target_rms;
  metrics["target_max"] = report.target_max;
  metrics["folds"] = report.folds;
  metrics["fold_places"] = Json::array();
  for (const SM::Fit_report::Fold& f : report.fold_places)
    metrics["fold_places"].push_back({{"face", f.face}, {"point", {f.point[0], f.point[1], f.point[2]}}});
  metrics["has_more_controls_than_vertices"] = report.has_more_controls_than_vertices();
  for (const SM::Fit_report::Chart& c : report.charts) {
    Json chart = metrics_of_errors(c);
    chart["controls"] = c.controls;
    chart["levels"] = c.levels;
    metrics["charts"].push_back(std::move(chart));
    metrics["patches_per_chart"].push_back(c.levels);
  }
  for (const SM::Fit_report::Level& l : report.levels)
    metrics["levels"].push_back(
      {{"controls", l.controls}, {"rms_error", l.rms_error}, {"max_error", l.max_error}});
  const SM::Fit_report::Seconds& t = report.seconds;
  metrics["seconds"] = {
    {"sampling", t.sampling}, {"solving_alone", t.solving_alone}, {"solving_jointly", t.solving_jointly},
    {"refining", t.refining}, {"measuring", t.measuring},         {"closest_point", t.closest_point}};
  metrics["bytes"] = {{"samples", report.bytes.samples}, {"equations", report.bytes.equations}};
  return metrics;
}

// What all steps of a run of the program need.
struct Job {
  const Command_line& options;
  const Fit_request& request;
  const Input& input;
  const std::vector<Json>& partitions; // how the paper's method made the maps
  SM::Atomic_folder& folder;
  Progress& progress;
  Stopwatch& watch;
};

Json parameters_of(const Job& job)
{
  Json p = {{"method", job.options.get<std::string>("method")}};
  if (!is_paper(job.options)) {
    const SM::Map_options o = SM::map_options_for_fitting();
    p.update({{"energy", "amips"}, {"lambda", o.lambda}, {"area_floor", o.area_floor}});
  }
  p.update({{"surface", job.request.is_patches ? "patches" : "hierarchical"},
            {"tolerance", job.request.average},
            {"max_tolerance", job.request.maximum},
            {"degree", job.request.degree},
            {"bump", "smoothstep"},
            {"bump_smoothness", job.request.smoothness},
            {"samples", job.request.samples}});
  return p;
}

// What was fitted to the maps: the surfaces, and of each the report, its metrics, and what is said of its errors.
template <class AnySurface>
struct Fits {
  std::vector<SM::Component<AnySurface>> surfaces;
  std::vector<SM::Fit_report> reports;
  std::vector<Json> metrics;
  std::vector<std::string> errors;
};

// Whether what is written keeps what the errors of the fit promise: these are measured from the target, and vertices
// alone or the paper's weighted errors promise nothing of the rest.
bool is_within_tolerance(const Fit_request& request, const SM::Fit_report& report, const Json& written,
                         double chord_error)
{
  if (request.is_patches || request.marking == SM::Marking::VERTICES) return true;
  for (const char* way : {"mesh_to_surface", "surface_to_mesh"})
    if (written[way]["max"] > request.maximum + report.target_max + chord_error) return false;
  return written["mesh_to_surface"]["rms"] <= request.average + report.target_rms + chord_error;
}

std::string folds_sentence(const SM::Fit_report& report)
{
  std::string text = "the surface turns over at " + std::to_string(report.folds) +
                     (report.folds == 1 ? " face" : " faces") + " of the mesh, near";
  for (std::size_t k = 0; k < report.fold_places.size() && k < 3; ++k) {
    const Eigen::Vector3d& x = report.fold_places[k].point;
    text += (k == 0 ? " (" : ", (") + shown(x[0]) + ", " + shown(x[1]) + ", " + shown(x[2]) + ")";
  }
  return text + (report.folds > 3 ? ", ..." : "");
}

// Writes the files of a body, those of several each in its folder. `least` is the number of vertices that the
// tessellation has at least, roughly. Returns the metrics and the tessellation.
template <class Map, class Surface>
std::pair<Json, SM::Charted_mesh> write_body(Job& job, const Map& map, const Surface& surface,
                                             const SM::Fit_report& report, Json metrics,
                                             const std::string& folder, double least)
{
  const auto file = [&](const char* name) { return job.folder.file(folder + name); };
  // The grid it starts from has a quarter as many vertices as the mesh, roughly; then no face is farther from the
  // surface than half the tolerance.
  const int subdivisions = SM::Tile_grid<typename Map::Atlas>::subdivisions_for(
    std::clamp(double(map.number_of_vertices()) / 4, least, 50000.), map.atlas());
  const double chord_error = job.request.average / 2;
  metrics["parameters"].update({{"subdivisions", subdivisions}, {"chord_error", chord_error}});
  const SM::Mesh_properties properties = SM::map_properties(map, job.input.read.properties);
  SM::Charted_mesh tessellation = job.watch.time("tessellate", [&] {
    SM::Charted_mesh mesh = SM::charted_tessellation(surface, map,
                                                     SM::parameters::subdivisions(subdivisions)
                                                       .chord_error(chord_error)
                                                       .mesh_properties(std::cref(properties)));
    SM::write_ply(file("surface.ply"), mesh);
    return mesh;
  });
  metrics["written"] = job.watch.time("distances", [&] { return written_distances(map, tessellation); });
  metrics["written"]["within_tolerance"] =
    is_within_tolerance(job.request, report, metrics["written"], chord_error);
  job.watch.time("write", [&] {
    SM::write_map(
      file("map.ply"), map,
      SM::parameters::repair_report(std::cref(job.input.repair)).mesh_properties(std::cref(properties)));
    SM::write_surface(file("surface.json"), surface);
    if (job.request.samples > 0)
      SM::write_samples(file("samples.csv"), surface,
                        SM::random_domain_points<typename Map::Atlas>(job.request.samples));
  });
  if (has_report)
    job.watch.time("report", [&] {
      write_page(file("report.html"), completed(metrics, "fit_mesh", job.watch), map, surface, report);
    });
  metrics = completed(std::move(metrics), "fit_mesh", job.watch);
  write_metrics(file("metrics.json"), metrics);
  return {std::move(metrics), std::move(tessellation)};
}

// Writes all files, and says what came of the fit.
template <class AnySurface>
int write(Job& job, const Parts& maps, Fits<AnySurface> fits, const Json& parameters)
{
  const bool is_quiet = job.options.get<bool>("quiet"), is_one = maps.size() == 1;
  const double least =
    (std::max)(6000. / double(maps.size()), 600.); // so that of hundreds of bodies it is not huge
  std::vector<Json> metrics(maps.size());
  std::vector<char> written_is_within_tolerance(maps.size(), 1);
  std::vector<SM::Charted_mesh> tessellations;
  std::vector<std::string> names;
  for_each_part(fits.surfaces, [&](const auto& part, std::size_t k) {
    visit_both(maps[k].value(), part.value(), [&](const auto& map, const auto& surface) {
      Json own;
      own["input"] = metrics_of_input(job.input, part, map);
      own["repair"] = metrics_of_repair(job.input.repair);
      own["map"] = metrics_of_map(map, job.watch);
      if (!job.partitions.empty()) own["partition"] = job.partitions[k];
      own["surface"] = fits.metrics[k];
      own["surface"]["smoothness"] = surface.smoothness();
      own["parameters"] = parameters;
      auto [all, tessellation] = write_body(job, map, surface, fits.reports[k], std::move(own),
                                            is_one ? std::string() : folder_of_part(k) + '/', least);
      written_is_within_tolerance[k] = all["written"]["within_tolerance"] == true;
      metrics[k] = std::move(all);
      tessellations.push_back(std::move(tessellation));
      names.push_back(part.name);
    });
  });
  report_errors("fit_mesh", fits.surfaces, job.input);
  Json shown = metrics[0];
  if (!is_one) {
    shown = metrics_of_parts(job.input, fits.surfaces, std::move(metrics));
    shown["parameters"] = parameters;
    for (std::size_t k = 0; k < maps.size(); ++k)
      if (fits.surfaces[k].has_value()) shown["parts"][k]["folder"] = folder_of_part(k);
    job.watch.time("write", [&] {
      SM::write_surfaces(job.folder.file("surface.json"), fits.surfaces);
      SM::write_ply(job.folder.file("surface.ply"), SM::joined(std::move(tessellations), names));
    });
    if (has_report)
      job.watch.time("report", [&] {
        write_page(job.folder.file("report.html"), completed(shown, "fit_mesh", job.watch), maps,
                   fits.surfaces, fits.reports);
      });
    shown = completed(std::move(shown), "fit_mesh", job.watch);
    write_metrics(job.folder.file("metrics.json"), shown);
  }
  throw_if_interrupted();
  job.folder.commit();

  if (!has_report && !is_quiet)
    say("fit_mesh", "no report.html: zlib or three.js was missing when fit_mesh was built");
  if (!is_quiet) std::cout << figures(shown) << std::flush;
  int status = SM::number_of_values(fits.surfaces) == maps.size() ? SUCCESS : PARTLY_SERVED;
  std::vector<Part_message> not_reached;
  const auto say_not_reached = [&](std::size_t k, const std::string& what) {
    not_reached.push_back({is_one ? "" : maps[k].name, what + "; the files are written"});
  };
  for (std::size_t k = 0; k < maps.size(); ++k)
    if (fits.surfaces[k].has_value()) {
      const SM::Fit_report& report = fits.reports[k];
      if (!fits.metrics[k]["tolerance_reached"])
        say_not_reached(k, "the tolerance was not reached: " + fits.errors[k]);
      else if (!written_is_within_tolerance[k])
        say_not_reached(k, "surface.ply is farther from the mesh than the tolerance");
      if (report.folds > 0) say_not_reached(k, folds_sentence(report));
    }
  say_of_parts("fit_mesh", not_reached);
  if (!not_reached.empty()) status = TOLERANCE_NOT_REACHED;
  return status;
}

template <class Bump>
int fit_hierarchical(Job& job, Parts maps, const Bump& bump)
{
  const Fit_request& request = job.request;
  Fits<SM::Any_surface<Bump>> fits;
  const auto fit = [&] {
    fits.surfaces = job.watch.time("fit", [&] {
      return SM::fit_components<CGAL::Parallel_if_available_tag>(
        maps, SM::parameters::rms_error(request.average)
                .max_error(request.maximum)
                .bump(bump)
                .spline_degree(request.degree)
                .max_controls(std::size_t(request.controls))
                .marking(request.marking)
                .joint_solve(request.joint)
                .fairness(request.fairness)
                .fit_target(request.target)
                .crease_angle(request.crease_angle)
                .fit_reports(std::ref(fits.reports))
                .visitor(std::ref(job.progress)));
    });
  };
  fit();
  if (job.options.get<bool>("correct-parameters")) {
    job.watch.time("correct", [&] {
      for_each_part(maps, [&](auto& part, std::size_t k) {
        if (!fits.surfaces[k].has_value()) return;
        std::optional<Parts::value_type::Value> corrected;
        visit_both(part.value(), fits.surfaces[k].value(), [&](const auto& map, const auto& surface) {
          corrected.emplace(SM::correct_parameters(map, surface));
        });
        part.value() = std::move(*corrected);
      });
    });
    fit();
  }

  Json parameters = parameters_of(job);
  parameters.update({{"max_controls", request.controls},
                     {"fairness", request.fairness},
                     {"target", job.options.get<std::string>("target")},
                     {"crease_angle", request.crease_angle},
                     {"marking", job.options.get<std::string>("marking")},
                     {"economy", job.options.get<bool>("economy")},
                     {"correct_parameters", job.options.get<bool>("correct-parameters")}});
  const bool only_vertices = request.marking == SM::Marking::VERTICES;
  std::vector<Part_message> messages;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const SM::Fit_report& report = fits.reports[k];
    if (report.has_more_controls_than_vertices() && !job.options.get<bool>("quiet"))
      messages.push_back({maps.size() == 1 ? "" : maps[k].name,
                          std::to_string(report.controls) + " controls for a mesh of " +
                            std::to_string(report.vertices) +
                            " vertices: the surface reproduces facets; a larger tolerance" +
                            (only_vertices ? " needs fewer" : " or --marking vertices needs fewer")});
    fits.metrics.push_back(metrics_of_surface(report));
    fits.errors.push_back(std::string(only_vertices ? "at vertices " : "") + "rms error " +
                          shown(only_vertices ? report.vertex_rms_error : report.rms_error) + " (tolerance " +
                          shown(request.average) + "), max " +
                          shown(only_vertices ? report.vertex_max_error : report.max_error) + " (tolerance " +
                          shown(request.maximum) + ") of the diagonal, " + std::to_string(report.controls) +
                          " controls" + reason(report));
  }
  say_of_parts("fit_mesh", messages);
  return write(job, maps, std::move(fits), parameters);
}

int fit_patches(Job& job, const Parts& maps)
{
  const Fit_request& request = job.request;
  using Any_stack = SM::Any_surface<SM::Smoothstep_bump<2>, SM::Patch_stack_embedding>;
  Fits<Any_stack> fits;
  for (const auto& part : maps) {
    SM::Patch_fit_report report;
    std::variant<Any_stack, SM::Error> result(std::in_place_index<1>, SM::Error_code::numeric_failure, "");
    try {
      if (!part.has_value()) throw SM::Error(part.error());
      result = std::visit(
        [&](const auto& map) -> Any_stack {
          return job.watch.time("fit", [&] {
            return SM::fit_patch_surface<CGAL::Parallel_if_available_tag>(
              map, SM::parameters::average_delta(request.average)
                     .max_delta(request.maximum)
                     .spline_degree(request.degree)
                     .max_patches(request.patches)
                     .patch_fit_report(std::ref(report))
                     .visitor(std::ref(job.progress)));
          });
        },
        part.value());
    } catch (const SM::Error& e) {
      result = SM::Error(e);
    }
    fits.surfaces.emplace_back(part, std::move(result));
    Json metrics = metrics_of_surface(report.surface);
    double average = 0, maximum = 0;
    for (std::size_t c = 0; c < report.charts.size(); ++c) {
      const SM::Patch_fit_report::Chart& chart = report.charts[c];
      metrics["charts"][c].update({{"patches", chart.patches},
                                   {"bins_per_side", chart.bins_per_side},
                                   {"has_fewer_bins", chart.has_fewer_bins},
                                   {"average_delta", chart.average_delta},
                                   {"max_delta", chart.max_delta},
                                   {"tolerance_reached", chart.tolerance_reached}});
      average = (std::max)(average, chart.average_delta);
      maximum = (std::max)(maximum, chart.max_delta);
    }
    fits.metrics.push_back(std::move(metrics));
    fits.reports.push_back(report.surface);
    fits.errors.push_back("weighted error of a chart at vertices " + shown(average) +
                          " on average (tolerance " + shown(request.average) + "), max " + shown(maximum) +
                          " (tolerance " + shown(request.maximum) + "), rms error " +
                          shown(report.surface.rms_error) + " of the diagonal, " +
                          std::to_string(report.surface.controls) + " controls");
  }
  Json parameters = parameters_of(job);
  parameters["max_patches"] = request.patches;
  return write(job, maps, std::move(fits), parameters);
}

} // namespace

int main(int argc, char** argv)
{
  return run("fit_mesh", [&]() -> int {
    Command_line options(
      "fit_mesh INPUT -o DIR [options]",
      "Fits a smooth surface to a mesh (OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF, COLLADA, with "
      "assimp\n"
      "glTF; closed of genus 0 or 1, or a disk) and writes into DIR, with coordinates in the units of the "
      "file:\n"
      "map.ply (a map that suits the fit: angles before areas), surface.json, surface.ply,\n"
      "metrics.json, report.html (all this for a browser) and, with --samples, samples.csv.\n"
      "Of several bodies each has its files in DIR/part-1 (the largest), DIR/part-2, ...; surface.json,\n"
      "surface.ply, metrics.json and report.html in DIR are of all of them.\n"
      "With --method paper both the map and the fit are those of Grimm 2002.\n"
      "Exit status: 0 success, 1 tolerance not reached, or some bodies could not be served (the files are\n"
      "written), 2 usage, or files cannot be written, 3 unreadable input, 4 unsupported topology or "
      "geometry\n"
      "of all bodies, or too little memory, 129, 130 or 143 ended by SIGHUP, ctrl-C or kill. Above 1 no "
      "file\n"
      "is written.");
    options.add("surface", po::value<std::string>(),
                "what is fitted: hierarchical (splines), or patches (Grimm 2002, 7 x 7 controls each);\n"
                "default: hierarchical, with --method paper patches");
    options.add("max-patches", po::value<int>()->default_value(16), "limit of the patches of a chart");
    options.add("tolerance", po::value<double>()->default_value(2e-3, "0.002"),
                "error allowed, fraction of the bounding box diagonal: root mean square, or for patches the\n"
                "average of the weighted errors of a chart at its vertices");
    options.add("max-tolerance", po::value<double>(),
                "largest error allowed, likewise (default: 10 times that)");
    options.add("degree", po::value<int>()->default_value(3), "degree of the splines, 2 to 5");
    options.add("smoothness", po::value<int>()->default_value(2), "smoothness of the blend, 1 to 3");
    options.add("max-controls", po::value<long>()->default_value(0),
                "limit of the number of controls; 0: four for each vertex, from 10000 to 200000");
    options.add(
      "target", po::value<std::string>()->default_value("automatic"),
      "what the errors are measured from: facets (of the mesh), curved (the smooth surface that its\n"
      "vertices are samples of) or automatic (the same with creases)");
    options.add("crease-angle", po::value<double>()->default_value(40),
                "edges with a larger angle between the normals of their faces stay creases, degrees");
    options.add("marking", po::value<std::string>()->default_value("all"),
                "what has to be within the tolerance: all (the whole mesh) or vertices (fewer controls)");
    options.add("economy", po::bool_switch(), "fewer controls for the same largest error, more time");
    options.add("fairness", po::value<double>()->default_value(0),
                "weight of the thin plate energy against noise; that of the mean squared error is 1");
    options.add("correct-parameters", po::bool_switch(),
                "move the vertices in the domain to where the surface is closest, and fit once more");
    options.add("samples", po::value<long>()->default_value(0),
                "write this many random points of the surface");
    options.parse(argc, argv);
    const Fit_request request = fit_request(options);
    const std::size_t asked = asked_parts(options);
    require_outputs(options, request, 1);

    Stopwatch watch;
    const Input input = watch.time("read", [&] { return read_input(options); });
    const std::vector<Mesh::Vertex_index> square_corners = corners(options, input);
    require_outputs(options, request, (std::min)(asked, input.topology.components));
    SM::Atomic_folder folder(options.get<std::string>("output"));
    Progress progress(options.get<bool>("quiet"));
    std::vector<Json> partitions;
    Parts maps = watch.time("map", [&] {
      return map_parts(options, input, SM::map_options_for_fitting(), square_corners, partitions, progress);
    });
    if (SM::number_of_values(maps) == 0) report_errors("fit_mesh", maps, input); // throws
    Job job{options, request, input, partitions, folder, progress, watch};
    if (request.is_patches) return fit_patches(job, maps);
    if (request.smoothness == 2) // the fastest
      return fit_hierarchical(job, std::move(maps), SM::Smoothstep_bump<2>());
    return fit_hierarchical(job, std::move(maps), SM::Any_smoothstep_bump(request.smoothness));
  });
}
