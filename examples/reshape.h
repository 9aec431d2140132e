// What fit_mesh does to the triangles of a mesh before it maps it.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_RESHAPE_H
#define SIMPLE_MANIFOLDS_EXAMPLES_RESHAPE_H

#include "fit_request.h"
#include "program_tools.h"

namespace tools {

/// Gives the flat parts of a mesh small triangles, if that is asked for, or it is needed and nothing forbids it. The
/// properties of the file are taken along.
void reshape(const Fit_request& request, const Command_line& options, Input& input);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_RESHAPE_H
