#include "blobs.h"
#include "catch.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/registration/spherical_harmonics.h>
#include <CGAL/Simple_manifolds/registration/transfer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_transfer {

namespace {

using namespace CGAL::Simple_manifolds;
using blobs::Blob;
using Eigen::Vector3d;
using Map = Manifold_map<Sphere_atlas>;

// The domain point is the point of the round sphere.
Map known_map(const Blob& b) { return Map(b.points, b.faces, b.sphere, b.points.size()); }

} // namespace

TEST_CASE("values, labels and tangent vectors come from one shape to another")
{
  const Blob a = blobs::blob(blobs::four_bumps(), 3), b = blobs::blob({}, 4, blobs::some_turn());
  const Correspondence<Sphere_atlas> c(known_map(a), known_map(b));
  std::vector<double> height;
  std::vector<int> label;
  std::vector<char> side;
  for (const Vector3d& p : b.sphere) {
    height.push_back(p[2]);
    label.push_back(p[0] > 0);
  }
  for (const Triangle& t : b.faces) side.push_back((b.sphere[t[0]] + b.sphere[t[1]] + b.sphere[t[2]])[1] > 0);
  const std::vector<double> heights = transfer(c, height);
  const std::vector<int> labels = transfer_nearest(c, label);
  const std::vector<char> sides = transfer_of_faces(c, side);
  REQUIRE(heights.size() == a.points.size());
  REQUIRE(labels.size() == a.points.size());
  REQUIRE(sides.size() == a.faces.size());
  for (std::size_t v = 0; v < heights.size(); ++v) {
    CHECK(heights[v] == Approx(a.sphere[v][2]).margin(0.01)); // the chords of b's faces
    if (std::abs(a.sphere[v][0]) > 0.1) CHECK(labels[v] == (a.sphere[v][0] > 0));
  }
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const Triangle& t = a.faces[f];
    const double y = (a.sphere[t[0]] + a.sphere[t[1]] + a.sphere[t[2]])[1] / 3;
    if (std::abs(y) > 0.1) CHECK(sides[f] == (y > 0));
  }

  Map::Location at;
  at.face = 77;
  at.barycentric = Vector3d(0.3, 0.3, 0.4);
  const Triangle& t = a.faces[77];
  const Vector3d along = a.points[t[2]] - a.points[t[1]];
  Map::Location moved = at;
  const double h = 1e-7;
  moved.barycentric += Vector3d(0, -h, h);
  REQUIRE(c(moved).face == c(at).face);
  const Vector3d difference = (c.position(moved) - c.position(at)) / h;
  CHECK((push_forward(c, at, along) - difference).norm() < 1e-5 * difference.norm());
}

TEST_CASE("spherical harmonics: orthonormal, exact for what they are, and invariant under rotations")
{
  // Products integrated by a rule of Gauss and equal angles would be exact; here a fine mesh is near enough.
  const Blob round = blobs::blob({}, 5);
  const int degree = 4, k = 25;
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(k, k);
  for (const Triangle& t : round.faces) {
    const Vector3d p = (round.sphere[t[0]] + round.sphere[t[1]] + round.sphere[t[2]]).normalized();
    const double area =
      Sphere_atlas().signed_area(round.sphere[t[0]], round.sphere[t[1]], round.sphere[t[2]]);
    const Eigen::VectorXd y = spherical_harmonics_at<>(degree, p);
    products += area * y * y.transpose();
  }
  CHECK((products - Eigen::MatrixXd::Identity(k, k)).cwiseAbs().maxCoeff() < 2e-3);
  const Vector3d p = Vector3d(1, -2, 0.5).normalized();
  const Eigen::VectorXd y = spherical_harmonics_at<>(2, p);
  CHECK(y[0] == Approx(std::sqrt(1 / (4 * std::acos(-1.)))));
  CHECK(y[2] == Approx(std::sqrt(3 / (4 * std::acos(-1.))) * p[2]));
  CHECK(y[3] == Approx(std::sqrt(3 / (4 * std::acos(-1.))) * p[0]));
  CHECK(y[4] == Approx(std::sqrt(15 / (4 * std::acos(-1.))) * p[0] * p[1]));
  CHECK(y[6] == Approx(std::sqrt(5 / (16 * std::acos(-1.))) * (3 * p[2] * p[2] - 1)));

  // An ellipsoid has degree 1: everything else is nothing.
  Blob ellipsoid = blobs::blob({}, 4);
  for (Vector3d& x : ellipsoid.points) x = Vector3d(3 * x[0], 2 * x[1], x[2]) + Vector3d(5, 0, 0);
  const Harmonic_surface<> e = spherical_harmonics<>(known_map(ellipsoid), 6);
  CHECK(e.degree() == 6);
  for (std::size_t v = 0; v < 100; ++v) CHECK((e(ellipsoid.sphere[v]) - ellipsoid.points[v]).norm() < 1e-7);
  const std::vector<double> spectrum = e.spectrum();
  CHECK(spectrum[1] == Approx(std::sqrt(4 * std::acos(-1.) / 3 * 14)));
  for (int l = 2; l <= 6; ++l) CHECK(spectrum[l] < 1e-6);

  // A blob: better with each degree, the same spectrum after a motion and a rotation of the sphere.
  Blob blob = blobs::blob(blobs::four_bumps(), 4);
  const auto error = [&](int l) {
    const Harmonic_surface<> s = spherical_harmonics<>(known_map(blob), l);
    double sum = 0;
    for (std::size_t v = 0; v < blob.points.size(); ++v)
      sum += (s(blob.sphere[v]) - blob.points[v]).squaredNorm();
    return std::sqrt(sum / static_cast<double>(blob.points.size()));
  };
  CHECK(error(8) < 0.3 * error(4));
  CHECK(error(12) < 0.3 * error(8));
  const Harmonic_surface<> s = spherical_harmonics<>(known_map(blob), 8);
  Blob moved = blob;
  for (Vector3d& x : moved.points) x = blobs::some_turn() * x + Vector3d(1, 2, 3);
  for (Vector3d& x : moved.sphere) x = (blobs::some_turn().transpose() * x).normalized();
  const std::vector<double> a = s.spectrum(), b = spherical_harmonics<>(known_map(moved), 8).spectrum();
  for (int l = 1; l <= 8; ++l) CHECK(b[l] == Approx(a[l]).epsilon(1e-6).margin(1e-9));
  CHECK(s.low_pass(3).degree() == 3);
  CHECK(s.low_pass(3).spectrum()[3] == a[3]);
}

} // namespace test_transfer
