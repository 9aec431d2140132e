// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/IO/internal/Text_scanner.h>
#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>

#include <CGAL/assertions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// What a surface file says before its charts: which type of surface it holds.
struct Surface_header {
  std::string atlas;    ///< `sphere`, `torus` or `plane`
  std::string bump;     ///< `smoothstep`, `bspline` or `polynomial`
  int smoothness = 0;   ///< of the bump
  int degree = 0;       ///< of the splines
};

namespace internal {

constexpr const char* surface_format = "simple_manifolds_surface";
constexpr int surface_version = 1;
constexpr int most_controls = 1 << 22; // of a patch: more would be an attack on the memory

inline nlohmann::ordered_json json_of_patch(const Spline_patch& patch)
{
  nlohmann::ordered_json j;
  j["support"] = patch.support();
  j["controls"] = {patch.nu(), patch.nv()};
  if (!patch.indices().empty()) j["indices"] = patch.indices();
  auto& list = j["coefficients"] = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& c : patch.coefficients()) {
    CGAL_precondition(c.allFinite()); // JSON has no NaN
    list.push_back({c.x(), c.y(), c.z()});
  }
  return j;
}

inline std::vector<int> indices_of_json(const Json_field& j, int controls)
{
  std::vector<int> indices(j.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = j[i].integer(0, controls - 1);
  std::vector<int> sorted = indices;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) j.fail("an index comes twice");
  return indices;
}

inline Spline_patch patch_of_json(const Json_field& j, int degree)
{
  const Json_field support = j["support"], controls = j["controls"], coefficients = j["coefficients"];
  support.require_size(4);
  controls.require_size(2);
  Spline_patch::Support rectangle;
  for (std::size_t k = 0; k < 4; ++k) rectangle[k] = support[k].number();
  for (int k = 0; k < 2; ++k)
    if (!(rectangle[k + 2] - rectangle[k] > 1e-12)) support.fail("the rectangle [u0,v0,u1,v1] is empty");
  const int nu = controls[std::size_t(0)].integer(degree + 1, most_controls);
  const int nv = controls[1].integer(degree + 1, most_controls / nu);

  std::vector<int> indices;
  std::size_t active = std::size_t(nu) * nv;
  if (j.has("indices")) {
    indices = indices_of_json(j["indices"], nu * nv);
    active = indices.size();
  }
  coefficients.require_size(active);
  std::vector<Eigen::Vector3d> values(active);
  for (std::size_t i = 0; i < active; ++i) {
    const Json_field c = coefficients[i];
    c.require_size(3);
    for (std::size_t k = 0; k < 3; ++k) values[i][k] = c[k].number();
  }
  if (active == 0) { // an empty list of indices means "none", which the patch says with zeros
    indices = {0};
    values = {Eigen::Vector3d::Zero()};
  }
  return Spline_patch(rectangle, degree, nu, nv, values, std::move(indices));
}

inline Surface_header header_of_json(const Json_field& j)
{
  if (!j.has("format") || j["format"].text() != surface_format)
    j.fail(std::string("no surface: the key \"format\" does not say \"") + surface_format + '"');
  if (j["version"].integer(0, 1 << 30) != surface_version)
    j["version"].fail("only version " + std::to_string(surface_version) + " can be read");
  return {j["atlas"].text(), j["bump"]["type"].text(), j["bump"]["smoothness"].integer(0, 99),
          j["degree"].integer(1, maximum_spline_degree)};
}

template <class Surface>
Surface surface_of_json(const Json_field& j)
{
  using Atlas = typename Surface::Atlas;
  using Bump = typename Surface::Bump;
  const Surface_header header = header_of_json(j);
  if (header.atlas != Atlas::name)
    j["atlas"].fail('"' + header.atlas + "\" where \"" + Atlas::name + "\" is expected");
  if (header.bump != Bump::type || header.smoothness != Bump::smoothness)
    j["bump"].fail(header.bump + " of smoothness " + std::to_string(header.smoothness) + " where "
                   + Bump::type + " of smoothness " + std::to_string(Bump::smoothness) + " is expected");
  const Json_field charts = j["charts"];
  charts.require_size(Atlas::number_of_charts);
  std::vector<Patch_stack_embedding> embeddings;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const Json_field list = charts[c]["patches"];
    std::vector<Spline_patch> patches;
    for (std::size_t i = 0; i < list.size(); ++i) patches.push_back(patch_of_json(list[i], header.degree));
    if (patches.empty()) list.fail("at least one patch is expected");
    embeddings.emplace_back(std::move(patches));
  }
  return Surface(std::move(embeddings));
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a surface as JSON, version 1: the atlas, the bump, the degree, and per chart its patches with
/// their coefficients. Numbers have as many digits as they need to be read back bit for bit.
///
/// \pre the patches have one degree, and finite coefficients
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Atlas, class Bump>
void write_surface(const std::string& file,
                   const Manifold_surface<Atlas, Patch_stack_embedding, Bump>& surface)
{
  nlohmann::ordered_json j;
  j["format"] = internal::surface_format;
  j["version"] = internal::surface_version;
  j["atlas"] = Atlas::name;
  j["bump"] = {{"type", Bump::type}, {"smoothness", int(Bump::smoothness)}};
  const int degree = surface.chart_embedding(0).patches().front().degree();
  j["degree"] = degree;
  j["charts"] = nlohmann::ordered_json::array();
  for (int c = 0; c < Atlas::number_of_charts; ++c) {
    auto patches = nlohmann::ordered_json::array();
    for (const Spline_patch& patch : surface.chart_embedding(c).patches()) {
      CGAL_precondition(patch.degree() == degree);
      patches.push_back(internal::json_of_patch(patch));
    }
    j["charts"].push_back({{"patches", std::move(patches)}});
  }
  Atomic_file output(file);
  output.stream() << j << '\n';
  output.commit();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Says what a surface file holds, so that the type to read it with can be chosen.
/// \throw IO_error when the file is missing or no surface
inline Surface_header read_surface_header(const std::string& file)
{
  const nlohmann::json j = internal::parse_json(file, internal::file_contents(file));
  return internal::header_of_json(internal::Json_field(file, j));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a surface of a known type.
/// \tparam Surface  a `Manifold_surface` with `Patch_stack_embedding`
/// \throw IO_error when the file is missing, no surface, damaged, or of another atlas or bump
template <class Surface>
Surface read_surface(const std::string& file)
{
  const nlohmann::json j = internal::parse_json(file, internal::file_contents(file));
  return internal::surface_of_json<Surface>(internal::Json_field(file, j));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a surface over whichever canonical surface the file names.
/// \tparam Bump  the bump of the file
/// \throw IO_error as `read_surface()`
template <class Bump = Smoothstep_bump<2>>
auto read_any_surface(const std::string& file)
{
  using Plane = Manifold_surface<Plane_atlas, Patch_stack_embedding, Bump>;
  using Sphere = Manifold_surface<Sphere_atlas, Patch_stack_embedding, Bump>;
  using Torus = Manifold_surface<Torus_atlas, Patch_stack_embedding, Bump>;
  using Any = std::variant<Plane, Sphere, Torus>;
  const nlohmann::json j = internal::parse_json(file, internal::file_contents(file));
  const internal::Json_field root(file, j);
  const std::string atlas = internal::header_of_json(root).atlas;
  if (atlas == Plane_atlas::name) return Any(internal::surface_of_json<Plane>(root));
  if (atlas == Sphere_atlas::name) return Any(internal::surface_of_json<Sphere>(root));
  if (atlas == Torus_atlas::name) return Any(internal::surface_of_json<Torus>(root));
  root["atlas"].fail("\"" + atlas + "\" is none of sphere, torus, plane");
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H
