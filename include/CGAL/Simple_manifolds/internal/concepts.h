// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_CONCEPTS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_CONCEPTS_H

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

// What the models of the concepts must have, said where they enter: one sentence for each member that is missing.
//
// These are macros, and headers that use them include this one first, so that the sentence is among the first five
// lines that a compiler writes: functions and further headers on the way would each add a line above it.

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Whether a function template such as [](auto& x) -> decltype(void(x.f())) {} can be called.
template <class... Arguments, class Function>
constexpr bool is_valid(Function)
{
  return std::is_invocable_v<Function, Arguments...>;
}

// For expressions: what is a T or becomes one by itself.
template <class T>
void accept(T);

// What a range consists of.
struct Not_a_range {};
template <class Range, class = void>
struct Range_element {
  using type = Not_a_range;
};
template <class Range>
struct Range_element<Range, std::void_t<decltype(*std::begin(std::declval<Range&>()))>> {
  using type = decltype(*std::begin(std::declval<Range&>()));
};

template <class T>
using Plain = std::remove_cv_t<std::remove_reference_t<T>>;
template <class T>
using Domain_point_of = typename Plain<T>::Domain_point;

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

// `expression` is one of an `x` of the type.
#define CGAL_SIMPLE_MANIFOLDS_REQUIRE(concept_name, Type, x, expression, member)                             \
  static_assert(                                                                                             \
    CGAL::Simple_manifolds::internal::is_valid<Type>([](auto&& x) -> decltype(void(expression)) {}),         \
    "this is no model of " concept_name ": " member " is missing")

#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE(concept_name, Type, name)                                         \
  static_assert(CGAL::Simple_manifolds::internal::is_valid<Type*>(                                           \
                  [](auto* x) -> std::void_t<typename std::remove_pointer_t<decltype(x)>::name> {}),         \
                "this is no model of " concept_name ": the type " #name " is missing")

#define CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(x)                                                                \
  std::declval<const CGAL::Simple_manifolds::internal::Domain_point_of<decltype(x)>&>()

// Meshes: their functions are found in the namespace of the mesh.
#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(Mesh)                                                             \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("FaceListGraph", const Mesh&, g, faces(g).begin(),                           \
                                "faces(mesh), or the header with its graph traits,");                        \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("FaceListGraph", const Mesh&, g, vertices(g).begin(), "vertices(mesh)");     \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("FaceListGraph", const Mesh&, g, halfedge(*faces(g).begin(), g),             \
                                "halfedge(face, mesh)");                                                     \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("FaceListGraph", const Mesh&, g, next(halfedge(*faces(g).begin(), g), g),    \
                                "next(halfedge, mesh)");                                                     \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("FaceListGraph", const Mesh&, g, target(halfedge(*faces(g).begin(), g), g),  \
                                "target(halfedge, mesh)")

#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_ATLAS(Atlas)                                                           \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE("ManifoldAtlas", Atlas, Domain_point);                                  \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE("ManifoldAtlas", Atlas, Chart);                                         \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a, a.chart(0), "chart(c)");                   \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a,                                            \
                                bool(a.contains(0, CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(a))),                  \
                                "contains(c, p)");                                                           \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a,                                            \
                                a.coordinates(0, CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(a)),                     \
                                "coordinates(c, p)");                                                        \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a,                                            \
                                a.charts_at(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(a)), "charts_at(p)");         \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a,                                            \
                                int(a.best_chart(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(a))), "best_chart(p)");  \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a,                                            \
                                int(a.tile(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(a))), "tile(p)");              \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldAtlas", const Atlas&, a, a.tile_point(0, 0.5, 0.5),                 \
                                "tile_point(tile, s, t)")

#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_BUMP(Bump)                                                             \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("BumpFunction", const Bump&, b, double(b(0.5)),                              \
                                "double operator()(double)");                                                \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("BumpFunction", const Bump&, b, double(b.jet(0.5)[2]), "jet(x)");            \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("BumpFunction", const Bump&, b, int(b.smoothness), "smoothness")

#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_EMBEDDING(Embedding)                                                   \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ChartEmbedding", const Embedding&, e, int(e.smoothness()), "smoothness()"); \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ChartEmbedding", const Embedding&, e, e.point(Eigen::Vector2d()),           \
                                "point(uv)");                                                                \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ChartEmbedding", const Embedding&, e, e.template jet<1>(Eigen::Vector2d()), \
                                "jet<Order>(uv)")

#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_MAP(Map)                                                               \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE("ManifoldMap", Map, Atlas);                                             \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE("ManifoldMap", Map, Domain_point);                                      \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_TYPE("ManifoldMap", Map, Location);                                          \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, m.atlas(), "atlas()");                         \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, std::size_t(m.number_of_vertices()),           \
                                "number_of_vertices()");                                                     \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, std::size_t(m.number_of_faces()),              \
                                "number_of_faces()");                                                        \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, m.point(std::size_t()), "point(v)");           \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, m.domain_point(std::size_t()),                 \
                                "domain_point(v)");                                                          \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, bool(m.is_virtual(std::size_t())),             \
                                "is_virtual(f)");                                                            \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, bool(m.is_virtual_vertex(std::size_t())),      \
                                "is_virtual_vertex(v)");                                                     \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m, double(m.diagonal()), "diagonal()");           \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m,                                                \
                                m.to_mesh(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(m), -1),                        \
                                "to_mesh(p, face_hint)");                                                    \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m,                                                \
                                m.position(m.to_mesh(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(m), -1)),            \
                                "position(location)");                                                       \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("ManifoldMap", const Map&, m,                                                \
                                m.to_domain(m.to_mesh(CGAL_SIMPLE_MANIFOLDS_DOMAIN_POINT(m), -1)),           \
                                "to_domain(location)")

// `Visitor`: a reference.
#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(Visitor)                                                       \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("SimpleManifoldsVisitor (passed by std::ref)", Visitor, v,                   \
                                v.start_phase("name"), "start_phase(const char*)");                          \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("SimpleManifoldsVisitor (passed by std::ref)", Visitor, v, v.progress(0.5),  \
                                "progress(double)");                                                         \
  CGAL_SIMPLE_MANIFOLDS_REQUIRE("SimpleManifoldsVisitor (passed by std::ref)", Visitor, v, v.end_phase(),    \
                                "end_phase()")

// A lambda expression, or a class that measures many faces at once.
#define CGAL_SIMPLE_MANIFOLDS_REQUIRE_SIZING(Sizing, Atlas)                                                  \
  static_assert(CGAL::Simple_manifolds::internal::is_sizing<Sizing, Atlas>,                                  \
                "this is no model of TessellationSizing: double operator()(triangulation, face) is missing")

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_CONCEPTS_H
