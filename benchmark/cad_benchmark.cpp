// The C2 splines over tiles that CAD surfaces are made of, beside the blend of charts, as CSV: controls for the same
// error, curvature against the truth, jets per second, conditioning of the normal equations. See README.md.
//
//   cad_benchmark [--quick] [MESH...]

#include "../test/embedding/Analytic_map.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>
#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/internal/Cholesky_solver.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
namespace si = SM::internal;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Of the processor: what others do on the machine does not count.
double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// The values of all functions at samples: a row each.
struct Design {
  std::vector<Eigen::Triplet<double>> entries;
  int rows = 0;

  Rows matrix(int functions) const
  {
    Rows a(rows, functions);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  }
};

/// The condition of the lower triangle of a matrix after its diagonal was scaled to 1, as Cholesky's factor sees it: the
/// ratio of what the power method and inverse iteration find. Infinite: there is no factor.
double condition(const si::Sparse_matrix& lower)
{
  Eigen::VectorXd d = lower.diagonal();
  for (Eigen::Index k = 0; k < d.size(); ++k) d[k] = d[k] > 0 ? 1 / std::sqrt(d[k]) : 0;
  si::Sparse_matrix a = d.asDiagonal() * lower * d.asDiagonal();
  for (Eigen::Index k = 0; k < d.size(); ++k)
    if (d[k] == 0) a.coeffRef(k, k) = 1; // a function that no sample sees
  try {
    si::Cholesky_solver solver(a);
    std::mt19937 random(1);
    const auto start = [&] {
      Eigen::VectorXd x(a.rows());
      for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = random() / 4294967296. - 0.5;
      return Eigen::VectorXd(x.normalized());
    };
    constexpr int steps = 60;
    double largest = 0, smallest = 0;
    Eigen::VectorXd x = start(), y = start();
    for (int k = 0; k < steps; ++k) {
      x = (a.selfadjointView<Eigen::Lower>() * x).eval();
      largest = x.norm();
      x /= largest;
      Eigen::MatrixX3d b(a.rows(), 3);
      b << y, y, y;
      y = solver.solve(b).col(0);
      smallest = 1 / y.norm();
      y.normalize();
    }
    return largest / smallest;
  } catch (const SM::Numeric_error&) {
    return HUGE_VAL;
  }
}

/// The normal matrix of rows, with a multiple of its diagonal.
si::Sparse_matrix normal_matrix(const Rows& a, double ridge)
{
  si::Sparse_matrix n =
    si::Sparse_matrix(si::Sparse_matrix(a.transpose()) * si::Sparse_matrix(a)).triangularView<Eigen::Lower>();
  for (Eigen::Index k = 0; k < n.rows(); ++k) n.coeffRef(k, k) *= 1 + ridge;
  return n;
}

/// The conditions of the two systems.
struct Conditions {
  double bare, solved;
};

/// Of the functions of the charts, weighted by their blends: bare, and with what a joint solve adds so that functions of
/// several charts that overlap are told apart.
template <class Surface>
Conditions conditions_of_charts(const Surface& surface, const si::Placed_points& samples)
{
  using Atlas = typename Surface::Atlas;
  using Domain = si::Cad_domain<Atlas>;
  const SM::Partition_of_unity<Atlas, typename Surface::Bump> partition(surface.bump(), surface.atlas());
  std::vector<int> first = {0};
  for (int c = 0; c < surface.atlas().number_of_charts(); ++c)
    first.push_back(first.back() + int(surface.chart_embedding(c).number_of_coefficients()));
  Design blend, own;
  for (const si::Tile_point& p : samples.places) {
    for (const auto& w : partition.weights(Domain::point(surface.atlas(), p))) {
      const SM::Hierarchical_embedding& e = surface.chart_embedding(w.point.chart);
      int offset = first[w.point.chart];
      for (const auto& level : e.levels()) {
        const auto local = [&](double x) {
          const int cell = std::clamp(int(x * level.cells), 0, level.cells - 1);
          return std::make_pair(cell, SM::Bspline_basis<3>::values(x * level.cells - cell));
        };
        const auto [i, f] = local(w.point.uv[0]);
        const auto [j, g] = local(w.point.uv[1]);
        for (int r = 0; r < 4; ++r)
          for (int s = 0; s < 4; ++s) {
            const int index = (i + r) * (level.cells + 3) + j + s;
            const auto at = std::lower_bound(level.indices.begin(), level.indices.end(), index);
            if (at == level.indices.end() || *at != index) continue;
            const int column = offset + int(at - level.indices.begin());
            const double value = f[r] * g[s];
            if (w.weight > 0) blend.entries.emplace_back(blend.rows, column, w.weight * value);
            own.entries.emplace_back(own.rows, column, value);
          }
        offset += int(level.indices.size());
      }
      ++own.rows;
    }
    ++blend.rows;
  }
  const Rows a = blend.matrix(first.back());
  const si::Sparse_matrix joint =
    normal_matrix(a, 1e-7) + si::Sparse_matrix(1e-3 * normal_matrix(own.matrix(first.back()), 0));
  return {condition(normal_matrix(a, 1e-12)), condition(joint)};
}

/// Of the splines over tiles that fit the samples: bare, and with the conditions of smoothness as they are weighted.
Conditions conditions_of_tiles(const si::Tile_gluing& gluing, const si::Placed_points& samples,
                               const Eigen::Vector3d& origin, double diagonal, double rms, double max)
{
  const bool has_sides = gluing.number_of_tiles() > 1;
  const si::Tile_spline_space space = has_sides
                                        ? si::Tile_spline_space(gluing, 5, 3, 2)
                                        : si::Tile_spline_space(gluing, 3, 1, gluing.is_periodic() ? 6 : 4);
  si::Tile_spline_fit::Options options;
  options.rms_error = rms;
  options.max_error = max;
  options.max_functions = 200000;
  options.is_smooth_across_tiles = has_sides;
  const auto sampler = [&](const std::vector<si::Tile_cell>& cells) {
    std::vector<si::Cell_samples> list(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double n = space.cells(cells[k].level);
      const Eigen::Vector2d low = Eigen::Vector2d(cells[k].i, cells[k].j) / n;
      for (std::size_t p = 0; p < samples.places.size(); ++p) {
        const Eigen::Vector2d x = samples.places[p].st - low;
        if (samples.places[p].tile != cells[k].tile || x.minCoeff() < 0 || x.maxCoeff() * n > 1) continue;
        list[k].places.push_back(samples.places[p].st);
        list[k].values.push_back((samples.points[p] - origin) / diagonal);
      }
      list[k].measured = list[k].places.size();
    }
    return list;
  };
  si::Tile_spline_fit fit(space, options, sampler, {});
  do fit.solve();
  while (fit.refine());

  const si::Tile_spline_space& found = fit.spline().space;
  Design design;
  si::Tile_spline_space::Rows values;
  for (const si::Tile_point& p : samples.places) {
    const auto& leaf = found.leaf_at(p.tile, p.st, false, false);
    found.evaluate(leaf, p.st, 0, values);
    for (std::size_t k = 0; k < leaf.functions.size(); ++k)
      design.entries.emplace_back(design.rows, leaf.functions[k].function, values(Eigen::Index(k), 0));
    ++design.rows;
  }
  const si::Sparse_matrix bare = normal_matrix(design.matrix(found.size()), 1e-12);
  if (!has_sides) return {condition(bare), condition(bare)};
  const si::Sparse_matrix all = bare + normal_matrix(si::Smoothness_conditions::matrix(found, 100), 0);
  return {condition(bare), condition(all)};
}

/// Millions of jets per second, the best of some runs.
double rate(int jets, const std::function<void()>& run)
{
  double best = HUGE_VAL;
  for (int k = 0; k < 5; ++k) {
    const double start = seconds();
    run();
    best = (std::min)(best, seconds() - start);
  }
  return jets / best / 1e6;
}

/// The face with a domain point, and its parameters there.
template <class Atlas>
SM::Jet jet_at(const SM::Cad_surface& surface, const Atlas& atlas, const typename Atlas::Domain_point& p)
{
  const si::Tile_point place = si::Cad_domain<Atlas>::place(atlas, p);
  for (const SM::Cad_face& face : surface.faces()) {
    const Eigen::Vector2d uv = face.on_tile(place.st); // exchanging twice is nothing
    if (face.tile == place.tile && face.knots_u.front() <= uv[0] && uv[0] <= face.knots_u.back() &&
        face.knots_v.front() <= uv[1] && uv[1] <= face.knots_v.back())
      return face.jet(uv);
  }
  return SM::Jet::zero();
}

/// Fits both to a map, and says what they cost.
template <class Map>
void compare(const std::string& name, const Map& map, double tolerance)
{
  const auto np = SM::parameters::rms_error(tolerance).max_error(10 * tolerance);
  SM::Fit_report fit;
  double start = seconds();
  const auto surface = SM::fit_surface(map, np.fit_target(SM::Fit_target::FACETS).fit_report(std::ref(fit)));
  const double surface_seconds = seconds() - start;
  SM::Cad_report cad;
  start = seconds();
  const SM::Cad_surface faces = SM::fit_cad_surface(map, np.cad_report(std::ref(cad)));
  const double cad_seconds = seconds() - start;

  constexpr int jets = 50000;
  const auto points = SM::random_domain_points(std::size_t(jets), 0, map.atlas());
  std::vector<SM::Jet> values(points.size());
  const double surface_rate = rate(jets, [&] { surface.jets(points, values.begin()); });
  std::vector<std::pair<const SM::Cad_face*, Eigen::Vector2d>> places;
  std::mt19937 random(3);
  for (int k = 0; k < jets; ++k) {
    const SM::Cad_face& face = faces.faces()[random() % faces.faces().size()];
    const auto within = [&](const std::vector<double>& knots) {
      return knots.front() + (knots.back() - knots.front()) * (random() / 4294967296.);
    };
    const double u = within(face.knots_u), v = within(face.knots_v);
    places.push_back({&face, {u, v}});
  }
  const double cad_rate = rate(jets, [&] {
    for (int k = 0; k < jets; ++k) values[k] = places[k].first->jet(places[k].second);
  });

  const si::Placed_points samples = si::measured_points<si::Map_on_arrays<Map>>(map);
  const Conditions charts = conditions_of_charts(surface, samples);
  const Conditions tiles =
    conditions_of_tiles(si::Cad_domain<typename Map::Atlas>::gluing(map.atlas()), samples, samples.points[0],
                        cad.diagonal, tolerance, 10 * tolerance);
  const auto row = [&](const char* method, std::size_t controls, double rms, double max, double time,
                       double speed, const Conditions& c) {
    std::cout << name << ',' << map.number_of_faces() << ',' << tolerance << ',' << method << ',' << controls
              << ',' << rms << ',' << max << ',' << time << ',' << speed << ',' << c.bare << ',' << c.solved
              << std::endl;
  };
  row("charts", fit.controls, fit.rms_error, fit.max_error, surface_seconds, surface_rate, charts);
  row("tiles", cad.functions, cad.rms_deviation, cad.max_deviation, cad_seconds, cad_rate, tiles);
}

/// A map that is a smooth function, so that also what lies between the vertices is known.
template <class Atlas>
struct Smooth_map : Analytic_map<Atlas> {
  using Base = Analytic_map<Atlas>;
  using Base::Base;
  using Base::to_mesh;
  typename Base::Location to_mesh(const typename Base::Domain_point& p) const { return Base::to_mesh(p, -1); }
};

/// Errors of the mean curvature, against the truth, in percent of the larger principal one.
template <class Atlas>
void compare_curvature(const std::string& name,
                       const std::function<Eigen::Vector3d(const typename Atlas::Domain_point&)>& f,
                       const std::function<std::pair<double, double>(const Eigen::Vector3d&)>& truth,
                       double tolerance)
{
  const Smooth_map<Atlas> map(f, 24);
  const auto np = SM::parameters::rms_error(tolerance).max_error(10 * tolerance);
  SM::Fit_report fit;
  const auto surface = SM::fit_surface(map, np.fit_target(SM::Fit_target::FACETS).fit_report(std::ref(fit)));
  SM::Cad_report cad;
  const SM::Cad_surface faces = SM::fit_cad_surface(map, np.cad_report(std::ref(cad)));
  const auto points = random_domain_points<Atlas>(5000);
  const auto row = [&](const char* method, std::size_t controls, double rms, const auto& jet) {
    std::vector<double> errors;
    for (const auto& p : points) {
      const auto [k1, k2] = truth(f(p));
      errors.push_back(100 * std::abs(SM::mean_curvature(jet(p)) - (k1 + k2) / 2) /
                       (std::max)(std::abs(k1), std::abs(k2)));
    }
    std::sort(errors.begin(), errors.end());
    std::cout << name << ",," << tolerance << ',' << method << ',' << controls << ',' << rms;
    for (const double share : {0.5, 0.95, 1.})
      std::cout << ',' << errors[std::size_t(share * double(errors.size() - 1))];
    std::cout << std::endl;
  };
  row("charts", fit.controls, fit.rms_error, [&](const auto& p) { return surface.jet(p); });
  row("tiles", cad.functions, cad.rms_deviation, [&](const auto& p) { return jet_at(faces, Atlas(), p); });
}

} // namespace

int main(int argc, char** argv)
{
  const bool is_quick = argc > 1 && argv[1] == std::string("--quick");
  std::cout << "surface,,rms tolerance,method,controls,rms,H median,H 95 %,H max\n";
  for (const double tolerance :
       is_quick ? std::vector<double>{1e-4} : std::vector<double>{1e-3, 1e-4, 1e-5, 1e-6}) {
    const Eigen::Vector3d axes(3, 2, 1);
    const auto ellipsoid = [axes](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return axes.cwiseProduct(p);
    };
    compare_curvature<SM::Sphere_atlas>(
      "ellipsoid", ellipsoid,
      [axes](const Eigen::Vector3d& x) {
        const Eigen::Vector3d squares = axes.cwiseProduct(axes), g = x.cwiseQuotient(squares);
        const double n = g.norm(), product = axes.prod();
        const double gauss = 1 / (product * product * std::pow(n, 4));
        const double mean = (squares.sum() - x.squaredNorm()) / (2 * product * product * std::pow(n, 3));
        const double root = std::sqrt((std::max)(0., mean * mean - gauss));
        return std::make_pair(mean + root, mean - root);
      },
      tolerance);
    compare_curvature<SM::Torus_atlas>(
      "torus", [](const Eigen::Vector2d& p) { return torus_of_revolution(p, 0.8); },
      [](const Eigen::Vector3d& x) {
        const double rho = std::hypot(x[0], x[1]);
        return std::make_pair(1 / 0.8, (rho - 2) / (0.8 * rho));
      },
      tolerance);
  }

  std::cout << "\nmesh,faces,rms tolerance,method,controls,rms,max,fit seconds,million jets per "
               "second,condition bare,"
               "condition as solved\n";
  for (int k = is_quick ? 2 : 1; k < argc; ++k) {
    try {
      Mesh mesh;
      SM::read_mesh(argv[k], mesh);
      const auto any =
        SM::map_to_canonical_surface(mesh, SM::parameters::map_options(SM::map_options_for_fitting()));
      std::string name = argv[k];
      name = name.substr(name.find_last_of('/') + 1);
      for (const double tolerance : is_quick ? std::vector<double>{3e-3} : std::vector<double>{3e-3, 1e-3})
        std::visit([&](const auto& map) { compare(name, map, tolerance); }, any);
    } catch (const std::exception& e) {
      std::cerr << argv[k] << ": " << e.what() << std::endl;
      return 1;
    }
  }
}
