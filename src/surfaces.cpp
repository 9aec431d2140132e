// Of the compiled library: fits and evaluation.

#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/correspondence/mesh_components.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#undef CGAL_SIMPLE_MANIFOLDS_INSTANTIATE // from here on, templates are made here
#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE template

#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/internal/evaluation/evaluate_batch.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Chart_spline_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_fit_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Hierarchical_space_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Node_basis_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Normal_distance_solver_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/fit/Refining_fit.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Crease_sectors_impl.h>
#include <CGAL/Simple_manifolds/embedding/internal/target/Local_surface_impl.h>
