// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MAP_EMBEDDING_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MAP_EMBEDDING_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <type_traits>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The mesh itself as the embedding of a chart, E_c = M o alpha_c^-1: a `Manifold_surface` of these is
/// the input mesh, and everything that works on surfaces works on it. It is continuous only; the jet at a
/// point is that of the face that contains it.
///
/// \tparam Map  a model of `ManifoldMap` with the members `atlas()`, `face(f)`, `domain_point(v)`,
///              `point(v)`, `to_mesh(p)` and `position(location)`, such as `Manifold_map`
///
/// \cgalModels{ChartEmbedding}
template <class Map>
class Map_embedding {
public:
  /// The map must outlive the embedding.
  Map_embedding(const Map& map, int chart) : map_(&map), chart_(chart) {}
  Map_embedding(const Map&&, int) = delete;

  /// Always 0.
  int smoothness() const { return 0; }

  /// The position M(alpha_c^-1(uv)).
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const
  {
    return map_->position(map_->to_mesh(map_->atlas().point(Chart_point{chart_, uv})));
  }

  /// Position and derivatives inside of the face that contains the point.
  template <int Order = 2>
  Jet jet(const Eigen::Vector2d& uv) const
  {
    // Barycentric coordinates are g / sum(g), where g = Q^-1 p and the columns of Q are the corners, in homogeneous
    // coordinates.
    const Basic_jet<Domain_point> p = map_->atlas().chart(chart_).point_jet(uv);
    const auto location = map_->to_mesh(p.value);
    const auto& face = map_->face(location.face);
    Eigen::Matrix3d q, x;
    for (int k = 0; k < 3; ++k) {
      q.col(k) = map_->atlas().homogeneous(p.value, map_->domain_point(face[k]));
      x.col(k) = map_->point(face[k]);
    }
    const Eigen::Matrix3d inverse = q.inverse(), numerator = x * inverse;
    const Jet h = map_->atlas().homogeneous_jet(p);
    const auto sum = [&](const Eigen::Vector3d& y) { return (inverse * y).sum(); };
    Jet e = quotient(Jet{numerator * h.value, numerator * h.u, numerator * h.v, numerator * h.uu,
                         numerator * h.uv, numerator * h.vv},
                     Scalar_jet{sum(h.value), sum(h.u), sum(h.v), sum(h.uu), sum(h.uv), sum(h.vv)});
    if constexpr (Order < 2) e.uu = e.uv = e.vv = Eigen::Vector3d::Zero();
    return e;
  }

private:
  using Atlas = typename Map::Atlas;
  using Domain_point = typename Atlas::Domain_point;

  const Map* map_;
  int chart_;
};

/// The map of a mesh (`Mesh_map`) is taken as the map on arrays that it is.
template <class Map>
Map_embedding(const Map&, int) -> Map_embedding<internal::Map_on_arrays<Map>>;

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// One `Map_embedding` for each chart, as `Manifold_surface` takes them. The map must outlive them.
template <class Map>
std::vector<Map_embedding<internal::Map_on_arrays<Map>>> map_embeddings(const Map& map)
{
  std::vector<Map_embedding<internal::Map_on_arrays<Map>>> charts;
  for (int c = 0; c < map.atlas().number_of_charts(); ++c) charts.emplace_back(map, c);
  return charts;
}
template <class Map>
std::vector<Map_embedding<Map>> map_embeddings(const Map&&) = delete;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MAP_EMBEDDING_H
