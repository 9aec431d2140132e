// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_SHAPES_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_SHAPES_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>
#include <CGAL/Simple_manifolds/registration/Shape_set.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsRegistration
///
/// Registers several shapes, so that one canonical surface is a domain of all of them. All are registered to one of them,
/// the template, whose domain points stay. Then, so that the choice of the template matters less, the mean of all
/// shapes takes its place: each shape is improved against the mean, by passes that are kept only where they lower the
/// distortion, and the mean is made anew. Two shapes are registered to each other as by `register_maps()`.
///
/// \tparam ConcurrencyTag  `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
/// \tparam Atlas  `Sphere_atlas`, `Torus_atlas` or `Plane_atlas`
/// \param maps  of the shapes, at least one
/// \param np  named parameters:
///   - `landmark_rows`  a range of ranges: for each landmark its vertex of each shape, as a position in the arrays of the
///     maps; default none
///   - `template_shape`  `std::size_t`, default 0
///   - `mean_iterations`  `int`, not negative: how often the mean is made; default 2; of no effect with two shapes
///   - `effort`, `visitor`  as for `register_maps()`
/// \pre each row of landmarks has as many entries as there are shapes
/// \throw Numeric_error  as `register_maps()`
template <class ConcurrencyTag = Sequential_tag, class Atlas,
          class NamedParameters = parameters::Default_named_parameters>
Shape_set<Atlas> register_shapes(const std::vector<std::shared_ptr<const Manifold_map<Atlas>>>& maps,
                                 const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters,
                                         "landmark_rows, template_shape, mean_iterations, effort, visitor");
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  CGAL_precondition(!maps.empty());
  const std::size_t t = internal::parameter(np, internal_np::template_shape, std::size_t(0));
  CGAL_precondition(t < maps.size());
  const int iterations = internal::parameter(np, internal_np::mean_iterations, 2);
  const Effort effort = internal::parameter(np, internal_np::effort, Effort::DEFAULT);
  Default_visitor default_visitor;
  auto& visitor = internal::parameter(np, CGAL::internal_np::visitor, default_visitor);

  std::vector<std::vector<std::size_t>> landmarks(maps.size()); // per shape
  if constexpr (internal::has_parameter<internal_np::landmark_rows_t, NamedParameters>)
    for (const auto& row : internal::parameter(np, internal_np::landmark_rows)) {
      std::size_t i = 0;
      for (const auto v : row) {
        CGAL_precondition(i < maps.size());
        landmarks[i++].push_back(static_cast<std::size_t>(v));
      }
      CGAL_precondition(i == maps.size());
    }

  std::vector<std::shared_ptr<const Manifold_map<Atlas>>> registered = maps;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (i == t) continue;
    std::vector<Landmark_pair<>> pairs;
    for (std::size_t k = 0; k < landmarks[t].size(); ++k) pairs.push_back({landmarks[i][k], landmarks[t][k]});
    const Correspondence<Atlas> c = register_maps<ConcurrencyTag>(*maps[i], *maps[t],
                                                                  parameters::landmark_pairs(pairs)
                                                                    .effort(effort)
                                                                    .fix_target(maps.size() > 2)
                                                                    .visitor(std::ref(visitor)));
    registered[i] = c.shared_source();
    registered[t] = c.shared_target();
  }
  if (maps.size() > 2)
    for (int iteration = 0; iteration < iterations; ++iteration) {
      Common_mesh mesh = common_mesh(Shape_set<Atlas>(registered), t);
      mesh.faces = maps[t]->faces(); // with virtual ones
      align_shapes(mesh);
      const std::vector<double> equal(maps.size(), 1 / static_cast<double>(maps.size()));
      const Manifold_map<Atlas> mean(morph(mesh, equal), maps[t]->faces(), registered[t]->domain_points(),
                                     maps[t]->number_of_vertices());
      for (std::size_t i = 0; i < maps.size(); ++i) {
        internal::Registration_request request;
        for (const std::size_t v : landmarks[i]) request.landmarks.emplace_back(static_cast<int>(v), 0);
        request.is_parallel = internal::is_parallel<ConcurrencyTag>();
        request.visitor = internal::Visitor_reference(visitor);
        request.effort = effort;
        registered[i] = internal::polished<Atlas>(registered[i], mean, request);
      }
    }
  return Shape_set<Atlas>(std::move(registered));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_SHAPES_H
