// Triangle meshes of surfaces, and the files of them.

#include "objects.h"

#include <CGAL/Simple_manifolds/IO/Charted_mesh.h>
#include <CGAL/Simple_manifolds/IO/write_gltf.h>
#include <CGAL/Simple_manifolds/IO/write_obj.h>
#include <CGAL/Simple_manifolds/IO/write_ply.h>
#include <CGAL/Simple_manifolds/IO/write_vtp.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>

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

// The criteria that were given; lengths are fractions of the diagonal.
template <class S>
class Given_sizing {
public:
  Given_sizing(const S& surface, std::optional<double> chord_error, std::optional<double> edge_length)
  {
    const double unit = SM::surface_diagonal(surface);
    if (chord_error) chord_.emplace(surface, *chord_error, unit);
    if (edge_length) edge_.emplace(surface, *edge_length, unit);
  }

  void operator()(const SM::Domain_triangulation<typename S::Atlas>& t, const std::vector<int>& faces,
                  std::vector<double>& excess) const
  {
    std::vector<double> other(faces.size());
    std::fill(excess.begin(), excess.end(), 0.);
    const auto add = [&](const auto& sizing) {
      if (!sizing) return;
      (*sizing)(t, faces, other);
      for (std::size_t i = 0; i < excess.size(); ++i)
        excess[i] = std::isnan(other[i]) ? other[i] : (std::max)(excess[i], other[i]);
    };
    add(chord_);
    add(edge_);
  }

private:
  std::optional<SM::Chord_error<S>> chord_;
  std::optional<SM::Edge_length<S>> edge_;
};

struct Tessellation : SM::Charted_mesh {
  bool criteria_met = true;
};

Tessellation tessellate(const Surface& self, std::optional<double> chord_error,
                        std::optional<double> edge_length, std::optional<int> subdivisions,
                        std::optional<std::size_t> max_faces)
{
  const auto is_positive = [](const std::optional<double>& x) { return !x || (*x > 0 && std::isfinite(*x)); };
  require(is_positive(chord_error) && is_positive(edge_length),
          "chord_error and edge_length have to be positive");
  require(!subdivisions || (*subdivisions >= 1 && *subdivisions <= 1 << 14),
          "subdivisions has to be in 1..16384");
  return without_lock([&] {
    return self.visit([&](const auto& surface) {
      using S = std::decay_t<decltype(surface)>;
      using Grid = SM::Tile_grid<typename S::Atlas>;
      Tessellation result;
      SM::Charted_mesh& mesh = result;
      const auto cells = [&](double n) {
        return subdivisions ? *subdivisions : Grid::subdivisions_for(n, surface.atlas());
      };
      if (!chord_error && !edge_length) {
        mesh = SM::charted_tessellation(surface, SM::parameters::subdivisions(cells(6000)));
        return result;
      }
      SM::Tessellation_report report;
      mesh = SM::charted_tessellation(
        surface, SM::parameters::sizing(Given_sizing<S>(surface, chord_error, edge_length))
                   .subdivisions(cells(96))
                   .max_faces(max_faces.value_or(SM::default_max_faces))
                   .tessellation_report(std::ref(report)));
      result.criteria_met = report.is_fine_enough;
      return result;
    });
  });
}

Tessellation charted_mesh(const Map& self)
{
  return without_lock([&] {
    return self.visit([&](const auto& map) {
      Tessellation result;
      static_cast<SM::Charted_mesh&>(result) = SM::charted_mesh(map);
      return result;
    });
  });
}

void save(const Tessellation& self, const std::filesystem::path& path)
{
  require(self.is_valid(), "the mesh is not complete");
  const std::string file = path.string(), extension = path.extension().string();
  without_lock([&] {
    if (extension == ".ply")
      SM::write_ply(file, self);
    else if (extension == ".glb")
      SM::write_gltf(file, self);
    else if (extension == ".vtp")
      SM::write_vtp(file, self);
    else if (extension == ".obj")
      SM::write_obj(file, self);
    else
      throw SM::IO_error(SM::Error_code::unsupported_format, file,
                         "no format of meshes; there are .ply, .glb, .obj and .vtp");
  });
}

template <class T>
auto array_of(std::vector<T> SM::Charted_mesh::*member)
{
  return [member](const py::object& self) { return view(self.cast<const Tessellation&>().*member, self); };
}

} // namespace

void add_tessellations(py::module_& m)
{
  py::class_<Tessellation>(m, "Tessellation",
                           "A triangle mesh with its places in the charts. The arrays are read-only.")
    .def_property_readonly("vertices", array_of(&SM::Charted_mesh::points), "Positions, shape (n, 3).")
    .def_property_readonly("faces", array_of(&SM::Charted_mesh::triangles), "Triangles, shape (m, 3).")
    .def_property_readonly("normals", array_of(&SM::Charted_mesh::normals),
                           "Exact unit normals of the surface, shape (n, 3); empty for the mesh of a map.")
    .def_property_readonly("face_charts", array_of(&SM::Charted_mesh::charts), "Per triangle a chart, or -1.")
    .def_property_readonly(
      "charts",
      [](const Tessellation& t) {
        std::vector<int> charts;
        for (const SM::Chart_point& p : t.chart_points) charts.push_back(p.chart);
        return take(std::move(charts));
      },
      "Per vertex a chart.")
    .def_property_readonly(
      "uv",
      [](const Tessellation& t) {
        std::vector<Eigen::Vector2d> uv;
        for (const SM::Chart_point& p : t.chart_points) uv.push_back(p.uv);
        return take(std::move(uv));
      },
      "Per vertex the coordinates in that chart, shape (n, 2).")
    .def_property_readonly(
      "fields",
      [](const py::object& self) {
        py::dict fields;
        for (const SM::Charted_mesh::Field& f : self.cast<const Tessellation&>().fields)
          fields[py::str(f.name)] = view(f.values, self);
        return fields;
      },
      "Values per vertex: mean_curvature, gaussian_curvature, domain_x, ...")
    .def_readonly("criteria_met", &Tessellation::criteria_met, "Whether max_faces sufficed.")
    .def("save", &save, py::arg("file"), "Writes .ply, .glb (glTF), .obj or .vtp.")
    .def("__repr__", [](const Tessellation& t) {
      return "<simple_manifolds.Tessellation of " + std::to_string(t.points.size()) + " vertices and " +
             std::to_string(t.triangles.size()) + " faces>";
    });
  m.def("tessellate", &tessellate, py::arg("surface"), py::arg("chord_error"), py::arg("edge_length"),
        py::arg("subdivisions"), py::arg("max_faces"));
  m.def("charted_mesh", &charted_mesh, py::arg("map"));
}

} // namespace simple_manifolds_python
