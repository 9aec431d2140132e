// Every surface of the list gets a certified map, however hard it is. The big ones are hidden: run
// `test_stress [.full]`, which takes some minutes; SIMPLE_MANIFOLDS_STRESS_TABLE=1 prints the figures of each.

#include "../catch.h"

#include "irreducible_tori.h"
#include "stress_map.h"
#include "stress_surfaces.h"

#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>

namespace {

void check_all(const std::vector<stress::Case>& cases, bool are_big)
{
  for (const auto& c : cases) {
    if (c.is_big != are_big) continue;
    CAPTURE(c.name);
    const Triangle_mesh mesh = c.make();
    const std::clock_t start = std::clock();
    stress::Figures figures;
    CHECK_NOTHROW(figures = stress::map_and_check(mesh));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    CHECK(figures.faces >= mesh.triangles.size());
    CHECK(figures.smallest_area > 0);
    if (std::getenv("SIMPLE_MANIFOLDS_STRESS_TABLE"))
      std::cout << std::left << std::setw(45) << c.name << std::right << std::setw(8) << figures.faces
                << " faces " << std::setw(8) << std::setprecision(3) << seconds << " s, smallest area "
                << figures.smallest_area << ", round trip " << figures.round_trip << std::endl;
  }
}

} // namespace

TEST_CASE("hard spheres are mapped", "[stress]") { check_all(stress::sphere_cases(), false); }
TEST_CASE("hard tori are mapped", "[stress]") { check_all(stress::torus_cases(), false); }
TEST_CASE("hard disks are mapped", "[stress]") { check_all(stress::disk_cases(), false); }

TEST_CASE("irreducible tori are mapped", "[stress]")
{
  std::map<std::size_t, int> count; // by the number of vertices
  for (const auto& faces : stress::irreducible_tori(400)) {
    Triangle_mesh mesh;
    mesh.triangles = faces;
    ++count[faces.size() / 2];
    Random random(7);
    set_random_points(mesh, static_cast<int>(faces.size() / 2), 0, random);
    CHECK_NOTHROW(stress::map_and_check(mesh));
  }
  CHECK(count[7] == 1);
  CHECK(count[8] == 4);
  CHECK(count[9] >= 13);
  CHECK(count[9] <= 15);
  CHECK(count[10] <= 1);
  CHECK(count.size() <= 4);
}

TEST_CASE("all 21 irreducible tori are found", "[.full]")
{
  CHECK(stress::irreducible_tori(20000).size() == 21);
}

TEST_CASE("hard and big spheres are mapped", "[.full]") { check_all(stress::sphere_cases(), true); }
TEST_CASE("hard and big tori are mapped", "[.full]") { check_all(stress::torus_cases(), true); }
TEST_CASE("hard and big disks are mapped", "[.full]") { check_all(stress::disk_cases(), true); }
