// The bodies for CAD systems that fit_mesh fits to maps.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIT_CAD_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIT_CAD_H

#include "fit_files.h"
#include "parts.h"

namespace tools {

/// Fits bodies to the maps, then what `fit` fits, and writes all files: they appear together. Returns the status.
int fit_with_cad(Job& job, Parts maps, int (*fit)(Job&, Parts));

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIT_CAD_H
