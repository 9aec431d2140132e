// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_TRIVIAL_DECK_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_TRIVIAL_DECK_H

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The deck transformations of a canonical surface that has no other copies of a point than the point itself: only
/// the identity. See `ManifoldAtlas::Deck`.
struct Trivial_deck {
  /// The product.
  Trivial_deck operator*(Trivial_deck) const { return {}; }
  /// The inverse.
  Trivial_deck inverse() const { return {}; }
  /// Always true.
  bool is_identity() const { return true; }
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_TRIVIAL_DECK_H
