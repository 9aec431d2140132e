// Registered maps: correspondences, sets of shapes, morphs.

#include "objects.h"

#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/Shape_set.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>
#include <CGAL/Simple_manifolds/registration/register_shapes.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <pybind11/stl.h>

#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace simple_manifolds_python {

template <>
struct Row<Eigen::Matrix<int, 2, 1>> {
  using Scalar = int;
  static constexpr int columns = 2;
};

namespace {

using Parallel = CGAL::Parallel_if_available_tag;
template <class Atlas>
using Map_of = SM::Manifold_map<Atlas>;
template <class Atlas>
using Shared_map = std::shared_ptr<const Map_of<Atlas>>;

// What is made of maps to one of the canonical surfaces over which shapes are registered.
template <template <class> class T>
using Registered_variant = std::variant<T<SM::Sphere_atlas>, T<SM::Torus_atlas>, T<SM::Plane_atlas>>;

struct Registered {
  Registered_variant<SM::Correspondence> maps;
  std::optional<SM::Registration_report> report;
};
struct Shapes {
  Registered_variant<SM::Shape_set> sets;
};

template <class Atlas>
Shared_map<Atlas> map_over(const Map& map)
{
  const auto* shared = std::get_if<Shared_map<Atlas>>(&map.variant());
  if (shared == nullptr)
    throw SM::Topology_error(SM::Error_code::wrong_genus,
                             std::string("all maps have to be to one canonical surface, the ") + Atlas::name);
  return *shared;
}

// f(a null pointer to the type of the map's canonical surface).
template <class F>
auto with_atlas(const Map& map, const F& f)
{
  if (std::holds_alternative<Shared_map<SM::Sphere_atlas>>(map.variant()))
    return f(static_cast<SM::Sphere_atlas*>(nullptr));
  if (std::holds_alternative<Shared_map<SM::Torus_atlas>>(map.variant()))
    return f(static_cast<SM::Torus_atlas*>(nullptr));
  if (std::holds_alternative<Shared_map<SM::Plane_atlas>>(map.variant()))
    return f(static_cast<SM::Plane_atlas*>(nullptr));
  throw SM::Topology_error(SM::Error_code::wrong_genus,
                           "only maps to the sphere, the torus and the square can be registered");
}
template <class Pointer>
using Atlas_of = std::remove_pointer_t<Pointer>;

SM::Effort effort_of(const std::string& word)
{
  return choice<SM::Effort>(
    word, "effort",
    {{"fast", SM::Effort::FAST}, {"default", SM::Effort::DEFAULT}, {"quality", SM::Effort::QUALITY}});
}

template <class Manifold_map>
std::size_t vertex(int v, const Manifold_map& map)
{
  require(v >= 0 && static_cast<std::size_t>(v) < map.number_of_vertices(),
          "a landmark is no vertex of the map");
  return static_cast<std::size_t>(v);
}

Registered register_maps(const Map& source, const Map& target, const Ints& landmarks,
                         const std::string& effort, bool fix_target, py::object progress)
{
  const Rows<Eigen::Matrix<int, 2, 1>> pairs(landmarks, "landmarks");
  const SM::Effort e = effort_of(effort);
  Python_visitor visitor(std::move(progress));
  return with_atlas(source, [&](auto* atlas) {
    using Atlas = Atlas_of<decltype(atlas)>;
    const Shared_map<Atlas> s = map_over<Atlas>(source), t = map_over<Atlas>(target);
    std::vector<SM::Landmark_pair<>> list;
    for (const auto& pair : pairs) list.push_back({vertex(pair[0], *s), vertex(pair[1], *t)});
    return without_lock([&] {
      SM::Registration_report report;
      auto maps = SM::register_maps<Parallel>(*s, *t,
                                              SM::parameters::landmark_pairs(list)
                                                .effort(e)
                                                .fix_target(fix_target)
                                                .registration_report(std::ref(report))
                                                .visitor(std::ref(visitor)));
      return Registered{std::move(maps), report};
    });
  });
}

Registered correspondence(const Map& source, const Map& target)
{
  return with_atlas(source, [&](auto* atlas) {
    using Atlas = Atlas_of<decltype(atlas)>;
    return Registered{SM::Correspondence<Atlas>(map_over<Atlas>(source), map_over<Atlas>(target)),
                      std::nullopt};
  });
}

// Where all vertices of the source are on the target.
template <class Atlas>
std::vector<typename Map_of<Atlas>::Location> locations(const SM::Correspondence<Atlas>& c)
{
  std::vector<typename Map_of<Atlas>::Location> at;
  at.reserve(c.source().number_of_vertices());
  c.of_vertices(std::back_inserter(at));
  return at;
}

py::tuple location_arrays(const Registered& self)
{
  std::vector<int> faces;
  std::vector<Eigen::Vector3d> barycentric;
  without_lock([&] {
    std::visit(
      [&](const auto& c) {
        for (const auto& at : locations(c)) {
          faces.push_back(at.face);
          barycentric.push_back(at.barycentric);
        }
      },
      self.maps);
  });
  return py::make_tuple(take(std::move(faces)), take(std::move(barycentric)));
}

py::array positions(const Registered& self)
{
  std::vector<Eigen::Vector3d> x;
  without_lock([&] {
    std::visit(
      [&](const auto& c) {
        for (const auto& at : locations(c)) x.push_back(c.target().position(at));
      },
      self.maps);
  });
  return take(std::move(x));
}

template <class Atlas>
std::vector<Shared_map<Atlas>> maps_over(const std::vector<const Map*>& maps)
{
  std::vector<Shared_map<Atlas>> shared;
  for (const Map* map : maps) shared.push_back(map_over<Atlas>(*map));
  return shared;
}

void require_maps(const std::vector<const Map*>& maps)
{
  require(!maps.empty(), "there has to be a map");
  for (const Map* map : maps) require(map != nullptr, "None is no map");
}

Shapes shape_set(const std::vector<const Map*>& maps)
{
  require_maps(maps);
  return with_atlas(*maps[0], [&](auto* atlas) -> Shapes {
    using Atlas = Atlas_of<decltype(atlas)>;
    return {SM::Shape_set<Atlas>(maps_over<Atlas>(maps))};
  });
}

Shapes register_shapes(const std::vector<const Map*>& maps, const Ints& landmarks, std::size_t template_shape,
                       int mean_iterations, const std::string& effort, py::object progress)
{
  require_maps(maps);
  require(template_shape < maps.size(), "there is no such template_shape");
  require(mean_iterations >= 0, "mean_iterations must not be negative");
  const SM::Effort e = effort_of(effort);
  Python_visitor visitor(std::move(progress));
  return with_atlas(*maps[0], [&](auto* atlas) -> Shapes {
    using Atlas = Atlas_of<decltype(atlas)>;
    const std::vector<Shared_map<Atlas>> shared = maps_over<Atlas>(maps);
    std::vector<std::vector<std::size_t>> rows;
    if (landmarks.size() > 0) {
      require(landmarks.ndim() == 2 && landmarks.shape(1) == static_cast<py::ssize_t>(maps.size()),
              "landmarks have to be an array with a row for each landmark and a column for each shape");
      for (py::ssize_t i = 0; i < landmarks.shape(0); ++i) {
        rows.emplace_back();
        for (std::size_t j = 0; j < maps.size(); ++j)
          rows.back().push_back(vertex(landmarks.at(i, static_cast<py::ssize_t>(j)), *shared[j]));
      }
    }
    return without_lock([&]() -> Shapes {
      return {SM::register_shapes<Parallel>(shared, SM::parameters::landmark_rows(rows)
                                                      .template_shape(template_shape)
                                                      .mean_iterations(mean_iterations)
                                                      .effort(e)
                                                      .visitor(std::ref(visitor)))};
    });
  });
}

std::size_t size_of(const Shapes& shapes)
{
  return std::visit([](const auto& set) { return set.size(); }, shapes.sets);
}

std::size_t index(py::ssize_t i, const Shapes& shapes)
{
  const auto n = static_cast<py::ssize_t>(size_of(shapes));
  if (i < -n || i >= n) throw py::index_error("there is no such shape");
  return static_cast<std::size_t>(i < 0 ? i + n : i);
}

SM::Common_mesh common_mesh(const Shapes& shapes, py::ssize_t i, std::optional<double> chord_error,
                            std::size_t max_faces)
{
  const std::size_t k = index(i, shapes);
  require(!chord_error || (*chord_error > 0 && std::isfinite(*chord_error)),
          "chord_error has to be positive");
  return std::visit(
    [&](const auto& set) {
      if (chord_error)
        for (std::size_t j = 0; j < set.size(); ++j)
          require(set.map(j).number_of_virtual_faces() == 0,
                  "chord_error needs maps without faces that close borders");
      return without_lock([&] {
        return chord_error ? SM::common_mesh(set, k, *chord_error, max_faces) : SM::common_mesh(set, k);
      });
    },
    shapes.sets);
}

} // namespace

void add_registration(py::module_& m)
{
  py::class_<SM::Registration_report>(m, "RegistrationReport", "How two maps were registered.")
    .def_readonly("landmarks", &SM::Registration_report::landmarks,
                  "Different pairs, all of which are met exactly.")
    .def_readonly("exact_at", &SM::Registration_report::exact_at,
                  "Vertices of the level on which all were met.")
    .def_readonly("rotations", &SM::Registration_report::rotations,
                  "Mean logarithm of the distortion for each rotation that was tried to the end.")
    .def_readonly("energies", &SM::Registration_report::energies,
                  "The mean density after each step; 1: isometric.")
    .def_readonly("is_backwards", &SM::Registration_report::is_backwards,
                  "Whether the target was laid out against the source.")
    .def_property_readonly(
      "kept",
      [](const SM::Registration_report& r) {
        return r.kept == SM::Kept_registration::SEARCH                ? "search"
               : r.kept == SM::Kept_registration::GIVEN_MAPS_IMPROVED ? "given_maps_improved"
                                                                      : "given_maps";
      },
      "What it has come from: 'search', 'given_maps_improved' or 'given_maps', which were nowhere worse.");

  py::class_<SM::Correspondence_distortion> distortion(
    m, "CorrespondenceDistortion", "How far a correspondence is from an isometry; 1 is best.");
  distortion.def_property_readonly("symmetric", &SM::Correspondence_distortion::symmetric,
                                   "Mean over both shapes.");
#define SIMPLE_MANIFOLDS_PYTHON_FIELD(name, doc)                                                             \
  distortion.def_readonly(#name, &SM::Correspondence_distortion::name, doc)
  SIMPLE_MANIFOLDS_PYTHON_FIELD(mean, "Of the density over the source.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(mean_on_target, "Of the density over the target.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(median, "Of the density over the source.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(p95, "Its 95th percentile.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(p99, "Its 99th percentile.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(max, "The largest that was met.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(angle_mean, "Of the quotient of the singular values; 1 when conformal.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(area_mean_abs_log2, "Of the quotient of areas; 0 when they are kept.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(samples, "The number of points.");
  SIMPLE_MANIFOLDS_PYTHON_FIELD(not_positive, "Points where rounding rules.");
#undef SIMPLE_MANIFOLDS_PYTHON_FIELD

  py::class_<Registered>(
    m, "Correspondence",
    "A one to one map from a shape, the source, to another one, the target, through their common "
    "domain. Immutable.")
    .def(py::init(&correspondence), py::arg("source"), py::arg("target"),
         "Through two maps as they are; nothing is optimised.")
    .def_property_readonly(
      "source",
      [](const Registered& c) {
        return std::visit([](const auto& m) { return Map(m.shared_source()); }, c.maps);
      },
      "The map of the shape that it goes from.")
    .def_property_readonly(
      "target",
      [](const Registered& c) {
        return std::visit([](const auto& m) { return Map(m.shared_target()); }, c.maps);
      },
      "The map of the shape that it goes to.")
    .def_readonly("report", &Registered::report, "How it was found, or None.")
    .def(
      "inverse",
      [](const Registered& c) {
        return std::visit([&](const auto& m) { return Registered{m.inverse(), c.report}; }, c.maps);
      },
      "The other way.")
    .def("locations", &location_arrays,
         "Where the vertices of the source are on the target: (faces, barycentric).")
    .def("positions", &positions,
         "Where the vertices of the source are on the target in space, shape (n, 3).")
    .def(
      "distortion",
      [](const Registered& c, std::size_t samples) {
        require(samples > 0, "samples has to be positive");
        return without_lock(
          [&] { return std::visit([&](const auto& m) { return SM::distortion(m, samples); }, c.maps); });
      },
      py::arg("samples") = 100000, "How far it is from an isometry.");

  py::class_<SM::Common_mesh>(m, "CommonMesh", "One triangulation for several shapes.")
    .def_property_readonly(
      "faces", [](const py::object& self) { return view(self.cast<const SM::Common_mesh&>().faces, self); },
      "Triangles, shape (m, 3).")
    .def_property_readonly(
      "positions",
      [](const py::object& self) {
        py::list list;
        for (const auto& x : self.cast<const SM::Common_mesh&>().positions) list.append(view(x, self));
        return list;
      },
      "Per shape the positions of the vertices, shape (n, 3).")
    .def(
      "aligned",
      [](const SM::Common_mesh& mesh, bool scale) {
        return without_lock([&] {
          SM::Common_mesh copy = mesh;
          SM::align_shapes(copy, scale);
          return copy;
        });
      },
      py::arg("scale") = false, "The same with the shapes moved, turned and perhaps scaled onto one another.")
    .def(
      "morph",
      [](const SM::Common_mesh& mesh, const std::vector<double>& weights) {
        require(weights.size() == mesh.number_of_shapes(), "there has to be a weight for each shape");
        return take(without_lock([&] { return SM::morph(mesh, weights); }));
      },
      py::arg("weights"), "The weighted mean of the shapes, shape (n, 3). Align them first.");

  py::class_<Shapes>(
    m, "ShapeSet", "Several shapes over one sphere, torus or square: a point of it is a point of each shape.")
    .def(py::init(&shape_set), py::arg("maps"), "Of maps as they are.")
    .def("__len__", &size_of)
    .def(
      "__getitem__",
      [](const Shapes& s, py::ssize_t i) {
        return std::visit([&](const auto& set) { return Map(set.shared_map(index(i, s))); }, s.sets);
      },
      py::arg("i"), "The map of a shape.")
    .def(
      "correspondence",
      [](const Shapes& s, py::ssize_t i, py::ssize_t j) {
        return std::visit(
          [&](const auto& set) {
            return Registered{set.correspondence(index(i, s), index(j, s)), std::nullopt};
          },
          s.sets);
      },
      py::arg("i"), py::arg("j"), "From shape i to shape j.")
    .def(
      "common_mesh", &common_mesh, py::arg("i") = 0, py::arg("chord_error") = py::none(),
      py::arg("max_faces") = std::size_t(1) << 20,
      "The triangulation of shape i for all; with a chord_error (fraction of the diagonals) refined for it.");

  m.def("register_maps", &register_maps, py::arg("source"), py::arg("target"), py::arg("landmarks"),
        py::arg("effort"), py::arg("fix_target"), py::arg("progress"));
  m.def("register_shapes", &register_shapes, py::arg("maps"), py::arg("landmarks"), py::arg("template_shape"),
        py::arg("mean_iterations"), py::arg("effort"), py::arg("progress"));
}

} // namespace simple_manifolds_python
