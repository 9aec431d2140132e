// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ITEM_NAME_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ITEM_NAME_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What a reader expects next, for its messages: a name, possibly with words before it or a number behind it. The text is made only when
// there is a message: to make it for each number of a file would take longer than to read them. Lives no longer than
// the name.
class Item_name {
public:
  Item_name(const char* name) : name_(name) {}
  Item_name(const std::string& name) : name_(name) {}
  Item_name(const char* words, const std::string& name) : words_(words), name_(name) {}
  Item_name(const char* name, std::size_t number) : name_(name), number_(number), has_number_(true) {}

  std::string text() const
  {
    std::string text(words_);
    text += name_;
    if (has_number_) text += std::to_string(number_);
    return text;
  }

  // The number of these items.
  Item_name count() const
  {
    Item_name result = *this;
    result.words_ = "the number of ";
    return result;
  }

private:
  std::string_view words_, name_;
  std::size_t number_ = 0;
  bool has_number_ = false;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_ITEM_NAME_H
