#include "cad_export.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>

namespace tools {

namespace {

const char* const cad_option_names[] = {"cad-tolerance", "max-faces", "face-cost", "unit",   "scale",
                                        "name",          "colour",    "schema",    "metrics"};

std::string shown_place(const Eigen::Vector3d& x)
{
  return "(" + shown(x[0]) + ", " + shown(x[1]) + ", " + shown(x[2]) + ")";
}

/// Three numbers from 0 to 1.
Eigen::Vector3d colour_of(const std::string& text)
{
  std::istringstream in(text);
  Eigen::Vector3d c;
  char comma = ',', more;
  for (int k = 0; k < 3; ++k)
    if ((k > 0 && !(in >> comma && comma == ',')) || !(in >> c[k]) || !(c[k] >= 0 && c[k] <= 1))
      throw po::error("--colour must be three numbers from 0 to 1: r,g,b");
  if (in >> more) throw po::error("--colour must be three numbers from 0 to 1: r,g,b");
  return c;
}

} // namespace

void add_cad_options(po::options_description& options)
{
  options.add_options()(
    "cad-tolerance", po::value<double>(),
    ".step: the largest deviation from the surface, fraction of the diagonal (default: half the\n"
    "tolerance of the fit)")("max-faces", po::value<long>(),
                             ".step: limit of the number of faces; 6 at least of a sphere, 1 of a torus or a "
                             "square, 6 (g - 1) of genus g")(
    "face-cost", po::value<double>()->default_value(500),
    ".step: the number of controls that a face is worth")(
    "unit", po::value<std::string>()->default_value("mm"),
    ".step: unit of the coordinates: mm, cm, m or inch")("scale", po::value<double>()->default_value(1),
                                                         ".step: coordinates are multiplied by it")(
    "name", po::value<std::string>(), ".step: name of the body (default: that of the file)")(
    "colour", po::value<std::string>(), ".step: r,g,b from 0 to 1")(
    "schema", po::value<std::string>()->default_value("ap214"), ".step: ap214 or ap242")(
    "metrics", po::value<std::string>(), ".step: JSON file for what is known of the faces");
}

std::string given_cad_option(const po::variables_map& values)
{
  for (const char* name : cad_option_names)
    if (values.count(name) && !values[name].defaulted()) return name;
  return {};
}

Cad_request cad_request(const po::variables_map& values)
{
  Cad_request r;
  r.cad.tolerance = values.count("cad-tolerance") ? values["cad-tolerance"].as<double>() : 0;
  if (values.count("cad-tolerance") && !(r.cad.tolerance >= 1e-7 && r.cad.tolerance <= 1))
    throw po::error("--cad-tolerance must be from 0.0000001 to 1");
  r.cad.face_cost = values["face-cost"].as<double>();
  if (!(r.cad.face_cost >= 0 && r.cad.face_cost <= 1e9)) throw po::error("--face-cost must be from 0 to 1e9");
  if (values.count("max-faces")) {
    const long n = values["max-faces"].as<long>();
    if (n < 1) throw po::error("--max-faces must be at least 1");
    r.cad.max_faces = std::size_t(n);
  }
  r.step.scale = values["scale"].as<double>();
  if (!(r.step.scale > 0 && std::isfinite(r.step.scale))) throw po::error("--scale must be positive");
  const std::string unit = values["unit"].as<std::string>(), schema = values["schema"].as<std::string>();
  if (unit != "mm" && unit != "cm" && unit != "m" && unit != "inch")
    throw po::error("--unit is one of mm, cm, m, inch");
  r.step.unit = unit == "mm"   ? SM::Step_unit::MILLIMETRE
                : unit == "cm" ? SM::Step_unit::CENTIMETRE
                : unit == "m"  ? SM::Step_unit::METRE
                               : SM::Step_unit::INCH;
  if (schema != "ap214" && schema != "ap242") throw po::error("--schema is one of ap214, ap242");
  r.step.schema = schema == "ap214" ? SM::Step_schema::AP214 : SM::Step_schema::AP242;
  if (values.count("colour")) r.step.colour = colour_of(values["colour"].as<std::string>());
  r.name = values.count("name") ? values["name"].as<std::string>()
                                : std::filesystem::path(values["output"].as<std::string>()).stem().string();
  if (values.count("metrics")) r.metrics = values["metrics"].as<std::string>();
  return r;
}

Json metrics_of_cad(const SM::Cad_report& r, const SM::Cad_options& cad, const SM::Step_options& step)
{
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  const char* stop = r.stop == SM::Cad_stop::TOLERANCE  ? "tolerance"
                     : r.stop == SM::Cad_stop::CONTROLS ? "controls"
                                                        : "resolution";
  Json m = {{"tolerance", cad.tolerance},
            {"tolerance_reached", r.tolerance_reached},
            {"stop", stop},
            {"faces", r.faces},
            {"edges", r.edges},
            {"controls", r.controls},
            {"functions", r.functions},
            {"levels", r.levels},
            {"diagonal", r.diagonal},
            {"size_mm", r.diagonal * step.scale * SM::millimetres(step.unit)},
            {"max_deviation", r.max_deviation},
            {"rms_deviation", r.rms_deviation},
            {"worst_point", {r.worst_point[0], r.worst_point[1], r.worst_point[2]}},
            {"largest_angle", r.largest_angle},
            {"largest_curvature_jump", r.largest_curvature_jump},
            {"area", r.area},
            {"surface_area", number(r.surface_area)},
            {"volume", r.volume},
            {"surface_volume", number(r.surface_volume)},
            {"smallest_sine", r.smallest_sine},
            {"singular_points", r.singular_points},
            {"singular_places", Json::array()},
            {"self_intersections", r.self_intersections},
            {"intersecting_pairs", r.intersecting_pairs},
            {"intersection_places", Json::array()}};
  for (const Eigen::Vector3d& x : r.singular_places) m["singular_places"].push_back({x[0], x[1], x[2]});
  for (const Eigen::Vector3d& x : r.intersection_places)
    m["intersection_places"].push_back({x[0], x[1], x[2]});
  return m;
}

std::string cad_figures(const std::string& file, const Cad_parts& parts)
{
  std::string text;
  for (std::size_t k = 0; k < parts.bodies.size(); ++k) {
    const SM::Cad_report& r = parts.reports[k];
    text += (parts.bodies.size() == 1 ? file : parts.bodies[k].name) + ": " +
            (parts.bodies[k].surface.is_closed() ? "solid" : "shell") + " of " + std::to_string(r.faces) +
            (r.faces == 1 ? " face, " : " faces, ") + std::to_string(r.controls) +
            " controls; deviation rms " + shown(r.rms_deviation) + ", max " + shown(r.max_deviation) +
            " of the diagonal; over edges " + shown(r.largest_angle) + " degrees, curvature " +
            shown(r.largest_curvature_jump) + "\n";
  }
  return text;
}

std::vector<std::string> cad_warnings(const SM::Cad_report& r, double tolerance, const SM::Step_options& step)
{
  std::vector<std::string> list;
  if (!r.tolerance_reached)
    list.push_back("the tolerance was not reached: deviation rms " + shown(r.rms_deviation) + ", max " +
                   shown(r.max_deviation) + " (tolerance " + shown(tolerance) +
                   ") of the diagonal, the largest near " + shown_place(r.worst_point) +
                   (r.stop == SM::Cad_stop::CONTROLS     ? "; the limit of controls is reached"
                    : r.stop == SM::Cad_stop::RESOLUTION ? "; cells cannot become smaller"
                                                         : ""));
  if (r.singular_points > 0)
    list.push_back("at " + std::to_string(r.singular_points) +
                   (r.singular_points == 1 ? " point" : " points") +
                   " the parameter lines are nearly parallel, so that CAD systems may find no normal, "
                   "first near " +
                   shown_place(r.singular_places.front()));
  if (r.self_intersections > 0)
    list.push_back("the surface meets itself at " + std::to_string(r.self_intersections) +
                   (r.self_intersections == 1 ? " place" : " places") + ", the largest near " +
                   shown_place(r.intersection_places.front()) +
                   ": CAD systems may fail to cut it or to unite it with other bodies");
  const double size = r.diagonal * step.scale * SM::millimetres(step.unit);
  if (size < 1 || size > 1e5)
    list.push_back("the body is " + shown(size) +
                   " mm large, which does not suit the tolerances of CAD systems: see --scale and --unit");
  return list;
}

} // namespace tools
