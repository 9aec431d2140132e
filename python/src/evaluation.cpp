// Positions, normals, derivatives and curvatures of surfaces in batches.

#include "objects.h"

#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>

#include <algorithm>
#include <vector>

namespace simple_manifolds_python {

namespace {

using Parallel = CGAL::Parallel_if_available_tag;

static_assert(sizeof(SM::Jet) == 18 * sizeof(double) && alignof(SM::Jet) == alignof(double),
              "a jet is a row of six vectors");

// f(surface, points, n) with domain points, or with chart points where charts are given.
template <class F>
void with_points(const Surface& self, const py::object& points, const F& f)
{
  self.visit([&](const auto& surface) {
    using Atlas = typename std::decay_t<decltype(surface)>::Atlas;
    if (!py::isinstance<py::tuple>(points)) {
      const Domain_points<Atlas> p(points.cast<Doubles>(), surface.atlas());
      f(surface, p.begin(), p.size());
      return;
    }
    const auto pair = points.cast<py::tuple>();
    require(pair.size() == 2, "chart points are a pair (charts, uv)");
    const Rows<int> charts(pair[0].cast<Ints>(), "charts");
    const Rows<Eigen::Vector2d> uv(pair[1].cast<Doubles>(), "uv");
    require(charts.size() == uv.size(), "there have to be as many charts as pairs uv");
    std::vector<SM::Chart_point> p(charts.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      require(charts[i] >= 0 && charts[i] < surface.atlas().number_of_charts(), "there is no such chart");
      const double low = uv[i].minCoeff(), high = uv[i].maxCoeff();
      require(Atlas::has_single_chart ? low >= 0 && high <= 1 : low > 0 && high < 1,
              "uv lies outside of its chart");
      p[i] = {charts[i], uv[i]};
    }
    f(surface, p.data(), p.size());
  });
}

py::array positions(const Surface& self, const py::object& points)
{
  py::array result;
  with_points(self, points, [&](const auto& surface, const auto* p, std::size_t n) {
    auto [array, x] = rows_to_fill<Eigen::Vector3d>(n);
    result = array;
    Eigen::Vector3d* const out = x;
    in_pieces(n, [&, p](std::size_t first, std::size_t last) {
      surface.template points<Parallel>(Span<std::decay_t<decltype(*p)>>{p + first, p + last}, out + first);
    });
  });
  return result;
}

// Shape (n, 6, 3): E, E_u, E_v, E_uu, E_uv, E_vv.
template <int order>
py::array jets_of_order(const Surface& self, const py::object& points)
{
  py::array result;
  with_points(self, points, [&](const auto& surface, const auto* p, std::size_t n) {
    py::array_t<double> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(n), 6, 3});
    auto* const out = reinterpret_cast<SM::Jet*>(array.mutable_data());
    result = array;
    in_pieces(n, [&, p](std::size_t first, std::size_t last) {
      surface.template jets<Parallel, order>(Span<std::decay_t<decltype(*p)>>{p + first, p + last},
                                             out + first);
    });
  });
  return result;
}
py::array jets(const Surface& self, const py::object& points, int order)
{
  require(order == 1 || order == 2, "order has to be 1 or 2");
  return order == 1 ? jets_of_order<1>(self, points) : jets_of_order<2>(self, points);
}

const SM::Jet* checked_jets(const Doubles& a, std::size_t& n)
{
  require(a.ndim() == 3 && a.shape(1) == 6 && a.shape(2) == 3, "jets are an array of shape (n, 6, 3)");
  n = static_cast<std::size_t>(a.shape(0));
  return reinterpret_cast<const SM::Jet*>(a.data());
}

py::array normals_of_jets(const Doubles& a)
{
  std::size_t n;
  const SM::Jet* const e = checked_jets(a, n);
  auto [result, x] = rows_to_fill<Eigen::Vector3d>(n);
  Eigen::Vector3d* const out = x;
  in_pieces(n, [&](std::size_t first, std::size_t last) {
    std::transform(e + first, e + last, out + first, [](const SM::Jet& j) { return SM::normal(j); });
  });
  return result;
}

// (k1, k2, mean, gaussian, direction1, direction2)
py::tuple curvatures_of_jets(const Doubles& a)
{
  std::size_t n;
  const SM::Jet* const e = checked_jets(a, n);
  std::vector<double> k1(n), k2(n), mean(n), gaussian(n);
  std::vector<Eigen::Vector3d> direction1(n), direction2(n);
  in_pieces(n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const SM::Principal_directions d = SM::principal_directions(e[i]);
      k1[i] = d.k1;
      k2[i] = d.k2;
      mean[i] = SM::mean_curvature(e[i]);
      gaussian[i] = SM::gaussian_curvature(e[i]);
      direction1[i] = d.direction1;
      direction2[i] = d.direction2;
    }
  });
  return py::make_tuple(take(std::move(k1)), take(std::move(k2)), take(std::move(mean)),
                        take(std::move(gaussian)), take(std::move(direction1)), take(std::move(direction2)));
}

} // namespace

void add_evaluation(py::module_& m)
{
  m.def("positions", &positions, py::arg("surface"), py::arg("points"));
  m.def("jets", &jets, py::arg("surface"), py::arg("points"), py::arg("order"));
  m.def("normals_of_jets", &normals_of_jets, py::arg("jets"));
  m.def("curvatures_of_jets", &curvatures_of_jets, py::arg("jets"));
}

} // namespace simple_manifolds_python
