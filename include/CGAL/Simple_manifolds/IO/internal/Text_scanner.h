// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// The bytes of a file.
inline std::string file_contents(const std::string& file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::none) // e.g. a name that is too long
    throw IO_error(Error_code::cannot_open, file, error.message());
  if (!std::filesystem::exists(status))
    throw IO_error(Error_code::cannot_open, file, "the file does not exist");
  if (!std::filesystem::is_regular_file(status))
    throw IO_error(Error_code::cannot_open, file, "is not a regular file");
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) throw IO_error(Error_code::cannot_open, file, "the file cannot be opened");
  if (size == 0) throw IO_error(Error_code::syntax_error, file, "the file is empty");
  std::string bytes(size, '\0');
  if (!in.read(&bytes[0], std::streamsize(size)))
    throw IO_error(Error_code::cannot_open, file, "the file cannot be read to its end");
  return bytes;
}

/// Splits a text into words and numbers and knows the line for messages. Numbers do not depend on the
/// locale and are correctly rounded. '#' starts a comment where `comments` says so.
class Text_scanner {
public:
  /// \param line  the line of the file at which the text begins
  Text_scanner(const std::string& file, std::string_view text, bool comments, std::size_t line = 1)
    : file_(file), text_(text), comments_(comments), line_(line)
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (line == 1 && text.substr(0, 3) == byte_order_mark) at_ = 3;
  }

  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw IO_error(Error_code::syntax_error, file_, what, line_);
  }

  /// Whether only white space and comments are left.
  bool at_end()
  {
    skip_space(true);
    return at_ == text_.size();
  }

  /// Whether only white space and a comment are left on the line.
  bool at_line_end()
  {
    skip_space(false);
    return at_ == text_.size() || text_[at_] == '\n';
  }

  void skip_line()
  {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  /// The next word, on whatever line it is.
  /// \param what  for the message when the file ends here
  std::string_view word(const std::string& what)
  {
    if (at_end()) fail("the file ends where " + what + " is expected");
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  double number(const std::string& what)
  {
    const std::string_view w = word(what);
    const bool has_plus = w.size() > 1 && w[0] == '+' && w[1] != '-'; // from_chars takes no plus
    const char *first = w.data() + has_plus, *last = w.data() + w.size();
    double x = 0;
    const auto [end, error] = std::from_chars(first, last, x);
    if (end != last || error == std::errc::invalid_argument)
      fail(what + " is expected, found \"" + shown(w) + '"');
    if (error == std::errc::result_out_of_range) // from_chars does not say on which side
      x = is_above_one(w) ? std::numeric_limits<double>::infinity() : 0;
    return x;
  }

  Eigen::Vector3d point(const std::string& what)
  {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = number(what);
    return p;
  }

  long long integer(const std::string& what) { return integer(word(what), what); }

  long long integer(std::string_view w, const std::string& what) const
  {
    long long x = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), x);
    if (w.empty() || end != w.data() + w.size() || error != std::errc())
      fail(what + " is expected, found \"" + shown(w) + '"');
    return x;
  }

  /// A number of elements, each of which takes at least `bytes_each` of the bytes that are left: so a
  /// wrong number in a header is an error here and not an allocation.
  std::size_t count(const std::string& what, std::size_t bytes_each)
  {
    const long long n = integer("the number of " + what);
    if (n < 0) fail("the number of " + what + " is " + std::to_string(n));
    if (std::size_t(n) > bytes_left() / bytes_each + 1)
      fail("the header announces " + std::to_string(n) + ' ' + what + ", but only " +
           std::to_string(bytes_left()) + " bytes follow");
    return std::size_t(n);
  }

  /// A word as it may be shown in a message of one line.
  static std::string shown(std::string_view w)
  {
    std::string s(w.substr(0, 24));
    for (char& c : s)
      if (c < ' ' || c > '~') c = '?';
    return s;
  }

private:
  // Whether a number that is far from 1 is above it: by the place of its first digit other than 0, and by its
  // exponent, which may be beyond all integers.
  static bool is_above_one(std::string_view w)
  {
    const std::size_t e = (std::min)(w.find_first_of("eE"), w.size()), point = (std::min)(w.find('.'), e);
    const long long places = (long long)(point) - (long long)(w.find_first_of("123456789"));
    if (e == w.size()) return places > 0;
    long long exponent = 0;
    const char* first = w.data() + e + (w[e + 1] == '+' ? 2 : 1);
    const bool is_integer = std::from_chars(first, w.data() + w.size(), exponent).ec == std::errc();
    return is_integer ? exponent > -places : w[e + 1] != '-';
  }

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_space(bool lines)
  {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!lines) return;
        ++line_;
      } else if (c == '#' && comments_) {
        skip_line();
        --at_; // the loop steps onto the end of the line
      } else if (!is_space(c)) {
        return;
      }
    }
  }

  const std::string& file_;
  std::string_view text_;
  bool comments_;
  std::size_t at_ = 0, line_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H
