// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_BASIS_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_BASIS_H

#include <CGAL/Simple_manifolds/correspondence/internal/engine/Corner_table.h>
#include <CGAL/Simple_manifolds/correspondence/internal/marking/Harmonic_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Loops a_1, b_1, ..., a_g, b_g through a vertex of a closed triangulated surface of genus g that generate its fundamental
// group with the only relation [a_1,b_1] ... [a_g,b_g] = 1.
//
// The edges that are in neither the tree of shortest paths from the vertex nor a spanning tree of the dual graph close the
// shortest system of 2g loops (Erickson and Whittlesey 2005). The border of the polygon that is left when the surface is
// cut along them reads as a word in which each loop, a letter, comes twice. One handle at a time is split off where it
// stands:
//
//   a Q b R a' S b' = [A,B] S R Q   with A = a c', B = c Q b R c', c = S R   (' is the inverse),
//
// and [A,B] is a letter from then on. Nothing is conjugated, so that words stay short; and the handles come in an order
// round the vertex, which may begin with any of them.
class Handle_basis {
public:
  using Pair = std::array<Long_isometry, 2>;

  // length: per half-edge.
  Handle_basis(const Corner_table& table, int vertices, int faces, const std::vector<double>& length,
               int root)
    : table_(table), kind_(3 * faces, OTHER), parent_(vertices, -1), entered_(faces, -1)
  {
    std::vector<double> distance = grow_tree(length, root);
    grow_dual_tree(length, distance);
    for (int h = 0; h < 3 * faces; ++h)
      if (kind_[h] == OTHER && h < table_.opposite(h)) letter_.push_back(h);
    read_word();
    reduce();
  }

  // Whether it is a surface of this genus.
  bool has_genus(int genus) const
  {
    return static_cast<int>(steps_.size()) == genus && static_cast<int>(letter_.size()) == 2 * genus;
  }

  // What a homomorphism makes of the pairs (a_i, b_i): deck[h] is the change of frame of a half-edge, which begins and
  // ends in the frames of its vertices.
  std::vector<Pair> pairs(const std::vector<Long_isometry>& deck) const
  {
    std::vector<Long_isometry> from_root(parent_.size());
    for (const int v : order_)
      if (parent_[v] != -1) from_root[v] = from_root[table_.origin(parent_[v])] * deck[parent_[v]];
    Values values;
    for (const int h : letter_)
      values.letter.push_back(from_root[table_.origin(h)] * deck[h] * from_root[table_.target(h)].inverse());
    std::vector<Pair> pairs;
    for (const Step& s : steps_) {
      const Long_isometry c = product(s.S, values) * product(s.R, values), c_inverse = c.inverse();
      pairs.push_back({product({s.a}, values) * c_inverse,
                       c * product(s.Q, values) * product({s.b}, values) * product(s.R, values) * c_inverse});
      values.block.push_back(commutator(pairs.back()));
    }
    std::vector<Pair> in_order;
    for (const int block : final_order_) in_order.push_back(pairs[block]);
    return in_order;
  }

  // The other way: the change of frame of each half-edge for which the pairs are those given, in order; all vertices have
  // the same frame.
  std::vector<Long_isometry> decks(const std::vector<Pair>& pairs_in_order) const
  {
    std::vector<Pair> pairs(steps_.size());
    for (std::size_t i = 0; i < final_order_.size(); ++i) pairs[final_order_[i]] = pairs_in_order[i];
    Values values;
    values.letter.resize(letter_.size());
    for (const Pair& p : pairs) values.block.push_back(commutator(p));
    const auto set = [&values](int symbol, const Long_isometry& m) {
      values.letter[std::abs(symbol) - 1] = symbol > 0 ? m : m.inverse();
    };
    for (std::size_t i = steps_.size(); i-- > 0;) { // what a step needs are letters of later ones
      const Step& s = steps_[i];
      const Long_isometry R = product(s.R, values), c = product(s.S, values) * R;
      set(s.a, pairs[i][0] * c);
      set(s.b, product(s.Q, values).inverse() * c.inverse() * pairs[i][1] * c * R.inverse());
    }
    std::vector<Long_isometry> deck(kind_.size());
    const auto set_half_edge = [&](int h, const Long_isometry& m) {
      deck[h] = m;
      deck[table_.opposite(h)] = m.inverse();
    };
    for (std::size_t i = 0; i < letter_.size(); ++i) set_half_edge(letter_[i], values.letter[i]);
    for (std::size_t i = face_order_.size(); i-- > 1;) { // from the leaves: the faces close
      const int h = entered_[face_order_[i]];
      set_half_edge(h, (deck[Corner_table::next(h)] * deck[Corner_table::previous(h)]).inverse());
    }
    return deck;
  }

private:
  enum Kind : char { OTHER, TREE, DUAL_TREE };
  using Word = std::vector<int>; // +-(i+1): letter i or its inverse; 2g + 1 + i: the commutator of step i

  struct Step {
    int a = 0, b = 0;
    Word Q, R, S;
  };
  struct Values {
    std::vector<Long_isometry> letter, block;
  };

  Long_isometry product(const Word& word, const Values& values) const
  {
    const int letters = static_cast<int>(letter_.size());
    Long_isometry m;
    for (const int x : word)
      m = m * (x > letters ? values.block[x - letters - 1]
               : x > 0     ? values.letter[x - 1]
                           : values.letter[-x - 1].inverse());
    return m;
  }
  static Long_isometry commutator(const Pair& p) { return p[0] * p[1] * p[0].inverse() * p[1].inverse(); }

  std::vector<double> grow_tree(const std::vector<double>& length, int root)
  {
    std::vector<double> distance(parent_.size(), (std::numeric_limits<double>::max)());
    std::vector<char> done(parent_.size(), false);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance[root] = 0;
    queue.push({0, root});
    while (!queue.empty()) {
      const int v = queue.top().second;
      queue.pop();
      if (done[v]) continue;
      done[v] = true;
      order_.push_back(v);
      if (parent_[v] != -1) kind_[parent_[v]] = kind_[table_.opposite(parent_[v])] = TREE;
      table_.for_each_outgoing(table_.outgoing(v), [&](int h) {
        const int w = table_.target(h);
        const double d = distance[v] + length[h];
        if (d < distance[w]) {
          distance[w] = d;
          parent_[w] = h;
          queue.push({d, w});
        }
      });
    }
    return distance;
  }

  // The spanning tree that crosses the edges which would close the longest loops.
  void grow_dual_tree(const std::vector<double>& length, const std::vector<double>& distance)
  {
    using Entry =
      std::pair<double, int>; // the length of a loop, the half-edge of its edge in the face to be entered
    std::priority_queue<Entry> queue;
    std::vector<char> reached(entered_.size(), false);
    const auto enter = [&](int face) {
      reached[face] = true;
      face_order_.push_back(face);
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        const int o = table_.opposite(h);
        if (kind_[h] != TREE && !reached[o / 3])
          queue.push({distance[table_.origin(h)] + length[h] + distance[table_.target(h)], o});
      }
    };
    enter(0);
    while (!queue.empty()) {
      const int h = queue.top().second;
      queue.pop();
      if (reached[h / 3]) continue;
      entered_[h / 3] = h;
      kind_[h] = kind_[table_.opposite(h)] = DUAL_TREE;
      enter(h / 3);
    }
  }

  // The letters along the border of the polygon, cyclic.
  void read_word()
  {
    if (letter_.empty()) return;
    std::vector<int> symbol(kind_.size(), 0);
    for (std::size_t i = 0; i < letter_.size(); ++i) {
      symbol[letter_[i]] = static_cast<int>(i) + 1;
      symbol[table_.opposite(letter_[i])] = -static_cast<int>(i) - 1;
    }
    int h = letter_[0];
    do {
      if (symbol[h] != 0) word_.push_back(symbol[h]);
      h = Corner_table::next(h);
      while (kind_[h] == DUAL_TREE) h = Corner_table::next(table_.opposite(h));
    } while (h != letter_[0]);
  }

  // Splits off the handle that needs the shortest words until there is none.
  void reduce()
  {
    const int letters = static_cast<int>(letter_.size());
    for (;;) {
      const int n = static_cast<int>(word_.size());
      std::vector<int> position(2 * letters + 1, -1); // of symbol x: x + letters
      std::vector<int> weight(2 * n + 1, 0);          // of what stands before; a commutator has four letters
      for (int i = 0; i < 2 * n; ++i) {
        const int x = word_[i % n];
        if (i < n && x <= letters) position[x + letters] = i;
        weight[i + 1] = weight[i] + (x > letters ? 4 : 1);
      }
      std::array<int, 4> best{};
      int least = (std::numeric_limits<int>::max)();
      for (int i = 0; i < n; ++i) {
        const int a = word_[i];
        if (a > letters) continue;
        const int j = i + (position[letters - a] - i + n) % n;
        for (int k = i + 1; k < j; ++k) {
          const int b = word_[k % n];
          if (b > letters) continue;
          const int l = i + (position[letters - b] - i + n) % n;
          if (l < j) continue;
          const int Q = weight[k] - weight[i + 1], R = weight[j] - weight[k + 1],
                    S = weight[l] - weight[j + 1];
          const int cost = Q + 3 * R + 2 * S;
          if (cost < least) {
            least = cost;
            best = {i, k, j, l};
          }
        }
      }
      if (least == (std::numeric_limits<int>::max)()) break;
      const auto [i, k, j, l] = best;
      const auto part = [&](int first, int last) {
        Word w;
        for (int x = first; x < last; ++x) w.push_back(word_[x % n]);
        return w;
      };
      Step step{word_[i], word_[k % n], part(i + 1, k), part(k + 1, j), part(j + 1, l)};
      Word rest = part(l + 1, i + n);
      rest.push_back(letters + 1 + static_cast<int>(steps_.size()));
      for (const Word* w : {&step.S, &step.R, &step.Q}) rest.insert(rest.end(), w->begin(), w->end());
      word_ = std::move(rest);
      steps_.push_back(std::move(step));
    }
    for (const int x : word_)
      if (x > letters) final_order_.push_back(x - letters - 1);
  }

  const Corner_table& table_;
  std::vector<Kind> kind_;   // per half-edge
  std::vector<int> parent_;  // per vertex: the half-edge of the tree that leads to it
  std::vector<int> order_;   // of the vertices by distance
  std::vector<int> entered_; // per face: its half-edge that the dual tree crosses into it
  std::vector<int> face_order_;
  std::vector<int> letter_; // half-edges
  Word word_;
  std::vector<Step> steps_;
  std::vector<int> final_order_; // of the steps
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_MARKING_HANDLE_BASIS_H
