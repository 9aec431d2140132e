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
    : levels_(source, {}, options.area_floor, options.is_parallel),
      positions_(levels_.numbered(source.positions, Eigen::Vector3d(0, 0, 0))), frozen_(frozen),
      options_(options)
  {
    while (levels_.mesh.level() < levels_.mesh.number_of_levels()) levels_.mesh.refine([](int) {});
  }

  // The mean pointwise energy of the source against the target, after as many sweeps of all vertices, and of the
  // worst ones; they move the domain points. between: is called after each sweep, or ten of the worst ones.
  template <class Between>
  double run(Registered_surface<Geometry>& source, const Lift<Geometry>& target, int sweeps,
             int sweeps_of_worst, const Between& between)
  {
    Geometry& geometry = levels_.geometry;
    const int n = static_cast<int>(source.domain_points.size());
    for (int v = 0; v < n; ++v) geometry.set_position(levels_.number(v), source.domain_points[v]);
    Registration_domain<Geometry>::develop(geometry, levels_.mesh);
    Registration_layout<Geometry> layout(levels_.mesh, geometry, target, positions_, options_.shape_floor,
                                         options_.is_parallel);
    layout.update_mesh();
    for (const int v : frozen_) layout.freeze(levels_.number(v), true);
    layout.set_stage(Registration_layout<Geometry>::Stage::POINTWISE);
    for (; sweeps > 0; --sweeps) {
      layout.sweep(1);
      between();
    }
    for (constexpr int some = 10; sweeps_of_worst > 0; sweeps_of_worst -= some) {
      layout.sweep_worst(some);
      between();
    }
    const double mean = layout.composed().pointwise_mean();
    geometry.start_level(levels_.mesh); // on the torus it takes the copies that are domain points
    for (int v = 0; v < n; ++v) source.domain_points[v] = geometry.position(levels_.number(v));
    return mean;
  }

  // That energy as it is.
  double energy(Registered_surface<Geometry>& source, const Lift<Geometry>& target)
  {
    return run(source, target, 0, 0, [] {});
  }

private:
  Surface_levels<Geometry> levels_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<int> frozen_;
  Registration_options options_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_POLISH_H
