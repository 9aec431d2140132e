#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/read_landmarks.h>

#include <string>
#include <vector>

namespace test_read_landmarks {

namespace {

using namespace CGAL::Simple_manifolds;
using Eigen::Vector3d;

} // namespace

TEST_CASE("landmarks of several shapes: vertices or points, with comments")
{
  const Temporary_folder folder;
  const auto two = read_landmarks(folder.write("a.txt", "# a comment\n3 4\r\n\n 5,6 # another\n1;2\n"), 2);
  REQUIRE(two.size() == 3);
  CHECK(two[0][0].vertex == 3);
  CHECK(two[1][1].vertex == 6);
  CHECK(two[2][1].vertex == 2);
  const auto points = read_landmarks(folder.write("b.txt", "1 2 3 4 5 6.5\n"), 2);
  REQUIRE(points.size() == 1);
  CHECK(points[0][0].vertex == -1);
  CHECK(points[0][1].point == Vector3d(4, 5, 6.5));
  for (const char* bad : {"1\n", "1 2 3\n", "1 x\n", "1 2.5\n", "1 -1\n", "1 nan\n", "1 99999999999\n"}) {
    INFO(bad);
    const std::string file = folder.write("bad.txt", std::string("0 0\n") + bad);
    CHECK_THROWS_WITH(read_landmarks(file, 2), Catch::Matchers::ContainsSubstring("line 2"));
  }
  CHECK_THROWS_AS(read_landmarks(folder("none.txt"), 2), IO_error);
}

TEST_CASE("landmarks of one shape, as Slicer and the benchmarks write them")
{
  const Temporary_folder folder;
  const auto slicer = read_landmarks(
    folder.write("a.fcsv", "# Markups fiducial file version = 4.10\n# CoordinateSystem = 0\n"
                           "vtkMRMLMarkupsFiducialNode_0,1.5,-2,3e1,0,0,0,1,1,1,0,F-1,,\n2,4,5,6,0,0,0,1\n"
                           "3,7,8,9,0,0,0,1,1,1,0,F-1,,\n"));
  REQUIRE(slicer.size() == 3);
  CHECK(slicer[2].point == Vector3d(7, 8, 9));
  CHECK(slicer[0].point == Vector3d(1.5, -2, 30));
  CHECK(slicer[1].point == Vector3d(4, 5, 6));
  const auto json = read_landmarks(folder.write(
    "a.mrk.json",
    R"({"markups": [{"type": "Fiducial", "controlPoints": [{"id": "1", "position": [1, 2.5, -3]}]}]})"));
  REQUIRE(json.size() == 1);
  CHECK(json[0].point == Vector3d(1, 2.5, -3));
  const auto vts = read_landmarks(folder.write("a.vts", " 2080 0.04 0.03 0.8\n -1 0 0 0\n7\n"));
  REQUIRE(vts.size() == 3);
  CHECK(vts[0].vertex == 2080);
  CHECK(vts[1].vertex == -1);
  CHECK_FALSE(vts[1].point.allFinite()); // the shape has not got it
  CHECK(vts[2].vertex == 7);
  CHECK(read_landmarks(folder.write("c.txt", "5\n1 2 3\n"))[1].point == Vector3d(1, 2, 3));

  CHECK_THROWS_AS(read_landmarks(folder.write("b.fcsv", "F,1,2\n")), IO_error);
  CHECK_THROWS_AS(read_landmarks(folder.write("b.mrk.json", R"({"markups": []})")), IO_error);
  CHECK_THROWS_AS(read_landmarks(folder.write("c.mrk.json", R"({"markups": 1})")), IO_error);
  CHECK_THROWS_AS(
    read_landmarks(folder.write("d.mrk.json", R"({"markups": [{"controlPoints": [{"position": [1, 2]}]}]})")),
    IO_error);
}

} // namespace test_read_landmarks
