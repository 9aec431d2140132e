// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CURVED_TARGET_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CURVED_TARGET_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Local_surface.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The smooth surface that the vertices of a mesh are taken to be samples of, as a function of the domain.
///
/// Each vertex has a `Local_surface` of degree 3 that was fitted to the vertices within two edges; those of the
/// neighbourhood of a point are blended, with weights that are smooth in the domain. Points have an error of fourth
/// order in the size of the faces and curvatures one of second order, while the curvatures of flat facets do not
/// converge. The surfaces pass by their vertices, as a local quadric does: noise is averaged.
///
/// Across creases nothing is blended and no neighbours are looked for: a vertex has one surface for each of its
/// sectors. Creases go through their vertices. At borders the surfaces are one-sided.
template <class Map>
class Curved_target {
public:
  using Location = typename Map::Location;
  using Domain_point = typename Map::Domain_point;

  /// \param crease_angle  see `Crease_sectors`
  Curved_target(const Map& map, double crease_angle, bool is_parallel)
    : map_(map),
      sectors_(map.points(), map.faces(), map.number_of_faces() - map.number_of_virtual_faces(), crease_angle)
  {
    const int n = int(map.number_of_vertices());
    chart_.resize(n);
    for (int v = 0; v < n; ++v) chart_[v] = map.atlas().best_chart(map.domain_point(v));
    find_neighbours();
    patches_.resize(sectors_.number_of_sectors());
    parallel_for(is_parallel, 0, int(patches_.size()), [&](int first, int last) {
      for (int s = first; s < last; ++s) fit(s);
    });
    std::vector<Eigen::Vector3d> shift(patches_.size());
    parallel_for(is_parallel, 0, int(patches_.size()), [&](int first, int last) {
      for (int s = first; s < last; ++s) shift[s] = shift_of(s);
    });
    for (std::size_t s = 0; s < patches_.size(); ++s) patches_[s].shift = shift[s];
  }

  /// \param p  the domain point of the location, which is on no virtual face
  Eigen::Vector3d position(const Location& location, const Domain_point& p) const
  {
    const Eigen::Vector3d& b = location.barycentric;
    Eigen::Vector3d x = base(location, p);
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * location.face + k, l = (k + 1) % 3;
      const double sum = b[k] + b[l];
      if (!sectors_.is_crease(h) || !(b[k] > 0) || !(b[l] > 0)) continue;
      Location on_edge;
      on_edge.face = location.face;
      on_edge.barycentric[k] = b[k] / sum;
      on_edge.barycentric[l] = 1 - on_edge.barycentric[k];
      Eigen::Vector3d way = sectors_.crease_point(h, on_edge.barycentric[l]) - map_.position(on_edge);
      if (const double length = way.norm(); length > largest_way()) way *= largest_way() / length;
      x += sum * sum * (map_.position(on_edge) + way - base(on_edge, map_.to_domain(on_edge)));
    }
    return x;
  }

  /// At a vertex that is not virtual.
  Eigen::Vector3d position(int v) const
  {
    const int s = sectors_.of_vertex(v);
    return s < 0 ? map_.point(v) : blend_at_corner(*sectors_.begin(s));
  }

private:
  static constexpr double usual_shift = 0.05;   // of vertices, in lengths of edges
  static constexpr double largest_slide = 0.25; // along the surface, likewise
  static constexpr double reach = 1.8;          // of a weight, in the frame of its patch

  // Of a point from the facets: very coarse meshes say too little of what is between their vertices.
  double largest_way() const { return 0.01 * map_.diagonal(); }

  struct Patch {
    Local_surface surface;
    double length = 0;         // of the edges
    double largest_height = 0; // above the facets
    Eigen::Vector3d shift =
      Eigen::Vector3d::Zero(); // on creases: from the blend to the vertex; else of the surface
  };

  // The sectors at the corners of the faces of each sector.
  void find_neighbours()
  {
    first_.assign(1, 0);
    std::vector<int> found;
    for (int s = 0; s < sectors_.number_of_sectors(); ++s) {
      found.clear();
      for (const int* h = sectors_.begin(s); h != sectors_.end(s); ++h)
        for (int k = 0; k < 3; ++k) found.push_back(sectors_.at_corner(*h / 3 * 3 + k));
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      neighbours_.insert(neighbours_.end(), found.begin(), found.end());
      first_.push_back(neighbours_.size());
    }
  }

  template <class F>
  void for_each_neighbour(int s, const F& f) const
  {
    for (std::size_t k = first_[s]; k < first_[s + 1]; ++k) f(neighbours_[k]);
  }

  // Those around given ones, sorted.
  std::vector<int> around(const std::vector<int>& sectors) const
  {
    std::vector<int> result;
    for (const int s : sectors) for_each_neighbour(s, [&](int t) { result.push_back(t); });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // In the chart that sees a vertex best, if it sees p.
  std::optional<Eigen::Vector2d> coordinates(int v, const Domain_point& p) const
  {
    if (!map_.atlas().contains(chart_[v], p)) return std::nullopt;
    return map_.atlas().coordinates(chart_[v], p);
  }

  void fit(int s)
  {
    const int v = sectors_.vertex(s);
    const Eigen::Vector3d &origin = map_.point(v), &normal = sectors_.normal(s);
    Patch& patch = patches_[s];
    for (const int* h = sectors_.begin(s); h != sectors_.end(s); ++h)
      patch.length +=
        (map_.point(sectors_.target(*h)) - origin).norm() / double(sectors_.end(s) - sectors_.begin(s));
    if (!(patch.length > 0) || !(normal.squaredNorm() > 0)) return;

    std::vector<int> found = around({s});
    found = around(found);
    if (found.size() < 13) found = around(found);
    std::vector<Local_surface::Point> points;
    int last = -1; // a vertex counts once, whatever the number of its sectors
    bool has_parameters = !sectors_.is_on_crease(v); // a crease must be interpolated, parameters are not
    std::sort(found.begin(), found.end(), [&](int a, int b) {
      return std::pair(sectors_.vertex(a), a) < std::pair(sectors_.vertex(b), b);
    });
    for (const int t : found) {
      const int u = sectors_.vertex(t);
      if (u == last) continue;
      last = u;
      const Eigen::Vector3d offset = map_.point(u) - origin;
      const double turn = (std::max)(0., sectors_.normal(t).dot(normal)); // other sheets do not count
      const double weight =
        std::exp(-0.5 * offset.squaredNorm() / (patch.length * patch.length)) * turn * turn;
      if (!(weight > 1e-8)) continue;
      const auto uv = coordinates(v, map_.domain_point(u));
      has_parameters = has_parameters && uv;
      points.push_back({offset, uv ? *uv : Eigen::Vector2d(0, 0), weight});
    }
    patch.surface = Local_surface(normal, points, has_parameters);
    // Twice the height of an arc above its chord, if it turns as much as the normals do: those of its faces are half as
    // far from its own as those of neighbours.
    const auto tangent = [&](const Eigen::Vector3d& n) {
      return n.squaredNorm() > 0 ? normal.cross(n).norm() / (std::max)(0.1, normal.dot(n)) : 0;
    };
    double turn = 0;
    for (const int* h = sectors_.begin(s); h != sectors_.end(s); ++h)
      turn = (std::max)(turn, 2 * tangent(sectors_.face_normal(*h / 3)));
    for_each_neighbour(s, [&](int t) { turn = (std::max)(turn, tangent(sectors_.normal(t))); });
    patch.largest_height = (std::min)(0.25 * (std::min)(turn, 2.) * patch.length, largest_way());
  }

  // What is left to do after all patches are known: creases go through their vertices, and at other vertices the
  // blend must not be too far away.
  Eigen::Vector3d shift_of(int s) const
  {
    const int v = sectors_.vertex(s);
    const Eigen::Vector3d way = map_.point(v) - blend_at_corner(*sectors_.begin(s));
    if (sectors_.is_interpolated(v)) return way;
    const double length = way.norm(), usual = usual_shift * patches_[s].length;
    return length > usual ? Eigen::Vector3d((1 - usual / length) * way) : Eigen::Vector3d(0, 0, 0);
  }

  Eigen::Vector3d blend_at_corner(int h) const
  {
    Location location;
    location.face = h / 3;
    location.barycentric[h % 3] = 1;
    return blend(location, map_.domain_point(sectors_.source(h)));
  }

  // The blend of the patches around the face.
  Eigen::Vector3d blend(const Location& location, const Domain_point& p) const
  {
    const Eigen::Vector3d flat = map_.position(location);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    int chart = -1; // of the last coordinates
    std::optional<Eigen::Vector2d> uv;
    const auto add = [&](int s, double least) {
      const int v = sectors_.vertex(s);
      const Patch& patch = patches_[s];
      const Eigen::Vector3d& origin = map_.point(v);
      Eigen::Vector3d x = flat;
      double square = reach * reach;
      if (patch.surface.has_parameters()) {
        if (chart_[v] != chart) {
          chart = chart_[v];
          uv = coordinates(v, p);
        }
        if (uv) {
          square = patch.surface.square_in_domain(*uv);
          if (square < reach * reach || least > 0) x = origin + patch.surface.at(*uv);
        }
      } else if (patch.surface.is_curved()) {
        square = patch.surface.square_in_space(flat - origin);
        if (square < reach * reach || least > 0) x = origin + patch.surface.project(flat - origin);
      }
      const double t = (std::max)(0., 1 - square / (reach * reach)), weight = t * t * t + least;
      if (!(weight > 0)) return;
      const Eigen::Vector3d &n = sectors_.normal(s), way = x - flat;
      const double height = n.dot(way), limit = (std::min)(largest_slide * patch.length, largest_way());
      const Eigen::Vector3d slide = way - height * n;
      const double length = slide.norm();
      sum += weight * (std::clamp(height, -patch.largest_height, patch.largest_height) * n +
                       (length > limit ? limit / length : 1) * slide);
      if (!sectors_.is_interpolated(v)) sum += weight * patch.shift;
      total += weight;
    };
    // merges the three sorted lists of neighbours
    std::array<std::size_t, 3> next, last;
    std::array<int, 3> own;
    for (int k = 0; k < 3; ++k) {
      own[k] = sectors_.at_corner(3 * location.face + k);
      next[k] = first_[own[k]];
      last[k] = first_[own[k] + 1];
    }
    for (;;) {
      int s = int(patches_.size());
      for (int k = 0; k < 3; ++k)
        if (next[k] < last[k]) s = (std::min)(s, neighbours_[next[k]]);
      if (s == int(patches_.size())) break;
      double least = 0; // so that the sum of the weights is positive
      for (int k = 0; k < 3; ++k) {
        if (next[k] < last[k] && neighbours_[next[k]] == s) ++next[k];
        if (own[k] == s) least = 1e-3 * location.barycentric[k] * location.barycentric[k];
      }
      add(s, least);
    }
    return flat + sum / total;
  }

  // The blend, moved so that it goes through vertices of creases.
  Eigen::Vector3d base(const Location& location, const Domain_point& p) const
  {
    Eigen::Vector3d x = blend(location, p);
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * location.face + k;
      const double b = location.barycentric[k];
      if (sectors_.is_interpolated(sectors_.source(h))) x += b * b * patches_[sectors_.at_corner(h)].shift;
    }
    return x;
  }

  const Map& map_;
  Crease_sectors sectors_;
  std::vector<int> chart_;         // per vertex: the one that sees it best
  std::vector<std::size_t> first_; // of the neighbours of a sector
  std::vector<int> neighbours_;
  std::vector<Patch> patches_; // per sector
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_TARGET_CURVED_TARGET_H
