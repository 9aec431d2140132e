// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PARSE_DOCUMENT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PARSE_DOCUMENT_H

#include <CGAL/Simple_manifolds/Error.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

inline constexpr std::size_t deepest_document = 16; // levels of arrays and objects; a surface has 6

// Refuses what would exhaust the stack of the library's recursive reader of CBOR: deep nesting, and all items
// without a length, none of which is in the files that are written here. Nothing is stored.
class Cbor_structure {
public:
  Cbor_structure(const std::string& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  void check()
  {
    do {
      if (depth_ > 0) --left_[depth_];
      read_item();
      while (depth_ > 0 && left_[depth_] == 0) --depth_;
    } while (depth_ > 0);
    if (at_ != bytes_.size()) fail("there are bytes behind the end");
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_,
                   "no valid CBOR, byte " + std::to_string(at_) + ": " + what);
  }

  void skip(std::uint64_t n)
  {
    if (n > bytes_.size() - at_) fail("the data end too early");
    at_ += std::size_t(n);
  }

  void read_item()
  {
    skip(1);
    const unsigned head = static_cast<unsigned char>(bytes_[at_ - 1]), kind = head >> 5, info = head & 31;
    std::uint64_t value = info;
    if (info > 27) fail("an item without a length");
    if (info >= 24) {
      const std::size_t n = std::size_t(1) << (info - 24);
      skip(n);
      value = 0;
      for (std::size_t k = at_ - n; k < at_; ++k) value = value << 8 | static_cast<unsigned char>(bytes_[k]);
    }
    switch (kind) {
    case 2:
    case 3:
      skip(value);
      break; // bytes, text
    case 4:
      descend(value, 1);
      break; // array
    case 5:
      descend(value, 2);
      break; // object
    case 6:
      fail("a tag");
    default:
      break; // a number, or a simple value
    }
  }

  void descend(std::uint64_t count, std::uint64_t items_each)
  {
    if (count > bytes_.size()) fail("more items are announced than bytes follow");
    if (count == 0) return;
    if (++depth_ == left_.size()) fail("the items are nested too deeply");
    left_[depth_] = count * items_each;
  }

  const std::string& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  std::array<std::uint64_t, deepest_document + 1> left_{}; // items to come, per level
  std::size_t depth_ = 0;
};

// A document that is cleared from its leaves up. The destructor of nlohmann::json takes memory for what is not
// empty, and ends the program where there is none.
struct Document {
  nlohmann::json root;

  ~Document() { clear(root); }

  static void clear(nlohmann::json& j)
  {
    if (!j.is_structured()) return;
    for (nlohmann::json& entry : j) clear(entry);
    j.clear();
  }
};

// Makes a document of the items that a reader of nlohmann::json finds. What such a reader makes by itself is no
// `Document` yet when memory ends.
class Document_builder {
public:
  using Json = nlohmann::json;

  Document_builder(const std::string& file, const std::string& bytes, bool is_cbor)
    : file_(file), bytes_(bytes), is_cbor_(is_cbor)
  {
  }

  Json take() { return std::move(document_.root); }

  bool null() { return add(nullptr); }
  bool boolean(bool x) { return add(x); }
  bool number_integer(Json::number_integer_t x) { return add(x); }
  bool number_unsigned(Json::number_unsigned_t x) { return add(x); }
  bool number_float(Json::number_float_t x, const std::string&) { return add(x); }
  bool string(std::string& x) { return add(std::move(x)); }
  bool binary(Json::binary_t&) { return add(nullptr); } // which no surface has
  bool start_object(std::size_t) { return open(Json::value_t::object); }
  bool start_array(std::size_t) { return open(Json::value_t::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name)
  {
    entry_ = &open_.back()->get_ref<Json::object_t&>()[name];
    Document::clear(*entry_); // the key may come twice
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const Json::exception& e)
  {
    if (is_cbor_)
      throw IO_error(Error_code::syntax_error, file_, "no valid CBOR, byte " + std::to_string(byte));
    if (e.id >= 400) fail("a number is out of range");
    const auto end = bytes_.begin() + std::ptrdiff_t((std::min)(byte, bytes_.size()));
    throw IO_error(Error_code::syntax_error, file_, "no valid JSON",
                   1 + std::size_t(std::count(bytes_.begin(), end, '\n')));
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, "no valid JSON: " + what);
  }

  // Where the next item belongs.
  Json& place()
  {
    if (open_.empty()) return document_.root;
    return open_.back()->is_object() ? *entry_ : open_.back()->get_ref<Json::array_t&>().emplace_back();
  }

  template <class T>
  bool add(T&& x)
  {
    place() = Json(std::forward<T>(x));
    return true;
  }

  bool open(Json::value_t type)
  {
    if (open_.size() == deepest_document) fail("the items are nested too deeply");
    Json& x = place();
    x = Json(type);
    open_.push_back(&x);
    return true;
  }

  bool close()
  {
    open_.pop_back();
    return true;
  }

  const std::string& file_;
  const std::string& bytes_;
  bool is_cbor_;
  Document document_;
  std::vector<Json*> open_; // arrays and objects that have begun and not ended
  Json* entry_ = nullptr;   // of the last key
};

inline bool is_cbor_object(const std::string& bytes)
{
  return !bytes.empty() && static_cast<unsigned char>(bytes[0]) >> 5 == 5;
}

// Reads JSON, or CBOR where the first byte begins an object of CBOR: no text of JSON begins with it.
inline nlohmann::json parse_document(const std::string& file, const std::string& bytes)
{
  using Format = nlohmann::json::input_format_t;
  const bool is_cbor = is_cbor_object(bytes);
  if (is_cbor) Cbor_structure(file, bytes).check();
  Document_builder builder(file, bytes, is_cbor);
  nlohmann::json::sax_parse(bytes, &builder, is_cbor ? Format::cbor : Format::json);
  return builder.take();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PARSE_DOCUMENT_H
