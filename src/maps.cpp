// Of the compiled library: the canonical surfaces, and maps onto them.

#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE template

#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas_impl.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas_impl.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling_impl.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/averaged_tile_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/barycentric_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/exact_sign_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/flat_geometry_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/sphere_balance_impl.h>
#include <CGAL/Simple_manifolds/atlas/internal/torus_balance_impl.h>
#include <CGAL/Simple_manifolds/correspondence/certify_impl.h>
#include <CGAL/Simple_manifolds/correspondence/criteria_impl.h>
#include <CGAL/Simple_manifolds/correspondence/distortion_impl.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh_impl.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/closed_triangles_impl.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_hyperbolic_surface_impl.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_plane_impl.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_sphere_impl.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_to_torus_impl.h>
#include <CGAL/Simple_manifolds/correspondence/mesh_components_impl.h>
#include <CGAL/Simple_manifolds/correspondence/topology_impl.h>
#include <CGAL/Simple_manifolds/internal/surface_faults_impl.h>
