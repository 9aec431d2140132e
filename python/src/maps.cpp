// The class Map.

#include "objects.h"

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace simple_manifolds_python {

namespace {

template <class Location>
class Location_writer { // an output iterator
public:
  Location_writer(int* face, Eigen::Vector3d* barycentric) : face_(face), barycentric_(barycentric) {}
  Location_writer& operator*() { return *this; }
  Location_writer& operator++() { return *this; }
  Location_writer& operator++(int) { return *this; }
  Location_writer& operator=(const Location& at)
  {
    *face_++ = at.face;
    *barycentric_++ = at.barycentric;
    return *this;
  }

private:
  int* face_;
  Eigen::Vector3d* barycentric_;
};

py::tuple to_mesh(const Map& self, const Doubles& domain_points)
{
  return self.visit([&](const auto& map) {
    using M = std::decay_t<decltype(map)>;
    const Domain_rows<typename M::Atlas> p(domain_points, "domain_points");
    require_domain_points(p, map.atlas());
    auto [faces, face] = rows_to_fill<int>(p.size());
    auto [barycentric, b] = rows_to_fill<Eigen::Vector3d>(p.size());
    int* const f = face;
    Eigen::Vector3d* const w = b;
    in_pieces(p.size(), [&](std::size_t first, std::size_t last) {
      map.to_mesh(Span<typename M::Domain_point>{p.begin() + first, p.begin() + last},
                  Location_writer<typename M::Location>(f + first, w + first));
    });
    return py::make_tuple(faces, barycentric);
  });
}

// The locations on a map, checked.
template <class M>
std::vector<typename M::Location> locations(const M& map, const Ints& faces, const Doubles& barycentric)
{
  const Rows<int> f(faces, "faces");
  const Rows<Eigen::Vector3d> b(barycentric, "barycentric");
  require(f.size() == b.size(), "there have to be as many faces as barycentric coordinates");
  std::vector<typename M::Location> result(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    require(f[i] >= 0 && static_cast<std::size_t>(f[i]) < map.number_of_faces(), "there is no such face");
    require(b[i].minCoeff() >= 0 && std::abs(b[i].sum() - 1) <= 1e-9,
            "barycentric coordinates must not be negative, and their sum has to be 1");
    result[i].face = f[i];
    result[i].barycentric = b[i];
  }
  return result;
}

py::array to_domain(const Map& self, const Ints& faces, const Doubles& barycentric)
{
  return self.visit([&](const auto& map) -> py::array {
    const auto at = locations(map, faces, barycentric);
    std::vector<typename std::decay_t<decltype(map)>::Domain_point> result(at.size());
    in_pieces(at.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) result[i] = map.to_domain(at[i]);
    });
    return take(std::move(result));
  });
}

py::array positions(const Map& self, const Doubles& domain_points)
{
  return self.visit([&](const auto& map) -> py::array {
    using M = std::decay_t<decltype(map)>;
    const Domain_rows<typename M::Atlas> p(domain_points, "domain_points");
    require_domain_points(p, map.atlas());
    auto [result, x] = rows_to_fill<Eigen::Vector3d>(p.size());
    Eigen::Vector3d* const out = x;
    in_pieces(p.size(), [&](std::size_t first, std::size_t last) {
      int hint = -1;
      for (std::size_t i = first; i < last; ++i) {
        const auto at = map.to_mesh(p[i], hint);
        hint = at.face;
        out[i] = map.position(at);
      }
    });
    return result;
  });
}

template <class Get>
auto array_of(const Get& get)
{
  return [get](const py::object& self) -> py::array {
    return self.cast<const Map&>().visit([&](const auto& map) { return py::array(view(get(map), self)); });
  };
}
template <class Get>
auto value_of(const Get& get)
{
  return [get](const Map& self) { return self.visit(get); };
}

py::array numbers(std::size_t n, const std::vector<int>& given)
{
  std::vector<int> result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = given.empty() ? static_cast<int>(i) : given[i];
  return take(std::move(result));
}

} // namespace

void add_maps(py::module_& m)
{
  py::class_<SM::Certificate>(
    m, "Certificate", "The proof that a map is one to one, or what is wrong with it; str() says it in words.")
    .def_property_readonly("is_valid", &SM::Certificate::is_valid, "Whether the map is one to one and onto.")
    .def_readonly("faces", &SM::Certificate::faces, "How many.")
    .def_readonly("flipped", &SM::Certificate::flipped, "Faces that are negative in the domain.")
    .def_readonly("degenerate", &SM::Certificate::degenerate, "Faces without area in the domain.")
    .def_readonly("unliftable", &SM::Certificate::unliftable, "Faces that wind round a handle.")
    .def_readonly("out_of_range", &SM::Certificate::out_of_range, "Vertices whose domain point is none.")
    .def_readonly("offending_faces", &SM::Certificate::offending_faces, "The first 16.")
    .def_readonly("offending_vertices", &SM::Certificate::offending_vertices, "The first 16.")
    .def_readonly("degree", &SM::Certificate::degree, "How often the faces cover the domain.")
    .def_readonly("smallest_domain_area", &SM::Certificate::smallest_domain_area, "Signed, of one face.")
    .def_readonly("topology_ok", &SM::Certificate::topology_ok,
                  "Whether the mesh is a surface of the right kind.")
    .def_readonly("topology_message", &SM::Certificate::topology_message, "What the mesh is.")
    .def_readonly("border_ok", &SM::Certificate::border_ok, "Whether the border runs once round the square.")
    .def("__bool__", &SM::Certificate::is_valid)
    .def("__str__", &SM::Certificate::sentence);

  py::class_<SM::Distortion>(m, "Distortion",
                             "How far a map is from an isometry; 1 is best, 0 for logarithms.")
    .def_readonly("angle_mean", &SM::Distortion::angle_mean, "Of the quotient of the singular values.")
    .def_readonly("angle_p99", &SM::Distortion::angle_p99, "Its weighted 99th percentile.")
    .def_readonly("angle_max", &SM::Distortion::angle_max, "Its largest value.")
    .def_readonly("area_mean_abs_log10", &SM::Distortion::area_mean_abs_log10,
                  "Of the quotient of the areas.")
    .def_readonly("area_max_abs_log10", &SM::Distortion::area_max_abs_log10, "Its largest value.")
    .def_readonly("symmetric_dirichlet", &SM::Distortion::symmetric_dirichlet, "The mean energy.")
    .def_readonly("l2_efficiency", &SM::Distortion::l2_efficiency, "The L2 stretch efficiency.")
    .def_readonly("smallest_domain_area", &SM::Distortion::smallest_domain_area, "Signed, of one face.");

  py::class_<Map>(
    m, "Map",
    "A one to one map between a triangle mesh and its canonical surface. Immutable. The arrays are the "
    "memory of the map itself, and read-only.")
    .def_property_readonly("domain", value_of([](const auto& map) {
                             return std::string(std::decay_t<decltype(map)>::Atlas::name);
                           }),
                           "The canonical surface: 'plane' (the square), 'sphere', 'torus' or 'hyperbolic'.")
    .def_property_readonly("genus", value_of([](const auto& map) { return long(map.atlas().genus()); }),
                           "The number of handles.")
    .def_property_readonly("number_of_charts",
                           value_of([](const auto& map) { return map.atlas().number_of_charts(); }),
                           "Of the atlas of the canonical surface.")
    .def_property_readonly("vertices", array_of([](const auto& map) -> const auto& { return map.points(); }),
                           "Positions in space, shape (n, 3).")
    .def_property_readonly("faces", array_of([](const auto& map) -> const auto& { return map.faces(); }),
                           "Triangles, shape (m, 3); those that close borders come last.")
    .def_property_readonly("domain_points",
                           array_of([](const auto& map) -> const auto& { return map.domain_points(); }),
                           "Per vertex: a unit vector (sphere), (u, v) (torus, square) or (tile, u, v).")
    .def_property_readonly("number_of_input_vertices",
                           value_of([](const auto& map) { return map.number_of_input_vertices(); }),
                           "Vertices from here on were added, on edges or to close borders.")
    .def_property_readonly("number_of_virtual_faces",
                           value_of([](const auto& map) { return map.number_of_virtual_faces(); }),
                           "So many of the last faces close borders and are no part of the mesh.")
    .def_property_readonly(
      "input_vertices",
      [](const Map& self) {
        return self.visit([&](const auto& map) {
          const std::size_t n = map.number_of_input_vertices();
          return numbers(n, map.input_indices().within(self.outer()).vertices);
        });
      },
      "Per input vertex its number in the mesh that was mapped: without those of no face.")
    .def_property_readonly(
      "input_faces",
      [](const Map& self) {
        return self.visit([&](const auto& map) {
          const std::size_t n = map.number_of_faces() - map.number_of_virtual_faces();
          return numbers(n, map.input_indices().within(self.outer()).faces);
        });
      },
      "Per face that is not virtual the number of the face of the mesh that it is a part of.")
    .def_property_readonly("certificate", value_of([](const auto& map) { return map.certificate(); }),
                           "The proof that the map is one to one.")
    .def_property_readonly("diagonal", value_of([](const auto& map) { return map.diagonal(); }),
                           "Of the bounding box: the unit of tolerances.")
    .def_property_readonly("is_inward_oriented",
                           value_of([](const auto& map) { return map.is_inward_oriented(); }),
                           "Whether the mesh is closed and its normals point inward.")
    .def("distortion",
         value_of([](const auto& map) { return without_lock([&] { return SM::distortion(map); }); }),
         "How far the map is from an isometry.")
    .def("to_mesh", &to_mesh, py::arg("domain_points"),
         "Where points of the domain are on the mesh: (faces, barycentric), of shapes (n,) and (n, 3).")
    .def("to_domain", &to_domain, py::arg("faces"), py::arg("barycentric"),
         "The domain points of points of the mesh: faces of shape (n,), barycentric coordinates of shape (n, "
         "3).")
    .def("positions", &positions, py::arg("domain_points"),
         "Where points of the domain are in space, shape (n, 3).")
    .def(
      "random_domain_points",
      [](const Map& self, std::size_t n, std::uint64_t seed) {
        return self.visit(
          [&](const auto& map) -> py::array { return take(SM::random_domain_points(n, seed, map.atlas())); });
      },
      py::arg("n"), py::arg("seed") = 0,
      "Points of the domain, evenly distributed, the same on every machine.")
    .def(
      "save",
      [](const Map& self, const std::filesystem::path& file, bool binary) {
        without_lock([&] {
          self.visit([&](const auto& map) {
            SM::write_map(file.string(), map, CGAL::parameters::use_binary_mode(binary));
          });
        });
      },
      py::arg("file"), py::arg("binary") = true,
      "Writes a PLY file, which load_map() reads back to the last bit.")
    .def("__repr__", value_of([](const auto& map) {
           return "<simple_manifolds.Map of " + std::to_string(map.number_of_vertices()) + " vertices and " +
                  std::to_string(map.number_of_faces()) + " faces to the " +
                  std::decay_t<decltype(map)>::Atlas::name + ">";
         }));
  m.def(
    "load_map",
    [](const std::string& file) {
      return Map(without_lock([&] { return SM::read_map(file); }), SM::Input_indices());
    },
    py::arg("file"));
}

} // namespace simple_manifolds_python
