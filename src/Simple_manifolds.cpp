// The compiled library: everything that headers declare to be in it.

#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE template

#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh_impl.h>
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
#include <CGAL/Simple_manifolds/cad/Cad_surface_impl.h>
#include <CGAL/Simple_manifolds/cad/Cad_tessellation_impl.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Face_cut_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/limit_positions_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/make_cad_surface_impl.h>
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
#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Leaf_basis_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_distance_solver_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Local_surface_impl.h>
#include <CGAL/Simple_manifolds/internal/surface_faults_impl.h>
#include <CGAL/Simple_manifolds/registration/register_maps_impl.h>
#include <CGAL/Simple_manifolds/repair/repair_soup_impl.h>
#include <CGAL/Simple_manifolds/repair/reshape_flat_parts_impl.h>
