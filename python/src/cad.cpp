// CAD surfaces and STEP files.

#include "objects.h"

#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simple_manifolds_python {

namespace {

using Parallel = CGAL::Parallel_if_available_tag;

struct Cad {
  SM::Cad_surface surface;
  SM::Cad_report report;
};

void require_positive(double x, const char* message) { require(x > 0 && std::isfinite(x), message); }
void require_costs(double face_cost)
{
  require(face_cost >= 0 && std::isfinite(face_cost), "face_cost has to be finite and not negative");
}

Cad surface_to_cad(const Surface& self, double tolerance, double face_cost, std::size_t max_faces,
                   std::size_t max_controls, py::object progress)
{
  require_positive(tolerance, "tolerance has to be positive");
  require_costs(face_cost);
  Python_visitor visitor(std::move(progress));
  return self.visit([&](const auto& surface) -> Cad {
    return without_lock([&] {
      SM::Cad_report report;
      SM::Cad_surface cad = SM::cad_surface<Parallel>(surface, SM::parameters::cad_tolerance(tolerance)
                                                                 .face_cost(face_cost)
                                                                 .max_faces(max_faces)
                                                                 .max_controls(max_controls)
                                                                 .cad_report(std::ref(report))
                                                                 .visitor(std::ref(visitor)));
      return Cad{std::move(cad), report};
    });
  });
}

Cad map_to_cad(const Map& self, double rms_error, std::optional<double> max_error, double face_cost,
               std::size_t max_faces, std::size_t max_controls, py::object progress)
{
  require_positive(rms_error, "rms_error has to be positive");
  require_positive(max_error.value_or(1), "max_error has to be positive");
  require_costs(face_cost);
  Python_visitor visitor(std::move(progress));
  return self.visit([&](const auto& map) -> Cad {
    return without_lock([&] {
      SM::Cad_report report;
      SM::Cad_surface cad =
        SM::fit_cad_surface<Parallel>(map, SM::parameters::rms_error(rms_error)
                                             .max_error(max_error.value_or(10 * rms_error))
                                             .face_cost(face_cost)
                                             .max_faces(max_faces)
                                             .max_controls(max_controls)
                                             .cad_report(std::ref(report))
                                             .visitor(std::ref(visitor)));
      return Cad{std::move(cad), report};
    });
  });
}

void save_step(const Cad& self, const std::filesystem::path& file, const std::string& name,
               const std::string& unit, double scale, const std::string& schema)
{
  SM::Step_options o;
  o.unit = choice<SM::Step_unit>(unit, "unit",
                                 {{"mm", SM::Step_unit::MILLIMETRE},
                                  {"cm", SM::Step_unit::CENTIMETRE},
                                  {"m", SM::Step_unit::METRE},
                                  {"in", SM::Step_unit::INCH}});
  o.schema = choice<SM::Step_schema>(schema, "schema",
                                     {{"ap214", SM::Step_schema::AP214}, {"ap242", SM::Step_schema::AP242}});
  require_positive(scale, "scale has to be positive");
  o.scale = scale;
  without_lock([&] { SM::write_step(file.string(), {{name, self.surface}}, o); });
}

} // namespace

void add_cad(py::module_& m)
{
  using Report = SM::Cad_report;
  py::class_<Report>(m, "CadReport", "What came of a CAD surface. Deviations are fractions of `diagonal`.")
    .def_readonly("faces", &Report::faces, "Of the surface.")
    .def_readonly("edges", &Report::edges, "Of the surface.")
    .def_readonly("controls", &Report::controls, "Of all faces.")
    .def_readonly("diagonal", &Report::diagonal, "Of the bounding box.")
    .def_readonly("max_deviation", &Report::max_deviation, "The largest distance, at independent points.")
    .def_readonly("rms_deviation", &Report::rms_deviation, "Its root mean square.")
    .def_readonly("tolerance_reached", &Report::tolerance_reached, "By these deviations.")
    .def_readonly("largest_angle", &Report::largest_angle,
                  "Between normals of two faces on an edge, degrees.")
    .def_readonly("largest_curvature_jump", &Report::largest_curvature_jump,
                  "Of the mean curvature there, relative.")
    .def_readonly("has_searched_intersections", &Report::has_searched_intersections,
                  "Whether find_self_intersections() was called.")
    .def_readonly("self_intersections", &Report::self_intersections, "Places where the surface meets itself.")
    .def_readonly("area", &Report::area, "Of the faces.")
    .def_readonly("volume", &Report::volume, "Inside of them; 0: it is not closed.")
    .def_readonly("smallest_sine", &Report::smallest_sine, "Of the angle between the parameter lines.")
    .def_readonly("singular_points", &Report::singular_points, "Where CAD systems may find no normal.");
  py::class_<Cad>(m, "CadSurface", "Few B-spline faces with common edges: a solid, if it is closed.")
    .def_readonly("report", &Cad::report, "What came of it.")
    .def(
      "find_self_intersections",
      [](Cad& self) {
        SM::Cad_report report = self.report;
        without_lock([&] { SM::find_self_intersections(self.surface, report); });
        self.report = std::move(report);
        return take(std::vector<Eigen::Vector3d>(self.report.intersection_places));
      },
      "Where the surface meets itself: the middles of the largest places, at most ten, shape (n, 3). The "
      "report then has "
      "their number.")
    .def("save_step", &save_step, py::arg("file"), py::arg("name") = "surface", py::kw_only(),
         py::arg("unit") = "mm", py::arg("scale") = 1., py::arg("schema") = "ap214",
         "Writes a STEP file. unit: 'mm', 'cm', 'm' or 'in'; schema: 'ap214' or 'ap242'.");
  m.def("surface_to_cad", &surface_to_cad, py::arg("surface"), py::arg("tolerance"), py::arg("face_cost"),
        py::arg("max_faces"), py::arg("max_controls"), py::arg("progress"));
  m.def("map_to_cad", &map_to_cad, py::arg("map"), py::arg("rms_error"), py::arg("max_error"),
        py::arg("face_cost"), py::arg("max_faces"), py::arg("max_controls"), py::arg("progress"));
}

} // namespace simple_manifolds_python
