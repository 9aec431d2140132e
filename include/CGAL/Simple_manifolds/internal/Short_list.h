// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_SHORT_LIST_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_SHORT_LIST_H

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// At most N values in place: the charts at a point are three or four, and are asked for at every
// evaluation, so that an allocation would dominate it.
template <class T, int N>
class Short_list {
public:
  using value_type = T;
  using const_iterator = const T*;
  using iterator = T*;
  static constexpr int capacity = N;

  const T* begin() const { return items_; }
  const T* end() const { return items_ + size_; }
  T* begin() { return items_; }
  T* end() { return items_ + size_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  const T& operator[](std::size_t i) const
  {
    CGAL_precondition(i < size_);
    return items_[i];
  }

  void push_back(const T& item)
  {
    CGAL_precondition(size_ < std::size_t(N));
    items_[size_++] = item;
  }

private:
  T items_[N];
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_SHORT_LIST_H
