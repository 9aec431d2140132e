// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Coarse_to_fine_layout.h>
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
#include <limits>
#include <utility>
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

  // attempt: each one looks for other homotopy classes
  Hyperbolic_geometry(int number_of_vertices, int number_of_faces, int genus, int attempt,
                      const Visitor_reference& visitor)
    : total_area(4 * 3.14159265358979323846 * (genus - 1)),
      minimum_vertices((std::max)(60, vertices_per_handle * (genus - 1))), visitor_(visitor),
      attempt_(attempt), copies_(genus - 1), most_work_(attempt == 0 ? 36000000 : 10000000),
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
    if (marking_) return take(*marking_, mesh);
    Marked_base base(mesh, copies_ + 1, attempt_, most_work_, visitor_);
    if (!base.is_possible()) return false;
    Marked_base::Marking best = base.match_handles();
    const auto use = [&](Marked_base::Marking m) {
      if (m.distortion < clear_gain * best.distortion) best = std::move(m);
    };
    if (minimum_vertices < vertices_per_handle * copies_) { // a base of a base
      if (base.work() < most_work_) use(base.match_chains());
    } else {
      // Harmonic maps leave parts that only hang on a handle no room; smaller bases have no such parts.
      const int n = mesh.number_of_active_vertices();
      std::size_t work = 0;
      const auto go_on = [&] { return best.distortion > good_distortion && base.work() + work < most_work_; };
      if (go_on() && best.distortion < (std::numeric_limits<double>::max)()) {
        Hyperbolic_geometry same(*this, mesh, n, 0);
        same.marking_ = &best.map;
        Marked_base::Marking relaxed = base_of_base(mesh, base, same, n + 1);
        if (relaxed.distortion < best.distortion) best = std::move(relaxed);
      }
      int fewest = n;
      for (const int per_handle : {10, 6, 4}) {
        if (!go_on()) break;
        Hyperbolic_geometry smaller(*this, mesh, per_handle * copies_, most_work_ - base.work() - work);
        use(base_of_base(mesh, base, smaller, fewest));
        work += smaller.work_ + static_cast<std::size_t>(1000 * n);
        fewest = (std::min)(fewest, smaller.base_vertices_);
      }
      if (go_on()) use(base.match_chains());
    }
    work_ = base.work();
    if (best.distortion == (std::numeric_limits<double>::max)()) return false;
    return take(best.map, mesh);
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
  static constexpr int vertices_per_handle = 20; // of a base
  static constexpr double good_distortion = 6;   // of a base: no more is tried

  static constexpr double clear_gain = 0.8; // the end of finer levels is only guessed from the base
  // For the base of a base.
  Hyperbolic_geometry(const Hyperbolic_geometry& g, const Collapse_hierarchy& base, int vertices,
                      std::size_t most_work)
    : total_area(g.total_area), minimum_vertices(vertices), visitor_(g.visitor_), attempt_(g.attempt_),
      copies_(g.copies_), most_work_(most_work), position_(base.number_of_active_vertices(), Point(0, 0, 1)),
      tile_(base.number_of_active_vertices()),
      deck_(3 * static_cast<std::size_t>(base.number_of_active_faces()), 0)
  {
  }

  // map: of the mesh, or of one with the same numbers of vertices
  bool take(const Harmonic_map& map, const Collapse_hierarchy& mesh)
  {
    const Corner_table& t = mesh.table();
    for (int v = 0; v < mesh.number_of_active_vertices(); ++v) {
      position_[v] = map.position(v);
      tile_[v] = map.tile(v);
    }
    for (int h = 0; h < 3 * mesh.number_of_active_faces(); ++h) {
      const Long_isometry& deck = map.deck(half_edge_between(map.table(), t.origin(h), t.target(h)));
      for (const auto& x : deck.entries())
        if (x > largest_entry || x < -largest_entry) return false;
      deck_[h] = table_.number(deck.cast<std::int64_t>());
    }
    return true;
  }

  // The base laid out from coarse to fine, too, if its own base has fewer vertices than so many.
  Marked_base::Marking base_of_base(const Collapse_hierarchy& mesh, const Marked_base& base,
                                    Hyperbolic_geometry& geometry, int vertices) const
  {
    const int n = mesh.number_of_active_vertices(), m = mesh.number_of_active_faces();
    const Base_metric metric(mesh, total_area);
    std::vector<Eigen::Vector3d> points;
    for (int v = 0; v < n; ++v) points.push_back(mesh.point(v));
    std::vector<Triangle> faces;
    for (int f = 0; f < m; ++f) {
      const auto t = mesh.table().face(f);
      faces.push_back({t[0], t[1], t[2]});
    }
    Collapse_hierarchy coarse(points, faces, std::vector<float>(metric.area.begin(), metric.area.end()), -1);
    coarse.decimate(
      false, geometry.minimum_vertices, [](int) { return true; },
      [](int, const std::vector<int>&, int) { return true; }, [](int) { return 1.f; }, [](double) {});
    Marked_base::Marking result{(std::numeric_limits<double>::max)(),
                                Harmonic_map(mesh.table(), n, m, copies_, metric.weight)};
    geometry.base_vertices_ = coarse.number_of_active_vertices();
    if (geometry.base_vertices_ >= vertices) return result;
    Map_options options;
    options.effort = Effort::QUALITY;
    const std::vector<Indexed_landmark<Point>> no_landmarks;
    const bool done =
      Coarse_to_fine_layout<Hyperbolic_geometry>(coarse, geometry, options, 1e-4, no_landmarks, false)
        .run([](double) {});
    if (!done) return result;
    std::vector<Tile> tile;
    std::vector<Point> position;
    for (int v = 0; v < n; ++v) {
      tile.push_back(geometry.tile(coarse.number_of(v)));
      position.push_back(geometry.position(coarse.number_of(v)));
    }
    std::vector<Long_isometry> deck;
    for (int h = 0; h < 3 * m; ++h) {
      const int other = half_edge_between(coarse.table(), coarse.number_of(mesh.table().origin(h)),
                                          coarse.number_of(mesh.table().target(h)));
      deck.push_back(geometry.deck(other).cast<boost::multiprecision::cpp_int>());
    }
    result.map.set_decks(std::move(deck), std::move(tile), std::move(position));
    result.distortion = base.distortion(result.map);
    return result;
  }

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
  int attempt_, copies_;
  std::size_t
    most_work_; // of all searches of an attempt, in moves of vertices: about a minute for three attempts
  int base_vertices_ = 0;                 // of a base of a base
  const Harmonic_map* marking_ = nullptr; // that is to be relaxed; no other one is looked for
  std::size_t work_ = 0;                  // of the marking, in moves of vertices
  Deck_table table_;
  std::vector<Point> position_;
  std::vector<Tile> tile_;
  std::vector<int> deck_; // per half-edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_HYPERBOLIC_GEOMETRY_H
