#include "catch.h"

#include "short_of_memory.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/surface_io.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>

#include <cmath>
#include <new>

namespace test_surface_io {

namespace SM = CGAL::Simple_manifolds;
using SM::Error_code;

namespace {

Eigen::Vector3d some_vector(int k) { return {std::sin(k), std::cos(7 * k) / 3, 1e-17 * k + k}; }

// A dense patch and a sparse one in each chart.
template <class Atlas, class Bump = SM::Smoothstep_bump<2>>
auto some_surface(int degree = 3)
{
  int k = 0;
  std::vector<SM::Patch_stack_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    const int nu = degree + 1 + c, nv = degree + 2;
    std::vector<Eigen::Vector3d> dense(nu * nv), sparse(2);
    for (auto& x : dense) x = some_vector(++k);
    for (auto& x : sparse) x = some_vector(++k);
    charts.emplace_back(std::vector<SM::Spline_patch>{
      SM::Spline_patch({0, 0, 1, 1}, degree, nu, nv, dense),
      SM::Spline_patch({0.1, 0.2, 0.7, 1}, degree, nu, nv, sparse, {nv + 1, 2})});
  }
  return SM::Manifold_surface<Atlas, SM::Patch_stack_embedding, Bump>(charts);
}

template <class Atlas>
SM::Manifold_surface<Atlas> hierarchical_surface()
{
  std::vector<SM::Hierarchical_embedding> charts;
  for (int c = 0; c < Atlas::number_of_charts(); ++c) {
    using Level = SM::Hierarchical_embedding::Level;
    Level base = {4, {}, {}}, fine = {16, {3, 5, 40 + c}, {}};
    for (int i = 0; i < 49; ++i) base.indices.push_back(i);
    for (int i = 0; i < 49; ++i) base.coefficients.push_back(some_vector(100 * c + i));
    for (int i = 0; i < 3; ++i) fine.coefficients.push_back(some_vector(100 * c + 60 + i));
    charts.emplace_back(3, std::vector<Level>{base, {8, {}, {}}, fine, {32, {}, {}}});
  }
  return SM::Manifold_surface<Atlas>(charts);
}

template <class Surface>
bool same_surface(const Surface& a, const Surface& b)
{
  for (int c = 0; c < Surface::Atlas::number_of_charts(); ++c) {
    const auto &p = a.chart_embedding(c).patches(), &q = b.chart_embedding(c).patches();
    if (p.size() != q.size()) return false;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i].support() != q[i].support() || p[i].degree() != q[i].degree() || p[i].nu() != q[i].nu() ||
          p[i].nv() != q[i].nv() || p[i].indices() != q[i].indices() ||
          p[i].coefficients() != q[i].coefficients())
        return false;
  }
  return true;
}

using Plane = SM::Manifold_surface<SM::Plane_atlas, SM::Patch_stack_embedding>;

} // namespace

TEMPLATE_TEST_CASE("surfaces read back bit for bit", "", SM::Plane_atlas, SM::Sphere_atlas, SM::Torus_atlas)
{
  const Temporary_folder folder;
  const auto surface = some_surface<TestType>();
  SM::write_surface(folder("s.json"), surface);
  using Surface = std::decay_t<decltype(surface)>;
  CHECK(same_surface(SM::read_surface<Surface>(folder("s.json")), surface));
  const auto any = SM::read_any_surface<SM::Smoothstep_bump<2>, SM::Patch_stack_embedding>(folder("s.json"));
  REQUIRE(std::holds_alternative<Surface>(any));
  CHECK(same_surface(std::get<Surface>(any), surface));
  CHECK(folder.entries() == std::vector<std::string>{"s.json"});
}

TEST_CASE("atlas, bump and degree are written and must agree")
{
  const Temporary_folder folder;
  const std::string file = folder("s.json");
  const auto surface = some_surface<SM::Torus_atlas, SM::Bspline_bump<3>>(4);
  SM::write_surface(file, surface);
  const SM::Surface_header header = SM::read_surface_header(file);
  CHECK(header.atlas == "torus");
  CHECK(header.bump == "bspline");
  CHECK(header.smoothness == 3);
  CHECK(header.degree == 4);
  CHECK(header.tolerance == 0);
  CHECK(same_surface(SM::read_surface<std::decay_t<decltype(surface)>>(file), surface));
  using Stack = SM::Patch_stack_embedding;
  CHECK_THROWS_AS((SM::read_surface<SM::Manifold_surface<SM::Torus_atlas, Stack>>(file)), SM::IO_error);
  CHECK_THROWS_AS((SM::read_any_surface<SM::Smoothstep_bump<2>, Stack>(file)), SM::IO_error);
  CHECK_NOTHROW((SM::read_any_surface<SM::Bspline_bump<3>, Stack>(file)));
  using Wrong_atlas = SM::Manifold_surface<SM::Sphere_atlas, SM::Patch_stack_embedding, SM::Bspline_bump<3>>;
  CHECK_THROWS_AS(SM::read_surface<Wrong_atlas>(file), SM::IO_error);
}

TEST_CASE("a file says what its surface was fitted to, if it is told")
{
  const Temporary_folder folder;
  const auto surface = some_surface<SM::Torus_atlas>();
  for (const char* name : {"s.json", "s.cbor"}) {
    SM::write_surface(folder(name), surface, SM::parameters::rms_error(3e-4));
    CHECK(SM::read_surface_header(folder(name)).tolerance == 3e-4);
    CHECK(same_surface(SM::read_surface<std::decay_t<decltype(surface)>>(folder(name)), surface));
  }
}

TEST_CASE("a surface is read without knowing its smoothness, and written again")
{
  const Temporary_folder folder;
  using Atlas = SM::Plane_atlas;
  using Any = SM::Manifold_surface<Atlas, SM::Patch_stack_embedding, SM::Any_smoothstep_bump>;
  const std::string file = folder("c3.json"), copy = folder("copy.json");
  SM::write_surface(file, some_surface<Atlas, SM::Smoothstep_bump<3>>());
  const auto any = SM::read_surface<Any>(file);
  CHECK(any.bump().smoothness == 3);
  SM::write_surface(copy, any);
  CHECK(folder.read("copy.json") == folder.read("c3.json"));
  SM::write_surface(file, some_surface<Atlas, SM::Smoothstep_bump<5>>()); // more than it can
  CHECK_THROWS_AS(SM::read_surface<Any>(file), SM::IO_error);
}

TEMPLATE_TEST_CASE("hierarchical surfaces read back bit for bit", "", SM::Plane_atlas, SM::Sphere_atlas,
                   SM::Torus_atlas)
{
  const Temporary_folder folder;
  const std::string file = folder("s.json"), again = folder("again.json");
  const auto surface = hierarchical_surface<TestType>();
  using Surface = std::decay_t<decltype(surface)>;
  SM::write_surface(file, surface);
  const Surface copy = SM::read_surface<Surface>(file);
  for (int c = 0; c < TestType::number_of_charts(); ++c) {
    const auto &a = surface.chart_embedding(c), &b = copy.chart_embedding(c);
    CHECK(a.degree() == b.degree());
    REQUIRE(a.levels().size() == b.levels().size());
    for (std::size_t k = 0; k < a.levels().size(); ++k) {
      CHECK(a.levels()[k].cells == b.levels()[k].cells);
      CHECK(a.levels()[k].indices == b.levels()[k].indices);
      CHECK(a.levels()[k].coefficients == b.levels()[k].coefficients);
    }
    using Io = SM::internal::Embedding_io<SM::Hierarchical_embedding>;
    CHECK(Io::number_of_leaves(a.degree(), a.levels()) == a.number_of_leaves());
  }
  SM::write_surface(again, copy);
  CHECK(folder.read("again.json") == folder.read("s.json"));
  CHECK(std::holds_alternative<Surface>(SM::read_any_surface(file)));

  // the same in binary, which says the same everywhere
  SM::write_surface(folder("s.cbor"), surface);
  CHECK(folder.read("s.cbor").size() < folder.read("s.json").size());
  const Surface binary = SM::read_surface<Surface>(folder("s.cbor"));
  SM::write_surface(again, binary);
  CHECK(folder.read("again.json") == folder.read("s.json"));
  int different = 0;
  for (const auto& p : SM::random_domain_points<TestType>(10000)) {
    const SM::Jet a = surface.jet(p), b = binary.jet(p);
    different +=
      a.value != b.value || a.u != b.u || a.v != b.v || a.uu != b.uu || a.uv != b.uv || a.vv != b.vv;
  }
  CHECK(different == 0);

  // the same function as a stack of patches
  using Stack = SM::Manifold_surface<TestType, SM::Patch_stack_embedding>;
  const Stack stack = SM::read_surface<Stack>(file);
  for (const auto& uv : {Eigen::Vector2d(.1, .2), Eigen::Vector2d(.7, .5), Eigen::Vector2d(1, .01)})
    CHECK((stack.chart_embedding(0).point(uv) - surface.chart_embedding(0).point(uv)).norm() < 1e-13);
}

TEST_CASE("only grids of the whole square, each twice as fine as another, are a hierarchy")
{
  const Temporary_folder folder;
  using Hierarchical = SM::Manifold_surface<SM::Plane_atlas>;
  const auto patch = [](const std::string& support, int controls, const std::string& functions) {
    const std::string n = std::to_string(controls);
    return R"({"support":)" + support + R"(,"controls":[)" + n + "," + n + "]," + functions + "}";
  };
  const auto read = [&](const std::string& patches) {
    return SM::read_surface<Hierarchical>(
      folder.write("s.json",
                   R"({"format":"simple_manifolds_surface","version":1,"atlas":"plane",
      "bump":{"type":"smoothstep","smoothness":2},"degree":1,"charts":[{"patches":[)" +
                     patches + "]}]}"));
  };
  const auto message = [&](const std::string& patches) {
    try {
      read(patches);
    } catch (const SM::IO_error& e) {
      CHECK(e.code() == Error_code::syntax_error);
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  const std::string all = "[0,0,1,1]", one = R"("indices":[1],"coefficients":[[1,2,3]])",
                    base = patch(all, 2, R"("coefficients":[[0,0,0],[0,1,0],[1,0,0],[1,1,4]])");
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(message(base + "," + patch("[0,0,1,0.5]", 3, one)), ContainsSubstring("charts[0].patches[1]"));
  CHECK_THAT(message(base + "," + patch(all, 4, one)), ContainsSubstring("patches[1].controls: 3 cells"));
  CHECK_THAT(message(base + "," + patch(all, 45001, one)), ContainsSubstring("power of 2"));
  CHECK_THAT(message(base + "," + patch(all, 1 << 20, one)), ContainsSubstring("from 2 to"));
  CHECK_THAT(message(patch(all, 40001, one)), ContainsSubstring("the coarsest grid has 40000 cells"));

  // in any order, with gaps; patches of one grid add up; a fine grid needs no memory for what is not active
  const Hierarchical e = read(patch(all, 5, one) + "," + base + "," + patch(all, 5, one) + "," +
                              patch(all, 32769, R"("indices":[],"coefficients":[])"));
  REQUIRE(e.chart_embedding(0).levels().size() == 16);
  CHECK(e.chart_embedding(0).levels()[1].indices.empty());
  CHECK(e.chart_embedding(0).levels()[2].indices == std::vector<int>{1});
  CHECK(e.chart_embedding(0).number_of_leaves() == 7);
  CHECK((e.point(Eigen::Vector2d(0, .25)) - Eigen::Vector3d(2, 4.25, 6)).norm() < 1e-15);
}

TEST_CASE("a file by hand is read")
{
  const Temporary_folder folder;
  const std::string file =
    folder.write("s.json", R"({"format":"simple_manifolds_surface","version":1,"atlas":"plane",
    "bump":{"type":"smoothstep","smoothness":2},"degree":1,"charts":[{"patches":[{"support":[0,0,1,1],
    "controls":[2,2],"coefficients":[[0,0,0],[0,1,0],[1,0,0],[1,1,4]]}]}]})");
  const Plane plane = SM::read_surface<Plane>(file);
  CHECK((plane.point(Eigen::Vector2d(0.5, 0.25)) - Eigen::Vector3d(0.5, 0.25, 0.5)).norm() < 1e-15);
}

TEST_CASE("damaged files are refused with the place of the damage")
{
  const Temporary_folder folder;
  const auto plane = some_surface<SM::Plane_atlas>();
  SM::write_surface(folder("good.json"), plane);
  const nlohmann::json good = nlohmann::json::parse(folder.read("good.json"));
  const auto message = [&](const std::string& text) {
    const std::string file = folder.write("bad.json", text);
    try {
      SM::read_surface<Plane>(file);
    } catch (const SM::IO_error& e) {
      CHECK(e.code() == Error_code::syntax_error);
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  const auto changed = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json j = good;
    j[nlohmann::json::json_pointer(pointer)] = value;
    return message(j.dump());
  };
  using Catch::Matchers::ContainsSubstring;
  const std::string patch = "/charts/0/patches/0/", sparse = "/charts/0/patches/1/";
  CHECK(message(good.dump()) == "accepted");
  CHECK_THAT(message(""), ContainsSubstring("empty"));
  CHECK_THAT(message("{}\n{"), ContainsSubstring("line 2"));
  CHECK_THAT(message("[]"), ContainsSubstring("no surface"));
  CHECK_THAT(message("7"), ContainsSubstring("no surface"));
  CHECK_THAT(message(std::string(100000, '[')), ContainsSubstring("no valid JSON"));
  CHECK_THAT(message("{\"format\":1e999}"), ContainsSubstring("no valid JSON"));
  CHECK_THAT(changed("/format", "other"), ContainsSubstring("no surface"));
  CHECK_THAT(changed("/version", 2), ContainsSubstring("version"));
  CHECK_THAT(changed("/atlas", "sphere"), ContainsSubstring("atlas"));
  CHECK_THAT(changed("/bump/type", "boxcar"), ContainsSubstring("bump"));
  CHECK_THAT(changed("/bump/smoothness", 3), ContainsSubstring("bump"));
  CHECK_THAT(changed("/degree", 0), ContainsSubstring("degree"));
  CHECK_THAT(changed("/degree", 2.5), ContainsSubstring("degree"));
  CHECK_THAT(changed("/degree", 99), ContainsSubstring("degree"));
  CHECK_THAT(changed("/tolerance", -1e-3), ContainsSubstring("tolerance"));
  CHECK_THAT(changed("/tolerance", "fine"), ContainsSubstring("tolerance"));
  CHECK_THAT(changed("/charts", nlohmann::json::array()), ContainsSubstring("charts: 1 entries"));
  CHECK_THAT(changed("/charts", 4), ContainsSubstring("array"));
  CHECK_THAT(changed("/charts/0/patches", nlohmann::json::array()), ContainsSubstring("patch"));
  CHECK_THAT(changed((patch + "support").c_str(), {0, 0, 1}),
             ContainsSubstring("charts[0].patches[0].support"));
  CHECK_THAT(changed((patch + "support").c_str(), {0, 1, 1, 0}), ContainsSubstring("empty"));
  CHECK_THAT(changed((patch + "support/0").c_str(), nullptr), ContainsSubstring("number"));
  CHECK_THAT(changed((patch + "controls").c_str(), {3, 5}), ContainsSubstring("controls[0]"));
  CHECK_THAT(changed((patch + "controls").c_str(), {100000, 100000}), ContainsSubstring("controls[1]"));
  CHECK_THAT(changed((patch + "controls/0").c_str(), 18446744073709551615u),
             ContainsSubstring("controls[0]"));
  CHECK_THAT(changed((patch + "controls/0").c_str(), 5), ContainsSubstring("25 entries"));
  CHECK_THAT(changed((patch + "coefficients/3").c_str(), {1, 2}), ContainsSubstring("coefficients[3]"));
  CHECK_THAT(changed((patch + "coefficients/3/1").c_str(), "x"), ContainsSubstring("coefficients[3][1]"));
  CHECK_THAT(changed((sparse + "indices").c_str(), {1, 1}), ContainsSubstring("twice"));
  CHECK_THAT(changed((sparse + "indices").c_str(), {1, 20}), ContainsSubstring("from 0 to 19"));
  CHECK_THAT(changed((sparse + "indices").c_str(), {1, -1}), ContainsSubstring("indices[1]"));
  CHECK_THAT(changed((sparse + "indices").c_str(), {1, 2, 3}), ContainsSubstring("3 entries"));
  nlohmann::json j = good;
  j.erase("bump");
  CHECK_THAT(message(j.dump()), ContainsSubstring("\"bump\" is missing"));
}

TEST_CASE("damaged CBOR is refused, whatever the damage")
{
  const Temporary_folder folder;
  SM::write_surface(folder("good.cbor"), some_surface<SM::Plane_atlas>());
  const std::string good = folder.read("good.cbor");
  const auto message = [&](const std::string& bytes) {
    const std::string file = folder.write("bad.cbor", bytes);
    try {
      SM::read_surface<Plane>(file);
    } catch (const SM::IO_error& e) {
      CHECK(e.code() == Error_code::syntax_error);
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  using Catch::Matchers::ContainsSubstring;
  CHECK(message(good) == "accepted");
  int accepted = 0;
  for (std::size_t n = 0; n < good.size(); n += n < 300 ? 1 : 37)
    accepted += message(good.substr(0, n)) == "accepted";
  CHECK(accepted == 0);
  for (std::size_t k = 0; k < good.size(); k += 3) { // what is left may be a surface: it must not crash
    std::string changed = good;
    changed[k] = char(changed[k] ^ (1 << k % 8));
    message(changed);
  }
  const std::string key = "\xa1\x61x"; // an object with the key x
  CHECK_THAT(message(good + "x"), ContainsSubstring("behind the end"));
  CHECK_THAT(message(key + std::string(1000000, '\x81')), ContainsSubstring("too deeply"));
  CHECK_THAT(message(key + std::string(1000000, '\x7f')),
             ContainsSubstring("byte 4: an item without a length"));
  CHECK_THAT(message(key + "\xc1\x01"), ContainsSubstring("a tag"));
  CHECK_THAT(message(key + "\x9b\x7f\xff\xff\xff\xff\xff\xff\xff"), ContainsSubstring("announced"));
  CHECK_THAT(message(key + "\x7b\x7f\xff\xff\xff\xff\xff\xff\xff"), ContainsSubstring("too early"));
  CHECK_THAT(message("\xa0"), ContainsSubstring("no surface"));
  CHECK_THAT(message(key + "\xff"), ContainsSubstring("without a length"));
}

TEST_CASE("files are as nlohmann::json writes them")
{
  const Temporary_folder folder;
  const auto check = [&](const auto& surface) {
    SM::write_surface(folder("s.json"), surface);
    SM::write_surface(folder("s.cbor"), surface);
    const auto j = nlohmann::ordered_json::parse(folder.read("s.json"));
    const auto cbor = nlohmann::ordered_json::to_cbor(j);
    CHECK(folder.read("s.json") == j.dump() + '\n');
    CHECK(folder.read("s.cbor") == std::string(cbor.begin(), cbor.end()));
  };
  check(some_surface<SM::Plane_atlas>());
  check(hierarchical_surface<SM::Sphere_atlas>());
  const std::vector<Eigen::Vector3d> corners = {
    {0, -0., 1e-320}, {1e300, -5, 0.1}, {float(0.1), 1 << 20, 1e21}, {-1e-5, 123456789, 1 / 3.}};
  std::vector<Eigen::Vector3d> many(70000, Eigen::Vector3d(1, 2, 3)); // 24, 256 and 65536 are steps of CBOR
  check(Plane({SM::Patch_stack_embedding(
    {SM::Spline_patch({0, 0, 1, 1}, 1, 2, 2, corners), SM::Spline_patch({0, 0, 1, 1}, 1, 2, 35000, many),
     SM::Spline_patch({0, 0, 1, 1}, 1, 100, 300, {corners[0]}, {29999})})}));
}

TEST_CASE("where memory ends at any point, that is an exception, and files stay as they are")
{
  const Temporary_folder folder;
  const auto surface = hierarchical_surface<SM::Plane_atlas>();
  // Calls step() with ever more memory, until there is enough; returns how often there was not.
  const auto failures = [](const auto& step, const auto& check) {
    for (int n = 0;; ++n) {
      try {
        allocations_left = n;
        step();
        allocations_left = -1;
        return n;
      } catch (const std::bad_alloc&) {
        allocations_left = -1;
        check();
      }
    }
  };
  const auto nothing = [] {};
  for (const std::string name : {"s.json", "s.cbor"}) {
    const std::string file = folder.write(name, "old");
    int changed = 0;
    CHECK(failures([&] { SM::write_surface(file, surface); },
                   [&] { changed += folder.read(name) != "old"; }) > 100);
    CHECK(changed == 0);
    CHECK(failures([&] { SM::read_any_surface(file); }, nothing) > 100);
    CHECK(failures([&] { SM::read_surface_header(file); }, nothing) > 100);

    const auto read_damaged = [&] {
      try {
        SM::read_any_surface(file);
      } catch (const SM::IO_error&) {
        return;
      }
      CHECK(false); // it was accepted
    };
    const std::string good = folder.read(name), twice = R"({"a":[[1],[2]],"a":[3,{"b":4}]})";
    for (const std::string& bytes : {good.substr(0, good.size() / 2), twice}) {
      folder.write(name, bytes);
      CHECK(failures(read_damaged, nothing) > 10);
    }
  }
}

} // namespace test_surface_io
