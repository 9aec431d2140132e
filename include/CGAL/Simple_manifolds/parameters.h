// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PARAMETERS_H
#define CGAL_SIMPLE_MANIFOLDS_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

/// \file

/// The named parameters of the package, each once: everything below is generated from this list.
/// CGAL's own parameters (`vertex_point_map`, `visitor`, ...) are used where they fit.
#define CGAL_SIMPLE_MANIFOLDS_FOR_EACH_PARAMETER(X)                                                          \
  X(repair_options)      /* Repair_options: the seven below at once; each of them goes before it */          \
  X(weld_distance)       /* std::optional<double>: of border points, fraction of the diagonal */             \
  X(drop_degenerate)     /* bool: faces with fewer than three different vertices */                          \
  X(drop_duplicates)     /* bool: faces that coincide with others */                                         \
  X(face_orientation)    /* Face_orientation: how faces are oriented */                                      \
  X(cut_non_manifold)    /* bool: edges and vertices that are not manifold, and one-sided components */      \
  X(drop_non_finite)     /* bool: faces with a corner that is NaN or infinite */                             \
  X(debris_share)        /* double in [0,1]: components below this share of the largest are dropped */       \
  X(repair_report)       /* std::reference_wrapper<Repair_report> */                                         \
  X(input_vertex_map)    /* WritablePropertyMap vertex of a repaired mesh -> vertex of the input */          \
  X(input_face_map)      /* WritablePropertyMap face of a repaired mesh -> face of the input */              \
  X(read_report)         /* std::reference_wrapper<Read_report> */                                           \
  X(mesh_properties)     /* Mesh_properties: what is written with a map, or goes to a tessellation */        \
  X(energy)              /* Energy: what a map minimises */                                                  \
  X(energy_lambda)       /* double: weight of area against angle in Energy::AMIPS */                         \
  X(area_floor)          /* double in (0,1]: share of uniform area in the target areas */                    \
  X(effort)              /* Effort: how long a map is relaxed */                                             \
  X(position_frame)      /* Position_frame: what says how a map lies on its canonical surface */             \
  X(map_options)         /* Map_options: the five above at once; each of them goes before it */              \
  X(vertex_weight_map)   /* ReadablePropertyMap vertex -> double: relative area in the domain */             \
  X(projection_weights)  /* Projection_weights: of neighbours, in the paper's method */                      \
  X(partition_report)    /* std::reference_wrapper<Partition_report> */                                      \
  X(partition_reports)   /* std::reference_wrapper<std::vector<Partition_report>>: one per component */      \
  X(corners)             /* Range of 4 vertex_descriptor: the corners of the square */                       \
  X(landmarks)           /* Range of Landmark: soft targets of vertices */                                   \
  X(landmark_pairs)      /* Range of Landmark_pair: vertices of one shape that meet those of another */      \
  X(landmark_rows)       /* Range of ranges: per landmark its vertex of each shape */                        \
  X(template_shape)      /* std::size_t: the shape that others are registered to */                          \
  X(mean_iterations)     /* int: how often several shapes are registered to their mean */                    \
  X(fix_target)          /* bool: whether a registration leaves the domain points of its target */           \
  X(registration_report) /* std::reference_wrapper<Registration_report> */                                   \
  X(close_borders)       /* Close_borders: which border loops are closed virtually */                        \
  X(max_components)      /* std::size_t: only this many components of a mesh, the largest */                 \
  X(domain_point_map)    /* WritablePropertyMap vertex -> domain point */                                    \
  X(max_error)           /* double: largest |E - M| allowed, fraction of the diagonal */                     \
  X(rms_error)           /* double: largest root mean square of |E - M|, fraction of the diagonal */         \
  X(spline_degree)       /* int in 2..5 */                                                                   \
  X(bump)                /* model of BumpFunction */                                                         \
  X(max_controls)        /* std::size_t: limit of the controls of a surface */                               \
  X(refinement)          /* Refinement: where a fit adds controls */                                         \
  X(joint_solve)         /* Joint_solve: when the charts are fitted together */                              \
  X(marking)             /* Marking: which points a fit brings within the tolerance */                       \
  X(fairness)            /* double: weight of the thin plate energy */                                       \
  X(noise_level)         /* double: how far vertices are from where they should be, of the diagonal */       \
  X(fit_effort)          /* Fit_effort: how much a fit does for few controls */                              \
  X(fitted_map)          /* std::reference_wrapper<std::optional<Map>>: another map that a surface suits */  \
  X(fitted_maps)         /* std::reference_wrapper<std::vector<std::optional<Map>>>: one per component */    \
  X(fit_target)          /* Fit_target: what a mesh says of the surface that is fitted to it */              \
  X(crease_angle)        /* double in [0,180], degrees: edges that are sharper stay creases */               \
  X(vertex_weights)      /* Range of double: weights of the vertices of a map in a fit */                    \
  X(fit_report)          /* std::reference_wrapper<Fit_report> */                                            \
  X(fit_reports)         /* std::reference_wrapper<std::vector<Fit_report>>: one per component */            \
  X(average_delta)       /* double: largest mean of b_c |M - E_c| at the vertices of a chart */              \
  X(max_delta)           /* double: largest b_c |M - E_c| there, fraction of the diagonal */                 \
  X(patch_controls)      /* int: controls per side of a patch */                                             \
  X(max_patches)         /* int: limit of the patches of a chart */                                          \
  X(max_bins)            /* int: limit of the bins per side of a chart */                                    \
  X(patch_solve)         /* Patch_solve: what is solved for when a patch was added */                        \
  X(patch_fit_report)    /* std::reference_wrapper<Patch_fit_report> */                                      \
  X(subdivisions)        /* int: cells per side of a tile */                                                 \
  X(chord_error)         /* double: largest distance of faces from a surface, fraction of diagonal */        \
  X(edge_length)         /* double: longest edge of a tessellation, fraction of the diagonal */              \
  X(sizing)              /* model of TessellationSizing */                                                   \
  X(max_faces)           /* std::size_t: limit of the faces of a tessellation */                             \
  X(cad_tolerance)       /* double: largest deviation of a CAD surface, fraction of the diagonal */          \
  X(face_cost)           /* double: the controls that a face of a CAD surface is worth */                    \
  X(cad_report)          /* std::reference_wrapper<Cad_report> */                                            \
  X(tile_borders)        /* Tile_borders: where the tiles of the sphere meet */                              \
  X(tessellation_report) /* std::reference_wrapper<Tessellation_report> */                                   \
  X(up_axis)             /* Up_axis: of a mesh that is written as glTF */                                    \
  X(relative_error)      /* double: error of an integral allowed, fraction of the integral of |f| */         \
  X(normal_map)          /* WritablePropertyMap vertex -> Vector_3 */                                        \
  X(chart_point_map)     /* WritablePropertyMap vertex -> Chart_point */

namespace CGAL {
namespace Simple_manifolds {

namespace internal_np {
#define CGAL_SIMPLE_MANIFOLDS_TAG(name) enum name##_t{name};
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_PARAMETER(CGAL_SIMPLE_MANIFOLDS_TAG)
#undef CGAL_SIMPLE_MANIFOLDS_TAG
} // namespace internal_np

/// \ingroup PkgSimpleManifoldsRef
///
/// A pack of named parameters that ends with one of this package: it can be continued by the
/// package's parameters and by CGAL's, e.g. `max_error(1e-3).rms_error(1e-4).verbose(true)`.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base> {
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>; ///< the same without our members
  using Pack::Pack;

#define CGAL_SIMPLE_MANIFOLDS_MEMBER(name)                                                                   \
  template <typename K>                                                                                      \
  Named_parameters<K, internal_np::name##_t, Pack> name(const K& value) const                                \
  {                                                                                                          \
    return Named_parameters<K, internal_np::name##_t, Pack>(value, *this);                                   \
  }
  CGAL_SIMPLE_MANIFOLDS_FOR_EACH_PARAMETER(CGAL_SIMPLE_MANIFOLDS_MEMBER)
#undef CGAL_SIMPLE_MANIFOLDS_MEMBER
};

/// The functions `p(value)` and `p(value, other_parameters)`; the second appends to any pack, CGAL's
/// included.
namespace parameters {

using CGAL::parameters::Default_named_parameters;
using CGAL::parameters::default_values;

#define CGAL_SIMPLE_MANIFOLDS_FUNCTION(name)                                                                 \
  template <typename K>                                                                                      \
  Named_parameters<K, internal_np::name##_t> name(const K& value)                                            \
  {                                                                                                          \
    return Named_parameters<K, internal_np::name##_t>(value);                                                \
  }                                                                                                          \
  template <typename K, typename T, typename Tag, typename Base>                                             \
  Named_parameters<K, internal_np::name##_t, CGAL::Named_function_parameters<T, Tag, Base>> name(            \
    const K& value, const CGAL::Named_function_parameters<T, Tag, Base>& other)                              \
  {                                                                                                          \
    return Named_parameters<K, internal_np::name##_t, CGAL::Named_function_parameters<T, Tag, Base>>(value,  \
                                                                                                     other); \
  }
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_PARAMETER(CGAL_SIMPLE_MANIFOLDS_FUNCTION)
#undef CGAL_SIMPLE_MANIFOLDS_FUNCTION

} // namespace parameters
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PARAMETERS_H
