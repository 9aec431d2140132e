// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_JSON_FIELD_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_JSON_FIELD_H

#include <CGAL/Simple_manifolds/Error.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A value inside a JSON file that knows its file and path, for messages such as
// "charts[2].patches[0].support: four numbers are expected".
class Json_field {
public:
  Json_field(const std::string& file, const nlohmann::json& value, std::string path = std::string())
    : file_(file), value_(value), path_(std::move(path))
  {
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, (path_.empty() ? "" : path_ + ": ") + what);
  }

  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }

  Json_field operator[](const char* key) const
  {
    if (!has(key)) fail(std::string("the key \"") + key + "\" is missing");
    return Json_field(file_, value_[key], path_.empty() ? key : path_ + '.' + key);
  }

  /// The size of an array.
  std::size_t size() const
  {
    if (!value_.is_array()) fail("an array is expected");
    return value_.size();
  }

  void require_size(std::size_t n) const
  {
    if (size() != n) fail(std::to_string(n) + " entries are expected, found " + std::to_string(size()));
  }

  Json_field operator[](std::size_t i) const
  {
    return Json_field(file_, value_[i], path_ + '[' + std::to_string(i) + ']');
  }

  double number() const
  {
    if (!value_.is_number()) fail("a number is expected");
    if (!std::isfinite(value_.get<double>())) fail("the number is NaN or infinite"); // CBOR has such
    return value_.get<double>();
  }

  int integer(long long lowest, long long highest) const
  {
    const bool is_small =
      value_.is_number_integer() &&
      !(value_.is_number_unsigned() && value_.get<unsigned long long>() > (unsigned long long)(highest));
    if (!is_small || value_.get<long long>() < lowest || value_.get<long long>() > highest)
      fail("an integer from " + std::to_string(lowest) + " to " + std::to_string(highest) + " is expected");
    return int(value_.get<long long>());
  }

  std::string string() const
  {
    if (!value_.is_string()) fail("a string is expected");
    return value_.get<std::string>();
  }

  /// A string to compare with, or to show.
  std::string text() const
  {
    std::string s = string().substr(0, 60);
    for (char& c : s)
      if (c < ' ' || c > '~') c = '?'; // it may be shown in a message of one line
    return s;
  }

private:
  const std::string& file_;
  const nlohmann::json& value_;
  std::string path_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_JSON_FIELD_H
