// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTEGER_ISOMETRY_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTEGER_ISOMETRY_H

#include <Eigen/Core>

#include <array>
#include <cstdint>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The form <p,q> = x x' + y y' - 3 z z'. The hyperbolic plane is the set of the rays (x,y,z), z > 0, with <p,p> < 0.
inline double lorentz_product(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return p[0] * q[0] + p[1] * q[1] - 3 * p[2] * q[2];
}

/// \ingroup PkgSimpleManifoldsAtlas
///
/// An isometry of the hyperbolic plane that is an integer matrix: it keeps the form of `lorentz_product()`. A group, and
/// with it the zero matrix, which stands for "none": a model of what `ManifoldAtlas::Deck` asks for.
///
/// \tparam Integer  `std::int64_t` for what lies close together; of any length for words of generators
template <class Integer>
class Integer_isometry {
public:
  using Entries = std::array<Integer, 9>; ///< row by row

  /// The identity.
  Integer_isometry() : m_{{1, 0, 0, 0, 1, 0, 0, 0, 1}} {}
  /// \pre the form is kept, or all entries are 0
  explicit Integer_isometry(const Entries& m) : m_(m) {}

  /// The zero matrix.
  static Integer_isometry none() { return Integer_isometry(Entries{{0, 0, 0, 0, 0, 0, 0, 0, 0}}); }

  /// The rotation of the plane by i quarter turns.
  static Integer_isometry quarter_turns(int i)
  {
    constexpr int cosine[4] = {1, 0, -1, 0}, sine[4] = {0, 1, 0, -1};
    const int c = cosine[i & 3], s = sine[i & 3];
    return Integer_isometry(Entries{{c, -s, 0, s, c, 0, 0, 0, 1}});
  }

  /// An entry.
  const Integer& operator()(int i, int j) const { return m_[3 * i + j]; }
  /// All of them.
  const Entries& entries() const { return m_; }

  /// Whether it is the zero matrix.
  bool is_none() const { return m_[8] == 0; }
  /// Whether it moves nothing.
  bool is_identity() const { return *this == Integer_isometry(); }

  /// The product.
  Integer_isometry operator*(const Integer_isometry& g) const
  {
    Entries product;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        product[3 * i + j] = m_[3 * i] * g.m_[j] + m_[3 * i + 1] * g.m_[3 + j] + m_[3 * i + 2] * g.m_[6 + j];
    return Integer_isometry(product);
  }

  /// The inverse: B^-1 m^T B for the form B = diag(1,1,-3). What is divided is a multiple of 3.
  Integer_isometry inverse() const
  {
    return Integer_isometry(Entries{{m_[0], m_[3], Integer(m_[6] * -3), m_[1], m_[4], Integer(m_[7] * -3),
                                     Integer(m_[2] / -3), Integer(m_[5] / -3), m_[8]}});
  }

  /// Whether all entries are equal.
  bool operator==(const Integer_isometry& other) const { return m_ == other.m_; }
  /// The contrary.
  bool operator!=(const Integer_isometry& other) const { return m_ != other.m_; }
  /// An order, for tables.
  bool operator<(const Integer_isometry& other) const { return m_ < other.m_; }

  /// The same with other integers.
  template <class Other>
  Integer_isometry<Other> cast() const
  {
    typename Integer_isometry<Other>::Entries m;
    for (int i = 0; i < 9; ++i) m[i] = static_cast<Other>(m_[i]);
    return Integer_isometry<Other>(m);
  }

  /// The same with doubles, rounded from 2^53 on.
  Eigen::Matrix3d matrix() const
  {
    Eigen::Matrix3d m;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m(i, j) = static_cast<double>(m_[3 * i + j]);
    return m;
  }

private:
  Entries m_;
};

/// \ingroup PkgSimpleManifoldsAtlas
/// A change of frame between tiles of `Hyperbolic_atlas`.
using Tile_isometry = Integer_isometry<std::int64_t>;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTEGER_ISOMETRY_H
