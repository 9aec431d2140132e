// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MANIFOLD_SURFACE_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MANIFOLD_SURFACE_H

#include <CGAL/Simple_manifolds/internal/concepts.h>

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/evaluate_batch.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsEmbedding
///
/// A smooth surface over a canonical surface: the blend of one embedding per chart,
///
///   E(p) = sum_c w_c(p) E_c(alpha_c(p)) / sum_c w_c(p),
///
/// where w_c is the product of two bump functions of the coordinates in the open chart c and zero
/// outside of it (Grimm 2002, section 4). On the plane, which has one chart, E = E_0 on the closed
/// square. E has `smoothness()` continuous derivatives.
///
/// All members are const and may be called from several threads; those for one point allocate nothing.
///
/// \tparam Atlas           a model of `ManifoldAtlas`
/// \tparam ChartEmbedding  a model of `ChartEmbedding`
/// \tparam Bump            a model of `BumpFunction`
template <class Atlas_, class ChartEmbedding = Hierarchical_embedding, class Bump_ = Smoothstep_bump<2>>
class Manifold_surface {
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas_);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_EMBEDDING(ChartEmbedding);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump_);

public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  using Chart_embedding = ChartEmbedding;            ///< the embedding of a chart
  using Bump = Bump_;                                ///< the bump function

  /// \param charts  one embedding per chart
  /// \pre `charts.size()` is the number of charts of the atlas
  explicit Manifold_surface(std::vector<Chart_embedding> charts, Bump bump = Bump(), Atlas atlas = Atlas())
    : charts_(std::move(charts)), partition_(bump, atlas)
  {
    CGAL_precondition(charts_.size() == std::size_t(partition_.atlas().number_of_charts()));
  }

  /// The atlas of the domain.
  const Atlas& atlas() const { return partition_.atlas(); }
  /// The bump function.
  const Bump& bump() const { return partition_.bump(); }
  /// E_c. \pre `0 <= c < atlas().number_of_charts()`
  const Chart_embedding& chart_embedding(int c) const
  {
    CGAL_precondition(0 <= c && c < atlas().number_of_charts());
    return charts_[c];
  }

  /// The number of continuous derivatives of E: the least of the bump and of the embeddings.
  int smoothness() const
  {
    int k = charts_.front().smoothness();
    for (const Chart_embedding& e : charts_) k = (std::min)(k, e.smoothness());
    return Atlas::has_single_chart ? k : (std::min)(k, int(bump().smoothness));
  }

  /// \name Evaluation at one point
  /// Derivatives are those by the coordinates (u,v) of one chart: of the given chart point, else of
  /// the best chart of the domain point. Normal and curvatures do not depend on the chart; their signs
  /// are those of `Jet_geometry.h`.
  /// @{

  /// The position E(p).
  Eigen::Vector3d point(const Domain_point& p) const
  {
    if constexpr (has_single_chart) {
      return charts_[0].point(atlas().coordinates(0, p));
    } else {
      double weight = 0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Chart_point& q : atlas().charts_at(p)) {
        const double w = partition_.proto(q.uv);
        weight += w;
        sum += w * charts_[q.chart].point(q.uv);
      }
      return sum / weight;
    }
  }

  /// The position at a chart point.
  Eigen::Vector3d point(const Chart_point& a) const { return point(atlas().point(a)); }

  /// Position and derivatives by the coordinates of the best chart of p.
  /// \tparam Order  the highest order of derivatives that is computed, 1 or 2; others are zero
  template <int Order = 2>
  Jet jet(const Domain_point& p) const
  {
    const Chart_point a = best_chart_point(p);
    return blended_jet<Order>(a, atlas().chart(a.chart).jet_at(p));
  }

  /// Position and derivatives by the coordinates of the chart `a.chart`.
  template <int Order = 2>
  Jet jet(const Chart_point& a) const
  {
    return blended_jet<Order>(a, atlas().chart(a.chart).point_jet(a.uv));
  }

  /// The unit normal; outward for an outward oriented mesh. `Point`: a domain point or a chart point.
  template <class Point>
  Eigen::Vector3d normal(const Point& p) const
  {
    return Simple_manifolds::normal(jet<1>(p));
  }

  /// The principal curvatures k1 >= k2.
  template <class Point>
  Principal_curvatures principal_curvatures(const Point& p) const
  {
    return Simple_manifolds::principal_curvatures(jet(p));
  }

  /// The principal curvatures with their directions, in space and by the coordinates of the chart.
  template <class Point>
  Principal_directions principal_directions(const Point& p) const
  {
    return Simple_manifolds::principal_directions(jet(p));
  }

  /// The mean curvature H = (k1 + k2) / 2.
  template <class Point>
  double mean_curvature(const Point& p) const
  {
    return Simple_manifolds::mean_curvature(jet(p));
  }

  /// The Gaussian curvature K = k1 k2.
  template <class Point>
  double gaussian_curvature(const Point& p) const
  {
    return Simple_manifolds::gaussian_curvature(jet(p));
  }

  /// The best chart of p, with the coordinates there.
  Chart_point best_chart_point(const Domain_point& p) const
  {
    const int c = atlas().best_chart(p);
    return {c, atlas().coordinates(c, p)};
  }
  /// @}

  /// \name Evaluation of ranges
  /// `Range` is a range of domain points or of chart points; one result per point is written to `out`, in
  /// order, as `point()`, `jet()` and `normal()` give it. Surfaces of hierarchical splines of degree 2 to 5
  /// on the package's atlases are evaluated in batches, at several times the speed of single points and equal
  /// up to rounding: positions differ by less than 1e-14 times the size of the controls.
  ///
  /// With `ConcurrencyTag` = `Parallel_tag` several threads work on the range. The results are the same for
  /// any number of threads, and for a point alone or in any range.
  /// @{

  /// Positions.
  template <class ConcurrencyTag = Sequential_tag, class Range, class OutputIterator>
  OutputIterator points(const Range& range, OutputIterator out) const
  {
    static_assert(is_range_of_points<Range>, "the range is none of domain points or chart points");
    return evaluate<ConcurrencyTag, 0>(range, out, Identity());
  }

  /// Jets with derivatives up to `Order`, 1 or 2.
  template <class ConcurrencyTag, int Order = 2, class Range, class OutputIterator>
  OutputIterator jets(const Range& range, OutputIterator out) const
  {
    static_assert(is_range_of_points<Range>, "the range is none of domain points or chart points");
    return evaluate<ConcurrencyTag, Order>(range, out, Identity());
  }

  /// The same, with `Sequential_tag`.
  template <int Order = 2, class Range, class OutputIterator>
  OutputIterator jets(const Range& range, OutputIterator out) const
  {
    return jets<Sequential_tag, Order>(range, out);
  }

  /// Unit normals.
  template <class ConcurrencyTag = Sequential_tag, class Range, class OutputIterator>
  OutputIterator normals(const Range& range, OutputIterator out) const
  {
    static_assert(is_range_of_points<Range>, "the range is none of domain points or chart points");
    return evaluate<ConcurrencyTag, 1>(range, out, [](const Jet& e) { return Simple_manifolds::normal(e); });
  }
  /// @}

private:
  template <class Range, class Element = internal::Plain<typename internal::Range_element<const Range>::type>>
  static constexpr bool is_range_of_points =
    std::is_same_v<Element, Domain_point> || std::is_same_v<Element, Chart_point>;

  struct Identity {
    template <class T>
    const T& operator()(const T& x) const
    {
      return x;
    }
  };

  template <class Iterator>
  static constexpr bool is_random_access =
    std::is_convertible_v<typename std::iterator_traits<Iterator>::iterator_category,
                          std::random_access_iterator_tag>;

  // Order 0: positions
  template <class ConcurrencyTag, int Order, class Range, class OutputIterator, class Function>
  OutputIterator evaluate(const Range& range, OutputIterator out, const Function& f) const
  {
    using Point = internal::Plain<typename internal::Range_element<const Range>::type>;
    using Result = internal::Plain<decltype(f(std::declval<internal::Batch_result<Order>>()))>;
    if constexpr (is_random_access<decltype(std::begin(range))> && is_random_access<OutputIterator>) {
      constexpr std::ptrdiff_t most = 1 << 30; // parallel_for() counts with int
      const auto begin = std::begin(range);
      const std::ptrdiff_t n = std::end(range) - begin;
      for (std::ptrdiff_t done = 0; done < n; done += most)
        internal::parallel_for<ConcurrencyTag>(0, int((std::min)(most, n - done)), [&](int first, int last) {
          evaluate_piece<Order, Point>(begin + (done + first), last - first, out + (done + first), f);
        });
      return out + n;
    } else {
      constexpr std::size_t chunk = std::is_convertible_v<ConcurrencyTag, Parallel_tag> ? 1 << 16 : 1 << 9;
      std::vector<Point> points;
      std::vector<Result> results;
      auto it = std::begin(range);
      while (it != std::end(range)) {
        points.clear();
        for (; it != std::end(range) && points.size() < chunk; ++it) points.push_back(*it);
        results.resize(points.size());
        evaluate<ConcurrencyTag, Order>(points, results.begin(), f);
        out = std::copy(results.begin(), results.end(), out);
      }
      return out;
    }
  }

  // through arrays that stay in the cache
  template <int Order, class Point, class Iterator, class OutputIterator, class Function>
  void evaluate_piece(Iterator it, int n, OutputIterator out, const Function& f) const
  {
    constexpr int chunk = 64;
    std::array<Point, chunk> points;
    using Result = internal::Batch_result<Order>;
    [[maybe_unused]] std::array<Result, chunk> results;
    constexpr bool is_direct = std::is_same_v<Function, Identity> &&
                               (std::is_same_v<OutputIterator, Result*> ||
                                std::is_same_v<OutputIterator, typename std::vector<Result>::iterator>);
    for (int done = 0; done < n; done += chunk) {
      const int m = (std::min)(chunk, n - done);
      for (int k = 0; k < m; ++k, ++it) points[std::size_t(k)] = *it;
      if constexpr (is_direct) {
        evaluate<Order>(points.data(), m, &out[done]);
      } else {
        evaluate<Order>(points.data(), m, results.data());
        for (int k = 0; k < m; ++k, ++out) *out = f(results[std::size_t(k)]);
      }
    }
  }

  template <int Order, class Point, class Result>
  void evaluate(const Point* points, int n, Result* results) const
  {
    if constexpr (internal::may_have_batches<Manifold_surface>)
      if (internal::has_batches(*this)) {
        internal::evaluate_batch<Order>(*this, points, n, results);
        return;
      }
    for (int k = 0; k < n; ++k)
      if constexpr (Order == 0)
        results[k] = point(points[k]);
      else
        results[k] = jet<Order>(points[k]);
  }

  static constexpr bool has_single_chart = Atlas::has_single_chart;

  // The quotient of the sums of w E_c and of w. The product is taken in the chart c, then both are
  // transported to the chart of a: one change of chart per chart, the same as for E_c alone.
  template <int Order>
  Jet blended_jet(const Chart_point& a, const Basic_jet<Domain_point>& p) const
  {
    if constexpr (has_single_chart) {
      return charts_[0].template jet<Order>(a.uv);
    } else if constexpr (Atlas::has_flat_transitions) { // no changes of chart: they are translations
      Scalar_jet weight = Scalar_jet::zero();
      Jet sum = Jet::zero();
      for (const Chart_point& q : atlas().charts_at(p.value)) {
        const Scalar_jet w = partition_.proto_jet(q.uv);
        weight += w;
        sum += product(w, charts_[q.chart].template jet<Order>(q.uv));
      }
      return quotient_of_order<Order>(sum, weight);
    } else {
      Scalar_jet weight = partition_.proto_jet(a.uv);
      Jet sum = product(weight, charts_[a.chart].template jet<Order>(a.uv));
      for (const int c : atlas().chart_numbers_at(p.value)) {
        if (c == a.chart) continue;
        const Transition_jet psi = atlas().chart(c).coordinates_jet(p);
        add(partition_.proto_jet(psi.value), charts_[c].template jet<Order>(psi.value), psi, weight, sum);
      }
      return quotient_of_order<Order>(sum, weight);
    }
  }

  template <int Order>
  static Jet quotient_of_order(const Jet& sum, const Scalar_jet& weight)
  {
    Jet e = quotient(sum, weight);
    if constexpr (Order < 2) e.uu = e.uv = e.vv = Eigen::Vector3d::Zero();
    return e;
  }

  // adds w and w E_c, seen through psi
  static void add(const Scalar_jet& w, const Jet& e, const Transition_jet& psi, Scalar_jet& weight, Jet& sum)
  {
    weight += compose(w, psi);
    sum += compose(product(w, e), psi);
  }

  std::vector<Chart_embedding> charts_;
  Partition_of_unity<Atlas, Bump> partition_;
};

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_MANIFOLD_SURFACE_H
