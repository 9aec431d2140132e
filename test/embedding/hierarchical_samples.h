// Hierarchical splines with random coefficients, and the same functions as sums of patches.

#ifndef SIMPLE_MANIFOLDS_TEST_HIERARCHICAL_SAMPLES_H
#define SIMPLE_MANIFOLDS_TEST_HIERARCHICAL_SAMPLES_H

#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>

#include <cmath>
#include <random>
#include <vector>

/// All functions of a base grid; on each further level those whose middle is within 3 cells of `centre`
/// and, beside them, a few anywhere. Deeper levels have smaller coefficients, as details have.
inline CGAL::Simple_manifolds::Hierarchical_embedding
random_hierarchy(int degree, int base, int levels, const Eigen::Vector2d& centre, unsigned seed = 1)
{
  std::mt19937 random(seed);
  const auto number = [&] { return double(random()) / 2147483648. - 1; };
  std::vector<CGAL::Simple_manifolds::Hierarchical_embedding::Level> list;
  for (int k = 0, cells = base; k < levels; ++k, cells *= 2) {
    const int n = cells + degree;
    list.push_back({cells, {}, {}});
    const auto middle = [&](int i) { return i - (degree - 1) / 2.; }; // in cells
    const auto add = [&](int i, int j) {
      list.back().indices.push_back(i * n + j);
      list.back().coefficients.push_back(std::pow(.5, k) * Eigen::Vector3d(number(), number(), number()));
    };
    const auto is_near = [&](int i, double x) { return std::abs(middle(i) - x * cells) < 3; };
    const int stray = k == 0 ? -1 : int(random() % unsigned(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (k == 0 || (is_near(i, centre.x()) && is_near(j, centre.y())) ||
            (k < 4 && i == stray && j % 5 == 0))
          add(i, j);
  }
  return CGAL::Simple_manifolds::Hierarchical_embedding(degree, list);
}

/// The definition: one patch per level.
inline CGAL::Simple_manifolds::Patch_stack_embedding
patch_stack(const CGAL::Simple_manifolds::Hierarchical_embedding& e)
{
  std::vector<CGAL::Simple_manifolds::Spline_patch> patches;
  for (const auto& level : e.levels()) {
    if (level.indices.empty()) continue; // which would mean all functions
    const int n = level.cells + e.degree();
    patches.emplace_back(CGAL::Simple_manifolds::Spline_patch::Support{0, 0, 1, 1}, e.degree(), n, n,
                         level.coefficients, level.indices);
  }
  return CGAL::Simple_manifolds::Patch_stack_embedding(patches);
}

#endif // SIMPLE_MANIFOLDS_TEST_HIERARCHICAL_SAMPLES_H
