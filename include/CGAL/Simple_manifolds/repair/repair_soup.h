// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_H
#define CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/repair/Repair_options.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>

#include <utility>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

CGAL_SIMPLE_MANIFOLDS_INLINE Mesh_soup repair_soup(Mesh_soup input, const Repair_options& options,
                                                   Repair_report& report);

} // namespace internal

/// \ingroup PkgSimpleManifoldsRepair
///
/// Mends what files have: see `Repair_options` for what is done by default and what can be asked for, and
/// `Repair_report` for what was done. The result is the same for the same input; repaired once more it does not
/// change; and a clean mesh comes out bit for bit as it went in. Time is linear but for sorting.
///
/// \param soup  points, and faces as indices of points
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{repair_options} \cgalParamDescription{what may be done; its members are parameters, too}
///     \cgalParamType{`Repair_options`} \cgalParamDefault{`Repair_options()`} \cgalParamNEnd
///   \cgalParamNBegin{repair_report} \cgalParamDescription{receives what was done, what is left, and the numbers in the
///     input}
///     \cgalParamType{`std::reference_wrapper<Repair_report>`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the repaired mesh. Vertices of no face are kept, those that were joined to others are not. It is an oriented
///   manifold, in one or in several components, when `Repair_report::left` is empty
///
/// \throw Topology_error (`degenerate_face`) when a face refers to a point that does not exist
template <class NamedParameters = parameters::Default_named_parameters>
Mesh_soup repair_soup(Mesh_soup soup, const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, CGAL_SIMPLE_MANIFOLDS_REPAIR_PARAMETERS);
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, repair_report);
  Repair_report ignored;
  return internal::repair_soup(std::move(soup), internal::repair_options(np),
                               internal::parameter(np, internal_np::repair_report, ignored));
}

} // namespace Simple_manifolds
} // namespace CGAL

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/repair/repair_soup_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_REPAIR_REPAIR_SOUP_H
