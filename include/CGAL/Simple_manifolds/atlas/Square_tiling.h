// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_H

#include <CGAL/Simple_manifolds/atlas/Integer_isometry.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// How the closed surface of genus g is made of 6 (g - 1) regular hyperbolic squares with angles of 60 degrees, six round
/// a vertex: g - 1 copies of a ring of six. Tile 6 c + k is tile k of copy c. In its frame a tile is the set of the rays
/// (u,v,1) with |u|, |v| <= 1; its sides are 0: u = 1, 1: v = 1, 2: u = -1, 3: v = -1, its corner i is between the sides i
/// and i + 1.
///
/// Side s = 0, 2 of tile k in copy c is glued to side s + 1 of tile k + 1 (modulo 6) in copy c + d (modulo g - 1), where d
/// is 1 for k = s = 0, -1 for k = 2 and s = 0, and 0 else. On the sides this exchanges u and v: (1,v) is (v,1) in the
/// other tile, (-1,v) is (v,-1). All else follows by multiplication of integers, and is the same for all copies and genera.
class Square_tiling {
public:
  static constexpr int ring_size = 6;        ///< tiles of a copy
  static constexpr int number_of_views = 17; ///< of the tiles that meet a tile

  /// A side of a tile, in a copy that is `shift` copies away.
  struct Side {
    int ring_tile; ///< 0 to 5
    int side;      ///< 0 to 3
    int shift;     ///< from copy to copy
  };
  /// What lies behind a side.
  static Side beyond(int ring_tile, int side)
  {
    const auto shift = [](int k, int s) { return s != 0 ? 0 : k == 0 ? 1 : k == 2 ? -1 : 0; };
    if (side % 2 == 0) return {(ring_tile + 1) % ring_size, side + 1, shift(ring_tile, side)};
    const int before = (ring_tile + ring_size - 1) % ring_size;
    return {before, side - 1, -shift(before, side - 1)};
  }
  /// From the frame behind a side to the frame of the tile. The reflection in the side u = 1 adds a multiple of its normal
  /// (3,0,1); followed by a half turn it is T.
  static Tile_isometry step(int side)
  {
    const Tile_isometry T(Tile_isometry::Entries{{2, 0, 3, 0, 1, 0, 1, 0, 2}});
    const int other = side % 2 == 0 ? side + 1 : side - 1;
    return Tile_isometry::quarter_turns(side) * T * Tile_isometry::quarter_turns(2 - other);
  }

  /// A tile that shares a vertex with a given one, or that one itself.
  struct View {
    int ring_tile;             ///< 0 to 5
    int shift;                 ///< from copy to copy
    Tile_isometry isometry;    ///< from its frame to that of the given one
    Eigen::Matrix3d to_here;   ///< the same
    Eigen::Matrix3d from_here; ///< the inverse
  };

  /// Those of a tile; view 0 is the tile itself. A point nearer than arcosh 2, the width of a tile, to a point of the tile
  /// is in one of these views, and has no other copy that near: no closed geodesic is shorter than twice that.
  const std::array<View, number_of_views>& views(int ring_tile) const { return views_[ring_tile]; }

  /// Per place in a ring the number of a view.
  using Corner = std::array<std::int8_t, ring_size>;
  /// The six tiles round the corner of a tile that lies in the direction (u,v): there is one of each place in a ring. Only
  /// their charts reach into this quarter of the tile.
  const Corner& views_round_corner(int ring_tile, double u, double v) const
  {
    return round_[ring_tile][u < 0 ? (v < 0 ? 2 : 1) : v < 0 ? 3 : 0];
  }

  /// The inverse of `step()`.
  const Eigen::Matrix3d& step_into(int side) const { return step_into_[side]; }

  /// The only object.
  static const Square_tiling& get();

  /// The copy that is `shift` copies from another one.
  static int copy(int from, int shift, int copies)
  {
    int c = from + shift;
    while (c < 0) c += copies;
    while (c >= copies) c -= copies;
    return c;
  }

private:
  Square_tiling();

  std::array<std::array<View, number_of_views>, ring_size> views_;
  std::array<std::array<Corner, 4>, ring_size> round_;
  std::array<Eigen::Matrix3d, 4> step_into_;
};

namespace internal {

// The point (u,v,1) of a hyperbolic domain point (tile,u,v).
inline Eigen::Vector3d ray_of(const Eigen::Vector3d& p) { return {p[1], p[2], 1}; }

// -<p,p> for p = (u,v,1).
inline double minus_square(const Eigen::Vector3d& p) { return 3 - p[1] * p[1] - p[2] * p[2]; }

// The chart of a tile sees the Poincare disk, of radius 1: X = (x,y) / (sqrt(-<p,p>) + sqrt(3) z) for a ray p in the frame
// of the tile, of which -<p,p> is known.
inline Eigen::Vector2d poincare(const Eigen::Vector3d& p, double root_of_minus_square)
{
  return p.head<2>() * (1 / (root_of_minus_square + 1.7320508075688772 * p[2])); // as quotient() of jets does
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/atlas/Square_tiling_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_SQUARE_TILING_H
