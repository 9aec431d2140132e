#include "fit_figures.h"

#include <Eigen/Core>

#include <cstddef>
#include <utility>

namespace tools {

namespace {

Json metrics_of_errors(const SM::Fit_errors& e)
{
  return {{"rms_error", e.rms_error},
          {"max_error", e.max_error},
          {"closest_point_rms", e.closest_point_rms},
          {"closest_point_max", e.closest_point_max},
          {"normal_deviation", e.normal_deviation},
          {"chart_disagreement", e.chart_disagreement}};
}

} // namespace

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
  metrics["folded_points"] = report.folded_points;
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

std::string reason(const SM::Fit_report& report)
{
  const Eigen::Vector3d& x = report.worst_point;
  const std::string what = report.stop == SM::Fit_stop::CONTROLS     ? ", their limit"
                           : report.stop == SM::Fit_stop::STAGNATION ? ", and more did not help"
                                                                     : ", with the smallest cells";
  return what + "; the largest error is near (" + shown(x[0]) + ", " + shown(x[1]) + ", " + shown(x[2]) + ")";
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

bool is_within_tolerance(const Fit_request& request, const SM::Fit_report& report, const Json& written,
                         double chord_error)
{
  if (request.is_patches || request.marking == SM::Marking::VERTICES) return true;
  for (const char* way : {"mesh_to_surface", "surface_to_mesh"})
    if (written[way]["max"] > request.maximum + report.target_max + chord_error) return false;
  return written["mesh_to_surface"]["rms"] <= request.average + report.target_rms + chord_error;
}

} // namespace tools
