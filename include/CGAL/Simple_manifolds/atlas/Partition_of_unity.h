// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_ATLAS_PARTITION_OF_UNITY_H
#define CGAL_SIMPLE_MANIFOLDS_ATLAS_PARTITION_OF_UNITY_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/internal/Short_list.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsAtlas
///
/// The blend functions of an atlas (Grimm 2002, section 4): on each chart the product of two bumps, of u
/// and of v, zero outside of it, divided by the sum over all charts. They are positive in their chart,
/// sum to 1 everywhere, and have as many continuous derivatives as the bump. The sum is never 0: the
/// chart of its tile sees every point far from its border.
///
/// If the atlas has a single chart, its blend function is the constant 1.
///
/// All members are const and may be called from several threads; none allocates.
///
/// \tparam Atlas_  a model of `ManifoldAtlas`
/// \tparam Bump_   a model of `BumpFunction`
template <class Atlas_, class Bump_ = Smoothstep_bump<2>>
class Partition_of_unity {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas_);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump_);

public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Bump = Bump_;                                ///< the bump function
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface

  /// The weight of one chart at a point.
  struct Weight {
    Chart_point point; ///< the point in that chart
    double weight;     ///< b_c, in [0,1]
  };

  /// The weight of one chart with its derivatives by the coordinates of the reporting chart.
  struct Weight_jet {
    Chart_point point;         ///< the point in this weight's chart
    Transition_jet transition; ///< from the reporting chart to this weight's chart
    Scalar_jet weight;         ///< b_c and its derivatives
  };

  using Weight_list = internal::Short_list<Weight, Atlas::max_charts_per_point>;         ///< a range
  using Weight_jet_list = internal::Short_list<Weight_jet, Atlas::max_charts_per_point>; ///< a range

  /// The partition of unity of the bumps on all charts of an atlas.
  explicit Partition_of_unity(const Bump& bump = Bump(), const Atlas& atlas = Atlas())
    : bump_(bump), atlas_(atlas)
  {
  }

  /// The atlas of the domain.
  const Atlas& atlas() const { return atlas_; }
  /// The bump function.
  const Bump& bump() const { return bump_; }

  /// The product of the two bumps, not normalised, at the coordinates `uv` of any chart.
  double proto(const Eigen::Vector2d& uv) const
  {
    if constexpr (has_single_chart) {
      return 1;
    } else {
      return bump_(uv[0]) * bump_(uv[1]);
    }
  }

  /// The same with its derivatives by these coordinates.
  Scalar_jet proto_jet(const Eigen::Vector2d& uv) const
  {
    if constexpr (has_single_chart) {
      return {1, 0, 0, 0, 0, 0};
    } else {
      const std::array<double, 3> f = bump_.jet(uv[0]), g = bump_.jet(uv[1]);
      return {f[0] * g[0], f[1] * g[0], f[0] * g[1], f[2] * g[0], f[1] * g[1], f[0] * g[2]};
    }
  }

  /// The charts that contain `p`, in increasing order, with their weights, which sum to 1.
  Weight_list weights(const Domain_point& p) const
  {
    Weight_list list;
    double sum = 0;
    for (const Chart_point& q : atlas_.charts_at(p)) {
      list.push_back({q, proto(q.uv)});
      sum += proto(q.uv);
    }
    for (Weight& w : list) {
      w.weight /= sum;
    }
    return list;
  }

  /// The weights and their derivatives by the coordinates (u,v) of the chart `a.chart`, at `a`. Within
  /// rounding of that chart's border, where its own weight is 0, the chart itself may be missing.
  /// \pre `a.uv` in the open unit square (on the plane: the closed one)
  Weight_jet_list weight_jets(const Chart_point& a) const
  {
    CGAL_precondition(has_single_chart ? a.uv.minCoeff() >= 0 && a.uv.maxCoeff() <= 1
                                       : a.uv.minCoeff() > 0 && a.uv.maxCoeff() < 1);
    return weight_jets(a, atlas_.chart(a.chart).point_jet(a.uv));
  }

  /// The same at a domain point, by the coordinates of its best chart.
  Weight_jet_list weight_jets(const Domain_point& p) const
  {
    const int c = atlas_.best_chart(p);
    const auto chart = atlas_.chart(c);
    return weight_jets({c, chart.coordinates(p)}, chart.jet_at(p));
  }

private:
  static constexpr bool has_single_chart = Atlas::has_single_chart;

  Weight_jet_list weight_jets(const Chart_point& a, const Basic_jet<Domain_point>& p) const
  {
    Weight_jet_list list;
    Scalar_jet sum = Scalar_jet::zero();
    for (const int c : atlas_.chart_numbers_at(p.value)) {
      if (c == a.chart) {
        list.push_back({a, identity_jet(a.uv), proto_jet(a.uv)});
      } else {
        const Transition_jet psi = atlas_.chart(c).coordinates_jet(p);
        list.push_back({{c, psi.value}, psi, compose(proto_jet(psi.value), psi)});
      }
      sum += list[list.size() - 1].weight;
    }
    for (Weight_jet& w : list) {
      w.weight = quotient(w.weight, sum);
    }
    return list;
  }

  Bump bump_;
  Atlas atlas_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_ATLAS_PARTITION_OF_UNITY_H
