// says: this is no model of ManifoldMap: diagonal() is missing

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>

struct Map {
  using Atlas = CGAL::Simple_manifolds::Plane_atlas;
  using Domain_point = Eigen::Vector2d;
  struct Location {
    int face;
    Eigen::Vector3d barycentric;
  };
  Atlas atlas() const;
  std::size_t number_of_vertices() const;
  std::size_t number_of_faces() const;
  bool is_virtual(std::size_t f) const;
  bool is_virtual_vertex(std::size_t v) const;
  Eigen::Vector3d point(std::size_t v) const;
  Domain_point domain_point(std::size_t v) const;
  Domain_point to_domain(const Location& location) const;
  Location to_mesh(const Domain_point& p, int face_hint) const;
  Eigen::Vector3d position(const Location& location) const;
};

void fit(const Map& map) { CGAL::Simple_manifolds::fit_surface(map); }
