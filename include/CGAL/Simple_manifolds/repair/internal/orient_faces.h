// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_ORIENT_FACES_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_ORIENT_FACES_H

#include <CGAL/Simple_manifolds/internal/half_edges.h>
#include <CGAL/Simple_manifolds/repair/internal/Soup_in_repair.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Per half-edge the one that it is glued to, -1 for none: two that have the same edge to themselves. Their faces may
// traverse it in the same direction.
inline std::vector<int> glued_half_edges(const Mesh_soup& soup)
{
  std::vector<int> glued(soup.number_of_half_edges(), -1);
  for_each_edge(soup, [&](auto begin, auto end) {
    if (end - begin != 2) return;
    glued[begin->second] = (begin + 1)->second;
    glued[(begin + 1)->second] = begin->second;
  });
  return glued;
}

// Turns over the faces that is_turned marks. glued: follows.
inline void turn_faces(Soup_in_repair& r, const std::vector<char>& is_turned, std::vector<int>& glued)
{
  Mesh_soup& soup = r.soup;
  const auto moved = [&](int h) { // where half-edge h is then
    return h != -1 && is_turned[soup.face(h)] ? soup.first(soup.face(h)) + soup.last(soup.face(h)) - h : h;
  };
  std::vector<int> result(glued.size());
  for (std::size_t h = 0; h < glued.size(); ++h) result[moved(static_cast<int>(h))] = moved(glued[h]);
  glued = std::move(result);
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    if (!is_turned[f]) continue;
    r.note_face(r.report.flipped, f);
    soup.reverse_face(f);
  }
}

// The patches of faces that are glued together, and which of their faces a consistent orientation turns over.
struct Patches {
  std::vector<int> of_face; // in the order of their first faces
  std::vector<char>
    is_turned; // per face: the fewer ones of its patch, and not its first face where they are as many
  std::vector<int> torn; // half-edges where no consistent orientation is possible, each with its lesser one
  int number = 0, number_one_sided = 0;

  Patches(const Mesh_soup& soup, const std::vector<int>& glued)
    : of_face(soup.number_of_faces(), -1), is_turned(soup.number_of_faces(), false)
  {
    std::vector<int> patch; // its faces, breadth first
    for (int first = 0; first < soup.number_of_faces(); ++first) {
      if (of_face[first] != -1) continue;
      of_face[first] = number;
      patch.assign(1, first);
      std::size_t turned = 0;
      const std::size_t torn_before = torn.size();
      for (std::size_t i = 0; i < patch.size(); ++i)
        for (int h = soup.first(patch[i]); h <= soup.last(patch[i]); ++h) {
          const int g = glued[h];
          if (g == -1) continue;
          const int f = soup.face(g);
          const bool is_other =
            is_turned[patch[i]] != (soup.source(g) == soup.source(h)); // than the first face
          if (of_face[f] == -1) {
            of_face[f] = number;
            is_turned[f] = is_other;
            turned += is_other;
            patch.push_back(f);
          } else if (is_turned[f] != static_cast<char>(is_other) && h < g)
            torn.push_back(h);
        }
      if (2 * turned > patch.size())
        for (int f : patch) is_turned[f] = !is_turned[f];
      number_one_sided += torn.size() > torn_before;
      ++number;
    }
  }
};

// Orients each patch consistently. A one-sided one stays as it is.
inline void orient_patches(Soup_in_repair& r, std::vector<int>& glued)
{
  Patches patches(r.soup, glued);
  if (!patches.torn.empty()) {
    std::vector<char> is_one_sided(patches.number, false);
    for (int h : patches.torn) is_one_sided[patches.of_face[r.soup.face(h)]] = true;
    for (int f = 0; f < r.soup.number_of_faces(); ++f)
      if (is_one_sided[patches.of_face[f]]) patches.is_turned[f] = false;
  }
  turn_faces(r, patches.is_turned, glued);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_INTERNAL_ORIENT_FACES_H
