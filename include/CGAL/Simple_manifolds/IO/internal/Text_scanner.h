// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Item_name.h>

#include <Eigen/Core>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Whether two words are equal but for the case of their letters.
inline bool is_same_word(std::string_view a, std::string_view b)
{
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; };
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [&](char x, char y) { return lower(x) == lower(y); });
}

/// A text without a byte order mark.
inline std::string_view without_mark(std::string_view text)
{
  return text.substr(text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

/// Splits a text into words and numbers and knows the line for messages. Lines end with LF, CR LF or CR. Numbers do not
/// depend on the locale and are correctly rounded. '#' starts a comment where `comments` says so; where
/// `continuations` says so, a backslash at the end of a line joins it with the next.
class Text_scanner {
public:
  /// \param line  the line of the file at which the text begins
  Text_scanner(const std::string& file, std::string_view text, bool comments, std::size_t line = 1,
               bool continuations = false)
    : file_(file), text_(line == 1 ? without_mark(text) : text), comments_(comments),
      continuations_(continuations), line_(line)
  {
  }

  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  /// Where one is, for messages.
  std::string place() const { return "line " + std::to_string(line_); }

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
    return at_ == text_.size() || is_line_end();
  }

  /// Goes to the end of the line.
  void skip_line()
  {
    for (; at_ < text_.size() && !is_line_end(); ++at_)
      if (is_continuation()) skip_continuation();
  }

  /// Whether nothing is left but white space and the bytes 0 and 26 with which files are filled up.
  bool is_at_filling() const
  {
    if (at_ < text_.size() && text_[at_] > ' ') return false; // as most often
    return text_.find_first_not_of(std::string_view("\0\x1a \t\r\n\v\f", 8), at_) == text_.npos;
  }

  /// Whether a text that can be ignored follows the data. Fails where it begins with a number: then the header has
  /// announced too few of `what`, and the others would be lost.
  bool has_trailing_text(const std::string& what)
  {
    if (is_at_filling() || at_end()) return false;
    double x = 0;
    if (is_number(next_word(), x)) fail("the file goes on behind the " + what + " that its header announces");
    return true;
  }

  /// The next word, as word() would give it, which is not taken yet; empty at the end.
  std::string_view next_word()
  {
    if (at_end()) return std::string_view();
    std::size_t end = at_;
    while (end < text_.size() && !is_space(text_[end])) ++end;
    return text_.substr(at_, end - at_);
  }

  /// The next word, on whatever line it is.
  /// \param what  for the message when the file ends here
  std::string_view word(const Item_name& what)
  {
    if (at_end()) fail("the file ends where " + what.text() + " is expected");
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) && !is_continuation()) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  double number(const Item_name& what)
  {
    const std::string_view w = word(what);
    double x = 0;
    if (!is_number(w, x)) fail(what.text() + " is expected, found \"" + shown(w) + '"');
    return x;
  }

  /// The numbers up to the end of the line, or up to what is none; skips the line.
  void rest_of_line(std::vector<double>& numbers)
  {
    numbers.clear();
    double x = 0;
    while (!at_line_end() && is_number(word("a number"), x)) numbers.push_back(x);
    skip_line();
  }

  /// Whether a word is a number, which then is put into x.
  static bool is_number(std::string_view w, double& x)
  {
    const bool has_plus = w.size() > 1 && w[0] == '+' && w[1] != '-'; // from_chars takes no plus
    const char *first = w.data() + has_plus, *last = w.data() + w.size();
    const auto [end, error] = std::from_chars(first, last, x);
    if (end == last && error == std::errc()) return true;
    if (w.find(".#") != w.npos) { // how some writers spell what is none: 1.#INF, -1.#IND, 1.#QNAN
      x = w.find(".#INF") == w.npos ? std::numeric_limits<double>::quiet_NaN()
          : w[0] == '-'             ? -std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::infinity();
      return true;
    }
    if (end != last || error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) // from_chars does not say on which side
      x = is_above_one(w) ? std::numeric_limits<double>::infinity() : 0;
    return true;
  }

  Eigen::Vector3d point(const Item_name& what)
  {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = number(what);
    return p;
  }

  long long integer(const Item_name& what) { return integer(word(what), what); }

  long long integer(std::string_view w, const Item_name& what) const
  {
    long long x = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), x);
    if (w.empty() || end != w.data() + w.size() || error != std::errc())
      fail(what.text() + " is expected, found \"" + shown(w) + '"');
    return x;
  }

  /// A number of elements, each of which takes at least `bytes_each` of the bytes that are left: so a
  /// wrong number in a header is an error here and not an allocation.
  std::size_t count(const Item_name& what, std::size_t bytes_each)
  {
    const long long n = integer(what.count());
    return checked_count(n, what, bytes_each);
  }

  std::size_t checked_count(long long n, const Item_name& what, std::size_t bytes_each) const
  {
    if (n < 0) fail(what.count().text() + " is " + std::to_string(n));
    if (std::size_t(n) > bytes_left() / bytes_each + 1)
      fail("the header announces " + std::to_string(n) + ' ' + what.text() + ", but only " +
           std::to_string(bytes_left()) + " bytes follow");
    return std::size_t(n);
  }

  /// A text without white space at its ends.
  static std::string_view trimmed(std::string_view text)
  {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
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

  bool is_line_end() const
  {
    return text_[at_] == '\n' || (text_[at_] == '\r' && (at_ + 1 == text_.size() || text_[at_ + 1] != '\n'));
  }

  bool is_continuation() const
  {
    if (!continuations_ || text_[at_] != '\\') return false;
    const std::size_t end = text_.find_first_not_of(" \t", at_ + 1);
    return end == text_.npos || text_[end] == '\n' || text_[end] == '\r';
  }

  // From the backslash to the last byte of the end of its line.
  void skip_continuation()
  {
    at_ = (std::min)(text_.find_first_of("\r\n", at_), text_.size() - 1);
    if (text_.substr(at_, 2) == "\r\n") ++at_;
    ++line_;
  }

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_space(bool lines)
  {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (is_line_end()) {
        if (!lines) return;
        ++line_;
      } else if (c == '#' && comments_) {
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n' && text_[at_ + 1] != '\r') ++at_;
      } else if (is_continuation()) {
        skip_continuation();
      } else if (!is_space(c)) {
        return;
      }
    }
  }

  const std::string& file_;
  std::string_view text_;
  bool comments_, continuations_;
  std::size_t at_ = 0, line_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_TEXT_SCANNER_H
