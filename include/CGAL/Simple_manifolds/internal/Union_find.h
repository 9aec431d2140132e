// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_UNION_FIND_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_UNION_FIND_H

#include <numeric>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Classes of the numbers 0, ..., n - 1. The root of a class is its least number.
class Union_find {
public:
  explicit Union_find(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i)
  {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // Returns whether two classes became one.
  bool join(int i, int j)
  {
    i = root(i);
    j = root(j);
    if (i == j) return false;
    (i < j ? parent_[j] : parent_[i]) = i < j ? i : j;
    return true;
  }

private:
  std::vector<int> parent_;
};

// The same with a side, 0 or 1, for each number: that of its class is relative to the root.
class Two_sided_union_find {
public:
  explicit Two_sided_union_find(int n) : parent_(n), side_(n, 0)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i)
  {
    int r = i, side = 0;
    for (; parent_[r] != r; r = parent_[r]) side ^= side_[r];
    while (parent_[i] != r && i != r) { // all of the path hang on the root
      const int next = parent_[i], next_side = side ^ side_[i];
      parent_[i] = r;
      side_[i] = static_cast<char>(side);
      side = next_side;
      i = next;
    }
    return r;
  }
  // The side of i relative to its root.
  int side(int i)
  {
    root(i);
    return side_[i];
  }
  // Says that i and j are on different sides, or on the same one. Returns false, and changes nothing, when the contrary
  // is known.
  bool join(int i, int j, bool are_different)
  {
    const int r = root(i), s = root(j), difference = side_[i] ^ side_[j] ^ (are_different ? 1 : 0);
    if (r == s) return difference == 0;
    const int lower = r < s ? r : s, upper = r < s ? s : r;
    parent_[upper] = lower;
    side_[upper] = static_cast<char>(difference);
    return true;
  }

private:
  std::vector<int> parent_;
  std::vector<char> side_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_UNION_FIND_H
