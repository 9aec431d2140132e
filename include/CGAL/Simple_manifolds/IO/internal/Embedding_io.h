// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H

#include <CGAL/Simple_manifolds/IO/internal/Document_writer.h>
#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

inline void write_patch(Document_writer& out, const Patch_record& patch)
{
  out.object(patch.has_indices ? 4 : 3);
  out.value("support");
  out.array(4);
  for (const double x : patch.support) out.value(x);
  out.value("controls");
  out.array(2);
  out.value(patch.nu);
  out.value(patch.nv);
  if (patch.has_indices) {
    out.value("indices");
    out.array(patch.indices.size());
    for (const int index : patch.indices) out.value(index);
  }
  out.value("coefficients");
  out.array(patch.coefficients.size());
  for (const Eigen::Vector3d& c : patch.coefficients) {
    CGAL_precondition(c.allFinite()); // JSON has no NaN
    out.array(3);
    for (const double x : c) out.value(x);
  }
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

inline Patch_record patch_of_json(const Json_field& j, int degree)
{
  constexpr int most_controls = (std::numeric_limits<int>::max)(); // active or not: they have indices
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

// A short file must not take much memory: of 2^24 controls, which are 512 MB, a chart has its share, and 256 more
// for each coefficient in the file. What is fitted does not come near to that: a hierarchy has at most five leaves
// per coefficient, of 36 controls each, and a full patch with its frame fewer than eight controls. Too large are
// hierarchies with very fine grids that are read as stacks of patches.
inline void require_memory(const Json_field& list, const std::string& what, std::uint64_t controls,
                           std::size_t coefficients, int number_of_charts)
{
  const std::uint64_t most = (1 << 24) / number_of_charts + 256 * std::uint64_t(coefficients);
  if (controls > most)
    list.fail(what + " take " + std::to_string(controls) + " controls in memory, and " +
              std::to_string(coefficients) + " coefficients allow for " + std::to_string(most));
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

  static Patch_stack_embedding read(const Json_field& list, int degree, int number_of_charts)
  {
    std::vector<Patch_record> records;
    std::uint64_t controls = 0; // of the grids with the frames that Spline_patch puts round them
    std::size_t coefficients = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      records.push_back(patch_of_json(list[i], degree));
      const Patch_record& p = records.back();
      controls += std::uint64_t(p.nu + 2 * degree) * std::uint64_t(p.nv + 2 * degree);
      coefficients += p.coefficients.size();
    }
    require_memory(list, std::to_string(records.size()) + " patches", controls, coefficients,
                   number_of_charts);

    std::vector<Spline_patch> patches;
    for (Patch_record& p : records) {
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

  static int degree(const Hierarchical_embedding& e) { return e.degree(); }

  static std::vector<Patch_record> patches(const Hierarchical_embedding& e)
  {
    std::vector<Patch_record> list;
    for (const Hierarchical_embedding::Level& level : e.levels()) {
      const int n = level.cells + e.degree();
      const bool is_full = level.indices.size() == std::size_t(n) * n;
      list.push_back(
        {{0, 0, 1, 1}, n, n, !is_full, is_full ? std::vector<int>() : level.indices, level.coefficients});
    }
    return list;
  }

  // The patches may come in any order; those of one grid add up.
  static Hierarchical_embedding read(const Json_field& list, int degree, int number_of_charts)
  {
    std::vector<Patch_record> patches;
    int base = (std::numeric_limits<int>::max)(); // cells per side of the coarsest grid
    for (std::size_t i = 0; i < list.size(); ++i) {
      patches.push_back(patch_of_json(list[i], degree));
      const Patch_record& p = patches.back();
      if (p.support != Spline_patch::Support{0, 0, 1, 1} || p.nu != p.nv)
        list[i].fail(std::string("it is no grid of equal cells of the unit square; ") + advice);
      base = (std::min)(base, p.nu - degree);
    }

    std::vector<std::map<int, Eigen::Vector3d>> active(1); // per level
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const Patch_record& p = patches[i];
      const int cells = p.nu - degree;
      std::size_t level = 0;
      while (base << level < cells) ++level;
      if (base << level != cells || level >= std::size_t(Hierarchical_embedding::maximum_levels))
        list[i]["controls"].fail(std::to_string(cells) + " cells per side are not the " +
                                 std::to_string(base) + " of the coarsest patch times a power of 2; " +
                                 advice);
      active.resize((std::max)(active.size(), level + 1));
      for (std::size_t k = 0; k < p.coefficients.size(); ++k) {
        const int index = p.has_indices ? p.indices[k] : int(k);
        const auto [at, is_new] = active[level].emplace(index, p.coefficients[k]);
        if (!is_new) at->second += p.coefficients[k];
      }
    }
    std::vector<Hierarchical_embedding::Level> levels;
    std::size_t coefficients = 0;
    for (std::size_t k = 0; k < active.size(); ++k) {
      coefficients += active[k].size();
      levels.push_back({base << k, {}, {}});
      for (const auto& [index, coefficient] : active[k]) {
        levels.back().indices.push_back(index);
        levels.back().coefficients.push_back(coefficient);
      }
    }
    const std::uint64_t leaves = number_of_leaves(degree, levels);
    require_memory(list,
                   "the coarsest grid has " + std::to_string(base) +
                     " cells per side: " + std::to_string(leaves) + " leaves",
                   leaves * std::uint64_t((degree + 1) * (degree + 1)), coefficients, number_of_charts);
    return Hierarchical_embedding(degree, std::move(levels));
  }

  // As many as the embedding will have. A cell has four in the place of one, or more, if functions of a finer
  // grid reach into it.
  static std::uint64_t number_of_leaves(int degree, const std::vector<Hierarchical_embedding::Level>& levels)
  {
    std::uint64_t leaves = std::uint64_t(levels[0].cells) * std::uint64_t(levels[0].cells);
    std::vector<int> divided; // cells of level k
    for (std::size_t k = levels.size() - 1; k > 0; --k) {
      const int n = levels[k].cells, side = n + degree;
      std::vector<int> parents;
      for (const int cell : divided) parents.push_back(cell / n / 2 * (n / 2) + cell % n / 2);
      for (const int index : levels[k].indices) { // the function reaches from cell i-d, j-d to cell i,j
        const int i = index / side, j = index % side;
        for (int p = (std::max)(i - degree, 0) / 2; p <= (std::min)(i, n - 1) / 2; ++p)
          for (int q = (std::max)(j - degree, 0) / 2; q <= (std::min)(j, n - 1) / 2; ++q)
            parents.push_back(p * (n / 2) + q);
      }
      std::sort(parents.begin(), parents.end());
      parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
      leaves += 3 * parents.size();
      divided = std::move(parents);
    }
    return leaves;
  }
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_EMBEDDING_IO_H
