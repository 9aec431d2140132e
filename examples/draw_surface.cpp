// Shows a map, then a surface that is fitted to it, in windows of CGAL's viewer.

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/draw.h>
#include <CGAL/simple_manifolds.h>

#include <iostream>

namespace SM = CGAL::Simple_manifolds;

int main(int argc, char** argv)
{
  SM::Coloured_mesh mesh;
  SM::read_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"), mesh); // closed, of genus 0
  //! [draw]
  const auto map = SM::map_to_sphere(mesh);
  CGAL::draw(map);
  const auto surface = SM::fit_surface(map);
  CGAL::draw(surface);
  //! [draw]
  std::cout << SM::coloured_mesh(surface).number_of_faces() << " triangles were drawn\n";
}
