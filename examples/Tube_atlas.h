// A canonical surface of one's own: the flat torus again, but with as many charts along it and round it as a shape needs.
// The nine charts of SM::Torus_atlas are squares; over a long tube they become ribbons.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_TUBE_ATLAS_H
#define SIMPLE_MANIFOLDS_EXAMPLES_TUBE_ATLAS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

/// One chart, a model of `ManifoldChart`: a rectangle of 2 x 2 cells of the columns and rows of the atlas.
class Tube_chart {
public:
  using Domain_point = Eigen::Vector2d;

  Tube_chart(int column, int row, const Eigen::Array2d& cells) : corner_(column, row), cells_(cells) {}

  bool contains(const Domain_point& p) const
  {
    const Eigen::Vector2d uv = coordinates(p);
    return uv.minCoeff() > 0 && uv.maxCoeff() < 1;
  }
  Eigen::Vector2d coordinates(const Domain_point& p) const
  {
    const Eigen::Array2d x = p.array() * cells_ - corner_; // in cells
    return (x - cells_ * (x / cells_).floor()) / 2;
  }
  Domain_point point(const Eigen::Vector2d& uv) const
  {
    return SM::Torus_atlas().canonical((corner_ + 2 * uv.array()) / cells_);
  }
  SM::Basic_jet<Domain_point> point_jet(const Eigen::Vector2d& uv) const { return jet_at(point(uv)); }
  SM::Basic_jet<Domain_point> jet_at(const Domain_point& p) const
  {
    const Eigen::Vector2d zero(0, 0);
    return {p, {2 / cells_[0], 0}, {0, 2 / cells_[1]}, zero, zero, zero};
  }
  SM::Transition_jet coordinates_jet(const SM::Basic_jet<Domain_point>& p) const
  {
    return {coordinates(p.value), in_chart(p.u),  in_chart(p.v),
            in_chart(p.uu),       in_chart(p.uv), in_chart(p.vv)};
  }
  /// A vector of the domain in the coordinates of the chart.
  Eigen::Vector2d in_chart(const Eigen::Vector2d& d) const { return d.array() * cells_ / 2; }

private:
  Eigen::Array2d corner_, cells_;
};

//! [atlas]
/// A model of `ManifoldAtlas`. What does not depend on the charts is that of the torus.
class Tube_atlas : SM::Torus_atlas {
public:
  using Torus_atlas::area, Torus_atlas::area_element, Torus_atlas::barycentric, Torus_atlas::canonical,
    Torus_atlas::coordinate_names, Torus_atlas::covers_once, Torus_atlas::Deck, Torus_atlas::deck,
    Torus_atlas::degree_tolerance, Torus_atlas::Domain_jet, Torus_atlas::Domain_point, Torus_atlas::edge_size,
    Torus_atlas::equal_area_point, Torus_atlas::flat_edges, Torus_atlas::for_each_copy, Torus_atlas::genus,
    Torus_atlas::has_flat_pictures, Torus_atlas::has_flat_transitions, Torus_atlas::has_free_metric,
    Torus_atlas::has_single_chart, Torus_atlas::homogeneous, Torus_atlas::homogeneous_jet,
    Torus_atlas::interpolate, Torus_atlas::is_closed, Torus_atlas::is_on_border, Torus_atlas::is_triangle,
    Torus_atlas::is_triangle_in_chart, Torus_atlas::is_valid, Torus_atlas::kernel_point,
    Torus_atlas::better_places, Torus_atlas::midpoint, Torus_atlas::number_of_pictures,
    Torus_atlas::orientation, Torus_atlas::picture, Torus_atlas::Picture_copy, Torus_atlas::query,
    Torus_atlas::side_of_step, Torus_atlas::signed_area, Torus_atlas::squared_distance;

  using Chart = Tube_chart;
  using Chart_list = std::vector<SM::Chart_point>;
  using Chart_numbers = std::vector<int>;
  static constexpr int max_charts_per_point = 4;
  static constexpr const char* name = "tube"; // in files, with its numbers
  static constexpr std::array<const char*, 2> number_keys = {{"columns", "rows"}};

  explicit Tube_atlas(const std::array<int, 2>& numbers) : columns_(numbers[0]), rows_(numbers[1]) {}
  static bool accepts(const std::array<int, 2>& numbers) { return numbers[0] >= 3 && numbers[1] >= 3; }
  std::array<int, 2> numbers() const { return {{columns_, rows_}}; }
  int number_of_charts() const { return columns_ * rows_; }
  //! [atlas]

  Chart chart(int c) const { return Chart(c % columns_, c / columns_, Eigen::Array2d(columns_, rows_)); }
  bool contains(int c, const Domain_point& p) const { return chart(c).contains(p); }
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const { return chart(c).coordinates(p); }
  Domain_point point(const SM::Chart_point& q) const { return chart(q.chart).point(q.uv); }
  Chart_list charts_at(const Domain_point& p) const
  {
    Chart_list list;
    for (const int c : chart_numbers_at(p)) list.push_back({c, coordinates(c, p)});
    return list;
  }
  Chart_numbers chart_numbers_at(const Domain_point& p) const
  {
    // Charts that begin in the cell of p or in the one before, in both directions; on the border of a cell fewer.
    const int column = int(std::floor(p[0] * columns_)), row = int(std::floor(p[1] * rows_));
    Chart_numbers list;
    for (int r = row - 1; r <= row; ++r)
      for (int c = column - 1; c <= column; ++c) {
        const int number = (c + columns_) % columns_ + columns_ * ((r + rows_) % rows_);
        if (contains(number, p)) list.push_back(number);
      }
    std::sort(list.begin(), list.end());
    return list;
  }
  int best_chart(const Domain_point& p) const { return tile(p); }
  bool has_transition(int i, int j) const
  {
    const auto is_near = [](int a, int b, int n) { return (a - b + 1 + n) % n < 3; };
    return is_near(i % columns_, j % columns_, columns_) && is_near(i / columns_, j / columns_, rows_);
  }
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const
  {
    return i == j ? uv : coordinates(j, chart(i).point(uv));
  }
  SM::Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const
  {
    return SM::identity_jet(transition(i, j, uv));
  }

  // The tile of a chart is its middle quarter.
  int tile(const Domain_point& p) const
  {
    const auto index = [](double u, int n) { return (int(std::floor(u * n - 0.5)) + n) % n; };
    return index(p[0], columns_) + columns_ * index(p[1], rows_);
  }
  Domain_point tile_point(int tile, double s, double t) const
  {
    // Of sums of integers and s: neighbours get the same bits.
    const auto place = [](double half_cells, int n) {
      return (half_cells < 2 * n ? half_cells : half_cells - 2 * n) / (2 * n);
    };
    return {place(2 * (tile % columns_) + 1 + 2 * s, columns_),
            place(2 * (tile / columns_) + 1 + 2 * t, rows_)};
  }
  double tile_area_element(int, double, double) const { return area() / number_of_charts(); }

  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point& p, const Ring& ring) const
  {
    Chart_numbers list;
    for (const int c : chart_numbers_at(p))
      if (margin(c, p, ring) > 0) list.push_back(c);
    return list;
  }
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const
  {
    int best = -1;
    double largest = 0;
    for (const int c : chart_numbers_at(p))
      if (const double m = margin(c, p, ring); m > largest) {
        largest = m;
        best = c;
      }
    return best;
  }
  std::vector<Eigen::Vector2d> star_in_chart(int c, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const
  {
    std::vector<Eigen::Vector2d> star;
    for (const Domain_point& r : ring) star.push_back(chart(c).in_chart(difference(p, r)));
    return star;
  }
  struct No_motions {
    std::optional<std::vector<Domain_point>> next() { return std::nullopt; }
  };
  No_motions balancing_motions(const std::vector<Domain_point>&, const std::vector<SM::Triangle>&) const
  {
    return {};
  }

private:
  // How far the star is from the border of a chart; negative outside.
  template <class Ring>
  double margin(int c, const Domain_point& p, const Ring& ring) const
  {
    const Eigen::Vector2d centre = coordinates(c, p);
    double least = (std::min)(centre.minCoeff(), 1 - centre.maxCoeff());
    for (const Domain_point& r : ring) {
      const Eigen::Vector2d uv = centre + chart(c).in_chart(difference(p, r));
      least = (std::min)({least, uv.minCoeff(), 1 - uv.maxCoeff()});
    }
    return least;
  }

  int columns_, rows_;
};

#endif // SIMPLE_MANIFOLDS_EXAMPLES_TUBE_ATLAS_H
