// Meshes for the tests of the paper's method.

#ifndef SIMPLE_MANIFOLDS_TEST_PAPER_SAMPLES_H
#define SIMPLE_MANIFOLDS_TEST_PAPER_SAMPLES_H

#include "random_surfaces.h"

#include <CGAL/Simple_manifolds/paper/map/internal/working_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

using Mesh = CGAL::Simple_manifolds::internal::Working_mesh;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Halfedge = boost::graph_traits<Mesh>::halfedge_descriptor;
using Path = std::vector<Halfedge>;

inline Mesh surface_mesh(const Triangle_mesh& m)
{
  return CGAL::Simple_manifolds::internal::working_mesh(m.points, m.triangles);
}

/// An octahedron, subdivided and then, with some random edges flipped, no more regular.
inline Triangle_mesh random_round_sphere(int subdivisions, int flips, Random& random)
{
  Triangle_mesh mesh = bipyramid(4);
  for (int i = 0; i < subdivisions; ++i)
    CGAL::Simple_manifolds::internal::subdivide(mesh.points, mesh.triangles);
  for (auto& p : mesh.points) p.normalize();
  flip_random_edges(mesh, flips, random);
  return mesh;
}

/// A random disk: a random sphere without the star of a vertex.
inline Triangle_mesh random_disk(int n, int flips, Random& random)
{
  return without_star(random_sphere(n, flips, 0, random), random.below(n));
}

/// Whether a path is one, and visits no vertex twice; a loop ends where it started.
inline bool is_simple_path(const Mesh& mesh, const Path& path, bool is_loop = false)
{
  std::vector<Vertex> visited;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0 && target(path[i - 1], mesh) != source(path[i], mesh)) return false;
    visited.push_back(source(path[i], mesh));
  }
  if (!path.empty() && (target(path.back(), mesh) == visited.front()) != is_loop) return false;
  if (!path.empty() && !is_loop) visited.push_back(target(path.back(), mesh));
  std::sort(visited.begin(), visited.end());
  return std::adjacent_find(visited.begin(), visited.end()) == visited.end();
}

#endif // SIMPLE_MANIFOLDS_TEST_PAPER_SAMPLES_H
