// Points per second of one core on surfaces of hierarchical splines, beside a plain bicubic patch and, if it
// was found, OpenSubdiv, as CSV. See README.md in this folder.

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>
#include <CGAL/Simple_manifolds/embedding/strided_arrays.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#ifdef SIMPLE_MANIFOLDS_HAS_OPENSUBDIV
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/bufferDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/cpuPatchTable.h>
#include <opensubdiv/osd/cpuVertexBuffer.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Eigen::Vector2d;
using Eigen::Vector3d;

int number_of_points = 200000;
int repetitions = 9;

// Of the processor, which this program uses one of: what others do on the machine does not count.
double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// What a row of the table says first.
struct Subject {
  std::string surface, evaluator;
  std::size_t controls, pieces;
};

template <class Function>
void for_each_index(const Function& f)
{
  for (int k = 0; k < number_of_points; ++k) f(k);
}

/// Prints the best of several runs: others on the machine take of its caches.
void measure(const Subject& s, const char* derivatives, const char* points, const std::function<void()>& run)
{
  double best = 1e300;
  for (int k = 0; k < repetitions; ++k) {
    const double start = seconds();
    run();
    best = (std::min)(best, seconds() - start);
  }
  std::cout << s.surface << ',' << s.evaluator << ',' << s.controls << ',' << s.pieces << ',' << derivatives
            << ',' << points << ',' << number_of_points / best * 1e-6 << std::endl;
}

/// The bumpy surfaces that all are to represent; on the plane a sheet, on the torus a ring.
Vector3d shape(const Vector3d& p) { return (1 + .1 * std::sin(5 * p.x()) * std::cos(4 * p.y())) * p; }
Vector3d shape(const Vector2d& p)
{
  const double a = 6.283185307179586 * p.x(), b = 6.283185307179586 * p.y();
  const double r = 1 + .1 * std::sin(3 * a + 2 * b);
  return {(2 + r * std::cos(b)) * std::cos(a), (2 + r * std::cos(b)) * std::sin(a), r * std::sin(b)};
}

/// A base grid of 4 x 4 cells, and details round a few points per chart, down to level 8.
template <class Atlas>
SM::Manifold_surface<Atlas> hierarchical_surface(double width)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1), detail(-1e-3, 1e-3);
  std::vector<SM::Hierarchical_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    std::vector<Vector2d> centres;
    for (int k = 0; k < 6; ++k) centres.emplace_back(uniform(random), uniform(random));
    std::vector<SM::Hierarchical_embedding::Level> levels;
    for (int level = 0; level <= 8; ++level) {
      const int cells = 4 << level, n = cells + 3;
      levels.push_back({cells, {}, {}});
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const Vector2d uv = Vector2d(i - 1, j - 1) / cells;
          const auto is_near = [&](const Vector2d& x) {
            return (uv - x).lpNorm<Eigen::Infinity>() * cells < width;
          };
          if (level > 0 && std::none_of(centres.begin(), centres.end(), is_near)) continue;
          levels.back().indices.push_back(i * n + j);
          levels.back().coefficients.push_back(
            level == 0 ? shape(Atlas().point({c, uv.cwiseMax(.001).cwiseMin(.999)}))
                       : Vector3d(detail(random), detail(random), detail(random)) / (1 << level));
        }
    }
    charts.emplace_back(3, levels);
  }
  return SM::Manifold_surface<Atlas>(charts);
}

/// Line by line over the tiles.
template <class Atlas>
std::vector<typename Atlas::Domain_point> coherent_points()
{
  const int n = int(std::sqrt(double(number_of_points) / Atlas::number_of_charts())) + 1;
  std::vector<typename Atlas::Domain_point> points;
  for (int tile = 0; tile < Atlas::number_of_charts(); ++tile)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) points.push_back(Atlas().tile_point(tile, (i + .5) / n, (j + .5) / n));
  points.resize(number_of_points);
  return points;
}

template <class Atlas>
void measure_manifold(double width)
{
  const SM::Manifold_surface<Atlas> surface = hierarchical_surface<Atlas>(width);
  Subject s{Atlas::name, "", 0, 0};
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    s.controls += surface.chart_embedding(c).number_of_coefficients();
    s.pieces += surface.chart_embedding(c).number_of_leaves();
  }
  std::vector<Vector3d> position(number_of_points);
  std::vector<SM::Jet> jet(number_of_points);
  const auto run = [&](const char* name, const auto& p) {
    s.evaluator = "scalar";
    measure(s, "0", name, [&] { for_each_index([&](int k) { position[k] = surface.point(p[k]); }); });
    measure(s, "1", name, [&] { for_each_index([&](int k) { jet[k] = surface.template jet<1>(p[k]); }); });
    measure(s, "2", name, [&] { for_each_index([&](int k) { jet[k] = surface.jet(p[k]); }); });
    s.evaluator = "batch";
    measure(s, "0", name, [&] { surface.points(p, position.begin()); });
    measure(s, "1", name, [&] { surface.template jets<1>(p, jet.begin()); });
    measure(s, "2", name, [&] { surface.jets(p, jet.begin()); });
    s.evaluator = "batch of float arrays";
    std::vector<float> in, out(18 * std::size_t(number_of_points));
    for (const auto& x : p)
      for (const double c : x) in.push_back(float(c));
    const auto range = SM::strided_points(surface.atlas(), in.data(), p.size());
    std::array<float*, 6> to;
    for (std::size_t n = 0; n < 6; ++n) to[n] = &out[3 * n];
    const auto jets = SM::strided_jets(to, 18);
    measure(s, "0", name, [&] { surface.points(range, SM::strided_vectors(out.data())); });
    measure(s, "1", name, [&] { surface.template jets<1>(range, jets); });
    measure(s, "2", name, [&] { surface.jets(range, jets); });
  };
  run("random", SM::random_domain_points<Atlas>(number_of_points));
  run("coherent", coherent_points<Atlas>());
}

/// The ceiling: one bicubic patch, no charts, no weights.
void measure_patch(int controls)
{
  std::vector<Vector3d> coefficients(controls * controls);
  for (int k = 0; k < controls * controls; ++k)
    coefficients[k] = shape(Vector2d(Vector2d(k / controls, k % controls) / controls));
  const SM::Spline_patch patch({0, 0, 1, 1}, 3, controls, controls, coefficients);
  const Subject s{"bicubic patch", "scalar", coefficients.size(), std::size_t(controls - 3) * (controls - 3)};
  std::vector<Vector3d> position(number_of_points);
  std::vector<SM::Jet> jet(number_of_points);
  const auto run = [&](const char* name, const std::vector<Vector2d>& p) {
    measure(s, "0", name, [&] { for_each_index([&](int k) { position[k] = patch.point(p[k]); }); });
    measure(s, "1", name, [&] { for_each_index([&](int k) { jet[k] = patch.jet<1>(p[k]); }); });
    measure(s, "2", name, [&] { for_each_index([&](int k) { jet[k] = patch.jet(p[k]); }); });
  };
  run("random", SM::random_domain_points<SM::Plane_atlas>(number_of_points));
  run("coherent", coherent_points<SM::Plane_atlas>());
}

#ifdef SIMPLE_MANIFOLDS_HAS_OPENSUBDIV

namespace Osd = OpenSubdiv::Osd;
namespace Far = OpenSubdiv::Far;
namespace Bfr = OpenSubdiv::Bfr;
namespace Sdc = OpenSubdiv::Sdc;

/// A point of a control face.
struct Face_point {
  int face;
  double uv[2];
};

/// The grid of all tiles of the sphere as a control mesh, of squares or of triangles.
struct Control_mesh {
  Control_mesh(int n, bool has_triangles) : is_loop(has_triangles)
  {
    const SM::Tile_grid<SM::Sphere_atlas> grid(n);
    for (const Vector3d& p : grid.domain_points()) points.push_back(shape(p));
    for (const auto& [a, b, c, d] : grid.cells()) {
      if (has_triangles)
        indices.insert(indices.end(), {a, b, c, a, c, d});
      else
        indices.insert(indices.end(), {a, b, c, d});
    }
    sizes.assign(indices.size() / (has_triangles ? 3 : 4), has_triangles ? 3 : 4);
  }

  const char* scheme() const { return is_loop ? "Loop" : "Catmull-Clark"; }

  std::unique_ptr<Far::TopologyRefiner> refiner() const
  {
    Far::TopologyDescriptor topology;
    topology.numVertices = int(points.size());
    topology.numFaces = int(sizes.size());
    topology.numVertsPerFace = sizes.data();
    topology.vertIndicesPerFace = indices.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const Factory::Options options(is_loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, Sdc::Options());
    return std::unique_ptr<Far::TopologyRefiner>(Factory::Create(topology, options));
  }

  Face_point face_point(int face, double u, double v) const
  {
    if (is_loop && u + v > 1) return {face, {1 - u, 1 - v}};
    return {face, {u, v}};
  }

  std::vector<Face_point> random_points() const
  {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> face(0, int(sizes.size()) - 1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Face_point> list;
    for (int k = 0; k < number_of_points; ++k) {
      const double u = uniform(random), v = uniform(random);
      list.push_back(face_point(face(random), u, v));
    }
    return list;
  }

  std::vector<Face_point> coherent_points() const
  {
    const int n = int(std::sqrt(double(number_of_points) / double(sizes.size()))) + 1;
    std::vector<Face_point> list;
    for (int face = 0; face < int(sizes.size()); ++face)
      for (int k = 0; k < n * n; ++k) list.push_back(face_point(face, (k / n + .5) / n, (k % n + .5) / n));
    list.resize(number_of_points);
    return list;
  }

  bool is_loop;
  std::vector<Vector3d> points;
  std::vector<int> indices, sizes;
};

/// Bfr, with the surfaces and their patch points of all faces made before the clock starts.
void measure_bfr(const Control_mesh& mesh)
{
  const auto refiner = mesh.refiner();
  const Bfr::RefinerSurfaceFactory<> factory(*refiner, Bfr::SurfaceFactory::Options());
  std::vector<Bfr::Surface<double>> surfaces(mesh.sizes.size());
  std::vector<std::vector<double>> patch_points(mesh.sizes.size());
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    factory.InitVertexSurface(int(f), &surfaces[f]);
    patch_points[f].resize(3 * surfaces[f].GetNumPatchPoints());
    surfaces[f].PreparePatchPoints(mesh.points[0].data(), 3, patch_points[f].data(), 3);
  }
  const Subject s{mesh.scheme(), "OpenSubdiv Bfr", mesh.points.size(), mesh.sizes.size()};
  std::vector<Vector3d> position(number_of_points);
  std::vector<SM::Jet> jet(number_of_points);
  const auto run = [&](const char* name, const std::vector<Face_point>& p) {
    measure(s, "0", name, [&] {
      for_each_index([&](int k) {
        const auto& [face, uv] = p[k];
        surfaces[face].Evaluate(uv, patch_points[face].data(), 3, position[k].data());
      });
    });
    measure(s, "1", name, [&] {
      for_each_index([&](int k) {
        const auto& [face, uv] = p[k];
        SM::Jet& e = jet[k];
        surfaces[face].Evaluate(uv, patch_points[face].data(), 3, e.value.data(), e.u.data(), e.v.data());
      });
    });
    measure(s, "2", name, [&] {
      for_each_index([&](int k) {
        const auto& [face, uv] = p[k];
        SM::Jet& e = jet[k];
        surfaces[face].Evaluate(uv, patch_points[face].data(), 3, e.value.data(), e.u.data(), e.v.data(),
                                e.uu.data(), e.uv.data(), e.vv.data());
      });
    });
  };
  run("random", mesh.random_points());
  run("coherent", mesh.coherent_points());
}

/// A vertex for Far.
struct Vertex {
  Vector3d x = Vector3d::Zero();
  void Clear() { x.setZero(); }
  void AddWithWeight(const Vertex& v, double w) { x += w * v.x; }
};

struct Patch_coordinates {
  std::vector<Osd::PatchCoord> list;
  const Osd::PatchCoord* BindCpuBuffer() const { return list.data(); }
};

/// Osd's evaluator on the processor: adaptive refinement to level 4, a patch map, single precision.
void measure_osd(const Control_mesh& mesh)
{
  const auto refiner = mesh.refiner();
  Far::PatchTableFactory::Options options(4);
  options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
  refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
  const std::unique_ptr<Far::PatchTable> table(Far::PatchTableFactory::Create(*refiner, options));
  std::vector<Vertex> vertices(refiner->GetNumVerticesTotal() + table->GetNumLocalPoints());
  for (std::size_t k = 0; k < mesh.points.size(); ++k) vertices[k].x = mesh.points[k];
  Vertex* from = vertices.data();
  for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
    Vertex* to = from + refiner->GetLevel(level - 1).GetNumVertices();
    Far::PrimvarRefinerReal<double>(*refiner).Interpolate(level, from, to);
    from = to;
  }
  table->GetLocalPointStencilTable()->UpdateValues(vertices.data(),
                                                   vertices.data() + refiner->GetNumVerticesTotal());
  std::vector<float> xyz;
  for (const Vertex& v : vertices)
    for (int i = 0; i < 3; ++i) xyz.push_back(float(v.x[i]));
  std::unique_ptr<Osd::CpuVertexBuffer> source(Osd::CpuVertexBuffer::Create(3, int(vertices.size())));
  source->UpdateData(xyz.data(), 0, int(vertices.size()));
  const std::unique_ptr<Osd::CpuPatchTable> patches(Osd::CpuPatchTable::Create(table.get()));
  const Far::PatchMap map(*table);

  const Subject s{mesh.scheme(), "OpenSubdiv Osd (float)", mesh.points.size(),
                  std::size_t(table->GetNumPatchesTotal())};
  std::vector<std::unique_ptr<Osd::CpuVertexBuffer>> out;
  for (int k = 0; k < 6; ++k) out.emplace_back(Osd::CpuVertexBuffer::Create(3, number_of_points));
  const Osd::BufferDescriptor xyz_of_3(0, 3, 3);
  Patch_coordinates coordinates;
  const auto run = [&](const char* name, const std::vector<Face_point>& p) {
    const auto find_patches = [&] {
      coordinates.list.clear();
      for (const Face_point& q : p)
        coordinates.list.emplace_back(*map.FindPatch(q.face, q.uv[0], q.uv[1]), float(q.uv[0]),
                                      float(q.uv[1]));
    };
    measure(s, "0", name, [&] {
      find_patches();
      Osd::CpuEvaluator::EvalPatches(source.get(), xyz_of_3, out[0].get(), xyz_of_3, number_of_points,
                                     &coordinates, patches.get());
    });
    measure(s, "1", name, [&] {
      find_patches();
      Osd::CpuEvaluator::EvalPatches(source.get(), xyz_of_3, out[0].get(), xyz_of_3, out[1].get(), xyz_of_3,
                                     out[2].get(), xyz_of_3, number_of_points, &coordinates, patches.get());
    });
    measure(s, "2", name, [&] {
      find_patches();
      Osd::CpuEvaluator::EvalPatches(source.get(), xyz_of_3, out[0].get(), xyz_of_3, out[1].get(), xyz_of_3,
                                     out[2].get(), xyz_of_3, out[3].get(), xyz_of_3, out[4].get(), xyz_of_3,
                                     out[5].get(), xyz_of_3, number_of_points, &coordinates, patches.get());
    });
  };
  run("random", mesh.random_points());
  run("coherent", mesh.coherent_points());
}

#endif // SIMPLE_MANIFOLDS_HAS_OPENSUBDIV

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && std::strcmp(argv[1], "--quick") == 0) {
    number_of_points = 2000;
    repetitions = 1;
  } else if (argc != 1) {
    std::cerr << "usage: evaluation_benchmark [--quick]\n";
    return 2;
  }
  std::cout << "surface,evaluator,controls,pieces,derivatives,points,million_points_per_second\n";
  for (const double width : {1.5, 4.}) {
    measure_manifold<SM::Sphere_atlas>(width);
    measure_manifold<SM::Torus_atlas>(width * 0.8);
    measure_manifold<SM::Plane_atlas>(width * 2);
  }
  measure_patch(23);
  measure_patch(67);
#ifdef SIMPLE_MANIFOLDS_HAS_OPENSUBDIV
  for (const int n : {20, 55})
    for (const bool is_loop : {false, true}) {
      const Control_mesh mesh(n, is_loop);
      measure_bfr(mesh);
      measure_osd(mesh);
    }
#endif
}
