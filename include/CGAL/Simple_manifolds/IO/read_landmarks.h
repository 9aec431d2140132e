// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_READ_LANDMARKS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_READ_LANDMARKS_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/IO/internal/file_contents.h>
#include <CGAL/Simple_manifolds/IO/internal/parse_document.h>

#include <Eigen/Core>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// Where a landmark is on a shape, as a file tells it.
struct Landmark_place {
  long long vertex = -1; ///< the number of a vertex in the file of the mesh, from 0; -1: a point is given
  Eigen::Vector3d point = Eigen::Vector3d::Zero(); ///< in space, where no vertex is given
};

namespace internal {

inline bool has_ending(const std::string& file, const std::string& ending)
{
  if (file.size() < ending.size()) return false;
  for (std::size_t i = 0; i < ending.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(file[file.size() - ending.size() + i])) != ending[i])
      return false;
  return true;
}

// The numbers of each line of a table that is not empty; what follows '#' is a comment. Words are separated by white space,
// commas or semicolons.
struct Table_line {
  std::size_t line;
  std::vector<double> numbers;
  std::size_t words; // more than numbers where one is none
  bool begins_with_number;
};

inline std::vector<Table_line> table_lines(const std::string& bytes)
{
  std::vector<Table_line> table;
  std::istringstream lines(bytes);
  std::string text;
  for (std::size_t line = 1; std::getline(lines, text); ++line) {
    text = text.substr(0, text.find('#'));
    for (char& c : text)
      if (c == ',' || c == ';' || c == '\r') c = ' ';
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    Table_line row{line, {}, 0, false};
    std::string word;
    while (words >> word) {
      ++row.words;
      std::istringstream in(word);
      in.imbue(std::locale::classic());
      double x;
      if (in >> x && in.peek() == std::istringstream::traits_type::eof() && std::isfinite(x))
        row.numbers.push_back(x);
      if (row.words == 1) row.begins_with_number = !row.numbers.empty();
    }
    if (row.words > 0) table.push_back(row);
  }
  return table;
}

inline Landmark_place landmark_vertex(const std::string& file, std::size_t line, double x)
{
  if (x != std::floor(x) || x < 0 || x > 2147483647.)
    throw IO_error(Error_code::syntax_error, file, "the number of a vertex is expected", line);
  Landmark_place place;
  place.vertex = static_cast<long long>(x);
  return place;
}

inline Landmark_place landmark_point(const double* x)
{
  Landmark_place place;
  place.point = Eigen::Vector3d(x[0], x[1], x[2]);
  return place;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads the landmarks of several shapes from one table: a line for each landmark, with the numbers of its vertices of all
/// shapes in order, or with its three coordinates on each of them. `#` starts a comment; commas and
/// semicolons separate as spaces do.
/// \param shapes  the number of shapes, at least 2
/// \return per landmark its places on the shapes
/// \throw IO_error  `cannot_open`, or `syntax_error` with the line
inline std::vector<std::vector<Landmark_place>> read_landmarks(const std::string& file, std::size_t shapes)
{
  std::vector<std::vector<Landmark_place>> landmarks;
  for (const internal::Table_line& row : internal::table_lines(internal::file_contents(file))) {
    const bool is_points = row.words == 3 * shapes;
    if (row.numbers.size() != row.words || (row.words != shapes && !is_points))
      throw IO_error(Error_code::syntax_error, file,
                     "a landmark of " + std::to_string(shapes) + " shapes is " + std::to_string(shapes) +
                       " numbers of vertices, or " + std::to_string(3 * shapes) + " coordinates",
                     row.line);
    landmarks.emplace_back();
    for (std::size_t i = 0; i < shapes; ++i)
      landmarks.back().push_back(is_points ? internal::landmark_point(&row.numbers[3 * i])
                                           : internal::landmark_vertex(file, row.line, row.numbers[i]));
  }
  return landmarks;
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads the landmarks of one shape: points of 3D Slicer (`.fcsv`, `.mrk.json`), which have to be in the coordinates of the
/// mesh; the numbers of vertices that lines begin with (`.vts`, as the correspondence benchmarks have them; -1: the
/// shape has not got this one); else a table with a number of a vertex, or three coordinates, per line.
/// \return in the order of the file; absent ones have vertex -1 and a point that is not finite
/// \throw IO_error  `cannot_open`, or `syntax_error` with the line
inline std::vector<Landmark_place> read_landmarks(const std::string& file)
{
  const std::string bytes = internal::file_contents(file);
  std::vector<Landmark_place> landmarks;
  if (internal::has_ending(file, ".json")) {
    const nlohmann::json document = internal::parse_document(file, bytes);
    const internal::Json_field markups = internal::Json_field(file, document)["markups"];
    if (markups.size() == 0) markups.fail("there is no list of points");
    const internal::Json_field points = markups[std::size_t(0)]["controlPoints"];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const internal::Json_field p = points[i]["position"];
      p.require_size(3);
      const double x[3] = {p[std::size_t(0)].number(), p[1].number(), p[2].number()};
      landmarks.push_back(internal::landmark_point(x));
    }
    return landmarks;
  }
  const bool is_slicer = internal::has_ending(file, ".fcsv"), is_vts = internal::has_ending(file, ".vts");
  for (const internal::Table_line& row : internal::table_lines(bytes)) {
    const auto require = [&](bool is_right, const char* what) {
      if (!is_right) throw IO_error(Error_code::syntax_error, file, what, row.line);
    };
    if (is_slicer) { // id,x,y,z,...: the id may be a number or not
      const std::size_t first = row.begins_with_number ? 1 : 0;
      require(row.numbers.size() >= first + 3, "an identifier and three coordinates are expected");
      landmarks.push_back(internal::landmark_point(&row.numbers[first]));
    } else if (is_vts) {
      require(!row.numbers.empty(), "the number of a vertex is expected");
      if (row.numbers[0] < 0) {
        landmarks.emplace_back();
        landmarks.back().point.setConstant(std::nan(""));
      } else {
        landmarks.push_back(internal::landmark_vertex(file, row.line, row.numbers[0]));
      }
    } else {
      require(row.numbers.size() == row.words && (row.words == 1 || row.words == 3),
              "the number of a vertex, or three coordinates, are expected");
      landmarks.push_back(row.words == 3 ? internal::landmark_point(row.numbers.data())
                                         : internal::landmark_vertex(file, row.line, row.numbers[0]));
    }
  }
  return landmarks;
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_READ_LANDMARKS_H
