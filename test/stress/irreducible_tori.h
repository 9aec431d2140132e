// Triangulated tori of which no edge can be contracted: every other one can be contracted to one of them.
// There are 21 of them, of 7 to 10 vertices (S. Lawrencenko: The irreducible triangulations of the torus,
// 1987). Here random edges are contracted until one is reached.

#ifndef SIMPLE_MANIFOLDS_TEST_STRESS_IRREDUCIBLE_TORI_H
#define SIMPLE_MANIFOLDS_TEST_STRESS_IRREDUCIBLE_TORI_H

#include "../correspondence/random_surfaces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace stress {

using Triangles = std::vector<std::array<int, 3>>;

/// Whether v and w, which are neighbours, have no other common neighbours than the two of their faces.
inline bool is_contractible(const std::vector<std::set<int>>& neighbours, int v, int w)
{
  std::vector<int> common;
  const auto &a = neighbours[v], &b = neighbours[w];
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size() == 2;
}

/// Contracts random edges as long as the torus stays simplicial; the vertices are renumbered.
inline Triangles contracted(Triangles faces, Random& random)
{
  int n = 0;
  for (const auto& t : faces) n = (std::max)(n, 1 + *std::max_element(t.begin(), t.end()));
  std::vector<std::set<int>> neighbours(n);
  for (const auto& t : faces)
    for (int k = 0; k < 3; ++k) neighbours[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
  for (;;) {
    std::vector<std::pair<int, int>> edges;
    for (int v = 0; v < n; ++v)
      for (int w : neighbours[v])
        if (v < w && is_contractible(neighbours, v, w)) edges.emplace_back(v, w);
    if (edges.empty()) break;
    const auto [v, w] = edges[random.below(static_cast<int>(edges.size()))];
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [v = v, w = w](const auto& t) {
                                 return std::count(t.begin(), t.end(), v) &&
                                        std::count(t.begin(), t.end(), w);
                               }),
                faces.end());
    for (auto& t : faces) std::replace(t.begin(), t.end(), w, v);
    for (int u : neighbours[w]) {
      neighbours[u].erase(w);
      if (u != v) {
        neighbours[u].insert(v);
        neighbours[v].insert(u);
      }
    }
    neighbours[w].clear();
  }
  std::map<int, int> number;
  for (auto& t : faces)
    for (int& v : t) v = number.emplace(v, static_cast<int>(number.size())).first->second;
  return faces;
}

/// The same for all numberings of the vertices and for both orientations: the least of the lists of faces
/// that arise when the vertices are numbered as a walk from each corner meets them.
inline Triangles canonical_form(const Triangles& faces)
{
  Triangles least;
  for (const bool is_mirrored : {false, true}) {
    std::map<std::pair<int, int>, int> opposite; // of a half-edge: the third corner of its face
    for (auto t : faces) {
      if (is_mirrored) std::swap(t[1], t[2]);
      for (int k = 0; k < 3; ++k) opposite[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
    }
    for (const auto& start : opposite) {
      std::map<int, int> number = {{start.first.first, 0}, {start.first.second, 1}};
      std::vector<std::pair<int, int>> walk = {start.first};
      std::set<std::pair<int, int>> done = {start.first};
      Triangles form;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const auto [a, b] = walk[i];
        const int c = opposite.at({a, b});
        number.emplace(c, static_cast<int>(number.size()));
        std::array<int, 3> t = {number.at(a), number.at(b), number.at(c)};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        form.push_back(t);
        for (const auto& next : {std::make_pair(b, a), std::make_pair(c, b), std::make_pair(a, c)})
          if (done.insert(next).second) walk.push_back(next);
      }
      std::sort(form.begin(), form.end());
      form.erase(std::unique(form.begin(), form.end()), form.end());
      if (least.empty() || form < least) least = form;
    }
  }
  return least;
}

/// Those that `times` random contractions lead to, each once, in a fixed order.
inline std::set<Triangles> irreducible_tori(int times)
{
  std::set<Triangles> found;
  Random random(1987);
  for (int i = 0; i < times; ++i) {
    const int most = i % 2 == 0 ? 3 : 6; // small grids lead to the common ones, larger ones to the rare ones
    Triangle_mesh mesh = grid_torus(3 + random.below(most), 3 + random.below(most), random.below(3));
    flip_random_edges(mesh, random.below(15 * most), random);
    found.insert(canonical_form(contracted(mesh.triangles, random)));
  }
  return found;
}

} // namespace stress

#endif // SIMPLE_MANIFOLDS_TEST_STRESS_IRREDUCIBLE_TORI_H
