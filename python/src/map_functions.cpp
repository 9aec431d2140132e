// The functions that make maps.

#include "objects.h"

#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/map_components.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>

#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simple_manifolds_python {

namespace {

using Parallel = CGAL::Parallel_if_available_tag;

// The options of all functions that make maps.
struct Options {
  SM::Map_options map;
  SM::Close_borders close_borders;

  explicit Options(const py::dict& d)
  {
    map.energy = choice<SM::Energy>(
      option<std::string>(d, "energy"), "energy",
      {{"symmetric_dirichlet", SM::Energy::SYMMETRIC_DIRICHLET}, {"amips", SM::Energy::AMIPS}});
    map.lambda = option<double>(d, "energy_lambda");
    map.area_floor = option<double>(d, "area_floor");
    map.effort = choice<SM::Effort>(
      option<std::string>(d, "effort"), "effort",
      {{"fast", SM::Effort::FAST}, {"default", SM::Effort::DEFAULT}, {"quality", SM::Effort::QUALITY}});
    map.position = choice<SM::Position_frame>(option<std::string>(d, "position"), "position",
                                              {{"none", SM::Position_frame::NONE},
                                               {"shape", SM::Position_frame::SHAPE},
                                               {"space", SM::Position_frame::SPACE}});
    close_borders = choice<SM::Close_borders>(option<std::string>(d, "close_borders"), "close_borders",
                                              {{"none", SM::Close_borders::NONE},
                                               {"small", SM::Close_borders::SMALL},
                                               {"inner", SM::Close_borders::INNER},
                                               {"all", SM::Close_borders::ALL}});
    require(map.lambda > 0 && std::isfinite(map.lambda), "energy_lambda has to be positive");
    require(map.area_floor > 0 && map.area_floor <= 1, "area_floor has to be in (0, 1]");
  }

  auto parameters(Python_visitor& visitor) const
  {
    return SM::parameters::map_options(map).close_borders(close_borders).visitor(std::ref(visitor));
  }
};

template <class Point>
std::vector<SM::Landmark<std::size_t, Point>> landmarks_of(const Ints& vertices, const Doubles& places,
                                                           const Doubles& weights)
{
  const Rows<int> v(vertices, "the vertices of landmarks");
  const Rows<double> w(weights, "the weights of landmarks");
  std::vector<SM::Landmark<std::size_t, Point>> result;
  if (v.size() == 0) return result;
  const Rows<Point> p(places, "the points of landmarks");
  require(v.size() == p.size() && v.size() == w.size(), "each landmark has a vertex, a point and a weight");
  require_finite(p.data(), p.size() * Row<Point>::columns, "the points of landmarks");
  for (std::size_t i = 0; i < v.size(); ++i) {
    require(std::isfinite(w[i]) && w[i] >= 0, "the weights of landmarks have to be finite and not negative");
    result.push_back({static_cast<std::size_t>(v[i]), p[i], w[i]});
  }
  return result;
}

// domain: the name of a canonical surface, or "auto". Vertices of landmarks and corners are known to be of faces, the
// corners on the border.
Map map(const Doubles& points, const Ints& triangles, const SM::Input_indices& outer,
        const std::string& domain, const py::dict& option_dict, const std::vector<std::size_t>& corners,
        const Ints& landmark_vertices, const Doubles& landmark_points, const Doubles& landmark_weights,
        py::object progress)
{
  const Rows<Eigen::Vector3d> p(points, "points");
  const Rows<SM::Triangle> t(triangles, "triangles");
  const Options options(option_dict);
  Python_visitor visitor(std::move(progress));
  const auto np = options.parameters(visitor);
  const auto made = [&](const auto& f) {
    return Map(without_lock([&]() -> SM::Any_map { return f(); }), outer);
  };
  if (domain == "sphere") {
    const auto landmarks =
      landmarks_of<Eigen::Vector3d>(landmark_vertices, landmark_points, landmark_weights);
    return made([&] { return SM::map_to_sphere<Parallel>(p, t, SM::parameters::landmarks(landmarks, np)); });
  }
  if (domain == "torus") {
    const auto landmarks =
      landmarks_of<Eigen::Vector2d>(landmark_vertices, landmark_points, landmark_weights);
    return made([&] { return SM::map_to_torus<Parallel>(p, t, SM::parameters::landmarks(landmarks, np)); });
  }
  if (domain == "plane") {
    const auto landmarks =
      landmarks_of<Eigen::Vector2d>(landmark_vertices, landmark_points, landmark_weights);
    return made([&] {
      return SM::map_to_plane<Parallel>(
        p, t, SM::parameters::corners(corners, SM::parameters::landmarks(landmarks, np)));
    });
  }
  if (domain == "hyperbolic") return made([&] { return SM::map_to_hyperbolic_surface<Parallel>(p, t, np); });
  return made(
    [&] { return SM::map_to_canonical_surface<Parallel>(p, t, SM::parameters::corners(corners, np)); });
}

// A list of (name, vertices, faces, map or None, error or None).
py::list map_components(const Doubles& points, const Ints& triangles, const SM::Input_indices& outer,
                        const py::dict& option_dict, std::optional<std::size_t> most, py::object progress)
{
  const Rows<Eigen::Vector3d> p(points, "points");
  const Rows<SM::Triangle> t(triangles, "triangles");
  const Options options(option_dict);
  require(!most || *most > 0, "max_components has to be positive");
  Python_visitor visitor(std::move(progress));
  auto components = without_lock([&] {
    return SM::map_components<Parallel>(
      p, t, SM::parameters::max_components(most.value_or(t.size() + 1), options.parameters(visitor)));
  });
  py::list result;
  for (auto& c : components) {
    py::object map = py::none(), error = py::none();
    if (c.has_value())
      map = py::cast(Map(std::move(c.value()), outer));
    else
      error = exception_of(c.error());
    result.append(py::make_tuple(c.name, take(std::move(c.vertices)), take(std::move(c.faces)), map, error));
  }
  return result;
}

template <class F>
void with_atlas(const std::string& name, const F& f)
{
  if (!SM::Canonical_surfaces::visit_name(name, f))
    wrong("'" + name + "' is none of " + SM::Canonical_surfaces::names());
}

// An atlas with the genus of the mesh.
template <class Atlas>
Atlas atlas_of_genus(int genus)
{
  if constexpr (std::is_same_v<Atlas, SM::Hyperbolic_atlas>) {
    require(Atlas::is_genus(genus), "hyperbolic surfaces have genus 2 or more");
    return Atlas(genus);
  } else {
    return (void)genus, Atlas();
  }
}

Map make_map(const std::string& domain, const Doubles& points, const Ints& triangles,
             const Doubles& domain_points, int genus)
{
  const Rows<Eigen::Vector3d> p(points, "points");
  const Rows<SM::Triangle> t(triangles, "triangles");
  std::optional<Map> map;
  with_atlas(domain, [&](auto type) {
    using Atlas = typename decltype(type)::Atlas;
    const Rows<typename Atlas::Domain_point> d(domain_points, "domain_points");
    require(p.size() == d.size(), "there have to be as many domain_points as points");
    map.emplace(without_lock([&]() -> SM::Any_map {
                  return SM::Manifold_map<Atlas>(p.vector(), t.vector(), d.vector(), p.size(), 0,
                                                 SM::Input_indices(), atlas_of_genus<Atlas>(genus));
                }),
                SM::Input_indices());
  });
  return std::move(*map);
}

SM::Certificate certify(const std::string& domain, const Doubles& domain_points, const Ints& triangles,
                        int genus)
{
  const Rows<SM::Triangle> t(triangles, "triangles");
  SM::Certificate certificate;
  with_atlas(domain, [&](auto type) {
    using Atlas = typename decltype(type)::Atlas;
    const Rows<typename Atlas::Domain_point> d(domain_points, "domain_points");
    without_lock([&] { certificate = SM::certify(atlas_of_genus<Atlas>(genus), d.vector(), t.vector()); });
  });
  return certificate;
}

} // namespace

void add_map_functions(py::module_& m)
{
  py::class_<SM::Input_indices>(m, "InputIndices")
    .def(py::init([](std::vector<int> vertices, std::vector<int> faces) {
      return SM::Input_indices{std::move(vertices), std::move(faces)};
    }));
  m.def("map", &map, py::arg("points"), py::arg("triangles"), py::arg("outer"), py::arg("domain"),
        py::arg("options"), py::arg("corners"), py::arg("landmark_vertices"), py::arg("landmark_points"),
        py::arg("landmark_weights"), py::arg("progress"));
  m.def("map_components", &map_components, py::arg("points"), py::arg("triangles"), py::arg("outer"),
        py::arg("options"), py::arg("max_components"), py::arg("progress"));
  m.def("make_map", &make_map, py::arg("domain"), py::arg("points"), py::arg("triangles"),
        py::arg("domain_points"), py::arg("genus"));
  m.def("certify", &certify, py::arg("domain"), py::arg("domain_points"), py::arg("triangles"),
        py::arg("genus"));
}

} // namespace simple_manifolds_python
