// A mesh structure of one's own, half-edges in arrays, goes through all layers and back, without CGAL's meshes.

#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

//! [mesh]
struct Half_edge {
  int vertex, next; // the vertex it points to, the next one of its face
};
struct My_mesh {
  std::vector<std::array<double, 3>> positions, normals;
  std::vector<Half_edge> half_edges;
  std::vector<int> faces; // a half-edge of each

  std::array<int, 3> corners(std::size_t face) const
  {
    const Half_edge& a = half_edges[std::size_t(faces[face])];
    const Half_edge& b = half_edges[std::size_t(a.next)];
    return {{a.vertex, b.vertex, half_edges[std::size_t(b.next)].vertex}};
  }
};
//! [mesh]

/// How such a mesh is made from triangles.
template <class Triangles>
void set_faces(My_mesh& mesh, const Triangles& triangles)
{
  for (const auto& t : triangles) {
    const int first = int(mesh.half_edges.size());
    mesh.faces.push_back(first);
    for (int k = 0; k < 3; ++k) mesh.half_edges.push_back({int(t[std::size_t(k)]), first + (k + 1) % 3});
  }
}

My_mesh read(const std::string& file)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> read;
  SM::read_mesh(file, read);
  My_mesh mesh;
  for (const auto v : vertices(read))
    mesh.positions.push_back({{read.point(v).x(), read.point(v).y(), read.point(v).z()}});
  std::vector<std::array<int, 3>> triangles;
  for (const auto f : faces(read)) {
    triangles.emplace_back();
    int k = 0;
    for (const auto v : vertices_around_face(halfedge(f, read), read))
      triangles.back()[std::size_t(k++ % 3)] = int(v);
  }
  set_faces(mesh, triangles);
  return mesh;
}

int main(int argc, char** argv)
{
  try {
    My_mesh mesh = read(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"));

    //! [there]
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) triangles.push_back(mesh.corners(f));
    const auto map = SM::map_to_sphere(mesh.positions, triangles); // arrays in, arrays out
    const auto surface = SM::fit_surface(map, SM::parameters::rms_error(1e-3));
    //! [there]
    std::cout << map.certificate().sentence() << '\n';

    //! [back]
    // Vertices and faces of the map are those of the arrays in another order, and some may be added.
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t v = 0; v < map.number_of_vertices(); ++v)
      if (const int own = map.input_vertex(v); own >= 0) {
        const Eigen::Vector3d n = surface.normal(map.domain_point(v));
        mesh.normals[std::size_t(own)] = {{n.x(), n.y(), n.z()}};
      }
    const SM::Closest_point_finder finder(surface);
    const auto nearest = finder(Eigen::Vector3d(0, 0, 0));
    const auto location = map.to_mesh(nearest.domain_point); // a face of the map with barycentric coordinates
    std::cout << "the place next to the origin is on face " << map.input_face(location.face) << '\n';
    //! [back]

    //! [finer]
    My_mesh finer;
    const auto triangulation = SM::adaptive_triangulation(surface, SM::parameters::chord_error(1e-3));
    std::vector<Eigen::Vector3d> positions;
    surface.points(triangulation.domain_points(), std::back_inserter(positions));
    for (const Eigen::Vector3d& x : positions) finer.positions.push_back({{x.x(), x.y(), x.z()}});
    set_faces(finer, triangulation.triangles());
    //! [finer]
    SM::write_map("own_mesh.ply", map);

    // The normals are those of the faces, but for the bend of the surface in them; the new mesh is a closed one of genus 0.
    double worst = 1, mean = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      std::array<Eigen::Vector3d, 3> x;
      Eigen::Vector3d normal(0, 0, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = std::size_t(mesh.corners(f)[k]);
        x[k] = Eigen::Vector3d(mesh.positions[v].data());
        normal += Eigen::Vector3d(mesh.normals[v].data());
      }
      const double cosine = (x[1] - x[0]).cross(x[2] - x[0]).normalized().dot(normal.normalized());
      worst = (std::min)(worst, cosine);
      mean += cosine / double(mesh.faces.size());
    }
    std::cout << "cosine between normals and faces: mean " << mean << ", least " << worst
              << "; the finer mesh has " << finer.faces.size() << " faces\n";
    const bool is_closed = 2 * finer.positions.size() == finer.faces.size() + 4;
    return is_closed && mean > 0.95 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const SM::Error& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
