// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_EVALUATE_BATCH_H
#define CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_EVALUATE_BATCH_H

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Pack.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/Tensor_sum.h>
#include <CGAL/Simple_manifolds/internal/Batch_slot.h>
#include <CGAL/Simple_manifolds/internal/always_inline.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <type_traits>

// The evaluation of surfaces of hierarchical splines at many points at once.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Adds b E with its derivatives: see Batch_slot. x holds E and its derivatives.
template <int Order, int Width, bool IsTransported>
CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void add_blended(const Batch_slot<Order, IsTransported>& slot, int k,
                                                     const Pack_jet<Width>& x, Pack_jet<Width>& e)
{
  const auto& b = slot.b;
  e.value += b[0][k] * x.value;
  if constexpr (Order >= 1) {
    e.u += b[1][k] * x.value;
    e.v += b[2][k] * x.value;
    if constexpr (IsTransported) {
      e.u += slot.first[0][0][k] * x.u;
      e.u += slot.first[1][0][k] * x.v;
      e.v += slot.first[0][1][k] * x.u;
      e.v += slot.first[1][1][k] * x.v;
    } else {
      e.u += b[0][k] * x.u;
      e.v += b[0][k] * x.v;
    }
  }
  if constexpr (Order >= 2) {
    e.uu += b[3][k] * x.value;
    e.uv += b[4][k] * x.value;
    e.vv += b[5][k] * x.value;
    if constexpr (IsTransported) {
      const auto add = [&](int n, Pack<Width>& to) {
        to += slot.second[0][n][k] * x.u;
        to += slot.second[1][n][k] * x.v;
        to += slot.second[2][n][k] * x.uu;
        to += slot.second[3][n][k] * x.uv;
        to += slot.second[4][n][k] * x.vv;
      };
      add(0, e.uu);
      add(1, e.uv);
      add(2, e.vv);
    } else {
      e.uu += (2 * b[1][k]) * x.u;
      e.uv += b[2][k] * x.u;
      e.uv += b[1][k] * x.v;
      e.vv += (2 * b[2][k]) * x.v;
      e.uu += b[0][k] * x.uu;
      e.uv += b[0][k] * x.uv;
      e.vv += b[0][k] * x.vv;
    }
  }
}

// The first three coordinates.
template <int Width>
Eigen::Vector3d vector(const std::array<Pack_jet<Width>, 4 / Width>& e, Pack<Width> Pack_jet<Width>::*member)
{
  constexpr int z = 2 / Width;
  return {(e[0].*member)[0], (e[0].*member)[1], (e[z].*member)[2 % Width]};
}

template <int Order, int Width>
void write_result(const std::array<Pack_jet<Width>, 4 / Width>& e, Eigen::Vector3d& out)
{
  out = vector<Width>(e, &Pack_jet<Width>::value);
}

template <int Order, int Width>
void write_result(const std::array<Pack_jet<Width>, 4 / Width>& e, Jet& out)
{
  using E = Pack_jet<Width>;
  out.value = vector<Width>(e, &E::value);
  out.u = vector<Width>(e, &E::u);
  out.v = vector<Width>(e, &E::v);
  if constexpr (Order >= 2) {
    out.uu = vector<Width>(e, &E::uu);
    out.uv = vector<Width>(e, &E::uv);
    out.vv = vector<Width>(e, &E::vv);
  } else {
    out.uu = out.uv = out.vv = Eigen::Vector3d::Zero();
  }
}

// The functions of the leaves of a row of points, with their derivatives by the coordinates of the chart.
template <int D, int Order>
struct Basis_rows {
  std::array<std::array<Row, D + 1>, Order + 1> derivative;

  // \param t      the coordinate in the leaf
  // \param cells  leaves per unit
  void compute(const Row& t, const Row& cells)
  {
    for (int k = 0; k < row_size; ++k) {
      const Span_basis<D, Order> basis(t[k]);
      double scale = 1;
      for (int n = 0; n <= Order; ++n, scale *= cells[k])
        for (int r = 0; r <= D; ++r)
          derivative[n][r][k] = n == 0 ? basis.derivative[n][r] : scale * basis.derivative[n][r];
    }
  }
};

// \tparam D  the degree of all charts
template <int D, int Order, int Width>
class Blend_rows {
public:
  using Sums = std::array<Pack_jet<Width>, 4 / Width>;

  // Adds the contributions of a slot; those of the first one are added to 0.
  template <bool IsFirst, class Slot>
  void add(const Hierarchical_embedding* charts, const Slot& slot)
  {
    const Leaf_table& first = charts[0].leaves(); // all have the same base
    for (int k = 0; k < row_size; ++k) {
      x_[k] = slot.u[k] * first.base();
      y_[k] = slot.v[k] * first.base();
      i_[k] = first.cell(x_[k]);
      j_[k] = first.cell(y_[k]);
    }
    if (is_coherent(first))
      find_places<true>(charts, slot.chart);
    else
      find_places<false>(charts, slot.chart);
    for (int k = 0; k < row_size; ++k) {
      s_[k] = first.in_leaf(x_[k], scale_[k]);
      t_[k] = first.in_leaf(y_[k], scale_[k]);
      scale_[k] *= first.base();
    }
    a_.compute(s_, scale_);
    b_.compute(t_, scale_);
    for (int k = 0; k < row_size; ++k)
      for (int i = 0; i < 4 / Width; ++i) {
        Pack_jet<Width> sum = IsFirst ? Pack_jet<Width>() : this->sum(k, i);
        if (slot.chart[k] >= 0) {
          Pack_jet<Width> x;
          tensor_sum_rows(k, i * Width, x);
          add_blended<Order, Width>(slot, k, x, sum);
          set_sum(k, i, sum);
        } else if (IsFirst) {
          set_sum(k, i, sum);
        }
      }
  }

  Sums operator[](int k) const
  {
    Sums e;
    for (int i = 0; i < 4 / Width; ++i) e[i] = sum(k, i);
    return e;
  }

private:
  CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE Pack_jet<Width> sum(int k, int i) const
  {
    const auto& s = sums_[k][i];
    Pack_jet<Width> e;
    e.value = s[0];
    if constexpr (Order >= 1) {
      e.u = s[1];
      e.v = s[2];
    }
    if constexpr (Order >= 2) {
      e.uu = s[3];
      e.uv = s[4];
      e.vv = s[5];
    }
    return e;
  }

  CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void set_sum(int k, int i, const Pack_jet<Width>& e)
  {
    auto& s = sums_[k][i];
    s[0] = e.value;
    if constexpr (Order >= 1) {
      s[1] = e.u;
      s[2] = e.v;
    }
    if constexpr (Order >= 2) {
      s[3] = e.uu;
      s[4] = e.uv;
      s[5] = e.vv;
    }
  }

  // Whether most points are close to those before them.
  bool is_coherent(const Leaf_table& table) const
  {
    int close = 0;
    for (int k = 1; k < row_size; ++k) close += table.are_close(i_[k] ^ i_[k - 1], j_[k] ^ j_[k - 1]);
    return close > row_size / 2;
  }

  // With `IsCoherent`, a point in the leaf of the one before it is not searched for. For random points that would
  // be a test whose result the processor cannot foresee.
  template <bool IsCoherent>
  void find_places(const Hierarchical_embedding* charts, const Row& chart_of)
  {
    Leaf_table::Place place{nullptr, 1, 0};
    int last_chart = -1, last = 0;
    for (int k = 0; k < row_size; ++k) {
      const int chart = int(chart_of[k]);
      scale_[k] = 1;
      if (chart < 0) continue;
      if (!IsCoherent || chart != last_chart ||
          ((i_[k] ^ i_[last]) | (j_[k] ^ j_[last])) >> place.shift != 0) {
        place = charts[chart].leaves().find_place(i_[k], j_[k]);
        prefetch(place.controls);
        last_chart = chart;
        last = k;
      }
      controls_[k] = place.controls;
      scale_[k] = place.scale;
    }
  }

  static CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void prefetch(const Quad* c)
  {
#if defined(__GNUC__)
    for (int i = 0; i < (D + 1) * (D + 1); i += 2) __builtin_prefetch(c + i);
#endif
  }

  CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void tensor_sum_rows(int k, int first, Pack_jet<Width>& e) const
  {
    const Quad* c = controls_[k];
    Pack<Width> value{}, u{}, v{}, uu{}, uv{}, vv{};
    for (int r = 0; r <= D; ++r, c += D + 1) {
      Pack<Width> s{}, s1{}, s2{};
      for (int l = 0; l <= D; ++l) {
        Pack<Width> x;
        load<Width>(c[l].x + first, x);
        s += b_.derivative[0][l][k] * x;
        if constexpr (Order >= 1) s1 += b_.derivative[1][l][k] * x;
        if constexpr (Order >= 2) s2 += b_.derivative[2][l][k] * x;
      }
      value += a_.derivative[0][r][k] * s;
      if constexpr (Order >= 1) {
        u += a_.derivative[1][r][k] * s;
        v += a_.derivative[0][r][k] * s1;
      }
      if constexpr (Order >= 2) {
        uu += a_.derivative[2][r][k] * s;
        uv += a_.derivative[1][r][k] * s1;
        vv += a_.derivative[0][r][k] * s2;
      }
    }
    e.value = value;
    if constexpr (Order >= 1) {
      e.u = u;
      e.v = v;
    }
    if constexpr (Order >= 2) {
      e.uu = uu;
      e.uv = uv;
      e.vv = vv;
    }
  }

  std::array<const Quad*, row_size> controls_;
  Row x_, y_, s_, t_, scale_;
  std::array<int, row_size> i_, j_;
  Basis_rows<D, Order> a_, b_;
  // only the derivatives that are asked for, so that less of the cache is used
  std::array<std::array<std::array<Pack<Width>, (Order + 1) * (Order + 2) / 2>, 4 / Width>, row_size> sums_;
};

template <int Order>
using Batch_result = std::conditional_t<Order == 0, Eigen::Vector3d, Jet>;

// Fetches the memory of results while they are computed: they are written in one go.
template <class Result>
CGAL_SIMPLE_MANIFOLDS_ALWAYS_INLINE void prefetch_for_writing([[maybe_unused]] const Result* out,
                                                              [[maybe_unused]] int n)
{
#if defined(__GNUC__)
  constexpr int line = 64;
  const char* const first = reinterpret_cast<const char*>(out);
  for (int k = 0; k < n * int(sizeof(Result)); k += line) __builtin_prefetch(first + k, 1);
#endif
}

template <int D, int Order, int Width>
void blend_row_of_degree(const Hierarchical_embedding* charts, const Batch_slots<Order>& slots, int n,
                         Batch_result<Order>* out)
{
  prefetch_for_writing(out, n);
  Blend_rows<D, Order, Width> rows;
  rows.template add<true>(charts, slots.own[0]);
  for (int i = 1; i < slots.number_of_own; ++i) rows.template add<false>(charts, slots.own[i]);
  for (int i = 0; i < slots.number_of_transported; ++i)
    rows.template add<false>(charts, slots.transported[i]);
  for (int k = 0; k < n; ++k) write_result<Order, Width>(rows[k], out[k]);
}

// Writes the first n results of a row. Knows neither the atlas nor the bump: this is most of the code of an
// evaluation, and all surfaces of a program have it once.
// \param charts  the embeddings of all charts
template <int Order>
void blend_row(const Hierarchical_embedding* charts, const Batch_slots<Order>& slots, int n,
               Batch_result<Order>* out)
{
  call_with_widest_packs([&](auto width) {
    constexpr int w = decltype(width)::value;
    switch (charts[0].degree()) {
    case 2:
      blend_row_of_degree<2, Order, w>(charts, slots, n, out);
      break;
    case 3:
      blend_row_of_degree<3, Order, w>(charts, slots, n, out);
      break;
    case 4:
      blend_row_of_degree<4, Order, w>(charts, slots, n, out);
      break;
    default:
      blend_row_of_degree<5, Order, w>(charts, slots, n, out);
    }
  });
}

// Whether an atlas has weights of many points at once.
template <class Atlas, class = void>
inline constexpr bool has_batch_weights = false;
template <class Atlas>
inline constexpr bool
  has_batch_weights<Atlas, std::void_t<typename Atlas::template Batch_weights<Smoothstep_bump<2>, 0>>> = true;

// Whether `evaluate_batch()` can evaluate surfaces of a type.
template <class Surface>
inline constexpr bool may_have_batches =
  std::is_same_v<typename Surface::Chart_embedding, Hierarchical_embedding>&&
    has_batch_weights<typename Surface::Atlas>;

// Whether it can evaluate this one: all charts have one base grid and one degree, of those that are compiled.
template <class Surface>
bool has_batches(const Surface& surface)
{
  const Hierarchical_embedding& first = surface.chart_embedding(0);
  for (int c = 1; c < surface.atlas().number_of_charts(); ++c) {
    const Hierarchical_embedding& e = surface.chart_embedding(c);
    if (e.degree() != first.degree() || e.levels()[0].cells != first.levels()[0].cells) return false;
  }
  return first.degree() >= 2 && first.degree() <= 5;
}

// Evaluates n points. The result for a point does not depend on the others.
// \tparam Order  0, 1 or 2
template <int Order, class Surface, class Point>
void evaluate_batch(const Surface& surface, const Point* points, int n, Batch_result<Order>* out)
{
  using Weights = typename Surface::Atlas::template Batch_weights<typename Surface::Bump, Order>;
  Weights weights(surface.atlas(), surface.bump());
  for (int done = 0; done < n; done += row_size) {
    const int m = (std::min)(n - done, row_size);
    call_with_widest_packs([&](auto) { // packs of any width
      for (int k = 0; k < row_size; ++k) weights.set(k, points[done + (std::min)(k, m - 1)]);
      weights.run();
    });
    blend_row<Order>(&surface.chart_embedding(0), weights.slots(), m, out + done);
  }
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE void blend_row<0>(const Hierarchical_embedding*, const Batch_slots<0>&, int,
                                                    Batch_result<0>*);
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE void blend_row<1>(const Hierarchical_embedding*, const Batch_slots<1>&, int,
                                                    Batch_result<1>*);
CGAL_SIMPLE_MANIFOLDS_INSTANTIATE void blend_row<2>(const Hierarchical_embedding*, const Batch_slots<2>&, int,
                                                    Batch_result<2>*);
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_EMBEDDING_INTERNAL_EVALUATION_EVALUATE_BATCH_H
