// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_ENGINE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_ENGINE_H

#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>

#include <memory>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// What `Surface_fitter` sees of a fit. A program whose fit the compiled library has instantiates no more than this.
template <class Map, class Bump>
class Fit_engine {
public:
  using Surface = Manifold_surface<typename Map::Atlas, Hierarchical_embedding, Bump>;

  Fit_engine() = default;
  Fit_engine(const Fit_engine&) = delete;
  Fit_engine& operator=(const Fit_engine&) = delete;
  virtual ~Fit_engine() = default;

  virtual Surface run(const Visitor_reference& visitor) = 0;
  virtual const Fit_report& report() const = 0;
  /// The map that the surface of the last run suits.
  virtual const Map& map() const = 0;
  virtual bool has_moved_map() const = 0;
};

/// Refers to the map.
template <class Map, class Bump>
std::unique_ptr<Fit_engine<Map, Bump>> make_fit_engine(const Map& map, const Fit_options& options,
                                                       const Bump& bump, bool is_parallel);

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_FIT_FIT_ENGINE_H
