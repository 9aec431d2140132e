// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_REQUEST_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_REQUEST_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// What register_maps() was asked for; landmarks are pairs of a vertex of the source and one of the target.
struct Registration_request {
  std::vector<std::pair<int, int>> landmarks;
  Effort effort = Effort::DEFAULT;
  bool has_fixed_target = false;
  bool is_parallel = false;
  Visitor_reference visitor;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_REQUEST_H
