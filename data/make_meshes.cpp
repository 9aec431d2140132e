// Makes the meshes of this folder: make_meshes DIR
//
// Coordinates are rounded before any decision is taken on them, so all compilers make the same files.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846;

using Point = std::array<double, 3>;
using Ring = std::vector<int>; // vertices of a closed curve

struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
};

Point rounded(Point p)
{
  for (double& x : p) x = std::round(1e5 * x) / 1e5 + 0.; // no -0
  return p;
}

double squared_distance(const Point& p, const Point& q)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return sum;
}

double distance(const Point& p, const Point& q) { return std::sqrt(squared_distance(p, q)); }

// Whether pq is shorter than rs, or as long, whatever the last bit.
bool is_not_longer(const Point& p, const Point& q, const Point& r, const Point& s)
{
  return squared_distance(p, q) <= squared_distance(r, s) + 1e-9;
}

// 0 up to a, 1 from b on, smooth between them.
double step(double a, double b, double x)
{
  const double t = std::clamp((x - a) / (b - a), 0., 1.);
  return t * t * (3 - 2 * t);
}

// 1 at the middle of [a,b], 0 outside.
double bump(double a, double b, double x)
{
  const double t = (2 * x - a - b) / (b - a);
  return std::abs(t) < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

// ---- Tubes ------------------------------------------------------------------------------------------------

// A surface that is swept by a closed curve: (s, a) -> point, s and a in [0,1], a periodic. Seen against the
// direction of s, the curve runs counterclockwise.
using Sweep = std::function<Point(double s, double a)>;

// Where the polygon has lengths (i + shift)/n of its total, i < n, as fractional indices.
std::vector<double> equal_parts(const std::vector<Point>& polygon, int n, double shift)
{
  std::vector<double> length{0};
  for (std::size_t k = 1; k < polygon.size(); ++k)
    length.push_back(length.back() + distance(polygon[k - 1], polygon[k]));
  std::vector<double> places;
  std::size_t k = 0;
  for (int i = 0; i < n; ++i) {
    const double wanted = (i + shift) / n * length.back();
    while (k + 2 < length.size() && length[k + 1] <= wanted) ++k;
    places.push_back(k + (wanted - length[k]) / (length[k + 1] - length[k]));
  }
  return places;
}

// n whole numbers, at least 6 each, with the given sum, in proportion to the lengths (largest remainders).
std::vector<int> apportion(const std::vector<double>& lengths, int sum)
{
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.);
  std::vector<int> parts, order;
  for (const double length : lengths) {
    parts.push_back(std::max(6, static_cast<int>(length / total * sum)));
    order.push_back(static_cast<int>(order.size()));
  }
  const auto missing = [&](int i) { return lengths[i] / total * sum - parts[i]; };
  int rest = sum - std::accumulate(parts.begin(), parts.end(), 0);
  for (; rest != 0; rest += rest > 0 ? -1 : 1) {
    const auto extreme = std::minmax_element(order.begin(), order.end(),
                                             [&](int i, int j) { return missing(i) < missing(j) - 1e-9; });
    rest > 0 ? ++parts[*extreme.second] : --parts[*extreme.first];
  }
  return parts;
}

// Fills the strip between two chains of vertices, always with the shorter of two diagonals. Triangles have
// the edges of `left` in its direction.
void fill_strip(Mesh& mesh, const Ring& left, const Ring& right)
{
  const auto& p = mesh.points;
  std::size_t i = 0, j = 0;
  while (i + 1 < left.size() || j + 1 < right.size()) {
    const bool is_left =
      j + 1 == right.size() ||
      (i + 1 < left.size() && is_not_longer(p[left[i + 1]], p[right[j]], p[left[i]], p[right[j + 1]]));
    if (is_left) {
      mesh.triangles.push_back({left[i], left[i + 1], right[j]});
      ++i;
    } else {
      mesh.triangles.push_back({left[i], right[j + 1], right[j]});
      ++j;
    }
  }
}

// The strip between two rings that run in the same direction.
void join(Mesh& mesh, Ring first, Ring second)
{
  const auto& p = mesh.points;
  const auto nearest = std::min_element(second.begin(), second.end(), [&](int v, int w) {
    return !is_not_longer(p[w], p[first[0]], p[v], p[first[0]]);
  });
  std::rotate(second.begin(), nearest, second.end());
  first.push_back(first[0]);
  second.push_back(second[0]);
  fill_strip(mesh, first, second);
}

// Closes a ring by a strip from its first vertex to the opposite one. The ring runs counterclockwise.
void close(Mesh& mesh, const Ring& ring)
{
  const std::size_t middle = ring.size() / 2;
  const Ring left(ring.begin() + 1, ring.begin() + middle + 1);
  const Ring right(ring.rbegin(), ring.rend() - middle - 1);
  mesh.triangles.push_back({ring[0], left[0], right[0]});
  fill_strip(mesh, left, right);
}

// Triangles of about equal size on a sweep: rings at equal distances with as many vertices as their lengths
// demand. With closed ends, unless the sweep is periodic in s, too.
Mesh tube(const Sweep& sweep, int number_of_rings, int number_of_vertices, bool is_periodic)
{
  constexpr int steps = 720;
  std::vector<double> s_of_rings(number_of_rings, 0.); // the mean over several angles
  for (int k = 0; k < 24; ++k) {
    std::vector<Point> meridian;
    for (int i = 0; i <= steps; ++i) meridian.push_back(sweep(i / double(steps), k / 24.));
    const int parts = is_periodic ? number_of_rings : number_of_rings - 1;
    std::vector<double> places = equal_parts(meridian, parts, 0);
    places.push_back(steps);
    for (int i = 0; i < number_of_rings; ++i) s_of_rings[i] += places[i] / steps / 24;
  }

  std::vector<std::vector<Point>> sections;
  std::vector<double> lengths;
  for (const double s : s_of_rings) {
    std::vector<Point> section;
    double length = 0;
    for (int i = 0; i <= steps; ++i) {
      section.push_back(sweep(s, i / double(steps)));
      length += i > 0 ? distance(section[i - 1], section[i]) : 0;
    }
    sections.push_back(std::move(section));
    lengths.push_back(length);
  }

  Mesh mesh;
  std::vector<Ring> rings;
  const std::vector<int> sizes = apportion(lengths, number_of_vertices);
  for (int i = 0; i < number_of_rings; ++i) {
    rings.emplace_back();
    for (const double place : equal_parts(sections[i], sizes[i], i % 2 * 0.5)) {
      rings.back().push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(rounded(sweep(s_of_rings[i], place / steps)));
    }
  }
  for (int i = 0; i + 1 < number_of_rings; ++i) join(mesh, rings[i], rings[i + 1]);
  if (is_periodic) {
    join(mesh, rings.back(), rings.front());
  } else {
    close(mesh, Ring(rings.front().rbegin(), rings.front().rend()));
    close(mesh, rings.back());
  }
  return mesh;
}

// A bent tube from the stem to the tip, with five ridges.
Mesh banana()
{
  return tube(
    [](double s, double a) -> Point {
      const double stem = 0.17 + 0.05 * step(0.06, 0, s);
      const double body = 0.47 * step(0.06, 0.45, s) * std::sqrt(1 - std::pow(step(0.5, 1.06, s), 1.5));
      const double ridges = 1 + 0.06 * step(0.1, 0.3, s) * std::cos(10 * pi * a);
      const double radius = (stem + body) * ridges * (1 - 0.45 * step(0.9, 1, s));
      const double bend = (2.3 * s - 1.25) * (1 - 0.12 * step(0.2, 0, s)), x = radius * std::cos(2 * pi * a);
      return {(2.6 + x) * std::sin(bend), 2.6 - (2.6 + x) * std::cos(bend), -radius * std::sin(2 * pi * a)};
    },
    35, 504, false);
}

// From the nose to the tail: ellipses, pulled out as fins above and below.
Mesh fish()
{
  return tube(
    [](double s, double a) -> Point {
      const double up = std::cos(2 * pi * a), side = std::sin(2 * pi * a);
      const double body = s < 0.36 ? std::pow(1 - std::pow(1 - s / 0.36, 2), 0.65) : 1 - step(0.36, 0.86, s);
      const double tail = step(0.76, 1, s);
      const double height = 0.14 + 0.62 * body + 0.7 * tail, width = 0.1 + 0.34 * body - 0.02 * tail;
      const double fin = (up > 0 ? 0.5 * bump(0.25, 0.7, s) : 0.36 * bump(0.5, 0.78, s)) * std::pow(up, 8);
      const double y = height * up + (up > 0 ? fin : -fin), x = 4 * s + 0.45 * tail * up * up + 0.5 * fin;
      return {x, y, width * side};
    },
    45, 1296, false);
}

// A ring torus that is thick at one place and thin at another.
Mesh torus()
{
  return tube(
    [](double s, double a) -> Point {
      const double radius = 0.55 * (1 + 0.3 * std::cos(2 * pi * s)), x = 1.5 + radius * std::cos(2 * pi * a);
      return {x * std::cos(2 * pi * s), x * std::sin(2 * pi * s), -radius * std::sin(2 * pi * a)};
    },
    40, 800, true);
}

// ---- Figures of cubes -------------------------------------------------------------------------------------

// Makes a figure from its picture: each digit is a row of as many cubes in depth, from the middle to both
// sides, and is odd. The surface of the cubes is smoothed, an even number of rounds.
Mesh figure(const std::vector<std::string>& picture, int rounds)
{
  const int rows = static_cast<int>(picture.size());
  const auto is_inside = [&](int x, int y, int z) {
    if (y < 0 || y >= rows || x < 0 || x >= static_cast<int>(picture[rows - 1 - y].size())) return false;
    const char c = picture[rows - 1 - y][x];
    return c != '.' && 2 * std::abs(z) < c - '0';
  };

  Mesh mesh;
  std::vector<std::array<int, 4>> quads;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& corner) {
    const auto [place, is_new] = index.emplace(corner, static_cast<int>(mesh.points.size()));
    if (is_new) mesh.points.push_back({double(corner[0]), double(corner[1]), double(corner[2])});
    return place->second;
  };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < static_cast<int>(picture[rows - 1 - y].size()); ++x)
      for (int z = -4; z <= 4; ++z)
        for (int k = 0; k < 3; ++k)
          for (const int side : {0, 1}) {
            std::array<int, 3> other{x, y, z};
            other[k] += 2 * side - 1;
            if (!is_inside(x, y, z) || is_inside(other[0], other[1], other[2])) continue;
            std::array<int, 4> quad;
            for (int i = 0; i < 4; ++i) { // counterclockwise seen from the positive side
              std::array<int, 3> corner{x, y, z};
              corner[k] += side;
              corner[(k + 1) % 3] += i == 1 || i == 2;
              corner[(k + 2) % 3] += i >= 2;
              quad[side == 1 ? i : 3 - i] = vertex(corner);
            }
            quads.push_back(quad);
          }

  // Taubin's smoothing: a step that shrinks, and one that swells again.
  for (int round = 0; round < rounds; ++round) {
    std::vector<Point> sum(mesh.points.size(), Point{0, 0, 0});
    std::vector<int> count(mesh.points.size(), 0);
    for (const auto& quad : quads)
      for (int i = 0; i < 4; ++i, ++count[quad[(i + 1) % 4]]) // each edge once from either side
        for (int k = 0; k < 3; ++k) sum[quad[i]][k] += mesh.points[quad[(i + 1) % 4]][k];
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      for (int k = 0; k < 3; ++k)
        mesh.points[v][k] += (round % 2 == 0 ? 0.6 : -0.62) * (sum[v][k] / count[v] - mesh.points[v][k]);
  }
  for (Point& p : mesh.points) p = rounded(p);

  for (const auto& [a, b, c, d] : quads) {
    const auto& p = mesh.points;
    const bool is_ac = is_not_longer(p[a], p[c], p[b], p[d]);
    mesh.triangles.push_back(is_ac ? std::array<int, 3>{a, b, c} : std::array<int, 3>{a, b, d});
    mesh.triangles.push_back(is_ac ? std::array<int, 3>{a, c, d} : std::array<int, 3>{b, c, d});
  }
  return mesh;
}

// A flat figure of clay with a slanted head; its arms are three rows of cubes thick, or a single one, which
// smoothing would thin too much.
Mesh gumby(bool has_thin_arms)
{
  const std::string above = has_thin_arms ? ".......333333333........" : std::string(24, '3');
  const std::string arms = has_thin_arms ? "111111133333333311111111" : above;
  return figure({".......333..............",
                 ".......33333............",
                 ".......3333333..........",
                 ".......33333333.........",
                 ".......333333333........",
                 ".......333333333........",
                 ".......333333333........",
                 "........3333333.........",
                 "........3333333.........",
                 ".......333333333........",
                 above,
                 arms,
                 above,
                 ".......333333333........",
                 ".......333333333........",
                 ".......333333333........",
                 ".......333333333........",
                 ".......333333333........",
                 ".......333333333........",
                 "......33333333333.......",
                 "......33333333333.......",
                 "......33333333333.......",
                 ".....333333.333333......",
                 ".....33333...33333......",
                 ".....33333...33333......",
                 "....333333...333333.....",
                 "....33333.....33333.....",
                 "....33333.....33333.....",
                 "...333333.....333333....",
                 "...333333.....333333...."},
                has_thin_arms ? 20 : 60);
}

// ---- Files ------------------------------------------------------------------------------------------------

void write(const std::filesystem::path& file, const Mesh& mesh)
{
  std::ofstream out(file, std::ios::binary);
  out << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Point& p : mesh.points) {
    char line[100];
    std::snprintf(line, sizeof line, "%.5f %.5f %.5f\n", p[0], p[1], p[2]);
    out << line;
  }
  for (const auto& t : mesh.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc != 2) {
    std::fputs("Usage: make_meshes DIR\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  write(folder / "banana.off", banana());
  write(folder / "fish.off", fish());
  write(folder / "gumby.off", gumby(false));
  write(folder / "gumby_thin_arms.off", gumby(true));
  write(folder / "torus.off", torus());
  return EXIT_SUCCESS;
} catch (const std::exception& e) {
  std::fprintf(stderr, "make_meshes: %s\n", e.what());
  return EXIT_FAILURE;
}
