// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_CONTROL_CELLS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_CONTROL_CELLS_H

#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The control nets of charts as quadrilaterals: one per cell of the splines, whose corners are the four
// controls that are nearest to the cell, in cyclic order.
//
//   f(box of the cell, (i,j) -> control (i,j) of the cell, 0 <= i,j <= degree, degree)

using Chart_box = Eigen::AlignedBox2d;

// Of hierarchical splines: one per leaf, with the controls of the sum in the grid of the leaf.
template <class Function>
void for_each_control_cell(const Hierarchical_embedding& e, const Function& f)
{
  struct Visitor {
    const Hierarchical_embedding& e;
    const Function& f;

    void visit(int cells, int i, int j) const
    {
      const Eigen::Vector2d centre((i + 0.5) / cells, (j + 0.5) / cells);
      const Leaf_table::Leaf leaf = e.leaves().find(centre[0], centre[1]);
      if (leaf.cells > cells) {
        for (int c = 0; c < 4; ++c) visit(2 * cells, 2 * i + c / 2, 2 * j + c % 2);
        return;
      }
      const int row = e.degree() + 1;
      const Eigen::Vector2d first(i, j);
      f(
        Chart_box(first / cells, (first + Eigen::Vector2d(1, 1)) / cells),
        [&](int k, int l) { return leaf.controls[k * row + l].vector(); }, e.degree());
    }
  };
  const int base = e.levels().front().cells;
  for (int i = 0; i < base; ++i)
    for (int j = 0; j < base; ++j) Visitor{e, f}.visit(base, i, j);
}

// Of a stack of patches: of the base patch, since the others only add to it.
template <class Function>
void for_each_control_cell(const Patch_stack_embedding& e, const Function& f)
{
  const Spline_patch& patch = e.patches().front();
  const Spline_patch::Support& s = patch.support();
  const int nu = patch.nu() - patch.degree(), nv = patch.nv() - patch.degree();
  const double du = (s[2] - s[0]) / nu, dv = (s[3] - s[1]) / nv;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      f(
        Chart_box(Eigen::Vector2d(s[0] + i * du, s[1] + j * dv),
                  Eigen::Vector2d(s[0] + (i + 1) * du, s[1] + (j + 1) * dv)),
        [&](int k, int l) { return patch.coefficient(i + k, j + l); }, patch.degree());
}

// Of anything else: none.
template <class Embedding, class Function>
void for_each_control_cell(const Embedding&, const Function&)
{
}

// The corners of the control cells of all charts, four by four; of each chart those inside of its tile.
// Controls nearer to the border of a chart have little weight there: they may be anywhere. `charts` receives
// the chart of each cell.
template <class Surface>
std::vector<Eigen::Vector3d> control_cells(const Surface& surface, std::vector<int>& charts)
{
  std::vector<Eigen::Vector3d> corners;
  const auto& atlas = surface.atlas();
  for (int c = 0; c < atlas.number_of_charts(); ++c) {
    const auto is_in_tile = [&](const Eigen::Vector2d& uv) {
      if (Surface::Atlas::has_single_chart) return true;
      return is_in_open_unit_square(uv) && atlas.tile(atlas.point(Chart_point{c, uv})) == c;
    };
    const auto add = [&](const Chart_box& box, const auto& control, int degree) {
      for (int k = 0; k < 4; ++k)
        if (!is_in_tile(box.corner(Chart_box::CornerType(k)))) return;
      const int a = (degree - 1) / 2, b = a + 1;
      charts.push_back(c);
      corners.insert(corners.end(), {control(a, a), control(b, a), control(b, b), control(a, b)});
    };
    for_each_control_cell(surface.chart_embedding(c), add);
  }
  return corners;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_CONTROL_CELLS_H
