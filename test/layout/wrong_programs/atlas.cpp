// says: this is no model of ManifoldAtlas: tile_point(tile, s, t) is missing

#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>

struct Atlas : CGAL::Simple_manifolds::Plane_atlas {
  void tile_point(int) const;
};

int main() { CGAL::Simple_manifolds::Partition_of_unity<Atlas> partition; }
