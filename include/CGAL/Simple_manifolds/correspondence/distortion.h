// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/internal/Vertex_faces.h>
#include <CGAL/Simple_manifolds/internal/bounding_cube.h>
#include <CGAL/Simple_manifolds/internal/variation.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// How far a map is from an isometry. Each face of the mesh is mapped linearly to its domain triangle
/// (the chordal one on the sphere); sigma1 >= sigma2 are the singular values of that map after both
/// surfaces are scaled to the same total area. Means are weighted by the area in space; faces without
/// area in space are left out.
struct Distortion {
  double angle_mean = 0;          ///< of sigma1 / sigma2: 1 when conformal
  double angle_p99 = 0;           ///< its weighted 99th percentile
  double angle_max = 0;           ///< its largest value
  double area_mean_abs_log10 = 0; ///< of |log10 (share of the domain's area / share of the mesh's area)|
  double area_max_abs_log10 = 0;  ///< its largest value
  /// Mean of (sigma1^2 + sigma2^2 + sigma1^-2 + sigma2^-2) / 4: 1 when isometric, else larger.
  double symmetric_dirichlet = 0;
  /// 1 / mean of (sigma1^-2 + sigma2^-2) / 2, the L2 stretch efficiency: 1 is best (Sander et al. 2001).
  double l2_efficiency = 0;
  double smallest_domain_area = 0; ///< signed, of one face, the domain as it is (unit sphere, unit square)
  std::size_t zero_area_faces = 0; ///< faces without area in space
  /// The constant metric of the domain that was used: on the torus the one of determinant 1 in which
  /// the map has the least Dirichlet energy, since the unit square is only one of all flat tori.
  Eigen::Matrix2d metric = Eigen::Matrix2d::Identity();
};

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// How the vertices and faces of a map lie in the charts.
struct Chart_report {
  std::vector<std::size_t> chart_counts; ///< vertices in each tile
  double variation = 0;                  ///< standard deviation of the counts over their mean
  double largest_over_mean = 0;          ///< largest count over the mean
  std::size_t stars_without_chart = 0;   ///< vertices that share no chart with all their neighbours
  std::size_t faces_without_chart = 0;   ///< faces whose corners lie in no common chart
};

namespace internal {

// The linear maps of the faces with area in space, and the areas.
struct Face_maps {
  std::vector<Eigen::Matrix2d> jacobian;
  std::vector<double> area;        // in space, in a unit of their own
  std::vector<double> flat_area;   // of the flat domain triangle
  std::vector<double> domain_area; // on the sphere the spherical one
  std::size_t zero_area_faces = 0;
  double smallest_domain_area = (std::numeric_limits<double>::max)();
};

// The edge vectors d and e of a triangle in its own plane, d along the first axis.
inline Eigen::Matrix2d flatten(const Eigen::Vector3d& d, const Eigen::Vector3d& e)
{
  const double length = d.norm();
  Eigen::Matrix2d m;
  m << length, d.dot(e) / length, 0, d.cross(e).norm() / length;
  return m;
}
inline Eigen::Matrix2d flatten(const Eigen::Vector2d& d, const Eigen::Vector2d& e)
{
  Eigen::Matrix2d m;
  m << d, e;
  return m;
}

template <class Atlas>
Face_maps face_maps(const Atlas& atlas, const std::vector<Eigen::Vector3d>& points,
                    const std::vector<typename Atlas::Domain_point>& domain_points,
                    const std::vector<Triangle>& faces)
{
  Face_maps maps;
  const double scale = unit_scale(points); // nothing here depends on the size
  for (const Triangle& t : faces) {
    const auto& a = domain_points[t[0]];
    const auto& b = domain_points[t[1]];
    const auto& c = domain_points[t[2]];
    const Eigen::Vector3d p = scale * points[t[0]], d = scale * points[t[1]] - p,
                          e = scale * points[t[2]] - p;
    const double area = d.cross(e).norm() / 2, domain_area = atlas.signed_area(a, b, c);
    maps.smallest_domain_area = (std::min)(maps.smallest_domain_area, domain_area);
    if (!(area > 0)) {
      ++maps.zero_area_faces;
      continue;
    }
    const auto edges = atlas.flat_edges(a, b, c);
    const Eigen::Matrix2d space = flatten(d, e), domain = flatten(edges.first, edges.second);
    Eigen::Matrix2d inverse; // of an upper triangular matrix
    inverse << 1 / space(0, 0), -space(0, 1) / (space(0, 0) * space(1, 1)), 0, 1 / space(1, 1);
    maps.jacobian.push_back(domain * inverse);
    maps.area.push_back(area);
    maps.flat_area.push_back(std::abs(domain.determinant()) / 2);
    maps.domain_area.push_back(std::abs(domain_area));
  }
  return maps;
}

// The metric M = G^-1 sqrt(det G), G = sum of area * J J^T, minimises the Dirichlet energy
// sum of area * tr(J^T M J) among all metrics of determinant 1.
Eigen::Matrix2d best_metric(const Face_maps& maps);

// Largest and smallest singular value of a 2x2 matrix.
std::pair<double, double> singular_values(const Eigen::Matrix2d& m);

Distortion distortion_in_metric(const Face_maps& maps, const Eigen::Matrix2d& metric);

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The distortion of a map given by arrays; on the torus in the best constant metric (`Distortion::metric`).
/// Degenerate domain triangles make values infinite.
/// \pre `points.size() == domain_points.size()`
template <class Atlas>
Distortion distortion(const Atlas& atlas, const std::vector<Eigen::Vector3d>& points,
                      const std::vector<typename Atlas::Domain_point>& domain_points,
                      const std::vector<Triangle>& faces)
{
  CGAL_precondition(points.size() == domain_points.size());
  const internal::Face_maps maps = internal::face_maps(atlas, points, domain_points, faces);
  const bool has_metric = Atlas::has_free_metric && !maps.area.empty();
  return internal::distortion_in_metric(maps, has_metric ? internal::best_metric(maps)
                                                         : Eigen::Matrix2d(Eigen::Matrix2d::Identity()));
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The distortion in a given constant metric of the torus or the square; the identity takes the unit
/// square as it is.
/// \pre `metric` is symmetric and positive definite
template <class Atlas>
Distortion distortion(const Atlas& atlas, const std::vector<Eigen::Vector3d>& points,
                      const std::vector<typename Atlas::Domain_point>& domain_points,
                      const std::vector<Triangle>& faces, const Eigen::Matrix2d& metric)
{
  CGAL_precondition(points.size() == domain_points.size());
  return internal::distortion_in_metric(internal::face_maps(atlas, points, domain_points, faces), metric);
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The distortion of a map, without its virtual faces.
template <class Atlas>
Distortion distortion(const Manifold_map<Atlas>& map)
{
  std::vector<Triangle> faces = map.faces();
  faces.resize(faces.size() - map.number_of_virtual_faces());
  return distortion(map.atlas(), map.points(), map.domain_points(), faces);
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// How the vertices and faces lie in the charts (criterion 2 of Grimm 2002, section 4.2, counts the stars).
/// Vertices of no face are ignored.
template <class Atlas>
Chart_report chart_report(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& domain_points,
                          const std::vector<Triangle>& faces)
{
  std::vector<char> used(domain_points.size(), false);
  for (const Triangle& t : faces)
    for (int v : t) used[v] = true;
  Chart_report report;
  report.chart_counts.resize(atlas.number_of_charts());
  const internal::Vertex_faces vertex_faces(domain_points.size(), faces);
  std::vector<typename Atlas::Domain_point> ring;
  for (std::size_t v = 0; v < domain_points.size(); ++v) {
    if (!used[v]) continue;
    ++report.chart_counts[atlas.tile(domain_points[v])];
    ring.clear();
    for (const int* f = vertex_faces.begin(v); f != vertex_faces.end(v); ++f)
      for (const int w : faces[*f])
        if (w != static_cast<int>(v)) ring.push_back(domain_points[w]);
    report.stars_without_chart += atlas.charts_of_star(domain_points[v], ring).empty();
  }
  for (const Triangle& t : faces) {
    const std::array<typename Atlas::Domain_point, 2> others = {{domain_points[t[1]], domain_points[t[2]]}};
    report.faces_without_chart += atlas.charts_of_star(domain_points[t[0]], others).empty();
  }

  std::size_t sum = 0, largest = 0;
  for (std::size_t n : report.chart_counts) {
    sum += n;
    largest = (std::max)(largest, n);
  }
  if (sum > 0) {
    report.variation = internal::variation(report.chart_counts);
    report.largest_over_mean =
      static_cast<double>(largest * report.chart_counts.size()) / static_cast<double>(sum);
  }
  return report;
}

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The same for a map: any class with the members `atlas`, `domain_points` and `faces`.
template <class Map>
Chart_report chart_report(const Map& map)
{
  return chart_report(map.atlas(), map.domain_points(), map.faces());
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/distortion_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_DISTORTION_H
