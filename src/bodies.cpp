// Of the compiled library: bodies for CAD systems.

#include <CGAL/Simple_manifolds/cad/find_self_intersections_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Cad_approximation_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Face_cut_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Smoothness_conditions_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_fit_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/Tile_spline_space_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/limit_positions_impl.h>
#include <CGAL/Simple_manifolds/cad/internal/make_cad_surface_impl.h>
