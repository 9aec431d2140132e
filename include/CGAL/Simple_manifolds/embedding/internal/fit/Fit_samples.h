// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_SAMPLES_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_SAMPLES_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Cell_tree.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Target.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The points that a surface is fitted to, with all that the charts need to know of them; nothing here
/// depends on the atlas. First come the vertices of the mesh, then the samples of the charts' cells.
struct Fit_samples {
  /// A sample in one of the charts that see it.
  struct View {
    int chart;
    int cell; ///< the node of the chart's tree that contains it: a leaf, once `descend()`ed
    Eigen::Vector2d uv;
    double blend; ///< b_c
  };

  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> normal; ///< of the target, of length 1; zero where it has none
  std::vector<double> domain;          ///< the share of its chart; of a point of the mesh its weight
  std::vector<double> area;            ///< of the part of the mesh that it stands for
  std::vector<int> face;               ///< of the mesh; -1 for a vertex
  std::vector<int> owner;              ///< the chart whose cell it samples; or of_vertex, of_face
  std::vector<std::size_t> begin{0};   ///< of the views of a sample
  std::vector<View> views;

  static constexpr int of_vertex = -1, of_face = -2; ///< owners of points of the mesh

  std::size_t size() const { return target.size(); }

  /// The number of the view of a sample in a chart, counted from its first; -1 if the chart does not see it.
  int view_in(std::size_t sample, int chart) const
  {
    for (std::size_t u = begin[sample]; u < begin[sample + 1]; ++u)
      if (views[u].chart == chart) return int(u - begin[sample]);
    return -1;
  }

  template <class Weights>
  void add(const Eigen::Vector3d& x, const Eigen::Vector3d& direction, double domain_share, double area_share,
           int on_face, int chart, const Weights& weights)
  {
    target.push_back(x);
    normal.push_back(direction.stableNormalized());
    domain.push_back(domain_share);
    area.push_back(area_share);
    face.push_back(on_face);
    owner.push_back(chart);
    for (const auto& w : weights) views.push_back({w.point.chart, -1, w.point.uv, w.weight});
    begin.push_back(views.size());
  }

  void append(const Fit_samples& other)
  {
    const std::size_t shift = views.size();
    target.insert(target.end(), other.target.begin(), other.target.end());
    normal.insert(normal.end(), other.normal.begin(), other.normal.end());
    domain.insert(domain.end(), other.domain.begin(), other.domain.end());
    area.insert(area.end(), other.area.begin(), other.area.end());
    face.insert(face.end(), other.face.begin(), other.face.end());
    owner.insert(owner.end(), other.owner.begin(), other.owner.end());
    views.insert(views.end(), other.views.begin(), other.views.end());
    for (std::size_t k = 1; k < other.begin.size(); ++k) begin.push_back(shift + other.begin[k]);
  }

  /// Keeps the samples k with `keep(k)`, in their order.
  template <class Predicate>
  void keep_if(const Predicate& keep)
  {
    std::size_t to = 0, view = 0;
    for (std::size_t k = 0, first = 0; k < size(); ++k) {
      const std::size_t last = begin[k + 1];
      if (keep(k, first)) {
        target[to] = target[k];
        normal[to] = normal[k];
        domain[to] = domain[k];
        area[to] = area[k];
        face[to] = face[k];
        owner[to] = owner[k];
        for (std::size_t v = first; v < last; ++v) views[view++] = views[v];
        begin[++to] = view;
      }
      first = last;
    }
    target.resize(to);
    normal.resize(to);
    domain.resize(to);
    area.resize(to);
    face.resize(to);
    owner.resize(to);
    views.resize(view);
    begin.resize(to + 1);
  }
};

/// The k-th of some points of a triangle: of a sequence that fills the square evenly (Roberts' R2), folded.
inline Eigen::Vector3d even_barycentric(int k, int count)
{
  if (count == 1) return Eigen::Vector3d::Constant(1. / 3);
  double s = 0.5 + 0.7548776662466927 * k, t = 0.5 + 0.5698402909980532 * k;
  s -= std::floor(s);
  t -= std::floor(t);
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return {1 - s - t, s, t};
}

/// Makes samples of a map.
template <class Map, class Bump>
class Surface_sampler {
public:
  using Partition = Partition_of_unity<typename Map::Atlas, Bump>;

  struct Chart_cell {
    int chart;
    Cell cell;
    int side; ///< cells per side of its level
  };

  Surface_sampler(const Map& map, const Target<Map>& target, const Partition& partition)
    : map_(&map), target_(target), partition_(partition)
  {
  }

  /// Goes on with another map of the same mesh.
  void follow(const Map& map) { map_ = &map; }

  /// All vertices but those that only close borders; `weights` is empty or has one weight per vertex.
  Fit_samples vertices(const std::vector<double>& weights) const
  {
    Fit_samples samples;
    const std::vector<Eigen::Vector3d> normals = vertex_normals();
    for (std::size_t v = 0; v < map_->number_of_vertices(); ++v)
      if (!map_->is_virtual_vertex(v))
        samples.add(target_.at_vertex(v), normals[v], v < weights.size() ? weights[v] : 1., 0, -1,
                    Fit_samples::of_vertex, partition_.weights(map_->domain_point(v)));
    return samples;
  }

  /// About as many points inside of faces as wanted, in proportion to their areas, one at least; none if there are
  /// more faces.
  Fit_samples faces(std::size_t wanted) const
  {
    Fit_samples samples;
    if constexpr (has_facets<Map>) {
      if (map_->number_of_faces() > wanted) return samples;
      double total = 0;
      for (std::size_t f = 0; f < map_->number_of_faces(); ++f)
        if (!map_->is_virtual(f)) total += facet_normal(f).norm();
      for (std::size_t f = 0; f < map_->number_of_faces(); ++f) {
        if (map_->is_virtual(f)) continue;
        const Eigen::Vector3d n = facet_normal(f);
        const double share = total > 0 ? n.norm() / total : 0;
        const int count = 1 + int(share * double(wanted));
        for (int k = 0; k < count; ++k) add_point(int(f), k, count, n, share / count, samples);
      }
    }
    return samples;
  }

  /// 3 x 3 samples in every cell. What is made does not depend on the number of threads.
  Fit_samples cells(bool is_parallel, const std::vector<Chart_cell>& cells) const
  {
    constexpr int piece = 64; // consecutive cells are near one another: the search starts from the last
    const int pieces = int((cells.size() + piece - 1) / piece);
    std::vector<Fit_samples> parts(pieces);
    parallel_tasks(is_parallel, pieces, [&](int k) {
      int face = -1;
      for (std::size_t c = std::size_t(k) * piece; c < cells.size() && c < std::size_t(k + 1) * piece; ++c)
        add_cell(cells[c], face, parts[k]);
    });
    Fit_samples samples;
    for (const Fit_samples& part : parts) samples.append(part);
    return samples;
  }

private:
  void add_cell(const Chart_cell& at, int& face, Fit_samples& samples) const
  {
    using Domain_point = typename Map::Domain_point;
    std::array<Domain_point, 9> p;
    std::array<Eigen::Vector3d, 9> x;
    std::array<bool, 9> is_virtual;
    std::array<int, 9> faces;
    for (int k = 0; k < 9; ++k) {
      const Eigen::Vector2d uv((at.cell.i + (2 * (k / 3) + 1) / 6.) / at.side,
                               (at.cell.j + (2 * (k % 3) + 1) / 6.) / at.side);
      p[k] = map_->atlas().point(Chart_point{at.chart, uv});
      const typename Map::Location location = map_->to_mesh(p[k], face);
      faces[k] = face = location.face;
      is_virtual[k] = map_->is_virtual(face);
      x[k] = is_virtual[k] ? map_->position(location) : target_(location, p[k]);
    }
    for (int k = 0; k < 9; ++k) {
      if (is_virtual[k]) // nothing is known of the surface where a border was closed
        continue;
      const int i = k / 3, j = k % 3, i0 = i > 0 ? i - 1 : 0, i1 = i < 2 ? i + 1 : 2, j0 = j > 0 ? j - 1 : 0,
                j1 = j < 2 ? j + 1 : 2;
      const Eigen::Vector3d du = (x[3 * i1 + j] - x[3 * i0 + j]) / (i1 - i0);
      const Eigen::Vector3d dv = (x[3 * i + j1] - x[3 * i + j0]) / (j1 - j0);
      const Eigen::Vector3d n = du.cross(dv);
      samples.add(x[k], n, 1 / (9. * at.side * at.side), n.norm(), faces[k], at.chart,
                  partition_.weights(p[k]));
    }
  }

  void add_point(int face, int k, int count, const Eigen::Vector3d& normal, double share,
                 Fit_samples& samples) const
  {
    typename Map::Location at;
    at.face = face;
    at.barycentric = even_barycentric(k, count);
    const auto p = map_->to_domain(at);
    samples.add(target_(at, p), normal, share, 0, face, Fit_samples::of_face, partition_.weights(p));
  }

  // Twice the area long.
  Eigen::Vector3d facet_normal(std::size_t f) const
  {
    const Triangle& t = map_->face(f);
    return (map_->point(t[1]) - map_->point(t[0])).cross(map_->point(t[2]) - map_->point(t[0]));
  }

  std::vector<Eigen::Vector3d> vertex_normals() const
  {
    std::vector<Eigen::Vector3d> normals(map_->number_of_vertices(), Eigen::Vector3d::Zero());
    if constexpr (has_facets<Map>)
      for (std::size_t f = 0; f < map_->number_of_faces(); ++f)
        if (!map_->is_virtual(f))
          for (const int v : map_->face(f)) normals[v] += facet_normal(f);
    return normals;
  }

  const Map* map_;
  const Target<Map>& target_;
  const Partition& partition_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_SAMPLES_H
