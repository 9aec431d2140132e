// says: this is no model of ChartEmbedding: jet<Order>(uv) is missing

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>

struct Embedding {
  int smoothness() const { return 2; }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return {uv.x(), uv.y(), 0}; }
};

int main()
{
  using Surface = CGAL::Simple_manifolds::Manifold_surface<CGAL::Simple_manifolds::Plane_atlas, Embedding>;
  Surface({Embedding()});
}
