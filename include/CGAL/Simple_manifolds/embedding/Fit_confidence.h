// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_CONFIDENCE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_CONFIDENCE_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors.h>
#include <CGAL/Simple_manifolds/internal/Polygon_soup.h>
#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// How far the points of fitted surfaces are from the next crease or border of the mesh, in cells of the spline: what
/// tells where their curvatures are to be believed.
///
/// A smooth surface rounds a crease and has the curvature of the rounding there, with ripples that fade: the error of
/// curvatures becomes about half as large with each cell. Next to a border a surface was fitted from one side only. Where
/// the confidence is 4 or more curvatures can be believed as far as the tolerance allows; below that they are best masked.
/// It says nothing of noise, nor of a tolerance that is too large for the detail.
class Fit_confidence {
public:
  /// \param map  whose mesh a surface was fitted to, such as a `Manifold_map` or a `Mesh_map`; it is not kept
  /// \param crease_angle  edges with a larger angle between the normals of their faces are creases, degrees, as
  ///   `Fit_options::crease_angle`; 180: none is
  template <class Map>
  explicit Fit_confidence(const Map& map, double crease_angle = Fit_options().crease_angle)
  {
    add_lines(internal::map_on_arrays(map), crease_angle * (3.14159265358979324 / 180));
    if (has_lines()) tree_.accelerate_distance_queries();
  }

  Fit_confidence(const Fit_confidence&) = delete;
  Fit_confidence& operator=(const Fit_confidence&) = delete;

  /// Whether the mesh has a crease or a border; else the confidence is infinite everywhere.
  bool has_lines() const { return !tree_.empty(); }

  /// The distance in space from E(p) to the next crease or border of the mesh, divided by the size of the cell of p: of the
  /// leaf of the spline of its best chart, the longer of its sides. 0 or more, or infinite. What is near in space only, on
  /// the other side of a thin wall, counts as well.
  /// \param surface  that was fitted to the map
  template <class Surface>
  double operator()(const Surface& surface, const typename Surface::Domain_point& p) const
  {
    static_assert(std::is_same_v<typename Surface::Chart_embedding, Hierarchical_embedding>,
                  "only fitted surfaces of hierarchical splines have cells");
    if (!has_lines()) return (std::numeric_limits<double>::infinity)();
    const Chart_point q = surface.best_chart_point(p);
    const Hierarchical_embedding& chart = surface.chart_embedding(q.chart);
    const Jet e = chart.jet<1>(q.uv);
    const double cell = std::sqrt((std::max)(e.u.squaredNorm(), e.v.squaredNorm())) /
                        chart.leaves().find(q.uv[0], q.uv[1]).cells;
    const Eigen::Vector3d x = surface.point(p);
    const double distance = std::sqrt(tree_.squared_distance(Kernel::Point_3(x[0], x[1], x[2])));
    return distance > 0 ? distance / cell : 0;
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Segments = std::vector<Kernel::Segment_3>;
  using Tree = AABB_tree<AABB_traits<Kernel, AABB_segment_primitive<Kernel, Segments::const_iterator>>>;

  template <class Map>
  void add_lines(const Map& map, double crease_angle)
  {
    const std::vector<Triangle> faces(map.faces().begin(),
                                      map.faces().end() - std::ptrdiff_t(map.number_of_virtual_faces()));
    const internal::Crease_sectors creases(map.points(), faces, faces.size(), crease_angle);
    const std::vector<int> opposite =
      internal::opposite_half_edges(internal::Triangle_soup(int(map.points().size()), faces));
    const auto point = [&](int v) {
      return Kernel::Point_3(map.point(v)[0], map.point(v)[1], map.point(v)[2]);
    };
    for (int h = 0; h < int(opposite.size()); ++h)
      if (opposite[h] < 0 || (h < opposite[h] && creases.is_crease(h)))
        lines_.emplace_back(point(creases.source(h)), point(creases.target(h)));
    tree_.rebuild(lines_.cbegin(), lines_.cend());
  }

  Segments lines_;
  Tree tree_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_FIT_CONFIDENCE_H
