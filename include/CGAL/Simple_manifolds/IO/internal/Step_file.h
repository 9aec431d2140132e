// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_FILE_H

#include <Eigen/Core>

#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// A reference to an entity of a STEP file.
struct Step_id {
  long number = 0;
};

// The texts of values, as ISO 10303-21 has them.

inline std::string step_text(Step_id id) { return '#' + std::to_string(id.number); }
inline std::string step_text(int n) { return std::to_string(n); }

/// The shortest text that is read back bit for bit; always with a point.
inline std::string step_text(double x)
{
  char buffer[32];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, x + 0.).ptr); // -0 becomes 0
  const std::size_t e = text.find('e');
  if (text.find('.') == std::string::npos) text.insert(e == std::string::npos ? text.size() : e, ".");
  if (e != std::string::npos) text[text.find('e')] = 'E';
  return text;
}

/// A text in quotes; letters beyond ASCII by their numbers, bytes that are no UTF-8 by that of the mark for them.
inline std::string step_text(const std::string& utf8)
{
  std::string text = "'";
  for (std::size_t k = 0; k < utf8.size();) {
    const unsigned char c = utf8[k++];
    if (c < 0x80) {
      if (c == '\'' || c == '\\') text += char(c);
      text += c < 0x20 || c == 0x7f ? ' ' : char(c);
      continue;
    }
    const int more = c >= 0xf0 && c < 0xf5 ? 3 : c >= 0xe0 && c < 0xf0 ? 2 : c >= 0xc2 && c < 0xe0 ? 1 : 0;
    unsigned long letter = more == 3 ? c & 0x07 : more == 2 ? c & 0x0f : c & 0x1f;
    bool is_valid = more > 0;
    for (int n = 0; n < more && is_valid; ++n) {
      is_valid = k < utf8.size() && (utf8[k] & 0xc0) == 0x80;
      if (is_valid) letter = letter << 6 | (utf8[k++] & 0x3f);
    }
    if (!is_valid) letter = 0xfffd;
    const int digits = letter > 0xffff ? 8 : 4;
    text += digits == 8 ? "\\X4\\" : "\\X2\\";
    for (int d = digits - 1; d >= 0; --d) text += "0123456789ABCDEF"[letter >> (4 * d) & 15];
    text += "\\X0\\";
  }
  return text + '\'';
}
inline std::string step_text(const char* text) { return step_text(std::string(text)); }

/// What is written as it is, such as `.T.` and `$`.
struct Step_token {
  std::string text;
};
inline std::string step_text(const Step_token& token) { return token.text; }

template <class T>
std::string step_text(const std::vector<T>& list)
{
  std::string text = "(";
  for (std::size_t k = 0; k < list.size(); ++k) text += (k > 0 ? "," : "") + step_text(list[k]);
  return text + ')';
}

inline std::string step_text(const Eigen::Vector3d& x)
{
  return '(' + step_text(x[0]) + ',' + step_text(x[1]) + ',' + step_text(x[2]) + ')';
}

/// The data section of a STEP file: entities, which get consecutive numbers.
class Step_file {
public:
  explicit Step_file(std::ostream& out) : out_(out) {}

  /// Adds an entity of one type.
  template <class... Arguments>
  Step_id add(const char* type, const Arguments&... arguments)
  {
    std::string text;
    ((text += (text.empty() ? "" : ",") + step_text(arguments)), ...);
    return add_text(type + ('(' + text + ')'));
  }

  /// Adds an entity whose text is given, e.g. one of several types.
  Step_id add_text(const std::string& text)
  {
    ++last_.number;
    out_ << '#' << last_.number << '=' << text << ";\n";
    return last_;
  }

private:
  std::ostream& out_;
  Step_id last_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_FILE_H
