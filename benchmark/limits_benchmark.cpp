// What the machine and the libraries below us can do at best, and how near we come, as CSV on the standard
// output. See README.md in this folder.
//
//   limits_benchmark [--quick]

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/internal/Cholesky_solver.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <Eigen/SparseCholesky>

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

namespace SM = CGAL::Simple_manifolds;
using Atlas = SM::Sphere_atlas;

// Wall seconds of the fastest of several calls.
template <class F>
double seconds(int calls, const F& f)
{
  double best = 1e300;
  for (int k = 0; k < calls; ++k) {
    const auto start = std::chrono::steady_clock::now();
    f();
    best = (std::min)(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

// bytes: what has to be read or written at least; 0 where that is not the limit
void row(const char* phase, const std::string& method, std::size_t size, const char* unit, double s,
         double bytes = 0)
{
  std::cout << phase << ',' << method << ',' << size << ',' << unit << ',' << s << ',';
  if (bytes > 0) std::cout << bytes / s / 1e9;
  std::cout << std::endl;
}

void memory()
{
  std::vector<char> a(std::size_t(256) << 20, 1), b(a.size());
  const double s = seconds(5, [&] { std::memcpy(b.data(), a.data(), a.size()); });
  if (b.back() != 1) throw std::runtime_error("memcpy did not copy");
  row("copy", "memcpy", a.size(), "bytes", s, 2. * double(a.size()));
}

// The sparsity of the normal equations of a bicubic spline with n x n controls: neighbours within 3.
SM::internal::Sparse_matrix normal_matrix(int n)
{
  std::vector<Eigen::Triplet<double>> entries;
  const double mass[] = {2416 / 5040., 1191 / 5040., 120 / 5040., 1 / 5040.}; // of cardinal cubic B-splines
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = i; k < (std::min)(i + 4, n); ++k)
        for (int l = (std::max)(0, j - 3); l < (std::min)(j + 4, n); ++l)
          if (k * n + l >= i * n + j) {
            const double ridge = k == i && l == j ? 1e-3 : 0;
            entries.emplace_back(k * n + l, i * n + j, mass[k - i] * mass[std::abs(l - j)] + ridge);
          }
  SM::internal::Sparse_matrix a(n * n, n * n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

template <class Solver>
void factorisation(const char* name, const SM::internal::Sparse_matrix& a)
{
  Solver solver;
  const double analysis = seconds(1, [&] { solver.analyzePattern(a); });
  const double factor = seconds(1, [&] { solver.factorize(a); });
  if (solver.info() != Eigen::Success) throw std::runtime_error(std::string(name) + " cannot factor");
  row("order", name, std::size_t(a.rows()), "unknowns", analysis);
  row("factor", name, std::size_t(a.rows()), "unknowns", factor);
}

void sparse_solves(bool is_quick)
{
  for (const int n : is_quick ? std::vector<int>{32} : std::vector<int>{64, 128, 256}) {
    const SM::internal::Sparse_matrix a = normal_matrix(n);
    const Eigen::MatrixX3d b = Eigen::MatrixX3d::Random(a.rows(), 3);
    factorisation<Eigen::SimplicialLLT<SM::internal::Sparse_matrix, Eigen::Lower>>("Eigen", a);
#ifdef CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
    factorisation<Eigen::CholmodSupernodalLLT<SM::internal::Sparse_matrix, Eigen::Lower>>("CHOLMOD", a);
#endif
    Eigen::MatrixX3d x;
    const double s = seconds(1, [&] { x = SM::internal::Cholesky_solver(a).solve(b); });
    if (!x.allFinite()) throw std::runtime_error("the solution is not finite");
    row("order+factor+solve", "ours", std::size_t(a.rows()), "unknowns", s);
  }
}

// What passes over a map once: certificate, files.
void streams(bool is_quick)
{
  const SM::Tile_grid<Atlas> grid(is_quick ? 20 : 289); // 1 million faces
  const std::vector<Eigen::Vector3d> points(grid.domain_points().begin(), grid.domain_points().end());
  const SM::Manifold_map<Atlas> map(points, SM::triangulate(grid, points), grid.domain_points(),
                                    points.size());
  const std::size_t faces = map.number_of_faces();
  const double in_memory = double(faces) * sizeof(SM::Triangle) + 3. * double(points.size()) * sizeof(double);
  bool is_valid = false;
  const double certify =
    seconds(3, [&] { is_valid = SM::certify(map.atlas(), map.domain_points(), map.faces()).is_valid(); });
  if (!is_valid) throw std::runtime_error("the map is not certified");
  row("certify", "ours", faces, "faces", certify, in_memory);

  namespace fs = std::filesystem;
  const std::string name = "limits_benchmark" + std::to_string(getpid()) + ".ply";
  const std::string file = (fs::temp_directory_path() / name).string();
  const double write = seconds(2, [&] { SM::write_map(file, map); });
  const double bytes = double(fs::file_size(file));
  row("write map", "ours", faces, "faces", write, bytes);
  std::size_t read_faces = 0;
  const double read = seconds(2, [&] { read_faces = SM::read_map<Atlas>(file).number_of_faces(); });
  fs::remove(file);
  if (read_faces != faces) throw std::runtime_error("the map read has another number of faces");
  row("read and certify map", "ours", faces, "faces", read, bytes);
}

} // namespace

int main(int argc, char** argv)
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  try {
    std::cout << "phase,method,size,unit,seconds,GB_per_s\n";
    memory();
    sparse_solves(is_quick);
    streams(is_quick);
  } catch (const std::exception& e) {
    std::cerr << "limits_benchmark: " << e.what() << '\n';
    return 1;
  }
}
