// says: this is no model of FaceListGraph: faces(mesh), or the header with its graph traits, is missing

#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>

#include <string>

int main() { CGAL::Simple_manifolds::map_to_sphere(std::string("hand.off")); }
