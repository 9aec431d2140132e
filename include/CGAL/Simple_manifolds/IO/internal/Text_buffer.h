// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_BUFFER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_BUFFER_H

#include <charconv>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Gives a stream long pieces: to ask it for every number takes longer than to write the number.
class Text_buffer {
public:
  explicit Text_buffer(std::ostream& out) : out_(out) {}
  Text_buffer(const Text_buffer&) = delete;
  Text_buffer& operator=(const Text_buffer&) = delete;
  ~Text_buffer()
  {
    try {
      flush();
    } catch (...) { // of a stream that throws: its state says that it failed
    }
  }

  // What is in the buffer goes to the stream; before others look at the stream.
  void flush()
  {
    const std::size_t size = std::exchange(size_, 0);
    if (size > 0) out_.write(text_, std::streamsize(size));
  }

  Text_buffer& operator<<(char c)
  {
    make_room(1);
    text_[size_++] = c;
    return *this;
  }
  Text_buffer& operator<<(std::string_view s)
  {
    if (s.size() > capacity) {
      flush();
      out_.write(s.data(), std::streamsize(s.size()));
    } else {
      make_room(s.size());
      std::memcpy(text_ + size_, s.data(), s.size());
      size_ += s.size();
    }
    return *this;
  }
  Text_buffer& operator<<(const char* s) { return *this << std::string_view(s); }
  Text_buffer& operator<<(const std::string& s) { return *this << std::string_view(s); }
  // The shortest text that reads back as the same number.
  template <class Number>
  Text_buffer& operator<<(Number x)
  {
    constexpr std::size_t longest = 32;
    make_room(longest);
    size_ = std::size_t(std::to_chars(text_ + size_, text_ + size_ + longest, x).ptr - text_);
    return *this;
  }

private:
  static constexpr std::size_t capacity = 1 << 14;

  void make_room(std::size_t n)
  {
    if (size_ + n > capacity) flush();
  }

  std::ostream& out_;
  char text_[capacity];
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_BUFFER_H
