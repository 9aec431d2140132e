// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

/*!
\ingroup PkgSimpleManifoldsConcepts
\cgalConcept

The concept `LayoutGeometry` describes a canonical surface to the engine that lays meshes out on it
(`internal/engine/Coarse_to_fine_layout.h`): the mesh is decimated to a base, the base is placed, and the vertices come
back level by level, each at a point of the kernel of its star, from where sweeps of Newton steps for single vertices lower
the distortion. The engine knows vertices and half-edges; where they are is the geometry's matter. With a model of
`ManifoldAtlas`, a model of this concept and a place in `CGAL::Simple_manifolds::Canonical_surfaces`, meshes are mapped to
a new canonical surface.

An object holds the positions of all vertices of one mesh, numbered from 0 in the order of the hierarchy. Unless said
otherwise, members are `const`, and members for different vertices may be called from several threads at once.

A model may also have a type `Short_star` (`internal/engine/Star_lanes.h`), with overloads of `model()` and `moved()` and
a member `prefetch(neighbour)`: the stars of at most eight faces, which most are, in arrays that compilers make vectors
of. A constant `has_metric` that is true says that `update_metric()` takes sums over faces: their order is that of the
collapses then.

The models of the package are in `internal/geometry/`: `Sphere_geometry`, `Torus_geometry`, `Plane_geometry`.

\sa `ManifoldAtlas`
*/
class LayoutGeometry {
public:
  /// A vector of Eigen of fixed size: a position.
  typedef unspecified_type Point;

  /// What it takes to see a neighbour from a vertex: its number, and which copy of it. Small: one is kept per half-edge.
  typedef unspecified_type Neighbour;

  /// The area of the domain, static or of the object.
  double total_area;

  /// At how many vertices decimation ends, static or of the object.
  int minimum_vertices;

  /// \name Decimation
  /// @{

  /// Whether the vertex may be removed.
  bool is_removable(int v) const;

  /// Whether vertex `u` may be merged into its neighbour `ring[i]`, beyond the link condition.
  /// \param ring  the neighbours, clockwise
  bool is_admissible(int u, const std::vector<int>& ring, int i) const;

  /// Decimation is over: takes over the numbers of the hierarchy. Not `const`.
  void renumber(const Collapse_hierarchy& mesh);

  /// @}
  /// \name Positions
  /// @{

  /// Places the base so that all faces are positive; false if it cannot. Not `const`.
  bool lay_out_base(const Collapse_hierarchy& mesh);

  /// Before the vertices of a level come back. Not `const`, from one thread.
  void start_level(const Collapse_hierarchy& mesh);

  /// The collapse along half-edge `h` was undone: brings up to date what the geometry keeps of half-edges. Not `const`,
  /// from one thread.
  void restore(const Corner_table& table, int h);

  /// The position of a vertex.
  const Point& position(int v) const;

  /// Moves a vertex. Not `const`.
  void set_position(int v, const Point& p);

  /// The target of half-edge `h` as its origin sees it.
  Neighbour neighbour(const Corner_table& table, int h) const;

  /// Where that neighbour is, in the same coordinates as the position of the vertex that sees it.
  Point seen(const Neighbour& n) const;

  /// Moves all vertices alike so that landmarks come near to their targets. Not `const`, from one thread.
  /// \tparam Landmarks  a range of elements with `vertex`, `target` and `weight`
  template <class Landmarks>
  void align(const Landmarks& landmarks);

  /// Changes the metric of the domain to the best one, where it is free. Not `const`, from one thread.
  /// \return whether the neighbours are seen elsewhere now
  bool update_metric(const Collapse_hierarchy& mesh, const std::vector<Face_target>& targets,
                     const Distortion_energy& energy);

  /// @}
  /// \name Faces and Energy
  /// @{

  /// The squared length of a difference of two points.
  double squared_length(const Point& d) const;

  /// Twice the signed area of the face (p, p + a, p + b).
  double twice_area(const Point& p, const Point& a, const Point& b) const;

  /// Energy, gradient and Hessian of a star in the two coordinates of `moved()`.
  Quadratic_model model(const Star<LayoutGeometry>& star, const Distortion_energy& energy) const;

  /// Adds weight * `squared_distance(p, target)` to such a model at `p`.
  void attract(Quadratic_model& m, const Point& p, const Point& target, double weight) const;

  /// Of a vertex from its landmark.
  double squared_distance(const Point& p, const Point& target) const;

  /// The step that minimises the model, limited where the model is not trusted.
  Eigen::Vector2d newton_step(const Quadratic_model& m) const;

  /// The vertex of a star after a step.
  Point moved(const Star<LayoutGeometry>& star, const Eigen::Vector2d& step) const;

  /// 2: moves freely, 1: slides on a side of the domain, 0: stays.
  int degrees_of_freedom(int v) const;

  /// The direction of the side of a vertex that slides.
  Eigen::Vector2d side_direction(int v) const;

  /// Coordinates round a point in which edges are straight, with the members of
  /// `CGAL::Simple_manifolds::Gnomonic_chart`: `half_plane(a, b)`, `point(x)`, `direction_to(p)` and `bound`, large enough
  /// for the points of `ring`.
  unspecified_type chart(const Point& origin, const std::vector<Point>& ring) const;

  /// @}
};
