#include "catch.h"

#include <CGAL/Simple_manifolds/paper/fit/bad_regions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace test_bad_regions {

namespace SM = CGAL::Simple_manifolds;
using SM::Bin_rectangle;

namespace {

// Row i of the drawing is row i of the bins; '#' has error 2, '+' has error 1.
SM::Error_bins drawn(const std::vector<std::string>& rows)
{
  SM::Error_bins bins(int(rows.size()));
  for (int i = 0; i < bins.bins_per_side(); ++i)
    for (int j = 0; j < bins.bins_per_side(); ++j)
      bins.add(bins.centre(i, j), rows[i][j] == '#' ? 2 : rows[i][j] == '+' ? 1 : 0);
  return bins;
}

} // namespace

TEST_CASE("A bin keeps the largest error of the points in it")
{
  SM::Error_bins bins(4);
  bins.add({0.3, 0.9}, 1);
  bins.add({0.49, 0.76}, 3);
  bins.add({0.26, 0.99}, 2);
  bins.add({1, 0}, 5);
  bins.add({-1e-9, 1 + 1e-9}, 4);
  CHECK(bins.error(1, 3) == 3);
  CHECK(bins.error(3, 0) == 5);
  CHECK(bins.error(0, 3) == 4);
  CHECK(bins.error(0, 0) == 0);
  CHECK(bins.largest_error() == 5);
  CHECK(bins.centre(1, 3) == Eigen::Vector2d(0.375, 0.875));
}

TEST_CASE("Regions of bad bins are connected by sides, the largest first")
{
  const SM::Error_bins bins = drawn({"##....", "..+++.", "..+.#.", "..+++.", "#.....", "#....+"});
  const auto regions = SM::bad_regions(bins, 0.5);
  REQUIRE(regions.size() == 4);
  CHECK(regions[0].bins == 8);
  CHECK(regions[0].rectangle == Bin_rectangle{1, 2, 4, 5});
  CHECK(regions[1].bins == 2);
  CHECK(regions[1].rectangle == Bin_rectangle{0, 0, 1, 2});
  CHECK(regions[2].rectangle == Bin_rectangle{4, 0, 6, 1});
  CHECK(regions[3].rectangle == Bin_rectangle{5, 5, 6, 6});

  const auto worse = SM::bad_regions(bins, 1); // larger than the level, not equal
  REQUIRE(worse.size() == 3);
  CHECK(worse[2].rectangle == Bin_rectangle{2, 4, 3, 5});
  CHECK(SM::bad_regions(bins, 2).empty());
}

// The other way: each bad bin takes the least label of its neighbours until nothing changes.
TEST_CASE("Regions of random bins are those that labels find")
{
  std::mt19937 engine(5);
  for (int round = 0; round < 300; ++round) {
    const int n = 1 + int(engine() % 12);
    const unsigned percent = 20 + engine() % 60;
    SM::Error_bins bins(n);
    std::vector<int> label(n * n, -1);
    for (int k = 0; k < n * n; ++k)
      if (engine() % 100 < percent) {
        bins.add(bins.centre(k / n, k % n), 1);
        label[k] = k;
      }
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (int a = 0; a < n * n; ++a)
        for (int b = 0; b < n * n; ++b)
          if (std::abs(a / n - b / n) + std::abs(a % n - b % n) == 1 && label[b] >= 0 &&
              label[b] < label[a]) {
            label[a] = label[b];
            has_changed = true;
          }
    }
    std::map<int, SM::Bad_region> expected;
    for (int k = 0; k < n * n; ++k)
      if (label[k] >= 0) {
        SM::Bad_region& r = expected.try_emplace(label[k], SM::Bad_region{0, {n, n, 0, 0}}).first->second;
        ++r.bins;
        r.rectangle.i0 = (std::min)(r.rectangle.i0, k / n);
        r.rectangle.i1 = (std::max)(r.rectangle.i1, k / n + 1);
        r.rectangle.j0 = (std::min)(r.rectangle.j0, k % n);
        r.rectangle.j1 = (std::max)(r.rectangle.j1, k % n + 1);
      }
    std::vector<SM::Bad_region> sorted; // by size, then by the lowest bin, which is the label
    for (const auto& [first, region] : expected) sorted.push_back(region);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.bins > b.bins; });
    const auto regions = SM::bad_regions(bins, 0.5);
    REQUIRE(regions.size() == sorted.size());
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      REQUIRE(regions[k].bins == sorted[k].bins);
      REQUIRE(regions[k].rectangle == sorted[k].rectangle);
    }
  }
}

TEST_CASE("A rectangle grows to the least size, no further, inside of the square")
{
  const int n = 7;
  int off_centre = 0;
  for (int least = 1; least <= n; ++least)
    for (int i0 = 0; i0 < n; ++i0)
      for (int i1 = i0 + 1; i1 <= n; ++i1) {
        const Bin_rectangle r = SM::enlarged({i0, 2, i1, 3}, least, n);
        REQUIRE((0 <= r.i0 && r.i0 <= i0 && i1 <= r.i1 && r.i1 <= n));
        REQUIRE(r.i1 - r.i0 == (std::max)(least, i1 - i0));
        REQUIRE(r.j1 - r.j0 == (std::max)(least, 1));
        REQUIRE((r.j0 <= 2 && r.j1 >= 3 && r.j0 >= 0 && r.j1 <= n));
        if (r.i0 > 0 && r.i1 < n) // even, unless the border is in the way
          off_centre += std::abs((i0 - r.i0) - (r.i1 - i1)) > 1;
      }
  CHECK(off_centre == 0);
}

} // namespace test_bad_regions
