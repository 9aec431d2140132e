// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_OVERLAY_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_OVERLAY_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/internal/Edge_tracer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Makes the common refinement of two maps. The edges of each are traced through the other mesh: this gives the order of
// the vertices along all edges, and the pair of faces on both sides of each piece of them. As two faces overlap in one
// convex cell at most, the pieces with one pair on their left are the border of its cell: no angles are compared.
//
// An edge of the one crosses one of the other once at most, and no two edges of the overlay have the same ends, since
// edges and faces are smaller than half the shortest loop (on the sphere: than half a great circle).
template <class Result>
class Overlay {
public:
  using Atlas = typename Result::Atlas;
  using Map = Manifold_map<Atlas>;

  Overlay(const Map& source, const Map& target, bool has_threads)
    : source_(source), target_(target), has_threads_(has_threads)
  {
    number_vertices();
    trace_source_edges();
    trace_target_edges();
    make_cells();
    place_vertices();
    triangulate();
  }

  Result result() && { return std::move(result_); }

private:
  using Location = typename Map::Location;
  using Vertex = typename Result::Vertex;
  using Cell = typename Result::Cell;
  using Traces = std::vector<std::vector<Trace_step>>;

  // One of the two meshes.
  struct Layer {
    explicit Layer(const Map& m)
      : map(m), mesh(m), vertex(m.number_of_vertices(), -1), place(m.number_of_vertices())
    {
      for (int h = 0; h < 3 * static_cast<int>(m.number_of_faces()); ++h)
        if (edge(h) == h) edges.push_back(h);
    }

    // The half-edge that stands for an edge.
    int edge(int h) const { return mesh.opposite(h) == -1 ? h : (std::min)(h, mesh.opposite(h)); }
    // The faces on the left and on the right of a half-edge, or -1.
    int left(int h) const { return h / 3; }
    int right(int h) const { return mesh.opposite(h) == -1 ? -1 : mesh.opposite(h) / 3; }

    Location at_vertex(int v) const
    {
      Location x;
      x.face = mesh.face_of(v);
      for (int k = 0; k < 3; ++k) x.barycentric[k] = map.face(x.face)[k] == v;
      return x;
    }
    Location on_edge(int h, double share) const
    {
      Location x;
      x.face = h / 3;
      x.barycentric[h % 3] = 1 - share;
      x.barycentric[(h % 3 + 1) % 3] = share;
      return x;
    }
    std::array<int, 2> ends(int h) const
    {
      return {{(std::min)(mesh.source(h), mesh.target(h)), (std::max)(mesh.source(h), mesh.target(h))}};
    }

    const Map& map;
    Edge_tracer<Map> mesh;
    std::vector<int> edges;         // their half-edges
    std::vector<int> vertex;        // per vertex: that of the overlay
    std::vector<Exact_place> place; // per vertex: in the other mesh
  };

  // A piece of an edge in one direction, and the faces on its left.
  struct Half_edge {
    int source_face, target_face, from, to;

    bool operator<(const Half_edge& h) const
    {
      return std::tie(source_face, target_face, from) < std::tie(h.source_face, h.target_face, h.from);
    }
    bool has_cell_of(const Half_edge& h) const
    {
      return source_face == h.source_face && target_face == h.target_face;
    }
  };

  // By the half-edges that stand for the edges.
  struct Crossing {
    int source_edge, target_edge, vertex;

    bool operator<(const Crossing& c) const
    {
      return std::tie(source_edge, target_edge) < std::tie(c.source_edge, c.target_edge);
    }
  };

  static void require(bool is_right)
  {
    if (!is_right)
      throw Numeric_error(Error_code::numeric_failure, "the common refinement of two maps does not close");
  }

  // Those of both meshes; two that coincide are one.
  void number_vertices()
  {
    int hint = -1;
    for (int v = 0; v < static_cast<int>(source_.map.number_of_vertices()); ++v) {
      if (source_.mesh.face_of(v) == -1) continue;
      Vertex x;
      x.source_vertex = v;
      x.on_source = source_.at_vertex(v);
      x.on_target = locate(source_, v, target_, hint, x.target_vertex, x.target_edge);
      source_.vertex[v] = add_vertex(x);
    }
    hint = -1;
    for (int v = 0; v < static_cast<int>(target_.map.number_of_vertices()); ++v) {
      if (target_.mesh.face_of(v) == -1) continue;
      Vertex x;
      x.target_vertex = v;
      x.on_target = target_.at_vertex(v);
      x.on_source = locate(target_, v, source_, hint, x.source_vertex, x.source_edge);
      target_.vertex[v] = x.source_vertex == -1 ? add_vertex(x) : source_.vertex[x.source_vertex];
    }
  }

  // Where vertex v of a layer is on the other one; sets the vertex or the edge there, if it is at one.
  static Location locate(Layer& layer, int v, const Layer& other, int& hint, int& vertex,
                         std::array<int, 2>& edge)
  {
    const Location x = other.map.to_mesh(layer.map.domain_point(v), hint);
    hint = x.face;
    const Exact_place place = layer.place[v] = other.mesh.place(layer.map.domain_point(v), x.face);
    if (place.corner() != -1)
      vertex = other.map.face(x.face)[place.corner()];
    else if (place.side() != -1)
      edge = other.ends(3 * x.face + place.side());
    return x;
  }

  int add_vertex(const Vertex& x)
  {
    result_.vertices.push_back(x);
    return static_cast<int>(result_.vertices.size()) - 1;
  }

  Traces traces(const Layer& layer, const Layer& other) const
  {
    Traces result(layer.edges.size());
    parallel_for(has_threads_, 0, static_cast<int>(layer.edges.size()), [&](int first, int last) {
      for (int i = first; i < last; ++i) {
        const int v = layer.mesh.source(layer.edges[i]), w = layer.mesh.target(layer.edges[i]);
        result[i] = other.mesh.trace(layer.map.domain_point(v), layer.place[v], layer.map.domain_point(w));
      }
    });
    return result;
  }

  // Calls f(edge, step, from, to) for all pieces of the edges of a layer; crossing(edge, step) tells the vertex there.
  template <class Crossing_vertex, class F>
  void for_each_piece(const Layer& layer, const Layer& other, const Crossing_vertex& crossing, const F& f)
  {
    const Traces all = traces(layer, other);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const int h = layer.edges[i];
      int from = layer.vertex[layer.mesh.source(h)];
      for (const Trace_step& step : all[i]) {
        const int to = step.end == Trace_step::LAST     ? layer.vertex[layer.mesh.target(h)]
                       : step.end == Trace_step::VERTEX ? other.vertex[step.at]
                                                        : crossing(h, step);
        f(h, step, from, to);
        from = to;
      }
    }
  }

  void trace_source_edges()
  {
    for_each_piece(
      source_, target_,
      [&](int h, const Trace_step& step) {
        Vertex x;
        x.source_edge = source_.ends(h);
        x.target_edge = target_.ends(step.at);
        x.on_source = source_.on_edge(h, step.share);
        x.on_target = target_.on_edge(step.at, step.share_of_other);
        crossings_.push_back({h, target_.edge(step.at), add_vertex(x)});
        return crossings_.back().vertex;
      },
      [&](int h, const Trace_step& step, int from, int to) {
        const int g = step.carrier;
        const int target_left = step.along == 0 ? g : step.along > 0 ? target_.left(g) : target_.right(g);
        const int target_right = step.along == 0 ? g : step.along > 0 ? target_.right(g) : target_.left(g);
        add_piece(source_.left(h), target_left, source_.right(h), target_right, from, to);
      });
    std::sort(crossings_.begin(), crossings_.end());
  }

  void trace_target_edges()
  {
    std::size_t met = 0;
    for_each_piece(
      target_, source_,
      [&](int h, const Trace_step& step) {
        const Crossing c{source_.edge(step.at), h, -1};
        const auto found = std::lower_bound(crossings_.begin(), crossings_.end(), c);
        require(found != crossings_.end() && !(c < *found));
        ++met;
        return found->vertex;
      },
      [&](int h, const Trace_step& step, int from, int to) {
        if (step.along == 0) // else it is a piece of an edge of the source, too
          add_piece(step.carrier, target_.left(h), step.carrier, target_.right(h), from, to);
      });
    require(met == crossings_.size());
  }

  void add_piece(int source_left, int target_left, int source_right, int target_right, int from, int to)
  {
    ++pieces_;
    add_half_edge(source_left, target_left, from, to);
    add_half_edge(source_right, target_right, to, from);
  }
  void add_half_edge(int source_face, int target_face, int from, int to)
  {
    require((source_face == -1) == (target_face == -1));
    if (source_face != -1) half_edges_.push_back({source_face, target_face, from, to});
  }

  void make_cells()
  {
    std::sort(half_edges_.begin(), half_edges_.end());
    for (auto begin = half_edges_.begin(); begin != half_edges_.end();) {
      const auto end =
        std::find_if(begin, half_edges_.end(), [&](const Half_edge& h) { return !h.has_cell_of(*begin); });
      require(end - begin >= 3 && end - begin <= 6);
      Cell cell;
      cell.source_face = begin->source_face;
      cell.target_face = begin->target_face;
      auto h = begin;
      do {
        require(h != end && cell.corners.size() < static_cast<std::size_t>(end - begin));
        cell.corners.push_back(h->from);
        h = std::find_if(begin, end, [&](const Half_edge& next) { return next.from == h->to; });
      } while (h != begin);
      require(cell.corners.size() == static_cast<std::size_t>(end - begin));
      result_.cells.push_back(cell);
      begin = end;
    }
    half_edges_.clear();
    half_edges_.shrink_to_fit();
    const long euler_characteristic = static_cast<long>(result_.vertices.size()) -
                                      static_cast<long>(pieces_) + static_cast<long>(result_.cells.size());
    require(euler_characteristic == (Atlas::is_closed ? 2 - 2 * source_.map.atlas().genus() : 1));
  }

  void place_vertices()
  {
    for (const Vertex& x : result_.vertices) {
      result_.domain_points.push_back(x.source_vertex == -1 && x.target_vertex != -1
                                        ? target_.map.domain_point(x.target_vertex)
                                        : source_.map.to_domain(x.on_source));
      result_.points_on_source.push_back(source_.map.position(x.on_source));
      result_.points_on_target.push_back(target_.map.position(x.on_target));
    }
  }

  // Of the fans of triangles in a cell that with the largest smallest triangle.
  void triangulate()
  {
    for (std::size_t i = 0; i < result_.cells.size(); ++i) {
      const auto& corners = result_.cells[i].corners;
      const std::size_t n = corners.size();
      const auto triangle = [&](std::size_t apex, std::size_t k) {
        return Triangle{corners[apex], corners[(apex + k) % n], corners[(apex + k + 1) % n]};
      };
      std::size_t best = 0;
      double largest = -1;
      for (std::size_t apex = 0; apex < n && n > 3; ++apex) {
        double smallest = (std::numeric_limits<double>::max)();
        for (std::size_t k = 1; k + 1 < n; ++k) smallest = (std::min)(smallest, size(triangle(apex, k)));
        if (smallest > largest) {
          best = apex;
          largest = smallest;
        }
      }
      for (std::size_t k = 1; k + 1 < n; ++k) {
        result_.faces.push_back(triangle(best, k));
        result_.cell_of_face.push_back(static_cast<int>(i));
      }
    }
  }

  // The area on both shapes, each in units of its diagonal.
  double size(const Triangle& t) const
  {
    const auto area = [&](const std::vector<Eigen::Vector3d>& x, double diagonal) {
      return ((x[t[1]] - x[t[0]]) / diagonal).cross((x[t[2]] - x[t[0]]) / diagonal).norm();
    };
    return area(result_.points_on_source, source_.map.diagonal()) +
           area(result_.points_on_target, target_.map.diagonal());
  }

  Layer source_, target_;
  bool has_threads_;
  std::size_t pieces_ = 0;
  std::vector<Half_edge> half_edges_;
  std::vector<Crossing> crossings_; // sorted when all are known
  Result result_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_OVERLAY_H
