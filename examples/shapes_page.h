// The page of map_shapes: shapes coloured alike, a slider that morphs, modes, and figures.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_SHAPES_PAGE_H
#define SIMPLE_MANIFOLDS_EXAMPLES_SHAPES_PAGE_H

#include "figures.h"

#include <CGAL/Simple_manifolds/registration/Shape_set.h>
#include <CGAL/Simple_manifolds/registration/common_mesh.h>
#include <CGAL/Simple_manifolds/registration/shape_statistics.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tools {

/// \param common  the shapes on the mesh of the first one, aligned by these motions
/// \param landmarks  per landmark its vertex of each shape
template <class Atlas>
void write_shapes_page(const std::string& file, const CGAL::Simple_manifolds::Shape_set<Atlas>& set,
                       const CGAL::Simple_manifolds::Common_mesh& common,
                       const std::vector<CGAL::Simple_manifolds::Similarity>& motions,
                       const CGAL::Simple_manifolds::Shape_statistics<>& statistics,
                       const std::vector<std::vector<std::size_t>>& landmarks, const Json& metrics);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_SHAPES_PAGE_H
