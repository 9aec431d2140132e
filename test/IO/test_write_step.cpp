#include "IO/temporary_folder.h"
#include "catch.h"
#include "embedding/analytic_embeddings.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>

#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_write_step {

namespace SM = CGAL::Simple_manifolds;

namespace {

// What a STEP file says: the entities by their numbers, the texts of their arguments apart. Independent of the writer.
struct Step {
  struct Entity {
    std::string type; // empty: several types
    std::vector<std::string> arguments;
    std::string text;
  };
  std::map<long, Entity> entities;
  std::string header;

  explicit Step(const std::string& text)
  {
    const std::size_t data = text.find("DATA;\n"), end = text.find("ENDSEC;\nEND-ISO-10303-21;\n");
    REQUIRE(text.rfind("ISO-10303-21;\nHEADER;\n", 0) == 0);
    REQUIRE(data != std::string::npos);
    REQUIRE(end + 26 == text.size());
    header = text.substr(0, data);
    std::istringstream lines(text.substr(data + 6, end - data - 6));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t is = line.find('=');
      REQUIRE((line[0] == '#' && is != std::string::npos && line.substr(line.size() - 2) == ");"));
      const long number = std::stol(line.substr(1, is - 1));
      CHECK(entities.count(number) == 0);
      const std::string body = line.substr(is + 1, line.size() - is - 2);
      const std::size_t open = body.find('(');
      Entity e{body.substr(0, open), open == 0 ? std::vector<std::string>() : items(body.substr(open)), body};
      entities[number] = e;
    }
  }

  // The items of a list in brackets.
  static std::vector<std::string> items(const std::string& list)
  {
    std::vector<std::string> result(1);
    int depth = 0;
    bool is_text = false;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const char c = list[k];
      if (c == '\'') is_text = !is_text;
      if (!is_text && c == ')') --depth;
      if (!is_text && c == ',' && depth == 1)
        result.emplace_back();
      else if (depth >= 1)
        result.back() += c;
      if (!is_text && c == '(') ++depth;
    }
    CHECK(depth == 0);
    return result;
  }

  const Entity& at(const std::string& reference) const
  {
    REQUIRE(reference[0] == '#');
    return entities.at(std::stol(reference.substr(1)));
  }

  std::vector<long> of_type(const std::string& type) const
  {
    std::vector<long> list;
    for (const auto& [number, e] : entities)
      if (e.type == type) list.push_back(number);
    return list;
  }

  const Entity& one(const std::string& type) const
  {
    const std::vector<long> list = of_type(type);
    REQUIRE(list.size() == 1);
    return entities.at(list[0]);
  }

  // Every reference leads somewhere.
  void check_references() const
  {
    for (const auto& [number, e] : entities) {
      bool is_text = false;
      for (std::size_t k = 0; k < e.text.size(); ++k) {
        if (e.text[k] == '\'') is_text = !is_text;
        if (!is_text && e.text[k] == '#') CHECK(entities.count(std::stol(e.text.substr(k + 1))) == 1);
      }
    }
  }

  // As many knots as the controls need.
  void check_splines() const
  {
    const auto sum = [](const std::string& list) {
      int total = 0;
      for (const std::string& m : items(list)) total += std::stoi(m);
      return total;
    };
    for (const long n : of_type("B_SPLINE_SURFACE_WITH_KNOTS")) {
      const std::vector<std::string>& a = entities.at(n).arguments;
      const std::vector<std::string> rows = items(a[3]);
      CHECK(sum(a[8]) == int(rows.size()) + std::stoi(a[1]) + 1);
      CHECK(items(a[8]).size() == items(a[10]).size());
      for (const std::string& row : rows) CHECK(sum(a[9]) == int(items(row).size()) + std::stoi(a[2]) + 1);
    }
    for (const long n : of_type("B_SPLINE_CURVE_WITH_KNOTS")) {
      const std::vector<std::string>& a = entities.at(n).arguments;
      CHECK(sum(a[6]) == int(items(a[2]).size()) + std::stoi(a[1]) + 1);
    }
    for (const long n : of_type("CARTESIAN_POINT"))
      for (const std::string& x : items(entities.at(n).arguments[1])) CHECK(x.find('.') != std::string::npos);
  }

  // Loops are closed, and each edge is used `uses` times, in opposite directions.
  void check_borders(std::size_t uses) const
  {
    std::map<std::string, std::vector<std::string>> directions;
    for (const long n : of_type("EDGE_LOOP")) {
      std::vector<std::string> ends;
      for (const std::string& oriented : items(entities.at(n).arguments[1])) {
        const Entity& o = at(oriented);
        const Entity& edge = at(o.arguments[3]);
        directions[o.arguments[3]].push_back(o.arguments[4]);
        const bool is_forward = o.arguments[4] == ".T.";
        ends.push_back(edge.arguments[is_forward ? 1 : 2]);
        ends.push_back(edge.arguments[is_forward ? 2 : 1]);
      }
      for (std::size_t k = 1; k < ends.size(); k += 2) CHECK(ends[k] == ends[(k + 1) % ends.size()]);
    }
    for (const auto& [edge, list] : directions) {
      CHECK(list.size() <= 2);
      if (uses == 2) CHECK(list.size() == 2);
      if (list.size() == 2) CHECK(list[0] != list[1]);
    }
    CHECK(directions.size() == of_type("EDGE_CURVE").size());
  }
};

std::string written(const std::vector<SM::Step_body>& bodies, const SM::Step_options& options = {})
{
  const Temporary_folder folder;
  SM::write_step(folder("a.step"), bodies, options);
  return folder.read("a.step");
}

const SM::Cad_surface& solid()
{
  static const SM::Cad_surface c =
    SM::cad_surface(analytic::ellipsoid({1, 0.7, 1.6}, 0.4), SM::parameters::cad_tolerance(1e-2));
  return c;
}

} // namespace

TEST_CASE("A STEP file is one product with a solid whose shell is closed")
{
  const Step s(written({{"a body", solid()}}));
  s.check_references();
  s.check_splines();
  s.check_borders(2);
  CHECK(s.header.find("AUTOMOTIVE_DESIGN") != std::string::npos);
  CHECK(s.of_type("ADVANCED_FACE").size() == solid().faces().size());
  CHECK(s.of_type("EDGE_CURVE").size() == solid().edges().size());
  CHECK(s.of_type("VERTEX_POINT").size() == solid().vertices().size());
  CHECK(s.of_type("PCURVE").size() == 2 * solid().edges().size());
  CHECK(s.of_type("SEAM_CURVE").empty());
  const Step::Entity& brep = s.one("MANIFOLD_SOLID_BREP");
  CHECK(brep.arguments[0] == "'a body'");
  const Step::Entity& shell = s.at(brep.arguments[1]);
  CHECK(shell.type == "CLOSED_SHELL");
  CHECK(Step::items(shell.arguments[1]).size() == solid().faces().size());
  const Step::Entity& representation = s.one("ADVANCED_BREP_SHAPE_REPRESENTATION");
  const Step::Entity& of = s.one("SHAPE_DEFINITION_REPRESENTATION");
  CHECK(&s.at(of.arguments[1]) == &representation);
  CHECK(s.at(s.at(s.at(s.at(of.arguments[0]).arguments[2]).arguments[2]).arguments[2]).type == "PRODUCT");

  // the numbers are those of the controls
  const Step::Entity& surface = s.entities.at(s.of_type("B_SPLINE_SURFACE_WITH_KNOTS")[0]);
  const std::string row = Step::items(surface.arguments[3])[2];
  const std::vector<std::string> x = Step::items(s.at(Step::items(row)[1]).arguments[1]);
  const SM::Cad_face& face = solid().faces()[0];
  for (int c = 0; c < 3; ++c) CHECK(std::stod(x[c]) == face.controls[2 * face.controls_v() + 1][c]);
}

TEST_CASE("Open surfaces are shells, a torus of one face meets itself, and bodies are products of their own")
{
  const SM::Cad_surface open = SM::cad_surface(analytic::paraboloid(1, 2));
  const SM::Cad_surface ring =
    SM::cad_surface(analytic::ring(2, 0.5), SM::parameters::max_faces(std::size_t(1)));
  const Step s(written({{"open", open}, {"ring", ring}}));
  s.check_references();
  s.check_splines();
  s.check_borders(1);
  const std::string shell = Step::items(s.one("SHELL_BASED_SURFACE_MODEL").arguments[1])[0];
  CHECK(s.at(shell).type == "OPEN_SHELL");
  CHECK(s.of_type("SEAM_CURVE").size() == 2);
  CHECK(s.of_type("PRODUCT").size() == 2);
  CHECK(s.of_type("SHAPE_DEFINITION_REPRESENTATION").size() == 2);
  CHECK(s.of_type("STYLED_ITEM").size() == 2);
  CHECK(s.one("MANIFOLD_SOLID_BREP").arguments[0] == "'ring'");
}

TEST_CASE("Units, scale, colour, schema and names")
{
  SM::Step_options options;
  options.unit = SM::Step_unit::INCH;
  options.scale = 1000;
  options.colour = {1, 0.5, 0};
  options.schema = SM::Step_schema::AP242;
  const std::string text = written({{"d'\xc3\xa9t\xc3\xa9 \\ \xf0\x9f\x90\x87 \xff", solid()}}, options);
  const Step s(text);
  s.check_references();
  CHECK(s.header.find("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF") != std::string::npos);
  CHECK(s.one("PRODUCT").arguments[0] ==
        "'d''\\X2\\00E9\\X0\\t\\X2\\00E9\\X0\\ \\\\ \\X4\\0001F407\\X0\\ \\X2\\FFFD\\X0\\'");
  CHECK(text.find("CONVERSION_BASED_UNIT('INCH'") != std::string::npos);
  CHECK(text.find("LENGTH_MEASURE(25.4)") != std::string::npos);
  CHECK(text.find("COLOUR_RGB('',1.,0.5,0.)") != std::string::npos);
  const Step::Entity& vertex = s.entities.at(s.of_type("VERTEX_POINT")[0]);
  const std::vector<std::string> x = Step::items(s.at(vertex.arguments[1]).arguments[1]);
  for (int c = 0; c < 3; ++c) CHECK(std::stod(x[c]) == 1000 * solid().vertices()[0][c]);

  options.unit = SM::Step_unit::METRE;
  CHECK(written({{"a", solid()}}, options).find("SI_UNIT($,.METRE.)") != std::string::npos);
  options.unit = SM::Step_unit::CENTIMETRE;
  CHECK(written({{"a", solid()}}, options).find("SI_UNIT(.CENTI.,.METRE.)") != std::string::npos);
}

TEST_CASE("Numbers have a point, and are read back bit for bit")
{
  for (const double x : {0., -0., 1., -12., 0.1, 1e-5, 1e22, 1. / 3, 5e-324, 1.7976931348623157e308}) {
    const std::string text = SM::internal::step_text(x);
    CAPTURE(text);
    CHECK(text.find('.') != std::string::npos);
    CHECK(text.find('e') == std::string::npos);
    CHECK(std::strtod(text.c_str(), nullptr) == x);
  }
  CHECK(SM::internal::step_text(-0.) == "0.");
  CHECK(SM::internal::step_text(1e22) == "1.E+22");
}

TEST_CASE("The same surface is the same file, and a file that cannot be written leaves the old one")
{
  CHECK(written({{"a", solid()}}) == written({{"a", solid()}}));
  const Temporary_folder folder;
  CHECK_THROWS_AS(SM::write_step(folder("missing/a.step"), solid()), SM::IO_error);
  folder.write("a.step", "old");
  SM::write_step(folder("a.step"), solid());
  CHECK(folder.read("a.step").size() > 1000);
  CHECK(folder.entries() == std::vector<std::string>{"a.step"});
}

} // namespace test_write_step
