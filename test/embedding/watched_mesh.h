// A mesh of which every change is seen, small surfaces to make it of, and whether two results are the same.

#ifndef SIMPLE_MANIFOLDS_TEST_EMBEDDING_WATCHED_MESH_H
#define SIMPLE_MANIFOLDS_TEST_EMBEDDING_WATCHED_MESH_H

#include "correspondence/random_surfaces.h"

#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace SM = CGAL::Simple_manifolds;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// A mesh with data of its own, and whether all of it is as it was.
template <class Domain_point>
struct Watched_mesh {
  Mesh mesh, copy;
  Mesh::Property_map<Mesh::Vertex_index, Domain_point> domain;
  Mesh::Property_map<Mesh::Face_index, int> number;
  std::vector<std::string> names;

  explicit Watched_mesh(const Triangle_mesh& t)
  {
    std::vector<Mesh::Vertex_index> v;
    for (const auto& p : t.points) v.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    for (const auto& f : t.triangles) mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
    number = mesh.add_property_map<Mesh::Face_index, int>("f:number", -1).first;
    for (const auto f : mesh.faces()) number[f] = int(f) * int(f);
    domain = mesh.add_property_map<Mesh::Vertex_index, Domain_point>("v:domain").first;
    for (const auto w : mesh.vertices()) domain[w] = Domain_point::Constant(double(w));
    copy = mesh;
    names = property_names();
  }

  std::vector<std::string> property_names() const
  {
    std::vector<std::string> all = mesh.properties<Mesh::Vertex_index>();
    for (const auto& more : {mesh.properties<Mesh::Halfedge_index>(), mesh.properties<Mesh::Edge_index>(),
                             mesh.properties<Mesh::Face_index>()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  bool is_unchanged() const
  {
    bool same = mesh.number_of_vertices() == copy.number_of_vertices() && !mesh.has_garbage() &&
                mesh.number_of_faces() == copy.number_of_faces() && property_names() == names;
    for (const auto h : copy.halfedges())
      same = same && mesh.next(h) == copy.next(h) && mesh.target(h) == copy.target(h) &&
             mesh.face(h) == copy.face(h);
    for (const auto v : copy.vertices())
      same = same && mesh.point(v) == copy.point(v) && mesh.halfedge(v) == copy.halfedge(v) &&
             domain[v] == Domain_point::Constant(double(v));
    for (const auto f : copy.faces()) same = same && number[f] == int(f) * int(f);
    return same;
  }
};

template <class Atlas>
bool same(const SM::Manifold_map<Atlas>& a, const SM::Manifold_map<Atlas>& b)
{
  return a.points() == b.points() && a.domain_points() == b.domain_points() && a.faces() == b.faces();
}

template <class... Maps>
bool same(const std::variant<Maps...>& a, const std::variant<Maps...>& b)
{
  return a.index() == b.index() &&
         std::visit([&b](const auto& map) { return same(map, std::get<std::decay_t<decltype(map)>>(b)); }, a);
}

template <class Atlas, class Embedding, class Bump>
bool same(const SM::Manifold_surface<Atlas, Embedding, Bump>& a,
          const SM::Manifold_surface<Atlas, Embedding, Bump>& b)
{
  bool is_same = true;
  for (int c = 0; c < Atlas::number_of_charts(); ++c)
    for (double x : {0.2, 0.45, 0.8})
      is_same = is_same && a.chart_embedding(c).point({x, 0.6}) == b.chart_embedding(c).point({x, 0.6});
  return is_same;
}

inline Triangle_mesh some_sphere()
{
  Random random(4);
  return random_sphere(40, 100, 0, random);
}
inline Triangle_mesh some_torus() { return grid_torus(5, 6, 2); }
inline Triangle_mesh some_disk() { return without_star(some_sphere(), 3); }

inline Mesh mesh_of(const Triangle_mesh& t) { return Watched_mesh<Eigen::Vector2d>(t).mesh; }

#endif // SIMPLE_MANIFOLDS_TEST_EMBEDDING_WATCHED_MESH_H
