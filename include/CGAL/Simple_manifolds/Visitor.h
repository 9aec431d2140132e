// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_VISITOR_H
#define CGAL_SIMPLE_MANIFOLDS_VISITOR_H

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRef
///
/// What the long functions report while they work. Derive from it and hide what you need, then pass
/// the object by `std::ref` as the named parameter `visitor`. To cancel, throw from any member: the
/// exception passes through, and the caller's data are as they were.
///
/// Phases follow one another and do not nest. The members are called from the calling thread only.
struct Default_visitor {
  /// A phase starts; `name` is a string literal such as `"decimate"`.
  void start_phase(const char* /* name */) {}
  /// The share of the running phase that is done, in [0,1], not decreasing.
  void progress(double /* fraction */) {}
  /// The running phase ended.
  void end_phase() {}
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_VISITOR_H
