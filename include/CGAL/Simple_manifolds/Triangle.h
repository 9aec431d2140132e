// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TRIANGLE_H
#define CGAL_SIMPLE_MANIFOLDS_TRIANGLE_H

#include <array>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// A triangle of an indexed mesh: the positions of its vertices, counterclockwise seen from outside.
using Triangle = std::array<int, 3>;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TRIANGLE_H
