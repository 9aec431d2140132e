// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CAD_CAD_DOMAIN_POINT_H
#define CGAL_SIMPLE_MANIFOLDS_CAD_CAD_DOMAIN_POINT_H

#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_domain.h>

#include <Eigen/Core>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCad
///
/// Whether `cad_surface()` and `fit_cad_surface()` serve surfaces over an atlas: all of this package.
template <class Atlas>
inline constexpr bool has_cad_surface = internal::Cad_domain<Atlas>::exists;

/// \ingroup PkgSimpleManifoldsCad
///
/// The domain point of a point of a face, given by its parameters: where the surface that it approximates has the point that
/// belongs to it.
/// \pre `has_cad_surface<Atlas>`
/// \param atlas  of the surface, or of the map, that `face` was made for
template <class Atlas>
typename Atlas::Domain_point cad_domain_point(const Atlas& atlas, const Cad_face& face,
                                              const Eigen::Vector2d& uv)
{
  return internal::Cad_domain<Atlas>::point(atlas, {face.tile, face.on_tile(uv)});
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CAD_CAD_DOMAIN_POINT_H
