// The points of a surface that are closest to points of space.

#include "objects.h"

#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <memory>
#include <utility>
#include <vector>

namespace simple_manifolds_python {

namespace {

// (domain points, points, distances, signed distances)
py::tuple closest_points(const Surface& self, const Doubles& points)
{
  const Rows<Eigen::Vector3d> x(points, "points");
  require_finite(x.data(), 3 * x.size(), "points");
  return self.visit([&](const auto& surface) {
    using S = std::decay_t<decltype(surface)>;
    using Finder = SM::Closest_point_finder<S>;
    if (!self.finder) self.finder = without_lock([&] { return std::make_shared<const Finder>(surface); });
    const auto finder = std::static_pointer_cast<const Finder>(self.finder);
    const std::size_t n = x.size();
    std::vector<typename S::Domain_point> places(n);
    std::vector<Eigen::Vector3d> feet(n);
    std::vector<double> distances(n), signed_distances(n);
    constexpr std::size_t piece = 1 << 13; // a query takes microseconds
    for (std::size_t first = 0; first < n; first += piece) {
      without_lock([&] {
        // few points each: parallel_tasks() hands them out one by one
        constexpr std::size_t task = 64;
        const std::size_t last = (std::min)(n, first + piece);
        SM::internal::parallel_tasks<CGAL::Parallel_if_available_tag>(
          static_cast<int>((last - first + task - 1) / task), [&](int k) {
            const std::size_t begin = first + task * static_cast<std::size_t>(k);
            for (std::size_t i = begin; i < (std::min)(last, begin + task); ++i) {
              const auto c = (*finder)(x[i]);
              places[i] = c.domain_point;
              feet[i] = c.point;
              distances[i] = c.distance;
              signed_distances[i] = c.signed_distance;
            }
          });
      });
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    return py::make_tuple(take(std::move(places)), take(std::move(feet)), take(std::move(distances)),
                          take(std::move(signed_distances)));
  });
}

} // namespace

void add_closest_points(py::module_& m)
{
  m.def("closest_points", &closest_points, py::arg("surface"), py::arg("points"));
}

} // namespace simple_manifolds_python
