// Times and qualities of every step on three real meshes; see README.md in this folder.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Rate = benchmark::Counter;

namespace {

auto map_mesh(SM::Sphere_atlas, const Mesh& mesh) { return SM::map_to_sphere(mesh); }
auto map_mesh(SM::Torus_atlas, const Mesh& mesh) { return SM::map_to_torus(mesh); }
auto map_mesh(SM::Plane_atlas, const Mesh& mesh) { return SM::map_to_plane(mesh); }

/// A mesh with all that the steps make of it, each once.
template <class Atlas_>
struct Scenario {
  using Atlas = Atlas_;
  using Domain_point = typename Atlas::Domain_point;
  using Map = SM::Manifold_map<Atlas>;
  using Surface = decltype(SM::fit_surface(std::declval<const Map&>()));

  explicit Scenario(const std::string& name)
    : mesh(read(name)), map(map_mesh(Atlas(), mesh)), surface(SM::fit_surface(map))
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::uniform_int_distribution<int> tile(0, Atlas::number_of_charts() - 1);
    for (int i = 0; i < 10000; ++i)
      points.push_back(Atlas().tile_point(tile(random), uniform(random), uniform(random)));
  }

  static Mesh read(const std::string& name)
  {
    Mesh mesh;
    SM::read_mesh(SIMPLE_MANIFOLDS_CGAL_DATA "/meshes/" + name + ".off", mesh);
    return mesh;
  }

  Mesh mesh;
  Map map;
  Surface surface;
  std::vector<Domain_point> points; ///< evenly spread over the tiles
};

/// \param size  points or faces that one iteration works on
void set_rate(benchmark::State& state, const char* name, std::size_t size)
{
  state.counters[name] = Rate(double(size), Rate::kIsIterationInvariantRate);
}

template <class Scenario>
void atlas(benchmark::State& state, const Scenario& s)
{
  const SM::Partition_of_unity<typename Scenario::Atlas> partition;
  for (auto _ : state)
    for (const auto& p : s.points) benchmark::DoNotOptimize(partition.weight_jets(p));
  set_rate(state, "points/s", s.points.size());
}

template <class Scenario>
void map(benchmark::State& state, const Scenario& s)
{
  for (auto _ : state) benchmark::DoNotOptimize(map_mesh(s.map.atlas(), s.mesh));
  set_rate(state, "faces/s", s.map.number_of_faces());
  const SM::Distortion d = SM::distortion(s.map);
  state.counters["angle"] = d.angle_mean;
  state.counters["area"] = d.area_mean_abs_log10;
  state.counters["symmetric_dirichlet"] = d.symmetric_dirichlet;
}

template <class Scenario>
void locate(benchmark::State& state, const Scenario& s)
{
  for (auto _ : state)
    for (const auto& p : s.points) benchmark::DoNotOptimize(s.map.to_mesh(p));
  set_rate(state, "points/s", s.points.size());
}

template <class Scenario>
void fit(benchmark::State& state, const Scenario& s)
{
  SM::Fit_report report;
  for (auto _ : state)
    benchmark::DoNotOptimize(SM::fit_surface(s.map, SM::parameters::fit_report(std::ref(report))));
  set_rate(state, "faces/s", s.map.number_of_faces());
  state.counters["rms_error"] = report.rms_error;
  state.counters["max_error"] = report.max_error;
  state.counters["controls"] = double(report.controls);
}

template <class Scenario>
void evaluate(benchmark::State& state, const Scenario& s)
{
  for (auto _ : state)
    for (const auto& p : s.points) benchmark::DoNotOptimize(s.surface.jet(p));
  set_rate(state, "points/s", s.points.size());
}

template <class Scenario>
void tessellate(benchmark::State& state, const Scenario& s)
{
  std::size_t faces = 0;
  for (auto _ : state) {
    Mesh out;
    SM::tessellate(s.surface, out);
    faces = out.number_of_faces();
  }
  set_rate(state, "faces/s", faces);
}

/// Registers all steps for one mesh. The scenario is made when the first of its benchmarks runs, so that
/// a filter does not pay for the others.
template <class Atlas>
void add(const std::string& mesh)
{
  using S = Scenario<Atlas>;
  const auto scenario = [mesh]() -> const S& {
    static const S s(mesh); // one mesh per atlas
    return s;
  };
  const auto step = [&](const char* name, void (*run)(benchmark::State&, const S&)) {
    benchmark::RegisterBenchmark((name + ("/" + mesh)).c_str(), [=](benchmark::State& state) {
      run(state, scenario());
    })->Unit(benchmark::kMillisecond);
  };
  step("atlas", atlas<S>);
  step("map", map<S>);
  step("locate", locate<S>);
  step("fit", fit<S>);
  step("evaluate", evaluate<S>);
  step("tessellate", tessellate<S>);
}

} // namespace

int main(int argc, char** argv)
{
  add<SM::Sphere_atlas>("hand");
  add<SM::Torus_atlas>("knot1");
  add<SM::Plane_atlas>("three_peaks");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
