// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/Vtk_data_set.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Legacy files of VTK with PolyData or an unstructured grid, text or binary. Lines of words say which array comes next.
class Legacy_vtk_reader {
public:
  Legacy_vtk_reader(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  File_mesh read()
  {
    if (bytes_.substr(0, 22) != "# vtk DataFile Version") fail("no VTK file");
    next_line();
    next_line(); // the title
    const std::string_view format = word("ASCII or BINARY");
    if (!is_same_word(format, "ASCII") && !is_same_word(format, "BINARY"))
      fail("ASCII or BINARY is expected, found \"" + Text_scanner::shown(format) + '"');
    is_binary_ = is_same_word(format, "BINARY");
    while (skip_space()) read_section(word("a keyword"));
    data_.add_to(file_, mesh_);
    return std::move(mesh_);
  }

private:
  static constexpr const char* knows = "only POLYDATA and UNSTRUCTURED_GRID are read";

  [[noreturn]] void fail(const std::string& what) const
  {
    const std::size_t end = (std::min)(at_, bytes_.size());
    if (is_binary_)
      throw IO_error(Error_code::syntax_error, file_, what + ", at byte " + std::to_string(end));
    throw IO_error(Error_code::syntax_error, file_, what,
                   1 + std::size_t(std::count(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(end), '\n')));
  }

  // Whether anything but white space is left.
  bool skip_space()
  {
    at_ = (std::min)(bytes_.find_first_not_of(std::string_view("\0 \t\r\n\v\f", 7), at_), bytes_.size());
    return at_ < bytes_.size();
  }

  std::string_view word(const char* what)
  {
    if (!skip_space()) fail(std::string("the file ends where ") + what + " is expected");
    const std::size_t begin = at_;
    at_ = (std::min)(bytes_.find_first_of(" \t\r\n\v\f", at_), bytes_.size());
    return bytes_.substr(begin, at_ - begin);
  }

  // Whether the word comes next, which then is taken.
  bool take(const char* keyword)
  {
    const std::size_t before = at_;
    if (skip_space() && is_same_word(word("a keyword"), keyword)) return true;
    at_ = before;
    return false;
  }

  std::string_view next_line()
  {
    const std::size_t begin = at_, end = (std::min)(bytes_.find('\n', at_), bytes_.size());
    at_ = (std::min)(end + 1, bytes_.size());
    return bytes_.substr(begin, end - begin);
  }

  std::size_t size(const char* what)
  {
    const std::string_view w = word(what);
    double x = 0;
    if (!Text_scanner::is_number(w, x) || to_index(x) < 0)
      fail(std::string(what) + " is expected, found \"" + Text_scanner::shown(w) + '"');
    return std::size_t(x);
  }

  Scalar_type type()
  {
    const std::string_view w = word("a type");
    using T = Scalar_type;
    static constexpr std::pair<std::string_view, T> types[] = {{"unsigned_char", T::UINT8},
                                                               {"char", T::INT8},
                                                               {"unsigned_short", T::UINT16},
                                                               {"short", T::INT16},
                                                               {"unsigned_int", T::UINT32},
                                                               {"int", T::INT32},
                                                               {"vtkidtype", T::INT32},
                                                               {"unsigned_long", T::UINT64},
                                                               {"long", T::INT64},
                                                               {"vtktypeint64", T::INT64},
                                                               {"vtktypeuint64", T::UINT64},
                                                               {"float", T::FLOAT32},
                                                               {"double", T::FLOAT64}};
    for (const auto& [name, t] : types)
      if (is_same_word(name, w)) return t;
    fail("arrays of type \"" + Text_scanner::shown(w) + "\" are not read");
  }

  // The values of an array; in binary files they begin with the next line.
  std::vector<double> values(std::size_t n, Scalar_type t)
  {
    if (is_binary_) next_line();
    if (n > (bytes_.size() - at_) / (is_binary_ ? size_of(t) : 2) + 1)
      fail("an array of " + std::to_string(n) + " values is announced, but only " +
           std::to_string(bytes_.size() - at_) + " bytes follow");
    std::vector<double> x(n);
    if (is_binary_) {
      Binary_scanner in(file_, bytes_, Binary_scanner::BIG_ENDIAN_BYTES, at_);
      for (double& value : x) value = in.number(t, "a value");
      at_ = in.position();
    } else {
      for (double& value : x) {
        const std::string_view w = word("a number");
        if (!Text_scanner::is_number(w, value))
          fail("a number is expected, found \"" + Text_scanner::shown(w) + '"');
      }
    }
    return x;
  }

  Vtk_data_set::Cells cells()
  {
    const std::size_t n = size("a number of cells"), numbers = size("a number of indices");
    Vtk_data_set::Cells c;
    if (take("OFFSETS")) { // since version 5.1
      c.ends = values(n, type());
      if (!c.ends.empty()) c.ends.erase(c.ends.begin()); // a 0
      if (!take("CONNECTIVITY")) fail("CONNECTIVITY is expected");
      c.connectivity = values(numbers, type());
      return c;
    }
    const std::vector<double> x = values(numbers, Scalar_type::INT32);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = c.connectivity.size() + i;
      const double corners = at < x.size() ? x[at] : -1;
      if (!(corners >= 0 && corners < double(x.size() - at)))
        fail("cell " + std::to_string(i) + " has more corners than are listed");
      const auto first = x.begin() + std::ptrdiff_t(at) + 1;
      c.connectivity.insert(c.connectivity.end(), first, first + std::ptrdiff_t(corners));
      c.ends.push_back(double(c.connectivity.size()));
    }
    return c;
  }

  // Names have blanks and other signs as %20.
  static std::string decoded(std::string_view name)
  {
    std::string s;
    for (std::size_t i = 0; i < name.size(); ++i) {
      const auto digit = [&](std::size_t k) {
        return std::string_view("0123456789abcdef").find(char(std::tolower((unsigned char)(name[k]))));
      };
      if (name[i] == '%' && i + 2 < name.size() && digit(i + 1) < 16 && digit(i + 2) < 16) {
        s += char(16 * digit(i + 1) + digit(i + 2));
        i += 2;
      } else {
        s += name[i];
      }
    }
    return s;
  }

  void add_array(const std::string& name, std::size_t components, Scalar_type t, std::vector<double> x)
  {
    if (target_ && components > 0 && components <= 64)
      target_->push_back({name, int(components), t, std::move(x)});
  }

  void add_array(std::string_view name, std::size_t components, Scalar_type t)
  {
    add_array(decoded(name), components, t, values(components * elements_, t));
  }

  void read_section(std::string_view keyword)
  {
    const auto is = [&](const char* other) { return is_same_word(keyword, other); };
    if (is("DATASET")) {
      const std::string_view kind = word("a kind of data set");
      if (!is_same_word(kind, "POLYDATA") && !is_same_word(kind, "UNSTRUCTURED_GRID"))
        throw IO_error(Error_code::unsupported_format, file_,
                       std::string(knows) + ", not " + Text_scanner::shown(kind));
    } else if (is("POINTS")) {
      const std::size_t n = size("the number of points");
      const Scalar_type t = type();
      mesh_.is_single_precision = t == Scalar_type::FLOAT32;
      data_.coordinates = values(3 * n, t);
    } else if (is("VERTICES")) {
      data_.cells[Vtk_data_set::VERTICES] = cells();
    } else if (is("LINES")) {
      data_.cells[Vtk_data_set::LINES] = cells();
    } else if (is("POLYGONS")) {
      data_.cells[Vtk_data_set::POLYGONS] = cells();
    } else if (is("TRIANGLE_STRIPS")) {
      data_.cells[Vtk_data_set::STRIPS] = cells();
    } else if (is("CELLS")) {
      data_.cells[Vtk_data_set::CELLS] = cells();
    } else if (is("CELL_TYPES")) {
      data_.cell_types = values(size("a number of types"), Scalar_type::INT32);
    } else if (is("POINT_DATA") || is("CELL_DATA")) {
      target_ = is("POINT_DATA") ? &data_.point_data : &data_.cell_data;
      elements_ = size("a number of elements");
    } else {
      read_array(keyword);
    }
  }

  void read_array(std::string_view keyword)
  {
    const auto is = [&](const char* other) { return is_same_word(keyword, other); };
    if (is("SCALARS")) {
      const std::string_view name = word("a name");
      const Scalar_type t = type();
      double components = 1;
      const std::string_view rest = Text_scanner::trimmed(bytes_.substr(at_, bytes_.find('\n', at_) - at_));
      if (Text_scanner::is_number(rest, components)) size("a number of components");
      if (take("LOOKUP_TABLE")) word("a name");
      add_array(name, std::size_t((std::max)(to_index(components), 0)), t);
    } else if (is("VECTORS") || is("NORMALS")) {
      const std::string_view name = word("a name");
      add_array(is("NORMALS") ? "normal" : name, 3, type());
    } else if (is("TENSORS") || is("TENSORS6")) {
      const std::string_view name = word("a name");
      add_array(name, is("TENSORS") ? 9 : 6, type());
    } else if (is("GLOBAL_IDS") || is("PEDIGREE_IDS")) {
      const std::string_view name = word("a name");
      add_array(name, 1, type());
    } else if (is("TEXTURE_COORDINATES")) {
      const std::string_view name = word("a name");
      const std::size_t n = size("a number of components");
      add_array(n == 2 ? "uv" : name, n, type());
    } else if (is("COLOR_SCALARS")) {
      word("a name");
      const std::size_t n = size("a number of components");
      add_array("colour", n, is_binary_ ? Scalar_type::UINT8 : Scalar_type::FLOAT32);
    } else if (is("LOOKUP_TABLE")) {
      word("a name");
      values(4 * size("a size"), is_binary_ ? Scalar_type::UINT8 : Scalar_type::FLOAT32);
    } else if (is("FIELD")) {
      word("a name");
      for (std::size_t n = size("a number of arrays"); n > 0; --n) {
        if (take("METADATA")) skip_metadata();
        const std::string_view name = word("a name");
        const std::size_t components = size("a number of components"), rows = size("a number of rows");
        const Scalar_type t = type();
        if (components > 0 && rows > bytes_.size() / components) fail("an array is longer than the file");
        add_array(decoded(name), components, t, values(components * rows, t));
      }
    } else if (is("METADATA")) {
      skip_metadata();
    } else {
      mesh_.warn(Read_warning::UNKNOWN_STATEMENTS, '"' + Text_scanner::shown(keyword) + '"');
      next_line();
    }
  }

  // Up to an empty line.
  void skip_metadata()
  {
    next_line();
    while (at_ < bytes_.size() && !Text_scanner::trimmed(next_line()).empty()) {
    }
  }

  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_ = 0, elements_ = 0;
  bool is_binary_ = false;
  Vtk_data_set data_;
  std::vector<Mesh_property>* target_ = nullptr;
  File_mesh mesh_;
};

inline File_mesh read_vtk(const std::string& file, std::string_view bytes)
{
  return Legacy_vtk_reader(file, bytes).read();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_VTK_H
