// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTY_COLUMNS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTY_COLUMNS_H

#include <CGAL/Simple_manifolds/IO/internal/Ply_rows.h>
#include <CGAL/Simple_manifolds/IO/internal/ply_properties.h>
#include <CGAL/Simple_manifolds/IO/internal/scalar_types.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <cctype>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The columns of properties behind others in the rows of a PLY. Their names are words, each once whatever the case of its
// letters: those that are `taken` (in small letters) get a suffix.
class Ply_property_columns {
public:
  Ply_property_columns(const std::vector<Mesh_property>& properties, std::set<std::string> taken)
    : properties_(properties)
  {
    for (const Mesh_property& p : properties) {
      types_.push_back(written_type(p));
      if (traits_of(types_.back()).in_ply == std::string("double")) types_.back() = Scalar_type::FLOAT64;
      for (std::string name : ply_columns(p)) {
        for (char& c : name)
          if (static_cast<unsigned char>(c) <= ' ') c = '_';
        while (!taken.insert(in_small_letters(name)).second) name += "_of_input";
        header_.push_back(std::string("property ") + traits_of(types_.back()).in_ply + ' ' + name);
      }
    }
  }

  void write_header(Ply_rows& ply) const
  {
    for (const std::string& line : header_) ply.header(line);
  }

  void write_values(Ply_rows& ply, std::size_t element) const
  {
    for (std::size_t i = 0; i < properties_.size(); ++i)
      for (std::size_t k = 0; k < static_cast<std::size_t>(properties_[i].components); ++k)
        ply.value(types_[i], properties_[i](element, k));
  }

private:
  static std::string in_small_letters(std::string name)
  {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
  }

  const std::vector<Mesh_property>& properties_;
  std::vector<Scalar_type> types_;  // per property
  std::vector<std::string> header_; // per column
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_PLY_PROPERTY_COLUMNS_H
