// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_POLISH_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_POLISH_H

#include <CGAL/Simple_manifolds/registration/internal/Registered_surface.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_layout.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The finest level alone: sweeps from the map that the source has.
template <class Geometry>
class Registration_polish {
public:
  Registration_polish(const Registered_surface<Geometry>& source, const std::vector<int>& frozen,
                      const Registration_options& options)
    : geometry_(static_cast<int>(source.points.size())),
      levels_(source, geometry_, {}, options.area_floor, options.is_parallel),
      positions_(levels_.numbered(source.positions)), frozen_(frozen), options_(options)
  {
    while (levels_.mesh.level() < levels_.mesh.number_of_levels()) levels_.mesh.refine([](int) {});
  }

  // The mean pointwise energy of the source against the target, after as many sweeps of all vertices, and of the
  // worst ones; they move the domain points.
  double run(Registered_surface<Geometry>& source, const Lift<Geometry>& target, int sweeps,
             int sweeps_of_worst = 0)
  {
    const int n = static_cast<int>(source.domain_points.size());
    for (int v = 0; v < n; ++v) geometry_.set_position(levels_.number(v), source.domain_points[v]);
    Registration_layout<Geometry> layout(levels_.mesh, geometry_, target, positions_, options_.shape_floor,
                                         options_.is_parallel);
    layout.update_mesh();
    for (const int v : frozen_) layout.freeze(levels_.number(v), true);
    layout.set_stage(Registration_layout<Geometry>::Stage::POINTWISE);
    layout.sweep(sweeps);
    layout.sweep_worst(sweeps_of_worst);
    for (int v = 0; v < n; ++v) source.domain_points[v] = geometry_.position(levels_.number(v));
    return layout.pointwise_mean();
  }

private:
  Geometry geometry_;
  Surface_levels<Geometry> levels_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<int> frozen_;
  Registration_options options_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_POLISH_H
