// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_H
#define CGAL_SIMPLE_MANIFOLDS_H

/// \file
/// Convenience header: all of the package but IO, which needs nlohmann_json, and drawing, which needs Qt.

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>
#include <CGAL/Simple_manifolds/parameters.h>

#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Hyperbolic_chart.h>
#include <CGAL/Simple_manifolds/atlas/Integer_isometry.h>
#include <CGAL/Simple_manifolds/atlas/Jet.h>
#include <CGAL/Simple_manifolds/atlas/Partition_of_unity.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Square_tiling.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/Mesh_soup.h>
#include <CGAL/Simple_manifolds/Surface_faults.h>
#include <CGAL/Simple_manifolds/Triangle.h>

#include <CGAL/Simple_manifolds/repair/Repair_options.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>
#include <CGAL/Simple_manifolds/repair/repair_mesh.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/correspondence/Mesh_map.h>
#include <CGAL/Simple_manifolds/correspondence/balance.h>
#include <CGAL/Simple_manifolds/correspondence/canonical_position.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/criteria.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_components.h>
#include <CGAL/Simple_manifolds/correspondence/map_properties.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_hyperbolic_surface.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_plane.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_sphere.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_torus.h>
#include <CGAL/Simple_manifolds/correspondence/mesh_components.h>
#include <CGAL/Simple_manifolds/correspondence/refine.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <CGAL/Simple_manifolds/registration/Correspondence.h>
#include <CGAL/Simple_manifolds/registration/Shape_set.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/common_refinement.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/refined_distortion.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>
#include <CGAL/Simple_manifolds/registration/register_shapes.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>
#include <CGAL/Simple_manifolds/registration/spherical_harmonics.h>
#include <CGAL/Simple_manifolds/registration/transfer.h>

#include <CGAL/Simple_manifolds/embedding/Bspline_basis.h>
#include <CGAL/Simple_manifolds/embedding/Fit_confidence.h>
#include <CGAL/Simple_manifolds/embedding/Fit_options.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Map_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Spline_patch.h>
#include <CGAL/Simple_manifolds/embedding/Surface_fitter.h>
#include <CGAL/Simple_manifolds/embedding/closest_point.h>
#include <CGAL/Simple_manifolds/embedding/correct_parameters.h>
#include <CGAL/Simple_manifolds/embedding/fit_components.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>
#include <CGAL/Simple_manifolds/embedding/fit_surface.h>
#include <CGAL/Simple_manifolds/embedding/measures.h>
#include <CGAL/Simple_manifolds/embedding/strided_arrays.h>

#include <CGAL/Simple_manifolds/tessellation/Chart_textures.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/Mesh_vertex_count.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_borders.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/random_domain_points.h>
#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <CGAL/Simple_manifolds/cad/Cad_options.h>
#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/Cad_tessellation.h>
#include <CGAL/Simple_manifolds/cad/cad_domain_point.h>
#include <CGAL/Simple_manifolds/cad/fit_cad_surface.h>
#include <CGAL/Simple_manifolds/cad/subdivision_cage.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>

#endif // CGAL_SIMPLE_MANIFOLDS_H
