// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_COCYCLES_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_COCYCLES_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A deck transformation of the flat torus: the translation by (i, j).
struct Deck {
  short i = 0, j = 0;
  Deck inverse() const { return {static_cast<short>(-i), static_cast<short>(-j)}; }
  friend Deck operator*(const Deck& a, const Deck& b)
  {
    return {static_cast<short>(a.i + b.i), static_cast<short>(a.j + b.j)};
  }
};

// Two integer 1-cocycles that form a basis of the cohomology of a triangulated torus, on the first
// `faces` faces of t: deck[h] is their pair of values on h. By tree and cotree (Eppstein 2003): the two
// edges in neither tree close two loops of faces; a cocycle counts the crossings of one loop.
// Returns false if the surface is no torus.
inline bool torus_cocycles(const Corner_table& t, int vertices, int faces, std::vector<Deck>& deck)
{
  std::vector<char> in_tree(3 * static_cast<std::size_t>(faces), 0);
  std::vector<char> reached(vertices, 0);
  std::vector<int> queue(1, 0);
  reached[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
    t.for_each_outgoing(t.outgoing(queue[i]), [&](int h) {
      if (reached[t.target(h)]) return;
      reached[t.target(h)] = 1;
      in_tree[h] = in_tree[t.opposite(h)] = 1;
      queue.push_back(t.target(h));
    });

  std::vector<int> entered(faces, -1); // the half-edge through which the cotree enters a face, in that face
  std::vector<char> crossed(in_tree);
  queue.assign(1, 0);
  entered[0] = 0; // the root: any value that is not -1
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      const int o = t.opposite(h);
      if (in_tree[h] || entered[o / 3] >= 0) continue;
      entered[o / 3] = o;
      crossed[h] = crossed[o] = 1;
      queue.push_back(o / 3);
    }

  std::vector<int> generators;
  for (int h = 0; h < 3 * faces; ++h)
    if (!crossed[h] && h < t.opposite(h)) generators.push_back(h);
  if (generators.size() != 2) return false;
  for (int h = 0; h < 3 * faces; ++h) deck[h] = Deck();
  for (int g = 0; g < 2; ++g) {
    // The loop leaves a face through h: +1 on h, -1 on its opposite.
    const auto cross = [&](int h, int sign) {
      (g == 0 ? deck[h].i : deck[h].j) += static_cast<short>(sign);
      const int o = t.opposite(h);
      (g == 0 ? deck[o].i : deck[o].j) -= static_cast<short>(sign);
    };
    cross(generators[g], 1);
    // From the face beyond the generator up to the root, and from the root down to the face before it.
    for (int f = t.opposite(generators[g]) / 3; f != 0; f = t.opposite(entered[f]) / 3) cross(entered[f], 1);
    for (int f = generators[g] / 3; f != 0; f = t.opposite(entered[f]) / 3) cross(entered[f], -1);
  }
  return true;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_GEOMETRY_TORUS_COCYCLES_H
