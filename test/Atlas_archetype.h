#ifndef SIMPLE_MANIFOLDS_TEST_ATLAS_ARCHETYPE_H
#define SIMPLE_MANIFOLDS_TEST_ATLAS_ARCHETYPE_H

// A user's canonical surface, of which the package knows nothing: the flat torus with as many columns and rows of
// charts as the object says. It has the members that the page ManifoldAtlas asks for, and no others.

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace archetype {

using CGAL::Simple_manifolds::Basic_jet;
using CGAL::Simple_manifolds::Chart_point;
using CGAL::Simple_manifolds::Jet;
using CGAL::Simple_manifolds::Torus_atlas;
using CGAL::Simple_manifolds::Transition_jet;
using CGAL::Simple_manifolds::Triangle;

// Two cells wide and high, of the columns and rows of an atlas.
class Chart {
public:
  using Domain_point = Eigen::Vector2d;

  Chart(int column, int row, const Eigen::Vector2d& scale) : corner_(column, row), scale_(scale) {}
  Chart(const Chart&) = default;
  Chart& operator=(const Chart&) = default;

  bool contains(const Domain_point& p) const
  {
    const Eigen::Vector2d uv = coordinates(p);
    return uv.minCoeff() > 0 && uv.maxCoeff() < 1;
  }
  Eigen::Vector2d coordinates(const Domain_point& p) const
  {
    Eigen::Vector2d x = p.cwiseProduct(scale_) - corner_; // in cells
    for (int k = 0; k < 2; ++k) x[k] -= scale_[k] * std::floor(x[k] / scale_[k]);
    return x / 2;
  }
  Domain_point point(const Eigen::Vector2d& uv) const
  {
    return Torus_atlas().canonical((corner_ + 2 * uv).cwiseQuotient(scale_));
  }
  Basic_jet<Domain_point> point_jet(const Eigen::Vector2d& uv) const { return jet_at(point(uv)); }
  Basic_jet<Domain_point> jet_at(const Domain_point& p) const
  {
    const Eigen::Vector2d zero(0, 0);
    return {p, {2 / scale_[0], 0}, {0, 2 / scale_[1]}, zero, zero, zero};
  }
  Transition_jet coordinates_jet(const Basic_jet<Domain_point>& p) const
  {
    const auto scaled = [this](const Eigen::Vector2d& d) -> Eigen::Vector2d {
      return d.cwiseProduct(scale_) / 2;
    };
    return {coordinates(p.value), scaled(p.u), scaled(p.v), scaled(p.uu), scaled(p.uv), scaled(p.vv)};
  }

private:
  Eigen::Vector2d corner_, scale_;
};

template <class T>
class List {
public:
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  std::size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  explicit List(std::vector<T> items) : items_(std::move(items)) {}

private:
  std::vector<T> items_;
};

// No motions.
class Motions {
public:
  std::optional<std::vector<Eigen::Vector2d>> next() { return std::nullopt; }
};

class Atlas {
public:
  using Domain_point = Eigen::Vector2d;
  using Domain_jet = Basic_jet<Domain_point>;
  using Chart = archetype::Chart;
  using Chart_list = List<Chart_point>;
  using Chart_numbers = List<int>;
  using Deck = Torus_atlas::Deck;
  using Picture_copy = Torus_atlas::Picture_copy;
  static constexpr int max_charts_per_point = 4;
  static constexpr bool is_closed = true;
  static constexpr bool has_single_chart = false;
  static constexpr bool has_flat_transitions = true;
  static constexpr bool has_flat_pictures = true;
  static constexpr bool has_free_metric = true;
  static constexpr double degree_tolerance = 1e-9;
  static constexpr const char* name = "archetype";
  static constexpr std::array<const char*, 2> coordinate_names = {{"a", "b"}};
  static constexpr std::array<const char*, 2> number_keys = {{"columns", "rows"}};

  // None is made without its numbers.
  explicit Atlas(const std::array<int, 2>& numbers) : columns_(numbers[0]), rows_(numbers[1]) {}
  static bool accepts(const std::array<int, 2>& numbers) { return numbers[0] >= 3 && numbers[1] >= 3; }
  std::array<int, 2> numbers() const { return {{columns_, rows_}}; }

  int genus() const { return 1; }
  int number_of_charts() const { return columns_ * rows_; }
  double area() const { return 1; }

  Chart chart(int c) const { return Chart(c % columns_, c / columns_, Eigen::Vector2d(columns_, rows_)); }
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }
  Domain_point point(const Chart_point& q) const { return chart(q.chart).point(q.uv); }
  Chart_list charts_at(const Domain_point& p) const
  {
    std::vector<Chart_point> list;
    for (const int c : chart_numbers_at(p)) list.push_back({c, coordinates(c, p)});
    return Chart_list(std::move(list));
  }
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    return charts_of_star(p, std::array<Domain_point, 0>());
  }
  int best_chart(const Domain_point& p) const { return tile(p); }
  bool has_transition(int i, int j) const
  {
    const auto is_near_by = [](int a, int b, int n) { return (a - b + 1 + n) % n < 3; };
    return is_near_by(i % columns_, j % columns_, columns_) && is_near_by(i / columns_, j / columns_, rows_);
  }
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const
  {
    return i == j ? uv : coordinates(j, chart(i).point(uv));
  }
  Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const
  {
    return CGAL::Simple_manifolds::identity_jet(transition(i, j, uv));
  }
  double area_element(const Domain_jet& p) const { return p.u.x() * p.v.y() - p.u.y() * p.v.x(); }

  int tile(const Domain_point& p) const
  {
    const auto index = [](double u, int n) { return (int(std::floor(u * n - 0.5)) + n) % n; };
    return index(p[0], columns_) + columns_ * index(p[1], rows_);
  }
  Domain_point tile_point(int tile, double s, double t) const
  {
    const auto place = [](double half_cells, int n) {
      return (half_cells < 2 * n ? half_cells : half_cells - 2 * n) / (2 * n);
    };
    return {place(2 * (tile % columns_) + 1 + 2 * s, columns_),
            place(2 * (tile / columns_) + 1 + 2 * t, rows_)};
  }
  double tile_area_element(int, double, double) const { return 1. / number_of_charts(); }

  Domain_point canonical(const Domain_point& p) const { return torus_.canonical(p); }
  Domain_point query(const Domain_point& p) const { return torus_.canonical(p); }
  bool is_valid(const Domain_point& p) const { return torus_.is_valid(p); }
  bool is_on_border(const Domain_point&) const { return false; }
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const { return torus_.midpoint(p, q); }
  double squared_distance(const Domain_point& p, const Domain_point& q) const
  {
    return torus_.squared_distance(p, q);
  }
  double edge_size(const Domain_point& p, const Domain_point& q) const { return torus_.edge_size(p, q); }
  Domain_point equal_area_point(double a, double b) const { return {a, b}; }

  Deck deck(const Domain_point& p, const Domain_point& q) const { return torus_.deck(p, q); }
  bool is_triangle(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return torus_.is_triangle(p, q, r);
  }
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return torus_.orientation(p, q, r);
  }
  int orientation(const Domain_point& p, const Domain_point& q, const Deck& dq, const Domain_point& r,
                  const Deck& dr) const
  {
    return torus_.orientation(p, q, dq, r, dr);
  }
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point& x) const
  {
    return torus_.side_of_step(p, q, x);
  }
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& b) const
  {
    return torus_.interpolate(p, q, r, b);
  }
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const
  {
    return torus_.barycentric(p, q, r, x);
  }
  std::pair<Eigen::Vector2d, Eigen::Vector2d> flat_edges(const Domain_point& p, const Domain_point& q,
                                                         const Domain_point& r) const
  {
    return torus_.flat_edges(p, q, r);
  }
  double signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const
  {
    return torus_.signed_area(p, q, r);
  }
  std::optional<bool> covers_once(const std::vector<Domain_point>&, const std::vector<Triangle>&) const
  {
    return std::nullopt;
  }

  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point& p, const Ring& ring) const
  {
    std::vector<int> list;
    for (int c = 0; c < number_of_charts(); ++c) {
      const Eigen::Vector2d centre = coordinates(c, p);
      bool fits = contains(c, p);
      for (const Domain_point& r : ring) {
        const Eigen::Vector2d uv = centre + in_chart(Torus_atlas::difference(p, r));
        fits = fits && uv.minCoeff() > 0 && uv.maxCoeff() < 1;
      }
      if (fits) list.push_back(c);
    }
    return Chart_numbers(std::move(list));
  }
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const
  {
    int best = -1;
    double largest = 0;
    for (const int c : charts_of_star(p, ring)) {
      const Eigen::Vector2d centre = coordinates(c, p);
      double margin = (std::min)(centre.minCoeff(), 1 - centre.maxCoeff());
      for (const Eigen::Vector2d& d : star_in_chart(c, p, ring))
        margin = (std::min)({margin, (centre + d).minCoeff(), 1 - (centre + d).maxCoeff()});
      if (margin > largest) {
        best = c;
        largest = margin;
      }
    }
    return best;
  }
  std::vector<Eigen::Vector2d> star_in_chart(int, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const
  {
    std::vector<Eigen::Vector2d> star;
    for (const Domain_point& r : ring) star.push_back(in_chart(Torus_atlas::difference(p, r)));
    return star;
  }
  bool is_triangle_in_chart(int, const Domain_point&, const Domain_point&, const Domain_point&) const
  {
    return true;
  }
  std::optional<Domain_point> kernel_point(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return std::nullopt;
  }
  std::vector<Domain_point> better_places(const Domain_point&, const std::vector<Domain_point>&) const
  {
    return {};
  }
  Motions balancing_motions(const std::vector<Domain_point>&, const std::vector<Triangle>&) const
  {
    return {};
  }

  int number_of_pictures() const { return 1; }
  int picture(const Domain_point&) const { return 0; }
  Eigen::Vector3d homogeneous(const Domain_point& p) const { return torus_.homogeneous(p); }
  Eigen::Vector3d homogeneous(const Domain_point& p, const Domain_point& q) const
  {
    return torus_.homogeneous(p, q);
  }
  Jet homogeneous_jet(const Domain_jet& p) const { return torus_.homogeneous_jet(p); }
  template <class Function>
  void for_each_copy(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                     const Function& f) const
  {
    torus_.for_each_copy(p, q, r, f);
  }
  std::array<Eigen::Vector3d, 3> homogeneous(const Domain_point& p, const Domain_point& q,
                                             const Domain_point& r, const Picture_copy& copy) const
  {
    return torus_.homogeneous(p, q, r, copy);
  }

private:
  Eigen::Vector2d in_chart(const Eigen::Vector2d& d) const
  {
    return d.cwiseProduct(Eigen::Vector2d(columns_, rows_)) / 2;
  }

  Torus_atlas torus_; // for the geometry that does not depend on the charts
  int columns_, rows_;
};

} // namespace archetype

#endif // SIMPLE_MANIFOLDS_TEST_ATLAS_ARCHETYPE_H
