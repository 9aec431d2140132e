// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_XML_SCANNER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_XML_SCANNER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The tags of an XML text, one after the other, and the text that follows each: as much as files of meshes need.
// Comments, declarations and processing instructions are passed over; entities stay as they are.
class Xml_scanner {
public:
  struct Tag {
    std::string_view name;
    bool is_begin = true, is_end = false; // both: <name/>
    std::vector<std::pair<std::string_view, std::string_view>> attributes;

    bool begins(std::string_view other) const { return is_begin && name == other; }
    bool ends(std::string_view other) const { return is_end && name == other; }
    // The value of an attribute, or nothing.
    std::string_view operator[](std::string_view key) const
    {
      for (const auto& [name_of_value, value] : attributes)
        if (name_of_value == key) return value;
      return std::string_view();
    }
  };

  Xml_scanner(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  [[noreturn]] void fail(const std::string& what) const
  {
    const auto end = text_.begin() + std::ptrdiff_t((std::min)(at_, text_.size()));
    throw IO_error(Error_code::syntax_error, file_, what,
                   1 + std::size_t(std::count(text_.begin(), end, '\n')));
  }

  // The next tag; fails at the end of the text.
  Tag next()
  {
    for (;;) {
      at_ = text_.find('<', at_);
      if (at_ == text_.npos) fail("the file ends before its last tag");
      if (!skip("<!--", "-->") && !skip("<![CDATA[", "]]>") && !skip("<?", "?>") && !skip("<!", ">")) break;
    }
    Tag tag;
    ++at_;
    if (at_ < text_.size() && text_[at_] == '/') {
      tag.is_begin = false;
      tag.is_end = true;
      ++at_;
    }
    tag.name = word();
    for (skip_space(); peek() != '>' && peek() != '/'; skip_space()) {
      const std::string_view key = word();
      skip_space();
      if (key.empty() || peek() != '=') fail("a tag is not understood");
      ++at_;
      skip_space();
      const char quote = peek();
      if (quote != '"' && quote != '\'') fail("the value of " + Text_scanner::shown(key) + " has no quotes");
      const std::size_t end = text_.find(quote, at_ + 1);
      if (end == text_.npos) fail("the value of " + Text_scanner::shown(key) + " has no end");
      tag.attributes.emplace_back(key, text_.substr(at_ + 1, end - at_ - 1));
      at_ = end + 1;
    }
    if (peek() == '/') {
      tag.is_end = true;
      ++at_;
      skip_space();
    }
    if (peek() != '>') fail("a tag has no end");
    ++at_;
    return tag;
  }

  // What stands between the last tag and the next.
  std::string_view text() const
  {
    std::string_view t = text_.substr(at_, text_.find('<', at_) - at_);
    constexpr std::string_view begin = "<![CDATA[";
    if (text_.substr(at_ + t.size(), begin.size()) == begin) {
      t = text_.substr(at_ + t.size() + begin.size());
      t = t.substr(0, t.find("]]>"));
    }
    return t;
  }

private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  char peek() const
  {
    if (at_ >= text_.size()) fail("the file ends in a tag");
    return text_[at_];
  }

  void skip_space()
  {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  bool skip(std::string_view begin, std::string_view end)
  {
    if (text_.substr(at_, begin.size()) != begin) return false;
    const std::size_t at = text_.find(end, at_ + begin.size());
    if (at == text_.npos) fail("what begins with " + std::string(begin) + " has no end");
    at_ = at + end.size();
    return true;
  }

  std::string_view word()
  {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) &&
           std::string_view("<>/=\"'").find(text_[at_]) == text_.npos)
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_XML_SCANNER_H
