// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_READ_WARNING_H
#define CGAL_SIMPLE_MANIFOLDS_IO_READ_WARNING_H

#include <cstddef>
#include <string>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// What a reader has passed over in a file that is not as its format wants it, but whose meaning is clear.
struct Read_warning {
  /// The kinds of what is passed over.
  enum Kind {
    OTHER_FORMAT,       ///< the contents are of another format than the extension says
    MISSING_KEYWORD,    ///< the word that begins the format, or ends its data, is missing
    WRONG_COUNT,        ///< the header announces another number of faces than the file holds
    TRAILING_DATA,      ///< bytes or lines that follow the data
    SKIPPED_ELEMENTS,   ///< points, lines, curves and other elements that are no faces
    UNKNOWN_STATEMENTS, ///< lines, chunks or tags that the format does not know
    SINGLE_PRECISION ///< edges without length, since numbers of 32 bits are too coarse so far from the origin
  };

  Kind kind = UNKNOWN_STATEMENTS; ///< what it is
  std::size_t count = 0;          ///< how many there are
  std::string first;              ///< the first of them and its place, e.g. `"vp" in line 7` or `byte 1084`

  /// One sentence, e.g. "2 elements that are no faces are skipped, the first: edge in line 34".
  std::string sentence() const
  {
    const std::string n = std::to_string(count), plural = count == 1 ? "" : "s",
                      are = count == 1 ? " is" : " are";
    const std::string place = first.empty() ? "" : (count == 1 ? ": " : ", the first: ") + first;
    switch (kind) {
    case OTHER_FORMAT:
      return "the contents are not what the extension says" + place;
    case MISSING_KEYWORD:
      return n + " keyword" + plural + are + " missing" + place;
    case WRONG_COUNT:
      return "the header announces another number of faces than the file holds" + place;
    case TRAILING_DATA:
      return n + " byte" + plural + " behind the data" + are + " ignored" + place;
    case SKIPPED_ELEMENTS:
      return n + " element" + plural + " that" + are + " no face" + plural + are + " skipped" + place;
    case UNKNOWN_STATEMENTS:
      return n + " statement" + plural + " that the format does not know" + are + " skipped" + place;
    case SINGLE_PRECISION:
      return n + " edge" + plural + " of faces" + (count == 1 ? " has" : " have") +
             " no length since the numbers of 32 bits in the file are too coarse so far from the origin: "
             "move the mesh to "
             "the origin before it is written, or write 64 bits" +
             place;
    }
    return place;
  }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_READ_WARNING_H
