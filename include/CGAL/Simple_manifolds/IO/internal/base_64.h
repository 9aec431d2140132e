// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BASE_64_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BASE_64_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Reads bytes that are written in base 64, as many as are asked for. What is no letter of it is passed over; padding
// ends a group, so that texts which were encoded apart can follow each other.
class Base_64_reader {
public:
  explicit Base_64_reader(std::string_view text) : text_(text) {}

  // The next n bytes, or as many as there are.
  std::string read(std::size_t n)
  {
    std::string bytes;
    while (bytes.size() < n) {
      if (used_ == group_.size() && !next_group()) break;
      bytes += group_[used_++];
    }
    return bytes;
  }

  std::string read_all() { return read(text_.size()); }

private:
  static int value_of(char c)
  {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+'             ? 62
           : c == '/'             ? 63
                                  : -1;
  }

  bool next_group()
  {
    std::uint32_t bits = 0;
    int letters = 0;
    for (; at_ < text_.size() && letters < 4; ++at_) {
      if (text_[at_] == '=' && letters >= 2) break;
      const int value = value_of(text_[at_]);
      if (value < 0) continue;
      bits = bits << 6 | std::uint32_t(value);
      ++letters;
    }
    if (letters < 2) return false;
    while (at_ < text_.size() && text_[at_] == '=') ++at_;
    bits <<= 6 * (4 - letters);
    group_.clear();
    used_ = 0;
    for (int k = 0; k + 1 < letters; ++k) group_ += char(bits >> (16 - 8 * k) & 255);
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0, used_ = 0;
  std::string group_; // at most three bytes, of which so many are used
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_BASE_64_H
