// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H

#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>

#include <CGAL/assertions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// One patch of a file. No indices: all functions are active.
struct Patch_record {
  Spline_patch::Support support;
  int nu, nv;
  bool has_indices;
  std::vector<int> indices;
  std::vector<Eigen::Vector3d> coefficients;
};

inline nlohmann::ordered_json json_of_patch(const Patch_record& patch)
{
  nlohmann::ordered_json j;
  j["support"] = patch.support;
  j["controls"] = {patch.nu, patch.nv};
  if (patch.has_indices) j["indices"] = patch.indices;
  auto& list = j["coefficients"] = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& c : patch.coefficients) {
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

// \param most_controls  of the whole grid, active or not
inline Patch_record patch_of_json(const Json_field& j, int degree, int most_controls)
{
  const Json_field support = j["support"], controls = j["controls"], coefficients = j["coefficients"];
  support.require_size(4);
  controls.require_size(2);
  Patch_record patch;
  for (std::size_t k = 0; k < 4; ++k) patch.support[k] = support[k].number();
  for (int k = 0; k < 2; ++k)
    if (!(patch.support[k + 2] - patch.support[k] > 1e-12))
      support.fail("the rectangle [u0,v0,u1,v1] is empty");
  patch.nu = controls[std::size_t(0)].integer(degree + 1, most_controls / (degree + 1));
  patch.nv = controls[1].integer(degree + 1, most_controls / patch.nu);

  std::size_t active = std::size_t(patch.nu) * patch.nv;
  patch.has_indices = j.has("indices");
  if (patch.has_indices) {
    patch.indices = indices_of_json(j["indices"], patch.nu * patch.nv);
    active = patch.indices.size();
  }
  coefficients.require_size(active);
  patch.coefficients.resize(active);
  for (std::size_t i = 0; i < active; ++i) {
    const Json_field c = coefficients[i];
    c.require_size(3);
    for (std::size_t k = 0; k < 3; ++k) patch.coefficients[i][k] = c[k].number();
  }
  return patch;
}

// How the embedding of a chart is written as a list of patches, and read from one.
template <class ChartEmbedding>
struct Embedding_io;

template <>
struct Embedding_io<Patch_stack_embedding> {
  static int degree(const Patch_stack_embedding& e) { return e.patches().front().degree(); }

  static std::vector<Patch_record> patches(const Patch_stack_embedding& e)
  {
    std::vector<Patch_record> list;
    for (const Spline_patch& p : e.patches()) {
      CGAL_precondition(p.degree() == degree(e));
      list.push_back({p.support(), p.nu(), p.nv(), !p.indices().empty(), p.indices(), p.coefficients()});
    }
    return list;
  }

  static Patch_stack_embedding read(const Json_field& list, int degree)
  {
    constexpr int most_controls = 1 << 22; // more would be an attack on the memory
    std::vector<Spline_patch> patches;
    for (std::size_t i = 0; i < list.size(); ++i) {
      Patch_record p = patch_of_json(list[i], degree, most_controls);
      if (p.has_indices && p.indices.empty()) { // "none", which a patch says with zeros
        p.indices = {0};
        p.coefficients = {Eigen::Vector3d::Zero()};
      }
      patches.emplace_back(p.support, degree, p.nu, p.nv, p.coefficients, std::move(p.indices));
    }
    return Patch_stack_embedding(std::move(patches));
  }
};

template <>
struct Embedding_io<Hierarchical_embedding> {
  static constexpr const char* advice = "Patch_stack_embedding can hold this patch";
  static constexpr int most_base_cells = 1 << 10; // more would be an attack on the memory

  static int degree(const Hierarchical_embedding& e) { return e.degree(); }

  static std::vector<Patch_record> patches(const Hierarchical_embedding& e)
  {
    std::vector<Patch_record> list;
    for (const Hierarchical_embedding::Level& level : e.levels()) {
      const int n = level.cells + e.degree();
      const bool is_full = level.indices.size() == std::size_t(n) * n;
      list.push_back({{0, 0, 1, 1}, n, n, !is_full, is_full ? std::vector<int>() : level.indices,
                      level.coefficients});
    }
    return list;
  }

  // The patches may come in any order; those of one grid add up.
  static Hierarchical_embedding read(const Json_field& list, int degree)
  {
    std::vector<Patch_record> patches;
    int base = std::numeric_limits<int>::max(); // cells per side of the coarsest grid
    for (std::size_t i = 0; i < list.size(); ++i) {
      patches.push_back(patch_of_json(list[i], degree, std::numeric_limits<int>::max()));
      const Patch_record& p = patches.back();
      if (p.support != Spline_patch::Support{0, 0, 1, 1} || p.nu != p.nv)
        list[i].fail(std::string("it is no grid of equal cells of the unit square; ") + advice);
      base = std::min(base, p.nu - degree);
    }
    if (base > most_base_cells)
      list.fail("the coarsest grid has " + std::to_string(base) + " cells per side");

    std::vector<std::map<int, Eigen::Vector3d>> active(1); // per level
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const Patch_record& p = patches[i];
      const int cells = p.nu - degree;
      std::size_t level = 0;
      while (base << level < cells) ++level;
      if (base << level != cells || level >= std::size_t(Hierarchical_embedding::maximum_levels))
        list[i]["controls"].fail(std::to_string(cells) + " cells per side are not the " + std::to_string(base)
                                 + " of the coarsest patch times a power of 2; " + advice);
      active.resize(std::max(active.size(), level + 1));
      for (std::size_t k = 0; k < p.coefficients.size(); ++k) {
        const int index = p.has_indices ? p.indices[k] : int(k);
        const auto [at, is_new] = active[level].emplace(index, p.coefficients[k]);
        if (!is_new) at->second += p.coefficients[k];
      }
    }
    std::vector<Hierarchical_embedding::Level> levels;
    for (std::size_t k = 0; k < active.size(); ++k) {
      levels.push_back({base << k, {}, {}});
      for (const auto& [index, coefficient] : active[k]) {
        levels.back().indices.push_back(index);
        levels.back().coefficients.push_back(coefficient);
      }
    }
    return Hierarchical_embedding(degree, std::move(levels));
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H
