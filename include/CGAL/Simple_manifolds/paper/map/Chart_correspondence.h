// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_CHART_CORRESPONDENCE_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_CHART_CORRESPONDENCE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/paper/map/Triangle_bins.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// The correspondence between charts and mesh as Grimm 2002, section 5.1, defines it: in each chart, faces
/// are the flat triangles of the coordinates of their vertices, and filled in by barycentric coordinates
/// there.
///
/// Where transitions are affine, on square and torus, all charts say the same, and it is the correspondence
/// of `Manifold_map`. On the sphere they do not: an edge that is straight in one chart is bent in another
/// one. The paper then takes the *default chart* of each face, that with the centre nearest to the face, and
/// notes small inconsistencies at the edges between faces with different default charts: gaps, mostly, and
/// overlaps in the domain, which `edge_gap()` measures. The correspondence of `Manifold_map` has none; this
/// class is for comparison.
///
/// \tparam Map  a `Manifold_map`; it has to outlive this object
template <class Map>
class Chart_correspondence {
public:
  using Atlas = typename Map::Atlas;                 ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  using Location = typename Map::Location;           ///< a face with barycentric coordinates

  /// \param map  must outlive this
  explicit Chart_correspondence(const Map& map) : map_(map)
  {
    const int n = static_cast<int>(map.number_of_faces());
    std::vector<std::vector<Triangle_bins::Plane_triangle>> triangles(map.atlas().number_of_charts());
    faces_.resize(triangles.size());
    for (int f = 0; f < n; ++f) {
      const Triangle& t = map.face(f);
      const std::array<Domain_point, 2> others = {{map.domain_point(t[1]), map.domain_point(t[2])}};
      charts_.push_back(map.atlas().charts_of_star(map.domain_point(t[0]), others));
      default_chart_.push_back(map.chart(f));
      for (const int c : charts_.back()) {
        faces_[c].push_back(f);
        triangles[c].push_back(triangle(c, f));
      }
    }
    for (auto& t : triangles) bins_.emplace_back(std::move(t));
  }
  explicit Chart_correspondence(const Map&&) = delete;

  /// The map.
  const Map& map() const { return map_; }
  /// The faces all of whose vertices lie in a chart.
  /// \pre it is one of the atlas
  const std::vector<int>& faces(int chart) const
  {
    CGAL_precondition(is_chart(chart));
    return faces_[chart];
  }
  /// The chart that decides where a face goes, -1: none.
  /// \pre it is a face of the map
  int default_chart(int face) const
  {
    CGAL_precondition(0 <= face && face < static_cast<int>(default_chart_.size()));
    return default_chart_[face];
  }

  /// M_c: the point of the mesh that belongs to a point of a chart; nothing where no face lies in the chart.
  /// \pre it is a chart of the atlas, and `uv` is in the closed unit square
  std::optional<Location> to_mesh(int chart, const Eigen::Vector2d& uv) const
  {
    CGAL_precondition(is_chart(chart));
    const Triangle_bins::Hit hit = bins_[chart].find(uv);
    if (hit.triangle == -1) return std::nullopt;
    Location location;
    location.face = faces_[chart][hit.triangle];
    location.barycentric = hit.barycentric;
    return location;
  }

  /// M_c^-1: the coordinates in a chart of a point of the mesh; nothing where the face does not lie in the
  /// chart.
  /// \pre they are a chart of the atlas and a face of the map
  std::optional<Eigen::Vector2d> to_chart(int chart, const Location& location) const
  {
    CGAL_precondition(is_chart(chart));
    CGAL_precondition(0 <= location.face && location.face < static_cast<int>(charts_.size()));
    const auto& charts = charts_[location.face];
    if (std::find(charts.begin(), charts.end(), chart) == charts.end()) return std::nullopt;
    const Triangle_bins::Plane_triangle t = triangle(chart, location.face);
    const Eigen::Vector3d& b = location.barycentric;
    return Eigen::Vector2d(b[0] * t[0] + b[1] * t[1] + b[2] * t[2]);
  }

  /// M^-1 by the default chart of the face.
  /// \pre the face has a default chart
  Domain_point to_domain(const Location& location) const
  {
    const int c = default_chart(location.face);
    CGAL_precondition(c != -1);
    return map_.atlas().canonical(map_.atlas().point({c, *to_chart(c, location)}));
  }

  /// M: of the charts that contain the point, the nearest one first, the first that finds it in a face whose
  /// default chart it is; in a gap, the first that finds it at all. Nothing where no face round the point
  /// lies in a chart.
  std::optional<Location> to_mesh(const Domain_point& p) const
  {
    const auto charts = map_.atlas().charts_at(p);
    const int best = map_.atlas().best_chart(p);
    std::optional<Location> other;
    for (const bool is_best : {true, false})
      for (const auto& q : charts) {
        if ((q.chart == best) != is_best) continue;
        std::optional<Location> location = to_mesh(q.chart, q.uv);
        if (location && default_chart_[location->face] == q.chart) return location;
        if (!other) other = location;
      }
    return other;
  }

  /// The distance in the domain between the two points that the faces at an edge say is the middle of it: the
  /// size of the gap or overlap there, 0 up to rounding where they have the same default chart.
  /// \param corner  half-edge `corner` of `face`, from corner `corner` to the next one
  /// \param other_face, other_corner  the opposite half-edge
  /// \pre both faces have a default chart
  double edge_gap(int face, int corner, int other_face, int other_corner) const
  {
    const auto middle = [this](int f, int k) {
      Location location;
      location.face = f;
      location.barycentric[k] = location.barycentric[(k + 1) % 3] = 0.5;
      return to_domain(location);
    };
    return std::sqrt(map_.atlas().squared_distance(middle(face, corner), middle(other_face, other_corner)));
  }

private:
  bool is_chart(int c) const { return 0 <= c && c < map_.atlas().number_of_charts(); }

  Triangle_bins::Plane_triangle triangle(int chart, int face) const
  {
    Triangle_bins::Plane_triangle t;
    for (int k = 0; k < 3; ++k) t[k] = map_.atlas().coordinates(chart, map_.domain_point(map_.face(face)[k]));
    return t;
  }

  const Map& map_;
  std::vector<typename Atlas::Chart_numbers> charts_; // per face
  std::vector<int> default_chart_;
  std::vector<std::vector<int>> faces_; // per chart
  std::vector<Triangle_bins> bins_;
};

/// The map of a mesh (`Mesh_map`) is taken as the map on arrays that it is.
template <class Map>
Chart_correspondence(const Map&) -> Chart_correspondence<internal::Map_on_arrays<Map>>;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_CHART_CORRESPONDENCE_H
