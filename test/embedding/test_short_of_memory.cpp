// Memory ends in the middle of maps and fits: std::bad_alloc comes out, what the caller has handed in is as it was, and
// the next call works as if nothing had happened.

#include "catch.h"

#include "short_of_memory.h"
#include "watched_mesh.h"

#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

#include <new>
#include <optional>
#include <variant>

namespace test_short_of_memory {

namespace params = SM::parameters;

namespace {

/// Lets the n-th allocation fail and all after it, for each n below 50 and then for ever fewer, until there are enough.
/// \param run           () -> result
/// \param is_unchanged  () -> bool
template <class Run, class Is_unchanged>
void fail_at_many_allocations(const Run& run, const Is_unchanged& is_unchanged)
{
  using Result = decltype(run());
  REQUIRE(is_unchanged());
  const Result expected = run();
  std::optional<Result> result;
  int failures = 0, changed = 0;
  for (long n = 0; !result; n += 1 + n / 50) {
    try {
      allocations_left = n;
      result.emplace(run());
      allocations_left = -1;
    } catch (const std::bad_alloc&) {
      allocations_left = -1;
      ++failures;
      changed += !is_unchanged();
    }
  }
  CHECK(failures > 50);
  CHECK(changed == 0);
  CHECK(same(expected, *result));
}

} // namespace

TEST_CASE("where memory ends in a mapper, that is an exception, and the mesh stays as it is")
{
  for (const Triangle_mesh& t : {some_sphere(), some_torus(), some_disk()}) {
    const Watched_mesh<Eigen::Vector2d> watched(t);
    fail_at_many_allocations([&] { return SM::map_to_canonical_surface(watched.mesh); },
                             [&] { return watched.is_unchanged(); });
  }
}

TEST_CASE("where memory ends in a function of a map, that is an exception, and the map stays as it is")
{
  const auto sphere = SM::map_to_canonical_surface(mesh_of(some_sphere()));
  const auto& map = std::get<SM::Mesh_map<Mesh, SM::Sphere_atlas>>(sphere);
  const auto copy = map;
  const auto is_unchanged = [&] { return same(map, copy); };
  fail_at_many_allocations([&] { return SM::balance(map); }, is_unchanged);
  fail_at_many_allocations([&] { return SM::refine(map); }, is_unchanged);
  fail_at_many_allocations([&] { return SM::fit_surface(map, params::rms_error(0.05)); }, is_unchanged);
}

} // namespace test_short_of_memory
