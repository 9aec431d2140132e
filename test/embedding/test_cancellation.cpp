// Mappers, functions of maps and fits are cancelled at every single step: the visitor's exception comes out, what the
// caller has handed in is as it was, and the next call works as if nothing had happened.

#include "catch.h"

#include "watched_mesh.h"

#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/paper/fit/fit_patch_surface.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <functional>
#include <variant>
#include <vector>

namespace test_cancellation {

namespace SM = CGAL::Simple_manifolds;
namespace params = SM::parameters;

namespace {

struct Cancelled {}; // nothing that anybody else would catch

/// Cancels at its `last`-th call of any member.
struct Impatient_visitor : SM::Default_visitor {
  explicit Impatient_visitor(int last = -1) : last(last) {}
  void start_phase(const char*) { step(); }
  void progress(double) { step(); }
  void end_phase() { step(); }
  void step()
  {
    if (steps++ == last) throw Cancelled();
  }
  int last, steps = 0;
};

/// \param run           (visitor) -> result
/// \param is_unchanged  () -> bool
/// \return the number of steps
template <class Run, class Is_unchanged>
int cancel_at_every_step(const Run& run, const Is_unchanged& is_unchanged, int least_steps)
{
  REQUIRE(is_unchanged());
  int not_cancelled = 0, changed = 0, last = 0;
  for (;; ++last) {
    Impatient_visitor visitor(last);
    try {
      run(visitor);
      break;
    } catch (const Cancelled&) {
      changed += !is_unchanged();
      not_cancelled += visitor.steps != last + 1; // it has gone on
    }
  }
  CHECK(last >= least_steps);
  CHECK(changed == 0);
  CHECK(not_cancelled == 0);
  return last;
}

/// The same for a mapper, (mesh, named parameters) -> map; it writes the domain points when it is let.
template <class Domain_point, class Mapper>
void cancel_mapper(const Triangle_mesh& t, const Mapper& mapper, int least_steps)
{
  Watched_mesh<Domain_point> watched(t);
  Watched_mesh<Domain_point> other(t);
  const auto result = mapper(other.mesh, params::domain_point_map(other.domain));
  cancel_at_every_step(
    [&](Impatient_visitor& visitor) {
      const auto again =
        mapper(watched.mesh, params::domain_point_map(watched.domain).visitor(std::ref(visitor)));
      CHECK(same(result, again));
    },
    [&] { return watched.is_unchanged(); }, least_steps);
  for (const auto v : other.mesh.vertices()) CHECK(watched.domain[v] == other.domain[v]);
}

/// The same for a function of a map: (map, named parameters) -> result.
template <class Atlas, class Function>
void cancel_function_of_map(const SM::Manifold_map<Atlas>& map, const Function& function, int least_steps)
{
  const SM::Manifold_map<Atlas> copy = map;
  Impatient_visitor patient;
  const auto result = function(map, CGAL::parameters::visitor(std::ref(patient)));
  cancel_at_every_step(
    [&](Impatient_visitor& visitor) {
      const auto again = function(map, CGAL::parameters::visitor(std::ref(visitor)));
      CHECK(same(result, again));
    },
    [&] { return same(map, copy); }, least_steps);
}

} // namespace

TEST_CASE("mappers are cancelled at every step")
{
  cancel_mapper<Eigen::Vector3d>(
    some_sphere(), [](const auto& mesh, const auto& np) { return SM::map_to_sphere(mesh, np); }, 10);
  cancel_mapper<Eigen::Vector2d>(
    some_torus(), [](const auto& mesh, const auto& np) { return SM::map_to_torus(mesh, np); }, 10);
  cancel_mapper<Eigen::Vector2d>(
    some_disk(), [](const auto& mesh, const auto& np) { return SM::map_to_plane(mesh, np); }, 10);
  cancel_mapper<Eigen::Vector3d>(
    some_disk(),
    [](const auto& mesh, const auto& np) {
      return SM::map_to_sphere(mesh, params::close_borders(SM::Close_borders::ALL, np));
    },
    10);
  const std::vector<SM::Landmark<Mesh::Vertex_index, Eigen::Vector3d>> landmarks = {
    {Mesh::Vertex_index(7), Eigen::Vector3d(1, 0, 0)}, {Mesh::Vertex_index(23), Eigen::Vector3d(0, 1, 0)}};
  cancel_mapper<Eigen::Vector3d>(
    some_sphere(),
    [&landmarks](const auto& mesh, const auto& np) {
      return SM::map_to_sphere(mesh, params::landmarks(landmarks, np));
    },
    10);
}

TEST_CASE("mapping and fitting in one call is cancelled at every step, with several threads")
{
  Random random(8);
  Watched_mesh<Eigen::Vector2d> watched(
    random_torus(60, 50, 1000, 0, random)); // shorter loops have one thread
  const auto fit = [&watched](auto& visitor) {
    return SM::fit_surface<CGAL::Parallel_if_available_tag>(
      watched.mesh, params::rms_error(0.05).visitor(std::ref(visitor)));
  };
  Impatient_visitor patient;
  const auto surface = std::get<2>(fit(patient)); // of the torus
  cancel_at_every_step(
    [&](Impatient_visitor& visitor) {
      const auto again = fit(visitor);
      CHECK(same(surface, std::get<2>(again)));
    },
    [&] { return watched.is_unchanged(); }, 15);
}

TEST_CASE("maps to whichever surface and by partition are cancelled at every step")
{
  for (const Triangle_mesh& t : {some_sphere(), some_torus(), some_disk()}) {
    Watched_mesh<Eigen::Vector2d> watched(t);
    const auto is_unchanged = [&] { return watched.is_unchanged(); };
    const auto map = SM::map_to_canonical_surface(watched.mesh);
    cancel_at_every_step(
      [&](Impatient_visitor& visitor) {
        const auto np = CGAL::parameters::visitor(std::ref(visitor));
        const auto again = SM::map_to_canonical_surface(watched.mesh, np);
        CHECK(same(map, again));
      },
      is_unchanged, 10);
    const auto partitioned = SM::map_by_partition(watched.mesh);
    cancel_at_every_step(
      [&](Impatient_visitor& visitor) {
        const auto again = SM::map_by_partition(watched.mesh, CGAL::parameters::visitor(std::ref(visitor)));
        CHECK(same(partitioned, again));
      },
      is_unchanged, 4);
  }
}

TEST_CASE("functions of maps are cancelled at every step")
{
  const auto sphere = SM::map_to_sphere(mesh_of(some_sphere()));
  const auto torus = SM::map_to_torus(mesh_of(some_torus()));
  const auto disk = SM::map_to_plane(mesh_of(some_disk()));
  const auto balance = [](const auto& map, const auto& np) { return SM::balance(map, np); };
  const auto refine = [](const auto& map, const auto& np) { return SM::refine(map, np); };
  cancel_function_of_map(sphere, balance, 3);
  cancel_function_of_map(torus, balance, 2); // translations only
  cancel_function_of_map(sphere, refine, 3);
  cancel_function_of_map(torus, refine, 2); // there is nothing to refine
  const auto fit = [](const auto& map, const auto& np) {
    return SM::fit_surface(map, params::rms_error(0.05, np));
  };
  cancel_function_of_map(sphere, fit, 5);
  cancel_function_of_map(torus, fit, 5);
  cancel_function_of_map(disk, fit, 5);
  for (const SM::Joint_solve joint : {SM::Joint_solve::ALWAYS, SM::Joint_solve::NEVER})
    cancel_function_of_map(
      disk,
      [&](const auto& map, const auto& np) {
        return SM::fit_surface(
          map, params::rms_error(
                 0.05, params::joint_solve(joint, params::refinement(SM::Refinement::UNIFORM, np))));
      },
      5);
  const auto patches = [](const auto& map, const auto& np) {
    return SM::fit_patch_surface(map, params::average_delta(0.05, params::max_patches(3, np)));
  };
  cancel_function_of_map(sphere, patches, 5);
  cancel_function_of_map(torus, patches, 5);
  cancel_function_of_map(disk, patches, 5);
}

TEST_CASE("a cancelled fit leaves the reports as they were")
{
  const auto map = SM::map_to_plane(mesh_of(some_disk()));
  SM::Fit_report report;
  report.controls = 12345;
  cancel_at_every_step(
    [&](Impatient_visitor& visitor) {
      SM::fit_surface(map, params::rms_error(0.05).fit_report(std::ref(report)).visitor(std::ref(visitor)));
    },
    [&] { return report.controls == 12345; }, 5);
  CHECK(report.controls < 12345);
  SM::Patch_fit_report patches;
  patches.surface.controls = 12345;
  patches.charts.resize(17);
  cancel_at_every_step(
    [&](Impatient_visitor& visitor) {
      SM::fit_patch_surface(map, params::average_delta(0.05)
                                   .max_patches(2)
                                   .patch_fit_report(std::ref(patches))
                                   .visitor(std::ref(visitor)));
    },
    [&] { return patches.surface.controls == 12345 && patches.charts.size() == 17; }, 5);
  CHECK(patches.charts.size() == 1);
}

} // namespace test_cancellation
