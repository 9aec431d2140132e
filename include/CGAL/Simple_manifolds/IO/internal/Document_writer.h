// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_DOCUMENT_WRITER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_DOCUMENT_WRITER_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A text as JSON, with a mark in place of what is no UTF-8.
inline nlohmann::json valid_text(const std::string& text)
{
  return nlohmann::json::parse(
    nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

// Writes a document item by item, as JSON or CBOR, with the bytes that nlohmann::json has for the whole. Here it
// gets numbers and texts only, which need no memory to be destroyed.
class Document_writer {
public:
  Document_writer(std::ostream& out, bool is_cbor) : out_(out), is_cbor_(is_cbor) {}

  // The next `entries` items are those of the array.
  void array(std::size_t entries) { open(entries, entries, '['); }
  // The next `entries` pairs of a key and an item are those of the object.
  void object(std::size_t entries) { open(entries, 2 * entries, '{'); }

  void value(const nlohmann::json& number_or_text)
  {
    separate();
    if (is_cbor_)
      nlohmann::json::to_cbor(number_or_text, out_);
    else
      out_ << number_or_text;
    close();
  }

  void entry(const char* key, const nlohmann::json& number_or_text)
  {
    value(key);
    value(number_or_text);
  }

private:
  struct Level {
    char bracket;
    std::size_t items, left; // of an object two for each entry
  };

  void open(std::size_t entries, std::size_t items, char bracket)
  {
    separate();
    if (is_cbor_) {
      std::vector<std::uint8_t> head =
        nlohmann::json::to_cbor(entries); // as a number, but for the first bits
      head[0] |= bracket == '{' ? 0xa0 : 0x80;
      for (const std::uint8_t byte : head) out_.put(char(byte));
    } else {
      out_.put(bracket);
    }
    levels_.push_back({bracket, items, items});
    close();
  }

  void separate()
  {
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!is_cbor_ && level.left < level.items)
      out_.put(level.bracket == '{' && level.left % 2 == 1 ? ':' : ',');
    --level.left;
  }

  void close()
  {
    for (; !levels_.empty() && levels_.back().left == 0; levels_.pop_back())
      if (!is_cbor_) out_.put(levels_.back().bracket == '{' ? '}' : ']');
  }

  std::ostream& out_;
  bool is_cbor_;
  std::vector<Level> levels_; // that have begun and not ended
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_DOCUMENT_WRITER_H
