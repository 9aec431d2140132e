// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

/*!
\ingroup PkgSimpleManifoldsConcepts
\cgalConcept

The concept `ManifoldAtlas` describes a canonical surface, the *domain*, with its charts and the
transitions between them. There is one per topological type: it knows no mesh and no shape, and is shared
by all of them (Grimm 2002, section 3).

A chart c is a homeomorphism alpha_c from an open part of the domain onto the open unit square. The charts
cover the domain, all are positively oriented and infinitely smooth, and so are the transitions
psi_ij = alpha_j o alpha_i^-1, which satisfy psi_ii = id, psi_ji = psi_ij^-1 and
psi_ik = psi_jk o psi_ij. The *tiles*, one per chart and inside of it, partition the domain.

An atlas owns all the geometry of its surface. A model of this concept works in every layer of the package: maps from
given domain points, their certificate, location, criteria, refinement and balance, fits, evaluation, tessellation,
files. Only `map_to_sphere()` and the others, which find the domain points, need more: a model of `LayoutGeometry`.

Signs of orientations and the choice of the tile are exact; everything else is computed in double precision.
All members are `const` (or static) and may be called from several threads at once. An atlas may have a state, such as
a genus; maps, surfaces and files carry the object, and nothing makes one by itself. The package's own atlases but for
`CGAL::Simple_manifolds::Hyperbolic_atlas` have none, and are default constructible.

\cgalRefines{CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Simple_manifolds::Hyperbolic_atlas}
\cgalHasModels{CGAL::Simple_manifolds::Plane_atlas}
\cgalHasModels{CGAL::Simple_manifolds::Sphere_atlas}
\cgalHasModels{CGAL::Simple_manifolds::Torus_atlas}
\cgalHasModelsEnd

\sa `ManifoldChart`
\sa `BumpFunction`
\sa `CGAL::Simple_manifolds::Partition_of_unity`
*/
class ManifoldAtlas {
public:
  /// \name Types
  /// @{

  /// A point of the domain: `Eigen::Vector2d` or `Eigen::Vector3d`.
  typedef unspecified_type Domain_point;

  /// `CGAL::Simple_manifolds::Basic_jet<Domain_point>`.
  typedef unspecified_type Domain_jet;

  /// A model of `ManifoldChart` with the same `Domain_point`.
  typedef unspecified_type Chart;

  /// A range of `CGAL::Simple_manifolds::Chart_point` with the members `begin()`, `end()` and `size()`.
  typedef unspecified_type Chart_list;

  /// A range of `int` with the members `begin()`, `end()`, `size()` and `empty()`.
  typedef unspecified_type Chart_numbers;

  /// A deck transformation of the universal cover: it takes a copy of a point to another copy. A group: default
  /// constructible as the identity, with `operator*`, `inverse()` and `is_identity()`.
  /// `CGAL::Simple_manifolds::Trivial_deck` where points have no other copies.
  typedef unspecified_type Deck;

  /// A copy of a triangle in a picture; copyable, small: one is kept per face.
  typedef unspecified_type Picture_copy;

  /// Optional: the charts' weights at many points at once, what batch evaluation needs; without it, points are evaluated
  /// one by one. See `CGAL::Simple_manifolds::Torus_atlas` for how to make one.
  template <class Bump, int Order>
  using Batch_weights = unspecified_type;

  /// @}
  /// \name Constants
  /// @{

  /// Whether the domain has no border.
  static constexpr bool is_closed;

  /// The largest number of charts that contain one point.
  static constexpr int max_charts_per_point;

  /// Whether there is one chart only, which covers the whole domain, with its border if there is one.
  static constexpr bool has_single_chart;

  /// Whether all transitions are translations.
  static constexpr bool has_flat_transitions;

  /// Whether the third homogeneous coordinate of all points is 1 in the pictures.
  static constexpr bool has_flat_pictures;

  /// Whether the metric of the domain is one of many equally good flat ones: distortion is then measured in the best.
  static constexpr bool has_free_metric;

  /// How far the sum of the areas of the faces of a map, over the area of the domain, may be from an integer by rounding.
  static constexpr double degree_tolerance;

  /// The name of the domain in files: one word.
  static constexpr const char* name;

  /// The names of the coordinates of a domain point in files, where `domain_` stands before each.
  static constexpr std::array<const char*, N> coordinate_names;

  /// Optional: the keys in files of the numbers that the object is made from, e.g. `genus`. Then there are also a member
  /// `numbers()` that returns them as `std::array<int, N>`, a static member `accepts()` that tells whether there is an
  /// object with such numbers, and a constructor that takes those.
  static constexpr std::array<const char*, N> number_keys;

  /// @}
  /// \name The Surface
  /// @{

  /// The genus of the domain.
  int genus() const;

  /// The number of charts, which are numbered from 0; also the number of tiles.
  int number_of_charts() const;

  /// The area of the domain.
  double area() const;

  /// @}
  /// \name Charts
  /// @{

  /// The chart `c`.
  Chart chart(int c) const;

  /// Whether chart `c` contains `p`: as `chart(c).contains(p)`. For at least one chart, that of the tile
  /// of `p`, the answer is true.
  bool contains(int c, const Domain_point& p) const;

  /// The coordinates of `p` in chart `c`.
  /// \pre `contains(c, p)`
  Eigen::Vector2d coordinates(int c, const Domain_point& p) const;

  /// The domain point of a chart point.
  Domain_point point(const CGAL::Simple_manifolds::Chart_point& q) const;

  /// All the charts that contain `p`, in increasing order, with its coordinates there.
  Chart_list charts_at(const Domain_point& p) const;

  /// The numbers of these charts.
  Chart_numbers chart_numbers_at(const Domain_point& p) const;

  /// The chart that sees `p` farthest from its border: the tile of `p`.
  int best_chart(const Domain_point& p) const;

  /// Whether the charts `i` and `j` overlap.
  bool has_transition(int i, int j) const;

  /// psi_ij(uv): the coordinates in chart `j` of the point `uv` of chart `i`.
  /// \pre both charts contain the point
  Eigen::Vector2d transition(int i, int j, const Eigen::Vector2d& uv) const;

  /// psi_ij and its first and second derivatives at `uv`; exactly the identity if `i == j`.
  /// \pre both charts contain the point
  CGAL::Simple_manifolds::Transition_jet transition_jet(int i, int j, const Eigen::Vector2d& uv) const;

  /// The area of the domain per area of the parameters (u,v) of a jet of domain points.
  double area_element(const Domain_jet& p) const;

  /// @}
  /// \name Tiles
  /// @{

  /// The one tile of `p`.
  int tile(const Domain_point& p) const;

  /// The point (s,t) of a tile: a positively oriented map of the closed unit square onto the closed tile. The
  /// points of an edge are the same numbers, bit for bit, in both tiles that share it.
  Domain_point tile_point(int tile, double s, double t) const;

  /// The shapes in which the domain is shown in pictures and reports, one at least. Optional: without this
  /// member it is shown as its charts, side by side.
  std::vector<CGAL::Simple_manifolds::Domain_shape<ManifoldAtlas>> shapes() const;

  /// The area of the domain per area of the parameters (s,t) of a tile.
  double tile_area_element(int tile, double s, double t) const;

  /// Optional: a grid of n x n cells on the tile with the borders of `CGAL::Simple_manifolds::Tile_borders::AVERAGED`, the
  /// points (i,j) in the order i (n+1) + j.
  std::vector<Domain_point> averaged_tile(int tile, int n) const;

  /// @}
  /// \name Points
  /// @{

  /// The domain point that `p` is up to rounding (and, on the torus, up to integers).
  Domain_point canonical(const Domain_point& p) const;

  /// What is located for `p`, any point that a user hands in; not rounded where that is not necessary.
  Domain_point query(const Domain_point& p) const;

  /// Whether `p` is a domain point: what certificates ask for. Coordinates are finite.
  bool is_valid(const Domain_point& p) const;

  /// Whether `p` is on the border of the domain.
  bool is_on_border(const Domain_point& p) const;

  /// The middle of the edge from `p` to `q`.
  Domain_point midpoint(const Domain_point& p, const Domain_point& q) const;

  /// The squared distance of the nearest copies, or of what stands for it locally.
  double squared_distance(const Domain_point& p, const Domain_point& q) const;

  /// The size of an edge compared with the charts: the larger, the less likely one contains it.
  double edge_size(const Domain_point& p, const Domain_point& q) const;

  /// Takes the square [0,1)^2 onto the domain, equal areas to equal areas.
  Domain_point equal_area_point(double a, double b) const;

  /// @}
  /// \name Triangles
  /// The triangle of three domain points has geodesic edges; where points have copies it is that of `p` and the
  /// copies of `q` and `r` nearest to `p`.
  /// @{

  /// The deck transformation that brings `q` nearest to `p`: exact.
  Deck deck(const Domain_point& p, const Domain_point& q) const;

  /// Whether the nearest copies of each pair of corners are those of one triangle, and no others are as near: exact.
  bool is_triangle(const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// The sign of the triangle's area, -1, 0 or 1: exact.
  int orientation(const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// The same for given copies of `q` and `r`, as seen from `p`.
  int orientation(const Domain_point& p, const Domain_point& q, const Deck& deck_q, const Domain_point& r,
                  const Deck& deck_r) const;

  /// The side, 1 (left) or -1, of the edge from `p` to `q` to which an infinitesimal step leads from a point `x` of it,
  /// always in the same direction: exact.
  int side_of_step(const Domain_point& p, const Domain_point& q, const Domain_point& x) const;

  /// The point of the triangle with the given barycentric coordinates, which sum to 1.
  Domain_point interpolate(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                           const Eigen::Vector3d& barycentric) const;

  /// The inverse of `interpolate()`: the barycentric coordinates of `x`, with sum 1; negative ones outside.
  /// \pre `orientation(p, q, r) != 0`
  Eigen::Vector3d barycentric(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                              const Domain_point& x) const;

  /// The edges q - p and r - p of the flat triangle that distortion is measured on, as vectors of two or three
  /// coordinates.
  std::pair<Vector, Vector> flat_edges(const Domain_point& p, const Domain_point& q,
                                       const Domain_point& r) const;

  /// The signed area of the triangle.
  double signed_area(const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// Whether positive faces of a surface of the domain's kind cover the domain once, as far as exact arithmetic can
  /// tell; else nothing, and the rounded sum of the areas decides.
  std::optional<bool> covers_once(const std::vector<Domain_point>& points,
                                  const std::vector<CGAL::Simple_manifolds::Triangle>& faces) const;

  /// Where the domain has a border: what is wrong with the border loop of a map, vertices counterclockwise; empty if it
  /// runs once round the border.
  std::string border_fault(const std::vector<Domain_point>& points, const std::vector<int>& loop) const;

  /// @}
  /// \name Stars
  /// A star is a vertex `p` with the ring of its neighbours, counterclockwise.
  /// @{

  /// The charts that contain `p` and the points of `ring`, in increasing order.
  /// \tparam Ring  a range of `Domain_point`
  template <class Ring>
  Chart_numbers charts_of_star(const Domain_point& p, const Ring& ring) const;

  /// Of these, the one whose border is farthest from the star in chart coordinates; -1 if there is none.
  int chart_of_star(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// The vectors from `p` to the points of `ring` in the coordinates of chart `c`, or these times a positive factor.
  std::vector<Eigen::Vector2d> star_in_chart(int c, const Domain_point& p,
                                             const std::vector<Domain_point>& ring) const;

  /// Whether the whole triangle lies in chart `c`.
  /// \pre `charts_of_star()` of one corner and the two others has it
  bool is_triangle_in_chart(int c, const Domain_point& p, const Domain_point& q, const Domain_point& r) const;

  /// A point from where all triangles of the star are positive, if the atlas finds one.
  std::optional<Domain_point> kernel_point(const Domain_point& p,
                                           const std::vector<Domain_point>& ring) const;

  /// Places where the vertex of a star may lie better, the best ones first; may be none.
  std::vector<Domain_point> better_places(const Domain_point& p, const std::vector<Domain_point>& ring) const;

  /// Motions of the domain that bring about equally many points into each tile: an object whose member `next()` returns
  /// the points after the best motion, then after lesser ones that are less likely to flip faces, as
  /// `std::optional<std::vector<Domain_point>>`; nothing when there is none left. It may refer to the arguments.
  unspecified_type balancing_motions(const std::vector<Domain_point>& points,
                                     const std::vector<CGAL::Simple_manifolds::Triangle>& faces) const;

  /// @}
  /// \name Pictures
  /// A picture shows a part of the domain in homogeneous coordinates such that edges lie in planes through the origin and
  /// positive triangles have a positive determinant. All together show the whole domain. Location searches in them.
  /// @{

  /// Their number.
  int number_of_pictures() const;

  /// One that shows `p`.
  int picture(const Domain_point& p) const;

  /// `p` in its picture, of length below 2.2.
  Eigen::Vector3d homogeneous(const Domain_point& p) const;

  /// The copy of `q` nearest to `p`, in coordinates in which `homogeneous_jet()` shows `p`.
  Eigen::Vector3d homogeneous(const Domain_point& p, const Domain_point& q) const;

  /// A jet of domain points in these coordinates.
  CGAL::Simple_manifolds::Jet homogeneous_jet(const Domain_jet& p) const;

  /// Calls `f(picture, copy)` for the copies of a triangle of which a picture may show a part.
  template <class Function>
  void for_each_copy(const Domain_point& p, const Domain_point& q, const Domain_point& r,
                     const Function& f) const;

  /// The corners of such a copy in its picture.
  std::array<Eigen::Vector3d, 3> homogeneous(const Domain_point& p, const Domain_point& q,
                                             const Domain_point& r, const Picture_copy& copy) const;

  /// @}
};
