// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_STRIDED_ARRAYS_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_STRIDED_ARRAYS_H

#include <CGAL/Simple_manifolds/atlas/Jet.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

/// \file
/// Arrays of other programs, in single or double precision, for the members of `Manifold_surface` that evaluate ranges:
/// points are read from where they are and results are written to where they are wanted, for example into the vertices
/// of a graphics card.

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// A random access iterator to access(0), access(1), ...
template <class Access>
class Access_iterator {
public:
  using iterator_category = std::random_access_iterator_tag;
  using reference = decltype(std::declval<const Access&>()(std::ptrdiff_t()));
  using value_type = reference;
  using difference_type = std::ptrdiff_t;
  using pointer = void;

  explicit Access_iterator(const Access& access, std::ptrdiff_t k = 0) : access_(access), k_(k) {}

  reference operator*() const { return access_(k_); }
  reference operator[](std::ptrdiff_t n) const { return access_(k_ + n); }
  Access_iterator& operator+=(std::ptrdiff_t n)
  {
    k_ += n;
    return *this;
  }
  Access_iterator& operator-=(std::ptrdiff_t n) { return *this += -n; }
  Access_iterator& operator++() { return *this += 1; }
  Access_iterator& operator--() { return *this += -1; }
  Access_iterator operator++(int) { return std::exchange(*this, *this + 1); }
  Access_iterator operator--(int) { return std::exchange(*this, *this - 1); }
  friend Access_iterator operator+(Access_iterator it, std::ptrdiff_t n) { return it += n; }
  friend Access_iterator operator+(std::ptrdiff_t n, Access_iterator it) { return it += n; }
  friend Access_iterator operator-(Access_iterator it, std::ptrdiff_t n) { return it -= n; }
  friend std::ptrdiff_t operator-(const Access_iterator& a, const Access_iterator& b) { return a.k_ - b.k_; }
  friend bool operator==(const Access_iterator& a, const Access_iterator& b) { return a.k_ == b.k_; }
  friend bool operator!=(const Access_iterator& a, const Access_iterator& b) { return a.k_ != b.k_; }
  friend bool operator<(const Access_iterator& a, const Access_iterator& b) { return a.k_ < b.k_; }
  friend bool operator>(const Access_iterator& a, const Access_iterator& b) { return b < a; }
  friend bool operator<=(const Access_iterator& a, const Access_iterator& b) { return !(b < a); }
  friend bool operator>=(const Access_iterator& a, const Access_iterator& b) { return !(a < b); }

private:
  Access access_;
  std::ptrdiff_t k_;
};

template <class Atlas, class Number>
struct Strided_reader {
  using Domain_point = typename Atlas::Domain_point;

  Atlas atlas;
  const Number* data;
  std::ptrdiff_t stride;

  Domain_point operator()(std::ptrdiff_t k) const
  {
    Domain_point p;
    for (int i = 0; i < int(p.size()); ++i) p[i] = double(data[k * stride + i]);
    return atlas.is_valid(p) ? p : atlas.canonical(p);
  }
};

template <class Number>
void write_strided(const Eigen::Vector3d& x, Number* to)
{
  for (int i = 0; i < 3; ++i) to[i] = static_cast<Number>(x[i]);
}

// What takes one result; `Value` is a vector or a jet.
template <class Access, class Value>
struct Strided_place {
  Access access;
  std::ptrdiff_t k;

  const Strided_place& operator=(const Value& x) const
  {
    access.write(k, x);
    return *this;
  }
};

template <class Number>
struct Vector_writer {
  Number* data;
  std::ptrdiff_t stride;

  void write(std::ptrdiff_t k, const Eigen::Vector3d& x) const { write_strided(x, data + k * stride); }
  Strided_place<Vector_writer, Eigen::Vector3d> operator()(std::ptrdiff_t k) const { return {*this, k}; }
};

template <class Number>
struct Jet_writer {
  std::array<Number*, 6> data;
  std::ptrdiff_t stride;

  void write(std::ptrdiff_t k, const Jet& e) const
  {
    const Eigen::Vector3d* const x[6] = {&e.value, &e.u, &e.v, &e.uu, &e.uv, &e.vv};
    for (std::size_t n = 0; n < 6; ++n)
      if (data[n] != nullptr) write_strided(*x[n], data[n] + k * stride);
  }
  Strided_place<Jet_writer, Jet> operator()(std::ptrdiff_t k) const { return {*this, k}; }
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Domain points in an array of numbers, as a range with random access: coordinate i of point k is `data[k * stride + i]`.
///
/// Points that are no domain points, as single precision rounds them, are replaced by what `Atlas::canonical()` gives:
/// vectors of other lengths by unit vectors, numbers outside of the torus's square by those modulo 1, points outside of
/// the square by the nearest ones of it.
///
/// \tparam Number  `float` or `double`
template <class Atlas, class Number>
class Strided_points {
public:
  /// Iterates over the points, by value.
  using const_iterator = internal::Access_iterator<internal::Strided_reader<Atlas, Number>>;

  /// \param data    is not copied
  /// \param n       the number of points
  /// \param stride  how many numbers lie between the first coordinates of points; may be negative, and 0: n times one point
  Strided_points(const Atlas& atlas, const Number* data, std::size_t n, std::ptrdiff_t stride)
    : begin_({atlas, data, stride}), size_(n)
  {
    CGAL_precondition(data != nullptr || n == 0);
  }

  /// The first point.
  const_iterator begin() const { return begin_; }
  /// Behind the last point.
  const_iterator end() const { return begin_ + std::ptrdiff_t(size_); }
  /// The number of points.
  std::size_t size() const { return size_; }

private:
  const_iterator begin_;
  std::size_t size_;
};

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// The range of `n` domain points in an array; by default they lie one behind the other.
template <class Atlas, class Number>
Strided_points<Atlas, Number> strided_points(const Atlas& atlas, const Number* data, std::size_t n,
                                             std::ptrdiff_t stride = Atlas::Domain_point::SizeAtCompileTime)
{
  return {atlas, data, n, stride};
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An output iterator for `Manifold_surface::points()` and `Manifold_surface::normals()`: coordinate i of result k is
/// written to `data[k * stride + i]`, rounded to `Number`, `float` or `double`. All is computed in double precision.
template <class Number>
auto strided_vectors(Number* data, std::ptrdiff_t stride = 3)
{
  return internal::Access_iterator<internal::Vector_writer<Number>>({data, stride});
}

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// An output iterator for `Manifold_surface::jets()`: the arrays, each as that of `strided_vectors()`, take E, E_u, E_v,
/// E_uu, E_uv and E_vv; those that are null are not written.
template <class Number>
auto strided_jets(const std::array<Number*, 6>& arrays, std::ptrdiff_t stride = 3)
{
  return internal::Access_iterator<internal::Jet_writer<Number>>({arrays, stride});
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_STRIDED_ARRAYS_H
