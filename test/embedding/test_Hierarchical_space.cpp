#include "catch.h"

#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Fit_samples.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_equations.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace test_Hierarchical_space {

namespace internal = CGAL::Simple_manifolds::internal;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

double uniform(std::mt19937& engine) { return engine() / 4294967296.; }

internal::Cell_tree refine_randomly(internal::Cell_tree tree, int times, int deepest, std::mt19937& engine)
{
  for (int k = 0; k < times; ++k) {
    // a corner of the square draws the cells, so that levels differ
    const Vector2d uv(std::pow(uniform(engine), 3), std::pow(uniform(engine), 3));
    const internal::Cell c = tree.cell(tree.leaf(uv));
    if (c.level < deepest) tree.refine(c);
  }
  return tree;
}

template <int D>
Vector3d value(const internal::Chart_spline& spline, const Vector2d& uv)
{
  return spline.point<D>(spline.tree().leaf(uv), uv);
}

// Of all functions: those of the leaf that contains uv and of its ancestors.
Eigen::RowVectorXd values_at(const internal::Chart_spline& spline, int leaf, const Vector2d& uv)
{
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(spline.size());
  for (int node = leaf; node >= 0; node = spline.basis().parent(node)) {
    const auto f = internal::local_values<3>(spline.tree(), node, uv);
    for (int k = 0; k < 16; ++k)
      if (const int i = spline.basis().function(node, k); i >= 0) values[i] = f[k];
  }
  return values;
}

template <int D>
void check_refinement()
{
  std::mt19937 engine(D);
  internal::Chart_spline spline(D, Vector3d(1, 2, 3));
  std::vector<Vector2d> points = {{0, 0}, {1, 1}, {0, 1}, {.25, .5}};
  for (int k = 0; k < 300; ++k) points.push_back({std::pow(uniform(engine), 2), uniform(engine)});
  for (const Vector2d& uv : points)
    CHECK((value<D>(spline, uv) - Vector3d(1, 2, 3)).norm() < 1e-14); // B-splines sum to one
  for (int round = 0; round < 4; ++round) {
    spline.add([&](int) { return Vector3d(uniform(engine), uniform(engine), uniform(engine)); });
    std::vector<Vector3d> before;
    for (const Vector2d& uv : points) before.push_back(value<D>(spline, uv));
    const int size = spline.size();
    spline.refine(refine_randomly(spline.tree(), 12, 7, engine));
    CHECK(spline.size() > size);
    for (std::size_t k = 0; k < points.size(); ++k)
      CHECK((value<D>(spline, points[k]) - before[k]).norm() < 1e-13);
  }
}

} // namespace

TEST_CASE("A tree of cells is graded and finds its leaves")
{
  std::mt19937 engine(1);
  const internal::Cell_tree tree = refine_randomly(internal::Cell_tree(4), 60, 9, engine);
  CHECK(tree.depth() > 4);
  double area = 0;
  for (int node = 0; node < tree.size(); ++node) {
    const internal::Cell c = tree.cell(node);
    CHECK(tree.find(c) == node);
    if (tree.is_leaf(node)) {
      const double n = tree.side(c.level);
      area += 1 / (n * n);
      CHECK(tree.leaf(Vector2d((c.i + .5) / n, (c.j + .5) / n)) == node);
      CHECK(tree.leaf(Vector2d(c.i / n, c.j / n)) == node); // cells are half-open
      continue;
    }
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj)
        if (tree.contains({c.level, c.i + di, c.j + dj}))
          CHECK(tree.find({c.level, c.i + di, c.j + dj}) >= 0);
  }
  CHECK(area == 1);
  CHECK(tree.is_leaf(tree.leaf(Vector2d(1, 1))));
}

TEST_CASE("Four cells round a vertex hold one new function of degree 3")
{
  internal::Cell_tree tree(4);
  CHECK(internal::Hierarchical_space(3, tree).size() == 49);
  for (int i = 1; i <= 2; ++i)
    for (int j = 1; j <= 2; ++j) tree.refine({0, i, j});
  const internal::Hierarchical_space space(3, tree);
  CHECK(space.size() == 50);
  CHECK(space.number_of_levels() == 2);
  CHECK(space.find(tree, 1, 5, 5) == 49); // over the cells 2..5 of the finer level
  CHECK(space.find(tree, 1, 4, 5) == -1);
}

TEST_CASE("Whole levels make way for the next")
{
  for (int d = 2; d <= 5; ++d) {
    internal::Cell_tree tree(4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) tree.refine({0, i, j});
    const internal::Hierarchical_space space(d, tree);
    CHECK(space.size() == (8 + d) * (8 + d));
    CHECK(space.begin(1) == 0); // none of the coarse functions is left
  }
}

TEST_CASE("A spline is the same function in a finer space")
{
  check_refinement<2>();
  check_refinement<3>();
  check_refinement<4>();
  check_refinement<5>();
}

TEST_CASE("Functions that are active are linearly independent")
{
  std::mt19937 engine(5);
  internal::Chart_spline spline(3, Vector3d::Zero());
  spline.refine(refine_randomly(spline.tree(), 15, 4, engine));
  const int n = spline.size();
  Eigen::MatrixXd values(8 * n, n);
  for (int k = 0; k < values.rows(); ++k) {
    const int leaf = [&] {
      for (;;)
        if (const int node = int(engine() % std::size_t(spline.tree().size())); spline.tree().is_leaf(node))
          return node;
    }();
    const internal::Cell c = spline.tree().cell(leaf);
    const double side = spline.tree().side(c.level);
    const Vector2d uv((c.i + uniform(engine)) / side, (c.j + uniform(engine)) / side);
    values.row(k) = values_at(spline, leaf, uv);
    CHECK(values.row(k).minCoeff() > -1e-15); // each is a B-spline
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(values);
  qr.setThreshold(1e-9);
  CHECK(qr.rank() == n);
}

TEST_CASE("Coefficients of leaves are those of the functions, and sums come up by the transpose")
{
  std::mt19937 engine(8);
  internal::Chart_spline spline(3, Vector3d::Zero());
  for (int round = 0; round < 3; ++round) spline.refine(refine_randomly(spline.tree(), 15, 5, engine));
  const auto random = [&] { return Vector3d(uniform(engine), uniform(engine), uniform(engine)); };
  std::vector<Vector3d> x(spline.size());
  for (Vector3d& p : x) p = random();
  spline.add([&](int f) { return x[f]; });
  std::vector<Vector3d> local(16 * std::size_t(spline.tree().size()), Vector3d::Zero());
  double at_leaves = 0, of_functions = 0;
  for (int leaf = 0; leaf < spline.tree().size(); ++leaf) {
    if (!spline.tree().is_leaf(leaf)) continue;
    const internal::Cell c = spline.tree().cell(leaf);
    const Vector2d uv = Vector2d(c.i + uniform(engine), c.j + uniform(engine)) / spline.tree().side(c.level);
    Vector3d point(0, 0, 0);
    const Eigen::RowVectorXd values = values_at(spline, leaf, uv);
    for (int f = 0; f < spline.size(); ++f) point += values[f] * x[f];
    CHECK((spline.point<3>(leaf, uv) - point).norm() < 1e-13);
    for (std::size_t k = 0; k < 16; ++k) {
      local[16 * std::size_t(leaf) + k] = random();
      at_leaves += local[16 * std::size_t(leaf) + k].dot(spline.local(leaf)[k]);
    }
  }
  const std::vector<Vector3d> sums = spline.basis().sums(local);
  for (std::size_t f = 0; f < x.size(); ++f) of_functions += sums[f].dot(x[f]);
  CHECK(std::abs(at_leaves - of_functions) < 1e-11 * at_leaves);
}

TEST_CASE("The normal equations of two charts are those of one row per sample")
{
  std::mt19937 engine(9);
  std::vector<internal::Chart_spline> splines(2, internal::Chart_spline(3, Vector3d::Zero()));
  for (internal::Chart_spline& s : splines) s.refine(refine_randomly(s.tree(), 12, 4, engine));
  const int n = splines[0].size(), all = n + splines[1].size();
  internal::Fit_samples samples;
  std::vector<Vector3d> value, residual;
  std::vector<double> joint, own;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
  Eigen::MatrixX3d right_side = Eigen::MatrixX3d::Zero(all, 3);
  for (int k = 0; k < 4000; ++k) {
    Eigen::RowVectorXd blended = Eigen::RowVectorXd::Zero(all);
    residual.push_back({uniform(engine), uniform(engine), uniform(engine)});
    samples.target.push_back({uniform(engine), uniform(engine), uniform(engine)});
    joint.push_back(uniform(engine));
    for (int c = 0; c < 2; ++c) {
      if (k % 4 == 1 + c) continue; // seen by one chart
      const internal::Cell_tree& tree = splines[c].tree();
      const Vector2d uv(std::pow(uniform(engine), 2), uniform(engine));
      samples.views.push_back({c, tree.leaf(uv), uv, uniform(engine)});
      own.push_back(0.1 * uniform(engine));
      value.push_back({uniform(engine), 0, 0});
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(all);
      row.segment(c * n, splines[c].size()) = values_at(splines[c], tree.leaf(uv), uv);
      matrix += own.back() * row.transpose() * row;
      right_side += own.back() * row.transpose() * (samples.target.back() - value.back()).transpose();
      blended += samples.views.back().blend * row;
    }
    samples.begin.push_back(samples.views.size());
    matrix += joint.back() * blended.transpose() * blended;
    right_side += joint.back() * blended.transpose() * residual.back().transpose();
  }
  constexpr double ridge = 1e-6; // a function that few samples see
  matrix.diagonal() *= 1 + ridge;
  const Eigen::MatrixX3d wanted = matrix.ldlt().solve(right_side);
  for (const bool is_parallel : {false, true}) {
    internal::Normal_equations equations(splines, {0, 1}, is_parallel);
    equations.assemble(samples, joint, own, value, residual, 0);
    CHECK((equations.solve(ridge) - wanted).norm() < 1e-8 * wanted.norm());
  }
}

TEST_CASE("Normal equations reproduce a polynomial, and are set up anew each time")
{
  std::mt19937 engine(6);
  std::vector<internal::Chart_spline> splines = {internal::Chart_spline(3, Vector3d::Zero())};
  const auto polynomial = [](const Vector2d& p) {
    return Vector3d(p.x() * p.x() * p.y(), p.x() - p.y(), 1 + std::pow(p.y(), 3));
  };
  internal::Fit_samples samples;
  std::vector<Vector3d> value, residual;
  for (int k = 0; k < 500; ++k) {
    const Vector2d uv(uniform(engine), uniform(engine));
    samples.target.push_back(polynomial(uv));
    samples.views.push_back({0, splines[0].tree().leaf(uv), uv, 1});
    samples.begin.push_back(samples.views.size());
    value.push_back(Vector3d::Zero());
    residual.push_back(samples.target.back());
  }
  const std::vector<double> none(500, 0), all(500, 1);
  internal::Normal_equations equations(splines, {0}, false);
  equations.assemble(samples, all, none, value, residual, 0);
  const Eigen::MatrixX3d x = equations.solve(0);
  equations.assemble(samples, all, none, value, residual, 0);
  CHECK(equations.solve(0) == x);
  splines[0].add([&](int f) -> Vector3d { return x.row(f).transpose(); });
  for (const auto& view : samples.views)
    CHECK((splines[0].point<3>(view.cell, view.uv) - polynomial(view.uv)).norm() < 1e-10);
}

} // namespace test_Hierarchical_space
