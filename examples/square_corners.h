// The option --corners of map_mesh and fit_mesh: which vertices of a disk go to the corners of the square.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_SQUARE_CORNERS_H
#define SIMPLE_MANIFOLDS_EXAMPLES_SQUARE_CORNERS_H

#include "program_tools.h"

#include <vector>

namespace tools {

/// The vertices of --corners; none if it is not given.
/// \throw Usage_error  unless they are four vertices of a disk's border, counterclockwise
std::vector<Mesh::Vertex_index> corners(const Command_line& options, const Input& input);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_SQUARE_CORNERS_H
