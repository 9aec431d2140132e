// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CANONICAL_MESH_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CANONICAL_MESH_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Cut_surface.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The canonical surface of genus g >= 2 as a triangle mesh, eight faces in each tile round its centre. Vertex t is the
// centre of tile t, the others are the corners of the tiles and the middles of their sides. Each has the frame of a tile.
class Canonical_mesh {
  using Tile = hyperboloid::Tile;

public:
  explicit Canonical_mesh(int genus) : copies_(genus - 1), tiles_(Square_tiling::ring_size * copies_)
  {
    find_corners();
    std::vector<Triangle> faces;
    for (int t = 0; t < tiles_; ++t)
      for (int side = 0; side < 4; ++side) {
        const Vertex &from = corner_[t][(side + 3) % 4], &to = corner_[t][side], middle = middle_of(t, side);
        for (const auto& [a, b] : {std::pair(from, middle), std::pair(middle, to)}) {
          faces.push_back({t, a.number, b.number});
          for (const Long_isometry& d : {a.frame, a.frame.inverse() * b.frame, b.frame.inverse()})
            deck_.push_back(d);
        }
      }
    table_.emplace(vertices_, faces);
    // Twice the distances of the centre of a face from its sides; a little less in three tiles, so that the shortest curves
    // lie there in every copy.
    const auto factor = [](int h) { return h / 24 % Square_tiling::ring_size >= 3 ? 0.45 : 0.5; };
    for (int h = 0; h < static_cast<int>(deck_.size()); ++h)
      across_.push_back((factor(h) + factor(table_->opposite(h))) * (h % 3 == 1                 ? 0.5165
                                                                     : h % 6 == 0 || h % 6 == 5 ? 0.3004
                                                                                                : 0.4232));
  }

  int number_of_faces() const { return 8 * tiles_; }
  // The surface for Chain_search. length: per half-edge, of the way from face to face
  Cut_surface surface(const std::vector<double>& length) const
  {
    return Cut_surface(*table_, vertices_, 8 * tiles_, length);
  }
  // These lengths, as they are.
  const std::vector<double>& across() const { return across_; }
  const Corner_table& table() const { return *table_; }

  // The tile of a face, in the frame of which it has its first corner.
  Tile tile(int face) const
  {
    return {face / 8 % Square_tiling::ring_size, face / 8 / Square_tiling::ring_size};
  }
  // From the frame of the face on the right of a half-edge to that of the face on its left.
  Long_isometry step(int h) const
  {
    const int o = table_->opposite(h);
    return to_face(h) * to_face(Corner_table::next(o)).inverse();
  }

private:
  // As a tile sees it.
  struct Vertex {
    int number = -1;
    Long_isometry frame; // from that of the vertex to that of the tile
  };
  using Number = boost::multiprecision::cpp_int;

  // From the frame of the origin of a half-edge to that of the first corner of its face.
  Long_isometry to_face(int h) const
  {
    return h % 3 == 0 ? Long_isometry() : h % 3 == 1 ? deck_[h - 1] : deck_[h].inverse();
  }

  // After the corners; that of the tile with the even side has the frame.
  Vertex middle_of(int t, int side) const
  {
    const Tile tile{t % Square_tiling::ring_size, t / Square_tiling::ring_size};
    if (side % 2 == 0) return {vertices_ - 2 * tiles_ + 2 * t + side / 2, Long_isometry()};
    return {middle_of(tile.beyond(side, copies_).number(), side - 1).number,
            Square_tiling::step(side).cast<Number>()};
  }

  void find_corners()
  {
    corner_.resize(tiles_);
    vertices_ = tiles_;
    for (int t = 0; t < tiles_; ++t)
      for (int i = 0; i < 4; ++i) {
        if (corner_[t][i].number != -1) continue;
        Tile at{t % Square_tiling::ring_size, t / Square_tiling::ring_size};
        int side = i;
        Tile_isometry m;
        for (int k = 0; k < 6; ++k) {
          corner_[at.number()][side] = {vertices_, m.inverse().cast<Number>()};
          m = m * Square_tiling::step(side);
          const int next = (Square_tiling::beyond(at.ring_tile, side).side + 3) % 4;
          at = at.beyond(side, copies_);
          side = next;
        }
        ++vertices_;
      }
    vertices_ += 2 * tiles_;
  }

  int copies_, tiles_, vertices_ = 0;
  std::vector<std::array<Vertex, 4>> corner_;
  std::optional<Corner_table> table_;
  std::vector<Long_isometry> deck_;
  std::vector<double> across_; // per half-edge
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_CANONICAL_MESH_H
