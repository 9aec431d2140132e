// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ATLAS_NUMBERS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ATLAS_NUMBERS_H

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A number that an atlas is made from, as files hold it.
struct Atlas_number {
  std::string key;
  int value;
};

template <class Atlas, class = void>
inline constexpr bool has_numbers = false;
template <class Atlas>
inline constexpr bool has_numbers<Atlas, std::void_t<decltype(Atlas::number_keys)>> = true;

// What tells an atlas from others of its type: `genus 3`; most have nothing to say.
template <class Atlas>
std::vector<Atlas_number> numbers_of([[maybe_unused]] const Atlas& atlas)
{
  std::vector<Atlas_number> numbers;
  if constexpr (has_numbers<Atlas>) {
    const auto values = atlas.numbers();
    for (std::size_t i = 0; i < values.size(); ++i) numbers.push_back({Atlas::number_keys[i], values[i]});
  }
  return numbers;
}

// The atlas with the numbers number(key); the same for all others of its type. fail(message), which throws, if there is
// none with these numbers.
template <class Atlas, class Number, class Fail>
Atlas atlas_of_numbers([[maybe_unused]] const Number& number, [[maybe_unused]] const Fail& fail)
{
  if constexpr (has_numbers<Atlas>) {
    auto values = decltype(std::declval<const Atlas&>().numbers()){};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(Atlas::number_keys[i]);
    if (!Atlas::accepts(values)) {
      std::string message = std::string("there is no ") + Atlas::name + " surface with";
      for (std::size_t i = 0; i < values.size(); ++i)
        message += std::string(" ") + Atlas::number_keys[i] + " " + std::to_string(values[i]);
      fail(message);
    }
    return Atlas(values);
  } else {
    return Atlas();
  }
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ATLAS_NUMBERS_H
