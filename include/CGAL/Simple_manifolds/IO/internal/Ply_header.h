// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_HEADER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_HEADER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What the header of a PLY announces. Its words may be in any case; its lines end as the first one does.
class Ply_header {
public:
  enum class Format { unknown, ascii, little, big };
  struct Property {
    std::string name;
    std::optional<Scalar_type> length; // of a list: the type of its length
    Scalar_type type;

    bool is_list() const { return length.has_value(); }
    bool is(std::string_view other) const { return is_same_word(name, other); }
  };
  struct Element {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;

    bool is(std::string_view other) const { return is_same_word(name, other); }
  };

  Format format = Format::unknown;
  std::vector<std::string> comments;
  std::vector<Element> elements;
  std::size_t size = 0, lines = 0; // of the header

  Ply_header(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes)
  {
    if (!is_same_word(bytes.substr(0, 3), "ply")) fail("no PLY file", 0);
    const std::size_t end = bytes.find_first_of("\r\n");
    ends_by_ = end != bytes.npos && bytes[end] == '\r' && bytes.substr(end, 2) != "\r\n" ? '\r' : '\n';
    const std::vector<std::string_view> first = split(next_line());
    if (first.size() != 1 || !is_same_word(first[0], "ply")) fail("no PLY file", 0);
    while (read_line(next_line())) {
    }
    if (format == Format::unknown) fail("the PLY header names no format that is known", 0);
  }

private:
  [[noreturn]] void fail(const std::string& what, std::size_t line) const
  {
    throw IO_error(Error_code::syntax_error, file_, what, line);
  }

  static std::optional<Scalar_type> type_of(std::string_view name)
  {
    using T = Scalar_type;
    static constexpr std::pair<std::string_view, T> types[] = {
      {"char", T::INT8},     {"int8", T::INT8},       {"uchar", T::UINT8},    {"uint8", T::UINT8},
      {"short", T::INT16},   {"int16", T::INT16},     {"ushort", T::UINT16},  {"uint16", T::UINT16},
      {"int", T::INT32},     {"int32", T::INT32},     {"uint", T::UINT32},    {"uint32", T::UINT32},
      {"int64", T::INT64},   {"long", T::INT64},      {"uint64", T::UINT64},  {"ulong", T::UINT64},
      {"float", T::FLOAT32}, {"float32", T::FLOAT32}, {"double", T::FLOAT64}, {"float64", T::FLOAT64}};
    for (const auto& [word, type] : types)
      if (is_same_word(word, name)) return type;
    return std::nullopt;
  }

  Scalar_type type(std::string_view name) const
  {
    const std::optional<Scalar_type> t = type_of(name);
    if (!t) fail("unknown type \"" + Text_scanner::shown(name) + '"', lines);
    return *t;
  }

  static std::vector<std::string_view> split(std::string_view line)
  {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t end = (std::min)(line.find_first_of(" \t\r", i), line.size());
      if (end > i) words.push_back(line.substr(i, end - i));
      i = end + 1;
    }
    return words;
  }

  std::string_view next_line()
  {
    const std::size_t end = bytes_.find(ends_by_, size);
    if (end == bytes_.npos) fail("the PLY header has no end", lines + 1);
    std::string_view line = bytes_.substr(size, end - size);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    size = end + 1;
    ++lines;
    return line;
  }

  // Returns whether there are more lines.
  bool read_line(std::string_view line)
  {
    const std::vector<std::string_view> w = split(line);
    const auto is = [&](std::size_t i, std::string_view word) { return is_same_word(w[i], word); };
    if (w.empty() || is(0, "obj_info")) return true;
    if (is(0, "end_header")) return false;
    if (is(0, "comment")) {
      comments.emplace_back(w.size() > 1 ? line.substr(std::size_t(w[1].data() - line.data()))
                                         : std::string_view());
    } else if (is(0, "format") && w.size() > 1) {
      format = is(1, "ascii")                  ? Format::ascii
               : is(1, "binary_little_endian") ? Format::little
               : is(1, "binary_big_endian")    ? Format::big
                                               : Format::unknown;
    } else if (is(0, "element") && w.size() == 3) {
      const long long count = Text_scanner(file_, w[2], false, lines).integer(w[2], "the number of elements");
      if (count < 0)
        fail("the number of " + Text_scanner::shown(w[1]) + " elements is " + std::to_string(count), lines);
      std::string name(w[1]);
      for (char& c : name) c = char(std::tolower((unsigned char)(c)));
      if (!names_.insert(name).second) // its columns would differ in length
        fail("the element " + Text_scanner::shown(w[1]) + " comes twice", lines);
      elements.push_back({std::string(w[1]), std::size_t(count), {}});
    } else if (is(0, "property") && !elements.empty() && w.size() == 5 && is(1, "list")) {
      elements.back().properties.push_back({std::string(w[4]), type(w[2]), type(w[3])});
    } else if (is(0, "property") && !elements.empty() && w.size() == 3) {
      elements.back().properties.push_back({std::string(w[2]), std::nullopt, type(w[1])});
    } else {
      fail("the header line \"" + Text_scanner::shown(line) + "\" is not understood", lines);
    }
    return true;
  }

  const std::string& file_;
  std::string_view bytes_;
  char ends_by_ = '\n';
  std::set<std::string> names_; // of elements, in lower case
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_HEADER_H
