// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_POINTS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_POINTS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The points where the error of a fit is measured: all vertices, then three points in each face, with
/// the charts that see them. Virtual faces, which only close borders, are left out. What does not change
/// during the refinement is computed once.
template <class Map, class Bump>
class Target_points {
public:
  using Atlas = typename Map::Atlas;
  using Domain_point = typename Atlas::Domain_point;

  /// A point in one of its charts.
  struct View {
    Chart_point at;
    double blend;              // b_c
    Eigen::Vector3d embedding; // E_c, kept up to date by `update()`
  };

  using Partition = Partition_of_unity<Atlas, Bump>;

  Target_points(const Map& map, const Bump& bump)
    : partition_(bump, map.atlas())
  {
    const std::size_t n = map.number_of_vertices() + 3 * map.number_of_faces();
    domain_.reserve(n);
    target_.reserve(n);
    begin_.reserve(n + 1);
    begin_.push_back(0);
    for(std::size_t v = 0; v < map.number_of_vertices(); ++v)
      if(!map.is_virtual_vertex(v))
        add(map.domain_point(v), map.point(v));
    vertices_ = size();
    for(std::size_t f = 0; f < map.number_of_faces(); ++f)
      for(int k = 0; k < 3 && !map.is_virtual(f); ++k) {
        typename Map::Location location;
        location.face = int(f);
        location.barycentric.setConstant(1. / 6);
        location.barycentric[k] = 2. / 3;
        add(map.to_domain(location), map.position(location));
      }
  }

  const Partition& partition() const { return partition_; }
  std::size_t size() const { return domain_.size(); }
  std::size_t number_of_vertices() const { return vertices_; }
  const Domain_point& domain(std::size_t k) const { return domain_[k]; }
  const Eigen::Vector3d& target(std::size_t k) const { return target_[k]; }
  const View* begin(std::size_t k) const { return views_.data() + begin_[k]; }
  const View* end(std::size_t k) const { return views_.data() + begin_[k + 1]; }

  /// Evaluates the embedding of chart c anew.
  template <class ChartEmbedding>
  void update(int c, const ChartEmbedding& embedding)
  {
    for(View& view : views_)
      if(view.at.chart == c)
        view.embedding = embedding.point(view.at.uv);
  }

  /// E(p) - M(p) at point k.
  Eigen::Vector3d residual(std::size_t k) const
  {
    Eigen::Vector3d e = -target_[k];
    for(const View* v = begin(k); v != end(k); ++v)
      e += v->blend * v->embedding;
    return e;
  }

private:
  void add(const Domain_point& p, const Eigen::Vector3d& x)
  {
    for(const auto& w : partition_.weights(p))
      views_.push_back({w.point, w.weight, Eigen::Vector3d::Zero()});
    domain_.push_back(p);
    target_.push_back(x);
    begin_.push_back(views_.size());
  }

  Partition partition_;
  std::size_t vertices_ = 0;
  std::vector<Domain_point> domain_;
  std::vector<Eigen::Vector3d> target_;
  std::vector<std::size_t> begin_; // of the views of a point
  std::vector<View> views_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_POINTS_H
