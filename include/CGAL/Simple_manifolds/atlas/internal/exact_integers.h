// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Coordinates as integers of any length, for computations that round nothing. They are few and seldom made: what counts
// is that little code is compiled for them.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// An integer of any length: a sign, and the magnitude by digits of 32 bits, the lowest first and the highest not 0.
class Integer {
public:
  Integer(std::int64_t value = 0) : is_negative_(value < 0)
  {
    std::uint64_t rest = value < 0 ? -static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    for (; rest > 0; rest >>= 32) digits_.push_back(static_cast<std::uint32_t>(rest));
  }

  int sign() const { return digits_.empty() ? 0 : is_negative_ ? -1 : 1; }

  // The length of the magnitude.
  int bits() const
  {
    int n = 32 * static_cast<int>(digits_.size());
    if (n > 0)
      for (std::uint32_t top = digits_.back(); top < 0x80000000u; top <<= 1) --n;
    return n;
  }

  Integer operator-() const
  {
    Integer x = *this;
    x.is_negative_ = !is_negative_;
    return x;
  }

  Integer operator<<(int n) const
  {
    Integer x;
    x.is_negative_ = is_negative_;
    x.digits_.assign(static_cast<std::size_t>(n / 32), 0);
    std::uint64_t carry = 0;
    for (const std::uint32_t d : digits_) {
      carry |= static_cast<std::uint64_t>(d) << (n % 32);
      x.digits_.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    x.digits_.push_back(static_cast<std::uint32_t>(carry));
    return x.trimmed();
  }

  friend Integer operator+(const Integer& a, const Integer& b)
  {
    if (a.is_negative_ == b.is_negative_) return a.plus(b);
    return a.is_smaller(b) ? b.minus(a) : a.minus(b);
  }
  friend Integer operator-(const Integer& a, const Integer& b) { return a + -b; }
  friend Integer operator*(const Integer& a, const Integer& b)
  {
    Integer x;
    x.is_negative_ = a.is_negative_ != b.is_negative_;
    x.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.digits_.size(); ++j) {
        carry += static_cast<std::uint64_t>(a.digits_[i]) * b.digits_[j] + x.digits_[i + j];
        x.digits_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      x.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
    }
    return x.trimmed();
  }
  friend bool operator<(const Integer& a, const Integer& b) { return (a - b).sign() < 0; }
  friend bool operator==(const Integer& a, const Integer& b) { return (a - b).sign() == 0; }

  // n / d in double precision, off by one unit in the last place at most.
  // \pre d is not 0
  friend double ratio(const Integer& n, const Integer& d)
  {
    if (n.sign() == 0) return 0;
    const int shift = d.bits() - n.bits();
    Integer rest = n << (std::max)(shift, 0), divisor = d << (std::max)(-shift, 0); // equally long
    rest.is_negative_ = divisor.is_negative_ = false;
    std::uint64_t quotient = 0; // 62 or 63 bits
    for (int i = 0; i < 63; ++i) {
      const bool is_in = !rest.is_smaller(divisor);
      if (is_in) rest = rest.minus(divisor);
      quotient = 2 * quotient + is_in;
      rest = rest << 1;
    }
    return n.sign() * d.sign() * std::ldexp(static_cast<double>(quotient), -62 - shift);
  }

private:
  // Of the magnitudes.
  bool is_smaller(const Integer& b) const
  {
    if (digits_.size() != b.digits_.size()) return digits_.size() < b.digits_.size();
    return std::lexicographical_compare(digits_.rbegin(), digits_.rend(), b.digits_.rbegin(),
                                        b.digits_.rend());
  }

  // The sum of the magnitudes, with the sign of this one.
  Integer plus(const Integer& b) const
  {
    Integer x = digits_.size() < b.digits_.size() ? b : *this;
    const Integer& shorter = digits_.size() < b.digits_.size() ? *this : b;
    x.digits_.push_back(0);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < x.digits_.size(); ++i) {
      carry += static_cast<std::uint64_t>(x.digits_[i]) + shorter.digit(i);
      x.digits_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    x.is_negative_ = is_negative_;
    return x.trimmed();
  }

  // The difference of the magnitudes, of which that of b is not the larger one, with the sign of this one.
  Integer minus(const Integer& b) const
  {
    Integer x = *this;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < x.digits_.size(); ++i) {
      const std::int64_t d = static_cast<std::int64_t>(x.digits_[i]) - b.digit(i) - borrow;
      borrow = d < 0;
      x.digits_[i] = static_cast<std::uint32_t>(d + (borrow << 32));
    }
    return x.trimmed();
  }

  std::uint32_t digit(std::size_t i) const { return i < digits_.size() ? digits_[i] : 0; }

  Integer& trimmed()
  {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
    return *this;
  }

  std::vector<std::uint32_t> digits_;
  bool is_negative_ = false;
};

// The integers x_i 2^s with the smallest s that makes all of them integers.
// \pre all x_i are finite
template <std::size_t N>
std::array<Integer, N> common_integers(const std::array<double, N>& x)
{
  std::array<std::int64_t, N> mantissa;
  std::array<int, N> exponent;
  bool all_zero = true;
  int lowest = 0;
  for (std::size_t i = 0; i < N; ++i) {
    int e = 0;
    mantissa[i] = static_cast<std::int64_t>(std::ldexp(std::frexp(x[i], &e), 53));
    exponent[i] = e - 53;
    if (mantissa[i] != 0 && (all_zero || exponent[i] < lowest)) {
      lowest = exponent[i];
      all_zero = false;
    }
  }
  std::array<Integer, N> integers;
  for (std::size_t i = 0; i < N; ++i) {
    if (mantissa[i] == 0) {
      continue;
    }
    integers[i] = Integer(mantissa[i]) << exponent[i] - lowest;
  }
  return integers;
}

// The integer coordinates of the vectors from p to q_i + k_i, all in one unit.
template <std::size_t N>
std::array<std::array<Integer, 2>, N> exact_differences(const Eigen::Vector2d& p,
                                                        const std::array<Eigen::Vector2d, N>& q,
                                                        const std::array<Eigen::Vector2i, N>& k)
{
  std::array<double, 2 * N + 3> x{p[0], p[1], 1.};
  for (std::size_t i = 0; i < N; ++i) {
    x[2 * i + 3] = q[i][0];
    x[2 * i + 4] = q[i][1];
  }
  const auto z = common_integers(x);
  std::array<std::array<Integer, 2>, N> d;
  for (std::size_t i = 0; i < N; ++i) {
    d[i] = {z[2 * i + 3] - z[0] + k[i][0] * z[2], z[2 * i + 4] - z[1] + k[i][1] * z[2]};
  }
  return d;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_EXACT_INTEGERS_H
