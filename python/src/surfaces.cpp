// The class Surface: fits, files, measures.

#include "objects.h"

#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace simple_manifolds_python {

namespace {

using Parallel = CGAL::Parallel_if_available_tag;

SM::Fit_options fit_options(const py::dict& d)
{
  SM::Fit_options o;
  o.rms_error = option<double>(d, "rms_error");
  o.max_error = d["max_error"].is_none() ? 10 * o.rms_error : option<double>(d, "max_error");
  o.spline_degree = option<int>(d, "degree");
  o.max_controls = d["max_controls"].is_none() ? 0 : option<std::size_t>(d, "max_controls");
  o.refinement =
    choice<SM::Refinement>(option<std::string>(d, "refinement"), "refinement",
                           {{"adaptive", SM::Refinement::ADAPTIVE}, {"uniform", SM::Refinement::UNIFORM}});
  o.joint_solve = choice<SM::Joint_solve>(option<std::string>(d, "joint_solve"), "joint_solve",
                                          {{"at_end", SM::Joint_solve::AT_END},
                                           {"always", SM::Joint_solve::ALWAYS},
                                           {"never", SM::Joint_solve::NEVER}});
  o.marking =
    choice<SM::Marking>(option<std::string>(d, "marking"), "marking",
                        {{"all_points", SM::Marking::ALL_POINTS}, {"vertices", SM::Marking::VERTICES}});
  o.target = choice<SM::Fit_target>(option<std::string>(d, "target"), "target",
                                    {{"automatic", SM::Fit_target::AUTOMATIC},
                                     {"facets", SM::Fit_target::FACETS},
                                     {"curved", SM::Fit_target::CURVED}});
  o.effort = choice<SM::Fit_effort>(option<std::string>(d, "fit_effort"), "fit_effort",
                                    {{"fast", SM::Fit_effort::FAST}, {"compact", SM::Fit_effort::COMPACT}});
  o.crease_angle = option<double>(d, "crease_angle");
  const double noise = option<double>(d, "noise_level");
  require(noise >= 0 && noise <= 1, "noise_level has to be in [0, 1]");
  o.set_noise_level(noise);
  if (!d["fairness"].is_none()) o.fairness = option<double>(d, "fairness");
  if (!d["vertex_weights"].is_none())
    o.vertex_weights = Rows<double>(option<Doubles>(d, "vertex_weights"), "vertex_weights").vector();
  const auto in_range = [](double x, double most) { return x >= 0 && x <= most; };
  require(in_range(o.rms_error, 1e300) && in_range(o.max_error, 1e300),
          "rms_error and max_error have to be finite and not negative");
  require(o.spline_degree >= 2 && o.spline_degree <= 5, "degree has to be in 2..5");
  require(in_range(o.fairness, 1), "fairness has to be in [0, 1]");
  require(in_range(o.crease_angle, 180), "crease_angle has to be in [0, 180]");
  for (const double w : o.vertex_weights)
    require(in_range(w, 1e300), "vertex_weights have to be finite, not negative");
  return o;
}

Surface fit(const Map& map, const py::dict& dict, py::object progress)
{
  const SM::Fit_options o = fit_options(dict);
  const auto side = static_cast<std::size_t>(4 + o.spline_degree);
  Python_visitor visitor(std::move(progress));
  return map.visit([&](const auto& m) {
    const auto least = static_cast<std::size_t>(m.atlas().number_of_charts()) * side * side;
    if (o.max_controls != 0 && o.max_controls < least)
      wrong("max_controls has to be at least " + std::to_string(least) + " here");
    if (!o.vertex_weights.empty() && o.vertex_weights.size() != m.number_of_vertices())
      wrong("there have to be as many vertex_weights as vertices of the map: " +
            std::to_string(m.number_of_vertices()));
    SM::Fit_report report;
    std::optional<std::decay_t<decltype(m)>> fitted;
    SM::Any_surface<> surface = without_lock([&]() -> SM::Any_surface<> {
      return SM::fit_surface<Parallel>(m, SM::parameters::rms_error(o.rms_error)
                                            .max_error(o.max_error)
                                            .spline_degree(o.spline_degree)
                                            .max_controls(o.max_controls)
                                            .refinement(o.refinement)
                                            .joint_solve(o.joint_solve)
                                            .marking(o.marking)
                                            .fairness(o.fairness)
                                            .fit_target(o.target)
                                            .crease_angle(o.crease_angle)
                                            .fit_effort(o.effort)
                                            .vertex_weights(o.vertex_weights)
                                            .fit_report(std::ref(report))
                                            .fitted_map(std::ref(fitted))
                                            .visitor(std::ref(visitor)));
    });
    return Surface(std::move(surface), o.rms_error, std::move(report),
                   fitted ? Map(SM::Any_map(std::move(*fitted)), map.outer()) : map);
  });
}

template <class F>
auto value_of(const F& f)
{
  return [f](const Surface& self) { return self.visit(f); };
}

} // namespace

void add_surfaces(py::module_& m)
{
  using Report = SM::Fit_report;
  py::class_<Report>(
    m, "FitReport",
    "How well a surface was fitted. Errors are fractions of the diagonal of the bounding box, at the "
    "vertices and at three points in each face.")
    .def_readonly("tolerance_reached", &Report::tolerance_reached,
                  "Whether rms_error and max_error are small enough.")
    .def_property_readonly(
      "stop", [](const Report& r) { return name_of(r.stop); },
      "Why it ended: 'tolerance', 'controls', 'stagnation' or 'resolution'.")
    .def_property_readonly(
      "rms_error", [](const Report& r) { return r.rms_error; }, "Root mean square of |E - M|.")
    .def_property_readonly(
      "max_error", [](const Report& r) { return r.max_error; }, "The largest |E - M|.")
    .def_property_readonly(
      "closest_point_rms", [](const Report& r) { return r.closest_point_rms; },
      "Root mean square of the distance from the surface.")
    .def_property_readonly(
      "closest_point_max", [](const Report& r) { return r.closest_point_max; }, "The largest such distance.")
    .def_property_readonly(
      "normal_deviation", [](const Report& r) { return r.normal_deviation; },
      "Root mean square angle between the normals of surface and face, radians.")
    .def_readonly("rms_tolerance", &Report::rms_tolerance, "What rms_error was to be.")
    .def_readonly("max_tolerance", &Report::max_tolerance, "What max_error was to be.")
    .def_readonly("vertex_rms_error", &Report::vertex_rms_error, "Of the vertices alone.")
    .def_readonly("vertex_max_error", &Report::vertex_max_error, "Of the vertices alone.")
    .def_readonly("target_rms", &Report::target_rms,
                  "How far the target is from the facets, root mean square.")
    .def_readonly("target_max", &Report::target_max, "The largest such distance.")
    .def_readonly("controls", &Report::controls, "Coefficients of all charts, each a point of space.")
    .def_readonly("vertices", &Report::vertices, "Of the mesh, for comparison.")
    .def_readonly("folds", &Report::folds, "Faces over which the surface turns over.")
    .def_readonly("folded_points", &Report::folded_points,
                  "Points at which it shows its other side, of 25 in each cell.")
    .def_property_readonly(
      "worst_point",
      [](const Report& r) { return take(std::vector<Eigen::Vector3d>{r.worst_point}).attr("reshape")(3); },
      "The point of the mesh where the error is max_error.")
    .def_property_readonly(
      "levels",
      [](const Report& r) {
        py::list list;
        for (const Report::Level& l : r.levels)
          list.append(py::make_tuple(l.controls, l.rms_error, l.max_error));
        return list;
      },
      "Per step of the refinement (controls, rms_error, max_error).")
    .def_property_readonly(
      "seconds", [](const Report& r) { return r.seconds.total; }, "Wall clock.")
    .def("__repr__", [](const Report& r) {
      return std::string("<simple_manifolds.FitReport: ") + (r.tolerance_reached ? "within" : "not within") +
             " the tolerances, rms error " + std::to_string(r.rms_error) + " of the diagonal, " +
             std::to_string(r.controls) + " controls>";
    });

  py::class_<Surface>(
    m, "Surface", "A smooth surface over a canonical surface, twice differentiable by default. Immutable.")
    .def_property_readonly(
      "domain", value_of([](const auto& s) { return std::string(std::decay_t<decltype(s)>::Atlas::name); }),
      "The canonical surface: 'plane' (the square), 'sphere', 'torus' or 'hyperbolic'.")
    .def_property_readonly("genus", value_of([](const auto& s) { return long(s.atlas().genus()); }),
                           "Number of handles.")
    .def_property_readonly("number_of_charts",
                           value_of([](const auto& s) { return s.atlas().number_of_charts(); }),
                           "Of the atlas of the canonical surface.")
    .def_property_readonly("smoothness", value_of([](const auto& s) { return s.smoothness(); }),
                           "The number of continuous derivatives.")
    .def_property_readonly("tolerance", &Surface::tolerance,
                           "The rms_error that it was fitted to; 0: unknown.")
    .def_property_readonly("report", &Surface::report,
                           "What came of the fit; None for a surface from a file.")
    .def_property_readonly(
      "map", &Surface::map,
      "The map that it suits: the one that it was fitted to, or with fit_effort 'compact' another "
      "one of the same mesh; None for a surface from a file.")
    .def(
      "random_domain_points",
      [](const Surface& self, std::size_t n, std::uint64_t seed) {
        return self.visit(
          [&](const auto& s) -> py::array { return take(SM::random_domain_points(n, seed, s.atlas())); });
      },
      py::arg("n"), py::arg("seed") = 0,
      "Points of the domain, evenly distributed, the same on every machine.")
    .def(
      "chart_points",
      [](const Surface& self, const Doubles& domain_points) {
        return self.visit([&](const auto& s) {
          using Atlas = typename std::decay_t<decltype(s)>::Atlas;
          const Domain_rows<Atlas> p(domain_points, "domain_points");
          require_domain_points(p, s.atlas());
          std::vector<int> charts(p.size());
          std::vector<Eigen::Vector2d> uv(p.size());
          for (std::size_t i = 0; i < p.size(); ++i) {
            const SM::Chart_point q = s.best_chart_point(s.atlas().query(p[i]));
            charts[i] = q.chart;
            uv[i] = q.uv;
          }
          return py::make_tuple(take(std::move(charts)), take(std::move(uv)));
        });
      },
      py::arg("domain_points"), "The best charts of points, and the coordinates there: (charts, uv).")
    .def(
      "save",
      [](const Surface& self, const std::filesystem::path& file) {
        without_lock([&] {
          self.visit([&](const auto& s) {
            SM::write_surface(file.string(), s, SM::parameters::rms_error(self.tolerance()));
          });
        });
      },
      py::arg("file"),
      "Writes JSON, or CBOR if the name ends in .cbor; load_surface() reads either, bit for bit.")
    .def("__repr__", value_of([](const auto& s) {
           return std::string("<simple_manifolds.Surface over the ") +
                  std::decay_t<decltype(s)>::Atlas::name + ", C" + std::to_string(s.smoothness()) + ">";
         }));
  m.def("fit", &fit, py::arg("map"), py::arg("options"), py::arg("progress"));
  m.def(
    "load_surface",
    [](const std::string& file) {
      return without_lock([&] {
        const double tolerance = SM::read_surface_header(file).tolerance;
        return Surface(SM::read_any_surface(file), tolerance);
      });
    },
    py::arg("file"));
}

} // namespace simple_manifolds_python
