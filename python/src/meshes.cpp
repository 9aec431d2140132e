// Files, repair and inspection: meshes as points and faces of any size.

#include "calls.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/closed_triangles.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/stl.h>

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simple_manifolds_python {

namespace {

// sizes: corners per face; corners: of the faces, one after the other.
SM::Mesh_soup soup_of(const Doubles& points, const Ints& corners, const Ints& sizes)
{
  const Rows<Eigen::Vector3d> p(points, "points");
  const Rows<int> c(corners, "corners"), s(sizes, "sizes");
  require(std::all_of(s.begin(), s.end(), [](int n) { return n >= 0; }) &&
            std::accumulate(s.begin(), s.end(), std::size_t(0)) == c.size(),
          "the sizes of the faces do not add up to the number of corners");
  SM::internal::require_countable(c.size());
  SM::Mesh_soup soup;
  soup.points = p.vector();
  soup.reserve_faces(s.size());
  std::size_t h = 0;
  for (const int n : s) {
    for (int k = 0; k < n; ++k) soup.add_corner(c[h++]);
    soup.end_face();
  }
  return soup;
}

py::tuple arrays_of(SM::Mesh_soup&& soup)
{
  std::vector<int> corners(soup.number_of_half_edges()), sizes(soup.number_of_faces());
  for (int h = 0; h < soup.number_of_half_edges(); ++h) corners[h] = soup.source(h);
  for (int f = 0; f < soup.number_of_faces(); ++f) sizes[f] = soup.number_of_corners(f);
  return py::make_tuple(take(std::move(soup.points)), take(std::move(corners)), take(std::move(sizes)));
}

py::dict properties_of(std::vector<SM::Mesh_property>&& list)
{
  py::dict result;
  for (SM::Mesh_property& p : list) {
    const int columns = p.components;
    py::array values = take(std::move(p.values));
    if (columns > 1) values = values.attr("reshape")(-1, columns);
    if (p.is_integer()) // NaN stands for what the file does not have
      if (!py::module_::import("numpy").attr("isnan")(values).attr("any")().cast<bool>())
        values = values.attr("astype")("int64");
    result[py::str(p.name)] = values;
  }
  return result;
}

// options: none, and the faces are taken as they stand.
py::dict read(const std::string& file, const std::optional<SM::Repair_options>& options)
{
  SM::Read_report read;
  SM::Repair_report report;
  SM::Mesh_soup soup = without_lock([&] {
    SM::Mesh_soup s = SM::read_soup(file, read);
    if (!options) return s;
    s =
      SM::repair_soup(std::move(s), SM::parameters::repair_options(*options).repair_report(std::ref(report)));
    std::vector<int> opposite;
    SM::internal::topology_of_repaired(file, s, report, read.warnings, opposite); // throws what is wrong
    read.properties =
      SM::selected_properties(read.properties, report.input, static_cast<std::size_t>(s.number_of_vertices()),
                              static_cast<std::size_t>(s.number_of_faces()));
    return s;
  });
  py::dict result;
  result["arrays"] = arrays_of(std::move(soup));
  result["vertex_properties"] = properties_of(std::move(read.properties.vertex));
  result["face_properties"] = properties_of(std::move(read.properties.face));
  result["unit"] = read.unit;
  py::list warnings;
  for (const SM::Read_warning& w : read.warnings) warnings.append(w.sentence());
  result["warnings"] = warnings;
  result["repair"] = report;
  return result;
}

py::tuple repair(const Doubles& points, const Ints& corners, const Ints& sizes,
                 const SM::Repair_options& options)
{
  SM::Mesh_soup soup = soup_of(points, corners, sizes);
  SM::Repair_report report;
  without_lock([&] {
    soup = SM::repair_soup(std::move(soup),
                           SM::parameters::repair_options(options).repair_report(std::ref(report)));
    SM::internal::throw_faults("", report.left);
  });
  return py::make_tuple(arrays_of(std::move(soup)), report);
}

// Polygons cut into triangles as maps cut them, and per triangle the polygon.
py::tuple triangulate(const Doubles& points, const Ints& corners, const Ints& sizes)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const SM::Mesh_soup soup = soup_of(points, corners, sizes);
  std::vector<SM::Triangle> triangles;
  std::vector<int> polygons;
  without_lock([&] {
    std::vector<int> opposite;
    SM::internal::topology_of_soup(soup, opposite);
    Mesh mesh;
    SM::internal::add_soup(soup, opposite, mesh, [&](int i, auto v) {
      const Eigen::Vector3d& x = soup.points[i];
      mesh.point(v) = {x[0], x[1], x[2]};
    });
    SM::internal::Mesh_arrays arrays =
      SM::internal::closed_triangles(SM::internal::Polygon_soup(mesh), soup.points, SM::Close_borders::NONE);
    triangles = std::move(arrays.triangles);
    const std::vector<int>& vertices = arrays.input.vertices; // empty: 0, 1, 2, ...
    if (!vertices.empty())
      for (SM::Triangle& t : triangles)
        for (int& v : t) v = vertices[v];
    polygons = std::move(arrays.input.faces);
  });
  return py::make_tuple(take(std::move(triangles)), take(std::move(polygons)));
}

SM::Face_orientation orientation(const std::string& word)
{
  return choice<SM::Face_orientation>(word, "face_orientation",
                                      {{"as_is", SM::Face_orientation::AS_IS},
                                       {"consistent", SM::Face_orientation::CONSISTENT},
                                       {"outward", SM::Face_orientation::OUTWARD}});
}

SM::Repair_options repair_options(std::optional<double> weld_distance, bool drop_degenerate,
                                  bool drop_duplicates, const std::string& face_orientation,
                                  bool cut_non_manifold, bool drop_non_finite, double debris_share)
{
  require(!weld_distance || (*weld_distance >= 0 && std::isfinite(*weld_distance)),
          "weld_distance has to be finite and not negative, or None");
  require(debris_share >= 0 && debris_share <= 1, "debris_share has to be between 0 and 1");
  SM::Repair_options o;
  o.weld_distance = weld_distance;
  o.drop_degenerate = drop_degenerate;
  o.drop_duplicates = drop_duplicates;
  o.face_orientation = orientation(face_orientation);
  o.cut_non_manifold = cut_non_manifold;
  o.drop_non_finite = drop_non_finite;
  o.debris_share = debris_share;
  return o;
}

template <class T>
py::object box_of(const T& object)
{
  if (object.box.isEmpty()) return py::none();
  return take(std::vector<Eigen::Vector3d>{object.box.min(), object.box.max()});
}

SM::Close_borders close_borders(const std::string& word)
{
  return choice<SM::Close_borders>(word, "close_borders",
                                   {{"none", SM::Close_borders::NONE},
                                    {"small", SM::Close_borders::SMALL},
                                    {"inner", SM::Close_borders::INNER},
                                    {"all", SM::Close_borders::ALL}});
}

} // namespace

void add_meshes(py::module_& m)
{
  py::class_<SM::Located_elements>(m, "LocatedElements",
                                   "Elements of one kind: how many, which and where the first are.")
    .def_readonly("count", &SM::Located_elements::count, "How many there are.")
    .def_property_readonly(
      "names",
      [](const SM::Located_elements& e) {
        std::vector<std::string> names;
        for (const SM::Mesh_element& element : e.elements) names.push_back(element.name());
        return names;
      },
      "The first ones, such as 'edge 3-5'.")
    .def_property_readonly(
      "places", [](const SM::Located_elements& e) { return take(std::vector<Eigen::Vector3d>(e.places)); },
      "Where these are, an array of shape (n, 3).")
    .def("__repr__", [](const SM::Located_elements& e) { return std::to_string(e.count) + e.where(); });

  py::class_<SM::Surface_faults> faults(m, "SurfaceFaults",
                                        "What keeps faces from being an oriented surface.");
  faults.def_property_readonly("number", &SM::Surface_faults::number, "How many faults there are.")
    .def_readonly("one_sided_components", &SM::Surface_faults::one_sided_components,
                  "Components like a Moebius strip.")
    .def("__bool__", [](const SM::Surface_faults& f) { return !f.is_empty(); })
    .def("__str__", &SM::Surface_faults::sentence);
#define SIMPLE_MANIFOLDS_PYTHON_FIELD(name, doc) faults.def_readonly(#name, &SM::Surface_faults::name, doc)
  SIMPLE_MANIFOLDS_PYTHON_FIELD(missing_vertices, "Faces that refer to a vertex that does not exist.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(non_finite_vertices, "Vertices with a coordinate that is NaN or infinite.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(degenerate_faces, "Faces with fewer than three different vertices.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(repeated_corners, "Other faces that visit a vertex twice.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(duplicate_faces, "Faces with the vertices of an earlier one.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(non_manifold_edges, "Edges of more than two faces.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(inconsistent_edges, "Edges that both faces traverse in the same direction.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(non_manifold_vertices, "Vertices whose faces form several fans.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(coincident_borders,
                                "Border edges that coincide, but would make a one-sided surface.");
#undef SIMPLE_MANIFOLDS_PYTHON_FIELD

  py::class_<SM::Repair_report> report(m, "RepairReport", "What a repair has done; str() says it in words.");
  report.def_property_readonly("has_changes", &SM::Repair_report::has_changes, "Whether anything was done.")
    .def_readonly("dropped_debris_faces", &SM::Repair_report::dropped_debris_faces,
                  "The faces of dropped debris.")
    .def_readonly("unused_vertices", &SM::Repair_report::unused_vertices,
                  "Vertices of no face; they are kept.")
    .def_readonly("left", &SM::Repair_report::left, "What is still wrong.")
    .def_property_readonly(
      "input_vertices", [](const SM::Repair_report& r) { return take(std::vector<int>(r.input.vertices)); },
      "Per vertex its number in the input, -1 for an added one; empty: 0, 1, 2, ...")
    .def_property_readonly(
      "input_faces", [](const SM::Repair_report& r) { return take(std::vector<int>(r.input.faces)); },
      "Per face its number in the input; empty: 0, 1, 2, ...")
    .def("__str__", &SM::Repair_report::sentence);
#define SIMPLE_MANIFOLDS_PYTHON_FIELD(name, doc) report.def_readonly(#name, &SM::Repair_report::name, doc)
  SIMPLE_MANIFOLDS_PYTHON_FIELD(welded, "Vertices that were joined to another one.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(joined_corners, "Faces that lost repeated corners, and remained.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(dropped_degenerate, "Faces with fewer than three different vertices.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(dropped_duplicate, "Faces with the corners of another one.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(dropped_non_finite, "Faces with a corner that is NaN or infinite.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(flipped, "Faces that were turned over.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(cut_edges, "Edges that became several, or border.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(cut_vertices, "Vertices that became several.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(split_edges, "Cut edges that got a vertex in the middle.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(dropped_debris, "Components without weight, told by their first face.");
#undef SIMPLE_MANIFOLDS_PYTHON_FIELD

  py::class_<SM::Repair_options>(
    m, "RepairOptions", "What a repair may do. By default only what cannot change the object is done.")
    .def(
      py::init(&repair_options), py::kw_only(), py::arg("weld_distance") = 1e-6,
      py::arg("drop_degenerate") = true, py::arg("drop_duplicates") = true,
      py::arg("face_orientation") = "consistent", py::arg("cut_non_manifold") = false,
      py::arg("drop_non_finite") = false, py::arg("debris_share") = 0.,
      "weld_distance: of border points, a fraction of the diagonal; None: never. face_orientation: 'as_is', "
      "'consistent' or 'outward'. debris_share: components below this share of the largest are dropped.")
    .def_static("everything", &SM::repair_everything,
                "All that a repair can do: an oriented manifold is left.")
    .def_static("nothing", &SM::repair_nothing, "Nothing at all.");

  py::class_<SM::Border_loop>(m, "BorderLoop", "A border curve of a mesh.")
    .def_readonly("edges", &SM::Border_loop::edges, "How many it has.")
    .def_readonly("length", &SM::Border_loop::length, "Of all of them.")
    .def_readonly("is_small", &SM::Border_loop::is_small, "Whether close_borders='small' closes it.");

  py::class_<SM::Inspected_component>(m, "InspectedComponent",
                                      "What a connected component is; str() says it in words.")
    .def_readonly("name", &SM::Inspected_component::name, "'part-1' has the most faces.")
    .def_readonly("first_face", &SM::Inspected_component::first_face, "The number of its first face.")
    .def_readonly("vertices", &SM::Inspected_component::vertices, "How many.")
    .def_readonly("edges", &SM::Inspected_component::edges, "How many.")
    .def_readonly("faces", &SM::Inspected_component::faces, "How many.")
    .def_readonly("area", &SM::Inspected_component::area, "Of its faces.")
    .def_readonly("loops", &SM::Inspected_component::loops, "Its border curves, the longest first.")
    .def_readonly("faults", &SM::Inspected_component::faults, "What keeps it from being a surface.")
    .def_property_readonly("box", &box_of<SM::Inspected_component>,
                           "Lowest and highest corner, shape (2, 3), or None.")
    .def_property_readonly("is_surface", &SM::Inspected_component::is_surface,
                           "Whether it is an oriented surface.")
    .def_property_readonly(
      "genus",
      [](const SM::Inspected_component& c) {
        return c.is_surface() ? py::object(py::int_(c.genus())) : py::object(py::none());
      },
      "The number of handles; None for what is no surface.")
    .def_property_readonly("euler_characteristic", &SM::Inspected_component::euler_characteristic,
                           "V - E + F.")
    .def(
      "canonical_surface",
      [](const SM::Inspected_component& c, const std::string& closed) {
        const std::string_view name = c.canonical_surface(close_borders(closed));
        return name.empty() ? py::object(py::none()) : py::object(py::str(std::string(name)));
      },
      py::arg("close_borders") = "none", "The domain that it can be mapped to, such as 'sphere', or None.")
    .def("__str__", &SM::Inspected_component::sentence);

  py::class_<SM::Mesh_inspection>(m, "MeshInspection", "What a mesh is, component by component.")
    .def_readonly("vertices", &SM::Mesh_inspection::vertices, "Vertices of faces.")
    .def_readonly("unused_vertices", &SM::Mesh_inspection::unused_vertices, "Vertices of no face.")
    .def_readonly("edges", &SM::Mesh_inspection::edges, "How many.")
    .def_readonly("faces", &SM::Mesh_inspection::faces, "How many.")
    .def_readonly("area", &SM::Mesh_inspection::area, "Of all faces.")
    .def_readonly("faults", &SM::Mesh_inspection::faults, "What keeps it from being a surface.")
    .def_readonly("components", &SM::Mesh_inspection::components, "The one with the most faces first.")
    .def_property_readonly("box", &box_of<SM::Mesh_inspection>,
                           "Lowest and highest corner, shape (2, 3), or None.");

  m.def("read", &read, py::arg("file"), py::arg("options"));
  m.def("repair", &repair, py::arg("points"), py::arg("corners"), py::arg("sizes"), py::arg("options"));
  m.def(
    "inspect",
    [](const Doubles& points, const Ints& corners, const Ints& sizes) {
      const SM::Mesh_soup soup = soup_of(points, corners, sizes);
      return without_lock([&] { return SM::inspect_soup(soup); });
    },
    py::arg("points"), py::arg("corners"), py::arg("sizes"));
  m.def("triangulate", &triangulate, py::arg("points"), py::arg("corners"), py::arg("sizes"));
}

} // namespace simple_manifolds_python
