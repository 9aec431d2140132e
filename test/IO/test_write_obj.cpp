#include "catch.h"

#include "sample_maps.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/write_obj.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>

namespace test_write_obj {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

// What the test needs of an OBJ file, read line by line.
struct Obj {
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<Eigen::Vector2d> coordinates;
  struct Corner {
    int chart, point, coordinates, normal;
  };
  std::vector<Corner> corners;

  explicit Obj(const std::string& text)
  {
    std::istringstream in(text);
    int chart = -2;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string keyword, word;
      words >> keyword;
      Eigen::Vector3d x(0, 0, 0);
      if (keyword == "v" || keyword == "vn" || keyword == "vt") {
        for (int k = 0; k < (keyword == "vt" ? 2 : 3); ++k) words >> x[k];
        REQUIRE(words);
      }
      if (keyword == "v") points.push_back(x);
      if (keyword == "vn") normals.push_back(x);
      if (keyword == "vt") coordinates.push_back(x.head<2>());
      if (keyword == "usemtl") {
        words >> word;
        REQUIRE(word.substr(0, 5) == "chart");
        chart = std::stoi(word.substr(5));
      }
      if (keyword == "f")
        while (words >> word) {
          Corner c{chart, 0, 0, 0};
          REQUIRE(std::sscanf(word.c_str(), "%d/%d/%d", &c.point, &c.coordinates, &c.normal) == 3);
          corners.push_back(c);
        }
    }
  }
};

} // namespace

TEST_CASE("each corner of an OBJ file has position, normal, and coordinates in the chart of its material")
{
  const Temporary_folder folder;
  const auto surface = ring(3, 1);
  SM::write_obj(folder("ring.obj"), SM::charted_tessellation(surface, SM::parameters::subdivisions(4)));
  CHECK(folder.entries() == std::vector<std::string>{"ring.mtl", "ring.obj"});
  const std::string text = folder.read("ring.obj");
  const Obj obj(text);
  CHECK(obj.points.size() == 9 * 16);
  CHECK(obj.normals.size() == 9 * 16);
  CHECK(obj.coordinates.size() == 9 * 25); // one per vertex and chart
  REQUIRE(obj.corners.size() == 3 * 9 * 32);
  double worst = 0;
  for (const Obj::Corner& c : obj.corners) {
    const SM::Chart_point a{c.chart, obj.coordinates.at(c.coordinates - 1)};
    worst = (std::max)({worst, (surface.point(a) - obj.points.at(c.point - 1)).norm(),
                        (surface.normal(a) - obj.normals.at(c.normal - 1)).norm()});
  }
  CHECK(worst < 1e-12);
  CHECK(text.find("\nmtllib ring.mtl\n") != text.npos);
  for (int c = 0; c < 9; ++c)
    CHECK(folder.read("ring.mtl").find("newmtl chart" + std::to_string(c) + "\nKd ") != text.npos);
}

TEST_CASE("CGAL reads the OBJ file")
{
  const Temporary_folder folder;
  SM::write_obj(folder("m.obj"), SM::charted_mesh(grid_map(ellipsoid(Eigen::Vector3d(1, 2, 3)), 4)));
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  REQUIRE(CGAL::IO::read_OBJ(folder("m.obj"), points, faces));
  CHECK(points.size() == 98);
  CHECK(faces.size() == 192);
}

TEST_CASE("materials refer to the images of the charts, which are written beside")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  mesh.images = {"the bytes of an image"};
  SM::write_obj(folder("a b.obj"), mesh);
  CHECK(folder.entries() == std::vector<std::string>{"a b.mtl", "a b.obj", "a b_chart0.png"});
  CHECK(folder.read("a b.mtl") == "newmtl chart0\nKd 1 1 1\nmap_Kd a b_chart0.png\n");
  CHECK(folder.read("a b_chart0.png") == mesh.images[0]);
}

TEST_CASE("triangles in no chart have no coordinates")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_mesh(tetrahedron_map());
  SM::write_obj(folder("t.obj"), mesh);
  CHECK(folder.read("t.obj").find("vt") == std::string::npos);
  const std::string faces = "usemtl no_chart\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
  CHECK(folder.read("t.obj").find(faces) != std::string::npos);
  mesh.normals = mesh.points;
  SM::write_obj(folder("t.obj"), mesh);
  CHECK(folder.read("t.obj").find("usemtl no_chart\nf 1//1 2//2 3//3\n") != std::string::npos);
}

TEST_CASE("of an OBJ file that cannot be written nothing is written")
{
  const Temporary_folder folder;
  SM::Charted_mesh mesh = SM::charted_tessellation(paraboloid(), SM::parameters::subdivisions(2));
  mesh.images = {"image"};
  std::filesystem::create_directory(folder("m.obj"));
  try {
    SM::write_obj(folder("m.obj"), mesh);
    FAIL("no exception");
  } catch (const SM::IO_error& e) {
    CHECK(e.code() == SM::Error_code::cannot_write);
  }
  CHECK(folder.entries() == std::vector<std::string>{"m.obj"});
}

} // namespace test_write_obj
