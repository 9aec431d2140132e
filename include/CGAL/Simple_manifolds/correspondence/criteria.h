// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/Splittable_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// How the star of one vertex lies in the charts (criteria 2 to 4 of Grimm 2002, section 5.1).
struct Star_criteria {
  /// The chart that contains the vertex and its neighbours, of several the one whose border is farthest
  /// from them in chart coordinates; -1 where there is none. (Criterion 2: there is one.)
  int chart = -1;
  /// Criterion 3: in the coordinates of that chart, the polygon of the neighbours goes round the vertex.
  /// Vertices on the border of the square belong to their polygon.
  bool contains_vertex = false;
  bool is_convex = false; ///< criterion 4: the polygon is convex; three vertices in line are
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The four criteria of Grimm 2002, section 5.1, for a good correspondence. The first three can be met, see
/// `balance()` and `refine()`; the fourth is an ideal that the paper does not reach either.
struct Criteria_report {
  Chart_report charts;                  ///< criterion 1: the vertices per chart; totals of criterion 2
  double largest_deviation = 0;         ///< of a count from the mean, over the mean; the paper asks for 0.2
  std::vector<Star_criteria> stars;     ///< per vertex; for a vertex of no face the default
  std::size_t vertices = 0;             ///< of faces
  std::size_t vertices_outside = 0;     ///< a chart contains the star, but the polygon not the vertex
  std::size_t convex_stars = 0;         ///< criterion 4
  std::vector<int> first_without_chart; ///< up to 16 vertices that violate criterion 2
  std::vector<int> first_outside;       ///< up to 16 vertices that violate criterion 3

  /// Criterion 4 as a share of the vertices.
  double convex_share() const { return vertices > 0 ? double(convex_stars) / double(vertices) : 0; }

  /// Whether criteria 2 and 3 hold at each vertex.
  bool holds_at_each_vertex() const { return charts.stars_without_chart + vertices_outside == 0; }

  /// The numbers in one sentence.
  std::string sentence() const;
};

namespace internal {

inline double determinant_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// Whether the polygon turns left or goes straight at each corner and all of it is seen from the origin.
// Points in line are no longer quite so in chart coordinates.
bool is_convex_round_origin(std::vector<Eigen::Vector2d> polygon, bool is_closed);

// Criteria 2 to 4 for a vertex at p.
template <class Atlas, class Point>
Star_criteria star_criteria(const Atlas& atlas, const Point& p, const std::vector<Point>& ring,
                            bool is_closed)
{
  Star_criteria s;
  s.chart = atlas.chart_of_star(p, ring);
  if (s.chart == -1) return s;
  std::vector<Eigen::Vector2d> star = atlas.star_in_chart(s.chart, p, ring);
  double turn = 0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Eigen::Vector2d &a = star[i], &b = star[(i + 1) % star.size()];
    turn += std::atan2(determinant_of(a, b), a.dot(b));
  }
  s.contains_vertex = !is_closed || turn > 3.14159265358979323846; // a multiple of 2 pi
  s.is_convex = s.contains_vertex && is_convex_round_origin(std::move(star), is_closed);
  return s;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Measures the four criteria of Grimm 2002, section 5.1. Linear time.
///
/// \param atlas  the canonical surface
/// \param domain_points  one per vertex
/// \param faces  a manifold, with border on the square only
template <class Atlas>
Criteria_report criteria_report(const Atlas& atlas,
                                const std::vector<typename Atlas::Domain_point>& domain_points,
                                const std::vector<Triangle>& faces)
{
  constexpr std::size_t longest_list = 16;
  Criteria_report report;
  report.charts = chart_report(atlas, domain_points, faces);
  const internal::Splittable_mesh mesh(static_cast<int>(domain_points.size()), faces);
  report.stars.resize(domain_points.size());
  std::vector<int> neighbours;
  std::vector<typename Atlas::Domain_point> ring;
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (mesh.is_isolated(v)) continue;
    ++report.vertices;
    const bool is_closed = mesh.ring(v, neighbours);
    ring.clear();
    for (int w : neighbours) ring.push_back(domain_points[w]);
    const Star_criteria s = internal::star_criteria(atlas, domain_points[v], ring, is_closed);
    report.stars[v] = s;
    report.convex_stars += s.is_convex;
    if (s.chart == -1) {
      if (report.first_without_chart.size() < longest_list) report.first_without_chart.push_back(v);
    } else if (!s.contains_vertex) {
      ++report.vertices_outside;
      if (report.first_outside.size() < longest_list) report.first_outside.push_back(v);
    }
  }
  const double mean = double(report.vertices) / atlas.number_of_charts();
  if (mean > 0)
    for (std::size_t n : report.charts.chart_counts)
      report.largest_deviation = (std::max)(report.largest_deviation, std::abs(double(n) / mean - 1));
  return report;
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for a map: any class with the members `atlas`, `domain_points` and `faces`.
template <class Map>
Criteria_report criteria_report(const Map& map)
{
  return criteria_report(map.atlas(), map.domain_points(), map.faces());
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/criteria_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CRITERIA_H
