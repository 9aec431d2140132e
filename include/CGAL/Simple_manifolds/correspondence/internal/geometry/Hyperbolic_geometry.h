// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Collapse_hierarchy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Distortion_energy.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Deck_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Hyperbolic_star.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Marked_base.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/hyperboloid.h>
#include <CGAL/Simple_manifolds/internal/Star_kernel.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The hyperbolic surface made of squares as the domain of Coarse_to_fine_layout. Each vertex has a tile, and a position in
// its frame; each half-edge the change of frame from the tile of its target to that of its origin, by its number in a
// table. So all coordinates stay of order 1.
//
// As on the torus, a vertex that comes back has the tile of the one that it was merged into.
class Hyperbolic_geometry {
public:
  using Point = hyperboloid::Point;
  using Tile = hyperboloid::Tile;
  using Star = internal::Star<Hyperbolic_geometry>;
  using Neighbour = Star::Neighbour;
  using Frame = Eigen::Matrix<double, 3, 2>;

  const double total_area;
  const int minimum_vertices;

  Hyperbolic_geometry(int number_of_vertices, int number_of_faces, int genus,
                      const Visitor_reference& visitor)
    : total_area(4 * 3.14159265358979323846 * (genus - 1)),
      minimum_vertices((std::max)(60, 20 * (genus - 1))), visitor_(visitor), copies_(genus - 1),
      position_(number_of_vertices, Point(0, 0, 1)), tile_(number_of_vertices),
      deck_(3 * static_cast<std::size_t>(number_of_faces), 0)
  {
  }

  const Point& position(int v) const { return position_[v]; }
  void set_position(int v, const Point& p) { position_[v] = p; }
  const Tile& tile(int v) const { return tile_[v]; }
  const Tile_isometry& deck(int h) const { return table_.deck(deck_[h]); }

  void renumber(const Collapse_hierarchy&) {}
  // Decimation: nothing beyond the link condition.
  bool is_removable(int) const { return true; }
  bool is_admissible(int, const std::vector<int>&, int) const { return true; }

  bool lay_out_base(const Collapse_hierarchy& mesh)
  {
    const std::optional<Harmonic_map> map = Marked_base(mesh, copies_ + 1, visitor_).find();
    if (!map) return false;
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v) {
      position_[v] = map->position(v);
      tile_[v] = map->tile(v);
    }
    for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h) {
      for (const auto& x : map->deck(h).entries())
        if (x > largest_entry || x < -largest_entry) return false;
      deck_[h] = table_.number(map->deck(h).cast<std::int64_t>());
    }
    return true;
  }

  // Vertices stay in the frames of tiles that they have left by a little.
  void start_level(const Collapse_hierarchy& mesh) { bring_into_tiles(mesh, 1.05); }

  // Each vertex into its tile, up to rounding.
  void finish(const Collapse_hierarchy& mesh) { bring_into_tiles(mesh, 1 + 1e-14); }

  void restore(const Corner_table& t, int h)
  {
    tile_[t.origin(h)] = tile_[t.target(h)];
    for (const int g : {h, t.opposite(h)}) {
      deck_[g] = 0;
      for (const int e : {Corner_table::next(g), Corner_table::previous(g)})
        deck_[e] = table_.inverse(deck_[t.opposite(e)]);
    }
  }

  bool update_metric(const Collapse_hierarchy&, const std::vector<Face_target>&, const Distortion_energy&)
  {
    return false;
  }
  template <class Landmarks>
  void align(const Landmarks&)
  {
  }

  Neighbour neighbour(const Corner_table& t, int h) const { return {t.target(h), deck_[h]}; }
  Point seen(const Neighbour& n) const
  {
    return n.deck == 0 ? position_[n.vertex] : Point(table_.scaled(n.deck) * position_[n.vertex]);
  }

  Quadratic_model model(const Star& star, const Distortion_energy& energy) const
  {
    return star.model(energy, tangent_frame(star.position));
  }
  // There are no landmarks.
  static void attract(Quadratic_model&, const Point&, const Point&, double) {}
  static double squared_distance(const Point&, const Point&) { return 0; }

  Eigen::Vector2d newton_step(const Quadratic_model& m) const { return limited(m.newton_step(1, 0, 1), 0.5); }

  Point moved(const Star& star, const Eigen::Vector2d& t) const
  {
    return hyperboloid::unit(star.position + tangent_frame(star.position) * t);
  }
  int degrees_of_freedom(int) const { return 2; }
  Eigen::Vector2d side_direction(int) const { return Eigen::Vector2d(1, 0); } // there are no sides

  // The Klein model round a point.
  struct Chart {
    Point origin;
    Frame frame;
    double bound;
    Half_plane half_plane(const Point& a, const Point& b) const
    {
      const Point da = a - origin, db = b - origin, cross = da.cross(db);
      return {origin.dot(cross), frame.transpose() * (origin.cross(db - da) + cross)};
    }
    Point point(const Eigen::Vector2d& x) const { return hyperboloid::unit(origin + frame * x); }
    Eigen::Vector2d direction_to(const Point&) const { return Eigen::Vector2d(0, 0); }
  };
  static Chart chart(const Point& origin, const std::vector<Point>& ring)
  {
    Chart c{origin, tangent_frame(origin), 0};
    for (const Point& r : ring) {
      const Eigen::Vector2d x = c.frame.transpose() * hyperboloid::dual(r);
      c.bound = (std::max)(c.bound, x.norm() / -hyperboloid::product(r, origin));
    }
    return c;
  }

private:
  static constexpr std::int64_t largest_entry = std::int64_t(1) << 40;

  static Frame tangent_frame(const Point& p)
  {
    Frame f;
    const Point t = Point(1, 0, 0) + p[0] * p;
    f.col(0) = t / std::sqrt(hyperboloid::product(t, t));
    f.col(1) = hyperboloid::dual(p.cross(f.col(0)));
    return f;
  }

  void bring_into_tiles(const Collapse_hierarchy& mesh, double slack)
  {
    const Corner_table& t = mesh.table();
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v)
      for (int side; (side = hyperboloid::side_beyond(position_[v], slack)) != -1;) {
        const Tile_isometry back = Square_tiling::step(side).inverse();
        position_[v] = hyperboloid::unit(hyperboloid::scaled(back) * position_[v]);
        tile_[v] = tile_[v].beyond(side, copies_);
        t.for_each_outgoing(t.outgoing(v), [&](int h) {
          deck_[h] = table_.number(back * table_.deck(deck_[h]));
          deck_[t.opposite(h)] = table_.inverse(deck_[h]);
        });
      }
  }

  const Visitor_reference& visitor_;
  int copies_;
  Deck_table table_;
  std::vector<Point> position_;
  std::vector<Tile> tile_;
  std::vector<int> deck_; // per half-edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H
