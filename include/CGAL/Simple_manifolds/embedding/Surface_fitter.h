// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_engine.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Refining_fit.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// Fits a manifold surface to a map.
///
/// Each chart has a hierarchical B-spline over dyadic cells, at first 4 x 4. It is fitted by weighted least
/// squares to the vertices in the chart and to 3 x 3 located points of every cell; the weight of a
/// residual is the blend b_c (Grimm 2002, section 5: Delta_c = b_c (M - E_c)), raised by a small floor.
/// Cells where that error is too large are split, the previous spline is expressed in the finer space,
/// exactly, and only its correction is solved for. When every chart is good enough all charts are
/// solved for together, with the blend inside the system, and cells are split where the surface E itself
/// errs, until it meets both tolerances or the limit of the controls is reached.
///
/// The result is deterministic, and does not depend on the number of threads. A fitter can neither be copied nor
/// moved: its parts refer to one another.
///
/// \tparam Map   a model of `ManifoldMap`. Used are: the types `Atlas`, `Domain_point` and `Location`
///               (default constructible, with members `face` and `barycentric`), and the members
///               `atlas()`, `number_of_vertices()`, `number_of_faces()`, `point(v)`, `domain_point(v)`,
///               `is_virtual(f)`, `is_virtual_vertex(v)`, `diagonal()`, `to_domain(location)`,
///               `position(location)` and `to_mesh(p, face_hint)`, where the hint -1 is none; the const
///               members are called from several threads under `Parallel_tag`.
/// \tparam Bump  a model of `BumpFunction`
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
template <class Map, class Bump = Smoothstep_bump<2>, class ConcurrencyTag = Sequential_tag>
class Surface_fitter {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump);

public:
  using Atlas = typename Map::Atlas; ///< the canonical surface with its charts
  using Surface = Manifold_surface<Atlas, Hierarchical_embedding, Bump>; ///< what is fitted

  /// The map must outlive the fitter.
  /// \pre the tolerances and the fairness are not negative, the fairness is at most 1; the degree is in 2..5;
  ///   `max_controls` is 0 or allows for the coarsest space: `number_of_charts * (4 + spline_degree)^2`; there are no
  ///   `vertex_weights` or as many as vertices, finite and not negative
  Surface_fitter(const Map& map, const Fit_options& options = Fit_options(), const Bump& bump = Bump())
    : fit_(internal::make_fit_engine(map, options, bump, internal::is_parallel<ConcurrencyTag>()))
  {
    CGAL_precondition(options.rms_error >= 0 && options.max_error >= 0);
    CGAL_precondition(options.fairness >= 0 && options.fairness <= 1);
    CGAL_precondition(options.crease_angle >= 0 && options.crease_angle <= 180);
    CGAL_precondition(options.spline_degree >= 2 && options.spline_degree <= 5);
    CGAL_precondition(options.max_controls == 0 ||
                      options.max_controls >= std::size_t(map.atlas().number_of_charts()) *
                                                (4 + options.spline_degree) * (4 + options.spline_degree));
    CGAL_precondition(options.vertex_weights.empty() ||
                      options.vertex_weights.size() == map.number_of_vertices());
    CGAL_precondition(std::all_of(options.vertex_weights.begin(), options.vertex_weights.end(),
                                  [](double w) { return w >= 0 && std::isfinite(w); }));
  }
  Surface_fitter(const Map&&, const Fit_options& = Fit_options(), const Bump& = Bump()) = delete;
  Surface_fitter(const Surface_fitter&) = delete;
  Surface_fitter& operator=(const Surface_fitter&) = delete;

  /// Fits; may be called repeatedly, with equal results.
  /// \param visitor  derived from `Default_visitor`; phases "fit" and "measure"
  /// \throw Geometry_error  `zero_extent`: all vertices coincide, so that errors have no unit;
  ///   `extent_out_of_range`: the diagonal of the mesh is not within 1e-60 and 1e60, or 1e-12 of a coordinate
  /// \throw Numeric_error  a factorisation fails
  template <class Visitor>
  Surface fit(Visitor& visitor)
  {
    return fit_->run(internal::Visitor_reference(visitor));
  }

  /// The same without a visitor.
  Surface fit()
  {
    Default_visitor visitor;
    return fit(visitor);
  }

  /// The map that the surface of the last `fit()` suits: the given one, or with `Fit_effort::COMPACT` one of the same
  /// mesh whose domain points moved with the surface. It lives until the next `fit()`.
  const Map& map() const { return fit_->map(); }
  /// Whether that is another map than the given one.
  bool has_moved_map() const { return fit_->has_moved_map(); }

  /// What the last `fit()` reached.
  const Fit_report& report() const { return fit_->report(); }

private:
  std::unique_ptr<internal::Fit_engine<Map, Bump>> fit_;
};

/// The map of a mesh (`Mesh_map`) is taken as the map on arrays that it is.
template <class Map, class Bump = Smoothstep_bump<2>>
Surface_fitter(const Map&, const Fit_options& = Fit_options(), const Bump& = Bump())
  -> Surface_fitter<internal::Map_on_arrays<Map>, Bump>;

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_SURFACE_FITTER_H
