// says: a Manifold_map takes positions in its arrays: for descriptors of the mesh there is the Mesh_map

#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Map = CGAL::Simple_manifolds::Manifold_map<CGAL::Simple_manifolds::Sphere_atlas>;

Eigen::Vector3d wrong(const Map& map, Mesh::Vertex_index v) { return map.domain_point(v); }

int main() {}
