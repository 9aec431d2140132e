// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_TESSELLATION_CHART_TEXTURES_H
#define CGAL_SIMPLE_MANIFOLDS_TESSELLATION_CHART_TEXTURES_H

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsTessellation
///
/// A function on a canonical surface as one image per chart, each of the whole unit square. A lookup blends
/// the images by the partition of unity, so that it has no seams (Grimm 2002, sections 1 and 7):
///
///   sample(p) = sum_c b_c(p) image_c(alpha_c(p)).
///
/// An image has n x n texels; texel (i,j) holds the value at its centre ((i + 1/2)/n, (j + 1/2)/n). Between
/// the centres it is bilinear, and so it is continued up to the border of the square. The blend of a function
/// with two derivatives then errs by O(1/n^2), is continuous, and exact for constants.
///
/// Values are kept in single precision.
///
/// \tparam Atlas_     a model of `ManifoldAtlas`
/// \tparam Channels_  the numbers per value: 1 for a scalar, 3 for a colour or a vector
/// \tparam Bump_      a model of `BumpFunction`
template <class Atlas_, int Channels_, class Bump_ = Smoothstep_bump<2>>
class Chart_textures {
public:
  using Atlas = Atlas_;                              ///< the canonical surface with its charts
  using Domain_point = typename Atlas::Domain_point; ///< a point of the canonical surface
  static constexpr int channels = Channels_;         ///< numbers per texel
  using Value = Eigen::Matrix<double, channels, 1>;  ///< what a texel holds

  /// \param resolution  texels per side of an image
  /// \param value  a function from `Chart_point` to `Value`, or to a number where there is one channel;
  ///   called once for each texel, chart by chart, with j running fastest
  /// \pre `resolution >= 2`
  template <class Function>
  Chart_textures(int resolution, const Function& value, const Bump_& bump = Bump_(),
                 const Atlas& atlas = Atlas())
    : partition_(bump, atlas), resolution_(resolution)
  {
    CGAL_precondition(resolution >= 2);
    values_.reserve(std::size_t(atlas.number_of_charts()) * resolution * resolution * channels);
    for (int c = 0; c < atlas.number_of_charts(); ++c)
      for (int i = 0; i < resolution; ++i)
        for (int j = 0; j < resolution; ++j) {
          Value x;
          if constexpr (channels == 1)
            x[0] = double(value(texel_point(resolution, c, i, j)));
          else
            x = value(texel_point(resolution, c, i, j));
          for (int k = 0; k < channels; ++k) values_.push_back(float(x[k]));
        }
  }

  /// The atlas of the domain.
  const Atlas& atlas() const { return partition_.atlas(); }
  /// The texels per side of an image.
  int resolution() const { return resolution_; }

  /// The centre of texel (i,j) of the image of chart c, at the given resolution.
  static Chart_point texel_point(int resolution, int c, int i, int j)
  {
    return {c, {(i + 0.5) / resolution, (j + 0.5) / resolution}};
  }

  /// The value of texel (i,j), i along u and j along v, of the image of chart c.
  /// \pre c is a chart, i and j in [0,n)
  Value texel(int c, int i, int j) const
  {
    CGAL_precondition(0 <= c && c < atlas().number_of_charts());
    CGAL_precondition(0 <= i && i < resolution_ && 0 <= j && j < resolution_);
    const std::size_t n = std::size_t(resolution_);
    return Eigen::Map<const Eigen::Matrix<float, channels, 1>>(&values_[((c * n + i) * n + j) * channels])
      .template cast<double>();
  }

  /// The blend of the images of all charts that contain `p`.
  Value sample(const Domain_point& p) const
  {
    Value sum = Value::Zero();
    for (const auto& w : partition_.weights(p)) sum += w.weight * sample(w.point);
    return sum;
  }

  /// The image of one chart, not blended: what a program that knows only images shows.
  Value sample(const Chart_point& a) const
  {
    const Eigen::Vector2d x = resolution_ * a.uv - Eigen::Vector2d(0.5, 0.5);
    const auto cell = [&](double s) { return std::clamp(int(std::floor(s)), 0, resolution_ - 2); };
    const int i = cell(x[0]), j = cell(x[1]);
    const double s = x[0] - i, t = x[1] - j; // beyond [0,1] in the outer half of the outermost texels
    return (1 - s) * ((1 - t) * texel(a.chart, i, j) + t * texel(a.chart, i, j + 1)) +
           s * ((1 - t) * texel(a.chart, i + 1, j) + t * texel(a.chart, i + 1, j + 1));
  }

private:
  Partition_of_unity<Atlas, Bump_> partition_;
  int resolution_;
  std::vector<float> values_;
};

namespace internal {

// The numbers per value of a function with this result: a number, or an Eigen vector of fixed size.
template <class Result>
constexpr int channels_of()
{
  if constexpr (std::is_arithmetic_v<Result>)
    return 1;
  else
    return Result::RowsAtCompileTime;
}

template <class Function>
auto value_on_surface(const Function& f, const Chart_point& a, const Jet& e)
{
  if constexpr (std::is_invocable_v<const Function&, const Jet&>)
    return f(e);
  else
    return f(a, e);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Puts a function on a canonical surface into images of its charts.
///
/// \param resolution  texels per side of an image
/// \param f           from `Atlas::Domain_point` to a number or to an Eigen vector of fixed size
/// \pre `resolution >= 2`
template <class Atlas, class Bump = Smoothstep_bump<2>, class Function>
auto bake(int resolution, const Function& f, const Bump& bump = Bump(), const Atlas& atlas = Atlas())
{
  using Result = std::decay_t<decltype(f(atlas.point(Chart_point())))>;
  return Chart_textures<Atlas, internal::channels_of<Result>(), Bump>(
    resolution, [&](const Chart_point& a) { return f(atlas.point(a)); }, bump, atlas);
}

/// \ingroup PkgSimpleManifoldsTessellation
///
/// Puts a function of the points of a surface into images of its charts: a normal, a curvature, a colour.
///
/// \tparam ConcurrencyTag  `Parallel_tag` evaluates the surface with several threads, to the same result
/// \param resolution  texels per side of an image
/// \param f  from a `Jet` of the surface, or from a `Chart_point` and the `Jet` there, to a number or to an
///           Eigen vector of fixed size
/// \pre `resolution >= 2`
template <class ConcurrencyTag = Sequential_tag, class Atlas, class ChartEmbedding, class Bump,
          class Function>
auto bake(const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface, int resolution, const Function& f)
{
  using Result = std::decay_t<decltype(internal::value_on_surface(f, Chart_point(), Jet()))>;
  using Textures = Chart_textures<Atlas, internal::channels_of<Result>(), Bump>;
  // The surface is evaluated for several i at once, enough for several threads.
  constexpr std::size_t enough = 1 << 16;
  std::vector<Chart_point> texels;
  std::vector<Jet> jets;
  std::size_t next = 0;
  int i = 0;
  return Textures(
    resolution,
    [&](const Chart_point& a) {
      if (next == jets.size()) {
        texels.clear();
        for (; i < resolution && texels.size() < enough; ++i)
          for (int j = 0; j < resolution; ++j)
            texels.push_back(Textures::texel_point(resolution, a.chart, i, j));
        i %= resolution;
        jets.clear();
        surface.template jets<ConcurrencyTag>(texels, std::back_inserter(jets));
        next = 0;
      }
      return internal::value_on_surface(f, a, jets[next++]);
    },
    surface.bump(), surface.atlas());
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_TESSELLATION_CHART_TEXTURES_H
