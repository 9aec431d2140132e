#include "catch.h"

#include "../Atlas_archetype.h"
#include "../correspondence/sample_maps.h"
#include "../tessellation/analytic_surfaces.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/write_report.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <cstring>

namespace test_write_report {

namespace {

constexpr const char* page = "<html><!-- data --></html>";

// The map of a smooth surface: vertices are those of a grid of the tiles.
template <class Surface>
auto map_of(const Surface& surface, int subdivisions)
{
  const SM::Tile_grid<typename Surface::Atlas> grid(subdivisions);
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : grid.domain_points()) points.push_back(surface.point(p));
  const auto triangles = SM::triangulate(grid, points);
  return SM::Manifold_map<typename Surface::Atlas>(points, triangles, grid.domain_points(), points.size());
}

// What a report holds, read the way a browser does.
struct Report {
  nlohmann::json info;
  std::string bytes;

  explicit Report(const std::string& text) : info(nlohmann::json::parse(element(text, "info")))
  {
    std::string packed;
    unsigned group = 0;
    int bits = 0;
    for (char c : element(text, "arrays")) {
      const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      if (c == '=') break;
      group = group << 6 | unsigned(std::strchr(digits, c) - digits);
      if ((bits += 6) < 8) continue;
      bits -= 8;
      packed += char(group >> bits & 255);
    }
    for (const auto& a : info["arrays"])
      bytes.resize(bytes.size() + a["size"].get<std::size_t>() * a["components"].get<std::size_t>() *
                                    (a["type"] == "i16" ? 2 : 4));
    uLongf size = uLongf(bytes.size());
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(&bytes[0]), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), uLong(packed.size())) == Z_OK);
    REQUIRE(size == bytes.size());
  }

  static std::string element(const std::string& text, const std::string& id)
  {
    const std::size_t first = text.find('>', text.find("<script id=\"" + id + "\"")) + 1;
    return text.substr(first, text.find("</script>", first) - first);
  }

  template <class T>
  std::vector<T> array(const std::string& name) const
  {
    const auto& a = info["arrays"].at(name);
    const std::size_t n = a["size"], components = a["components"], first = a["first"];
    const std::size_t width = components * sizeof(T);
    std::vector<T> items(n * components);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < width; ++k)
        reinterpret_cast<char*>(items.data())[i * width + k] = bytes[first + k * n + i];
    return items;
  }

  std::vector<int> indices(const std::string& name) const
  {
    std::vector<int> items;
    int index = 0;
    for (const unsigned coded : array<std::uint32_t>(name))
      items.push_back(index += coded % 2 ? -int(coded / 2) - 1 : int(coded / 2));
    return items;
  }
};

double largest_difference(const std::vector<float>& values, double truth)
{
  double largest = 0;
  for (double x : values) largest = (std::max)(largest, std::abs(x - truth));
  return largest;
}

} // namespace

TEST_CASE("a report holds the mesh, the surface and their geometry")
{
  const auto sphere = ellipsoid(Eigen::Vector3d(2, 2, 2));
  const auto map = map_of(sphere, 8);
  const Temporary_folder folder;
  const nlohmann::ordered_json figures = {{"input", {{"file", "</script><b>"}}}};
  SM::write_report(folder("r.html"), map, sphere, SM::Fit_report(), figures, page);
  const std::string text = folder.read("r.html");
  CHECK(text.find("</script><b>") == std::string::npos); // no text can end the element that it is in
  const Report report(text);
  CHECK(report.info["figures"] == nlohmann::json(figures));
  CHECK(report.info["atlas"]["name"] == "sphere");
  CHECK(report.info["atlas"]["charts"].size() == 6);
  CHECK(report.info["atlas"]["shapes"][0]["title"] == "unit sphere");

  // What is drawn of the mesh is on it, at the domain points whose places on the unit sphere are given.
  const auto points = report.array<float>("mesh.points"), places = report.array<float>("mesh.shape0");
  const auto errors = report.array<float>("mesh.error");
  const double diagonal = map.diagonal();
  const auto point = [&](int v) -> Eigen::Vector3d {
    const auto& c = report.info["centre"];
    return Eigen::Vector3d(points[3 * v], points[3 * v + 1], points[3 * v + 2]) * diagonal +
           Eigen::Vector3d(c[0], c[1], c[2]);
  };
  double off = 0, wrong_error = 0;
  for (int v = 0; v < int(errors.size()); ++v) {
    const auto p = Eigen::Vector3d(places[3 * v], places[3 * v + 1], places[3 * v + 2]).normalized();
    off = (std::max)(off, (point(v) - map.position(map.to_mesh(p))).norm());
    wrong_error = (std::max)(wrong_error, std::abs(errors[v] - (point(v) - 2 * p).norm() / diagonal));
  }
  CHECK(off < 3e-5);
  CHECK(wrong_error < 2e-5);

  // The pieces of a face have its area, its orientation and its border.
  const auto triangles = report.indices("mesh.triangles"), faces = report.indices("mesh.faces");
  const auto edges = report.array<std::int16_t>("mesh.edges");
  REQUIRE(faces.size() > map.number_of_faces());
  std::vector<Eigen::Vector3d> area(map.number_of_faces(), Eigen::Vector3d::Zero());
  std::vector<double> border(map.number_of_faces(), 0);
  for (std::size_t t = 0; t < faces.size(); ++t) {
    Eigen::Vector3d x[3];
    for (int k = 0; k < 3; ++k) x[k] = point(triangles[3 * t + k]);
    area[faces[t]] += (x[1] - x[0]).cross(x[2] - x[0]);
    for (int k = 0; k < 3; ++k)
      if (edges[t] >> k & 1) border[faces[t]] += (x[(k + 1) % 3] - x[(k + 2) % 3]).norm();
  }
  double wrong_area = 0, wrong_border = 0;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    const SM::Triangle& t = map.face(f);
    const Eigen::Vector3d u = map.point(t[1]) - map.point(t[0]), v = map.point(t[2]) - map.point(t[0]);
    wrong_area = (std::max)(wrong_area, (area[f] - u.cross(v)).norm());
    wrong_border = (std::max)(wrong_border, std::abs(border[f] - u.norm() - v.norm() - (u - v).norm()));
  }
  CHECK(wrong_area < 1e-4);
  CHECK(wrong_border < 1e-3);

  // The surface is the sphere of radius 2.
  CHECK(largest_difference(report.array<float>("surface.mean"), diagonal / 2) < 1e-3 * diagonal);
  const double square = diagonal * diagonal;
  CHECK(largest_difference(report.array<float>("surface.gauss"), square / 4) < 1e-3 * square);
  const auto error = report.array<float>("surface.error");
  CHECK(*std::max_element(error.begin(), error.end()) > 1e-4); // between the vertices the mesh is flat
  const auto normals = report.array<std::int16_t>("surface.normals");
  const auto charts = report.array<std::int16_t>("surface.charts");
  const auto uv = report.array<float>("surface.coordinates");
  double angle = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const Eigen::Vector3d p = map.atlas().point({charts[i], {uv[2 * i], uv[2 * i + 1]}});
    for (int k = 0; k < 3; ++k) angle = (std::max)(angle, std::abs(normals[3 * i + k] / 32767. - p[k]));
  }
  CHECK(angle < 1e-4);
}

TEST_CASE("a report draws a surface within half the tolerance and says how far its triangles are")
{
  const auto sphere = ellipsoid(Eigen::Vector3d(2, 2, 2));
  const auto map = map_of(sphere, 8);
  const Temporary_folder folder;
  const auto figures = nlohmann::ordered_json::object();
  std::size_t triangles = 0;
  for (const double tolerance : {1e-3, 2e-4, 1e-6}) { // the last needs more triangles than a page has
    SM::Fit_report fit;
    fit.rms_tolerance = tolerance;
    SM::write_report(folder("r.html"), map, sphere, fit, figures, page);
    const Report report(folder.read("r.html"));
    const double said = report.info["fit"]["chord_error"];
    CHECK(said > tolerance / 100);
    CHECK((said <= tolerance / 2) == (tolerance > 1e-6));
    const auto points = report.array<float>("surface.points");
    const auto corners = report.indices("surface.triangles");
    double lowest = 1;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) centre[i] += points[3 * std::size_t(corners[t + k]) + i] / 3;
      lowest = (std::min)(lowest, centre.norm());
    }
    CHECK(2 / map.diagonal() - lowest < said + 1e-6);
    CHECK(corners.size() > 2 * triangles);
    CHECK(corners.size() <= 300000);
    triangles = corners.size();
  }
}

TEST_CASE("a report says where the error is largest and where the surface turns over")
{
  const auto torus = map_of(ring(3, 1), 6);
  SM::Fit_report fit;
  fit.max_error = 0.1;
  fit.worst_point = torus.point(17) + Eigen::Vector3d(1e-6, 0, 0);
  fit.folds = 30;
  fit.fold_places = {{5, Eigen::Vector3d::Zero()}, {60, Eigen::Vector3d::Zero()}};
  const Temporary_folder folder;
  SM::write_report(folder("r.html"), torus, ring(3, 1), fit, nlohmann::ordered_json::object(), page);
  const nlohmann::json found = Report(folder.read("r.html")).info["fit"];
  CHECK(found["folds"] == 30);
  const auto& atlas = torus.atlas();
  const auto point = [&](std::size_t k) {
    const auto& place = found["places"].at(k);
    const int chart = place["chart"];
    const double u = place["uv"][0], v = place["uv"][1];
    const auto p = atlas.point({chart, {u, v}});
    CHECK(atlas.tile(p) == chart);
    return torus.position(torus.to_mesh(p));
  };
  REQUIRE(found["places"].size() == 3);
  CHECK(found["places"][0]["kind"] == "worst");
  CHECK((point(0) - torus.point(17)).norm() < 1e-5);
  for (const std::size_t k : {1, 2}) {
    CHECK(found["places"][k]["kind"] == "fold");
    const SM::Triangle& t = torus.face(std::size_t(fit.fold_places[k - 1].face));
    CHECK((point(k) - (torus.point(t[0]) + torus.point(t[1]) + torus.point(t[2])) / 3).norm() < 1e-5);
  }
}

TEST_CASE("a report of a map alone has no surface; a page without a place for the data is refused")
{
  const auto map = map_of(ring(3, 1), 2);
  const Temporary_folder folder;
  const auto figures = nlohmann::ordered_json::object();
  SM::write_report(folder("r.html"), map, figures, page);
  const Report report(folder.read("r.html"));
  CHECK(report.info["arrays"].contains("mesh.angle"));
  CHECK_FALSE(report.info["arrays"].contains("mesh.error"));
  CHECK_FALSE(report.info["arrays"].contains("surface.points"));
  CHECK_FALSE(report.info.contains("fit"));
  CHECK_THROWS_AS(SM::write_report(folder("s.html"), map, figures, "<html>"), SM::IO_error);
  CHECK(folder.entries() == std::vector<std::string>{"r.html"});
}

TEST_CASE("a report of components holds each with its figures, and the errors of the others")
{
  const auto sphere = map_of(ellipsoid(Eigen::Vector3d(1, 2, 3)), 8);
  const auto torus = map_of(ring(3, 1), 8);
  std::vector<SM::Component<SM::Any_map>> maps;
  const auto component = [](const char* name) { return SM::Mesh_component{name, {}, {}}; };
  maps.emplace_back(component("egg"), SM::Any_map(sphere));
  maps.emplace_back(component("knot"), SM::Error(SM::Error_code::wrong_genus, "genus 2"));
  maps.emplace_back(component("ring"), SM::Any_map(torus));
  const nlohmann::ordered_json figures = {{"input", {{"file", "a"}}},
                                          {"parts", {{{"x", 1}}, {{"x", 2}}, {{"x", 3}}}}};
  const Temporary_folder folder;
  SM::write_report(folder("m.html"), maps, figures, page);
  const Report report(folder.read("m.html"));
  const nlohmann::json& parts = report.info["parts"];
  REQUIRE(parts.size() == 3);
  CHECK(report.info["figures"] == nlohmann::json({{"input", {{"file", "a"}}}}));
  CHECK(parts[0]["name"] == "egg");
  CHECK(parts[0]["atlas"]["name"] == "sphere");
  CHECK(parts[1] == nlohmann::json({{"name", "knot"}, {"error", "genus 2"}}));
  CHECK(parts[2]["atlas"]["name"] == "torus");
  CHECK(parts[2]["figures"]["x"] == 3);
  CHECK(report.array<float>("0.mesh.angle").size() == sphere.number_of_faces());
  CHECK(report.array<float>("2.mesh.angle").size() == torus.number_of_faces());

  // A surface of one of them, and why the other has none.
  SM::Component_surfaces<> surfaces;
  std::vector<SM::Fit_report> reports(3);
  surfaces.emplace_back(component("egg"), SM::Error(SM::Error_code::numeric_failure, "no surface"));
  surfaces.emplace_back(component("knot"), SM::Error(SM::Error_code::wrong_genus, "genus 2"));
  surfaces.emplace_back(component("ring"),
                        SM::Any_surface<>(SM::fit_surface(
                          torus, SM::parameters::rms_error(0.05).fit_report(std::ref(reports[2])))));
  SM::write_report(folder("s.html"), maps, surfaces, reports, figures, page);
  const Report fitted(folder.read("s.html"));
  CHECK(fitted.info["parts"][0]["error"] == "no surface");
  CHECK(fitted.info["parts"][0]["atlas"]["name"] == "sphere");
  CHECK_FALSE(fitted.info["parts"][0].contains("fit"));
  CHECK(fitted.info["parts"][2]["fit"]["rms_tolerance"] == 0.05);
  CHECK(fitted.info["arrays"].contains("2.surface.points"));
  CHECK_FALSE(fitted.info["arrays"].contains("0.surface.points"));
}

TEMPLATE_TEST_CASE("a face is drawn in pieces that are short, lie in one tile each and make the whole", "",
                   SM::Sphere_atlas, SM::Torus_atlas, SM::Plane_atlas)
{
  const TestType atlas;
  using Domain_point = typename TestType::Domain_point;
  std::vector<Domain_point> p; // on the sphere and the torus round a point where three or four tiles meet
  if constexpr (std::is_same_v<TestType, SM::Sphere_atlas>)
    p = {Domain_point(1, 0.2, 0.1).normalized(), Domain_point(0.1, 1, 0.3).normalized(),
         Domain_point(0.2, 0.1, 1).normalized()};
  else
    p = {Domain_point(0.4, 0.45), Domain_point(0.7, 0.42), Domain_point(0.51, 0.8)};
  double area = 0, wrong_area = 0, length = 0, longest = 0;
  bool is_turned_over = false;
  const SM::internal::Tile_cutter<TestType> cut(atlas);
  std::vector<int> tiles;
  cut(p[0], p[1], p[2], [&](const auto& piece) {
    const auto& c = piece.corners;
    Eigen::Matrix3d weights;
    for (int k = 0; k < 3; ++k) weights.col(k) = c[k].weights;
    area += weights.determinant();
    is_turned_over = is_turned_over || !(weights.determinant() > -1e-12);
    const Domain_point centre = atlas.interpolate(p[0], p[1], p[2], weights.rowwise().mean());
    if (atlas.tile(centre) != piece.tile) wrong_area += weights.determinant();
    for (int k = 0; k < 3; ++k) {
      const auto &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      REQUIRE(atlas.contains(piece.tile, a.point));
      longest = (std::max)(
        longest, (atlas.coordinates(piece.tile, a.point) - atlas.coordinates(piece.tile, b.point)).norm());
      if (piece.is_edge[k]) length += (a.weights - b.weights).norm();
    }
    tiles.push_back(piece.tile);
  });
  CHECK(area == Approx(1));
  CHECK(length == Approx(3 * std::sqrt(2.))); // of the three sides, in barycentric coordinates
  CHECK(longest < 0.1);
  CHECK_FALSE(is_turned_over);
  CHECK(wrong_area < 1e-4);
  std::sort(tiles.begin(), tiles.end());
  const auto n = std::unique(tiles.begin(), tiles.end()) - tiles.begin();
  CHECK(n == (std::is_same_v<TestType, SM::Sphere_atlas>  ? 3
              : std::is_same_v<TestType, SM::Torus_atlas> ? 4
                                                          : 1));
}

TEST_CASE("distortions of faces have the means of the map's distortion")
{
  const auto map = map_of(ring(3, 1), 4);
  const auto d = SM::internal::face_distortions(map);
  const SM::Distortion whole = SM::distortion(map);
  double area = 0, angle = 0, log_area = 0;
  for (std::size_t f = 0; f < map.number_of_faces(); ++f) {
    const SM::Triangle& t = map.face(f);
    const double a = (map.point(t[1]) - map.point(t[0])).cross(map.point(t[2]) - map.point(t[0])).norm();
    area += a;
    angle += a * d.angle[f];
    log_area += a * std::abs(d.log10_area[f]);
  }
  CHECK(angle / area == Approx(whole.angle_mean).epsilon(1e-12));
  CHECK(log_area / area == Approx(whole.area_mean_abs_log10).epsilon(1e-12));
}

TEMPLATE_TEST_CASE("a simplified map is a map: one to one, of vertices of the first", "", SM::Sphere_atlas,
                   SM::Torus_atlas, SM::Plane_atlas)
{
  const auto simplify = [](const auto& map) {
    using Map = std::decay_t<decltype(map)>;
    const std::size_t wanted = map.number_of_faces() / 3;
    const SM::internal::Map_simplification<Map> s(map, wanted);
    CHECK(s.faces.size() <= wanted + 2);
    CHECK(s.faces.size() > wanted / 2);
    std::vector<Eigen::Vector3d> points;
    std::vector<typename Map::Domain_point> domain_points;
    for (int v : s.vertices) {
      points.push_back(map.point(v));
      domain_points.push_back(map.domain_point(v));
    }
    const Map simplified(points, s.faces, domain_points, points.size()); // certifies
    CHECK(simplified.certificate().is_valid());
  };
  if constexpr (std::is_same_v<TestType, SM::Sphere_atlas>)
    simplify(map_of(ellipsoid(Eigen::Vector3d(1, 2, 3)), 10));
  else if constexpr (std::is_same_v<TestType, SM::Torus_atlas>)
    simplify(map_of(ring(3, 1), 8));
  else {
    const SM::Tile_grid<SM::Plane_atlas> grid(20);
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : grid.domain_points()) points.emplace_back(p.x(), p.y(), std::sin(5 * p.x() * p.y()));
    simplify(SM::Manifold_map<SM::Plane_atlas>(points, SM::triangulate(grid, points), grid.domain_points(),
                                               points.size()));
  }
}

TEST_CASE("control cells of a linear spline of any level lie on it")
{
  // The coefficients of a linear function are its values at the Greville points.
  const int degree = 3, cells = 4, side = cells + degree;
  const auto linear = [](double u, double v) { return Eigen::Vector3d(2 * u - v, u + 3 * v, 1 - u); };
  const SM::Hierarchical_embedding::Level fine{2 * cells, {3 * (2 * cells + degree) + 4}, {{0, 0, 0}}};
  SM::Hierarchical_embedding::Level coarse{cells, {}, {}};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      coarse.indices.push_back(i * side + j);
      coarse.coefficients.push_back(linear((i - 1.) / cells, (j - 1.) / cells));
    }
  const SM::Hierarchical_embedding e(degree, {coarse, fine}); // `fine` divides leaves and adds nothing
  std::size_t count = 0;
  double largest = 0, area = 0;
  using SM::internal::Chart_box;
  SM::internal::for_each_control_cell(e, [&](const Chart_box& box, const auto& control, int d) {
    REQUIRE(d == degree);
    ++count;
    area += box.volume();
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const double u = i ? box.max().x() : box.min().x(), v = j ? box.max().y() : box.min().y();
        largest = (std::max)(largest, (control(1 + i, 1 + j) - linear(u, v)).norm());
      }
  });
  CHECK(count == e.number_of_leaves());
  CHECK(count > std::size_t(cells * cells));
  CHECK(area == Approx(1));
  CHECK(largest < 1e-14);

  const SM::Manifold_surface<SM::Plane_atlas> surface({e});
  std::vector<int> charts;
  CHECK(SM::internal::control_cells(surface, charts).size() == 4 * count);
  CHECK(charts == std::vector<int>(count, 0));
}

TEST_CASE("a report shows surfaces over an atlas of one's own, as its charts")
{
  const Temporary_folder folder;
  const auto m = sample::torus_grid(48, 30, {0.01, 0.02});
  const archetype::Atlas atlas(std::array<int, 2>{{8, 5}});
  const SM::Manifold_map<archetype::Atlas> map(m.points, m.faces, m.domain_points, m.points.size(), 0,
                                               SM::Input_indices(), atlas);
  SM::Fit_report fit;
  const auto surface = SM::fit_surface(map, SM::parameters::rms_error(0.01).fit_report(std::ref(fit)));
  SM::write_report(folder("r.html"), map, surface, fit, nlohmann::ordered_json::object(), page);
  const Report report(folder.read("r.html"));
  const nlohmann::json& facts = report.info["atlas"];
  CHECK(facts["name"] == "archetype");
  CHECK(facts["charts"].size() == 40);
  CHECK(facts["shapes"].size() == 1);
}

} // namespace test_write_report
