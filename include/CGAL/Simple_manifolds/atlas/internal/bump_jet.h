// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BUMP_JET_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BUMP_JET_H

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>

#include <array>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The jet of a bump at a point of [0,1]; elsewhere any numbers.
template <class Bump>
std::array<double, 3> bump_jet(const Bump& bump, double x)
{
  return bump.jet(x);
}
template <int K>
std::array<double, 3> bump_jet(const Smoothstep_bump<K>& bump, double x)
{
  return bump.inner_jet(x);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_INTERNAL_BUMP_JET_H
