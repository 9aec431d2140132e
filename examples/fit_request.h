// What is asked of fit_mesh: its command line.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIT_REQUEST_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIT_REQUEST_H

#include "Command_line.h"

#include <CGAL/Simple_manifolds/embedding/Fit_options.h>

namespace tools {

namespace SM = CGAL::Simple_manifolds;

/// What of it concerns the fit.
struct Fit_request {
  bool is_patches;
  double average, maximum; // tolerances
  int degree, smoothness, patches;
  long samples, controls;
  double fairness, noise;
  SM::Marking marking;
  SM::Fit_target target;
  SM::Fit_effort effort;
  double crease_angle;
  SM::Joint_solve joint;
  enum class Reshape { NEVER, WHERE_NEEDED, ALWAYS } reshape;
};

/// Edges with a larger angle are creases of what is fitted, degrees.
inline double crease_angle_of(const Fit_request& r)
{
  return r.target == SM::Fit_target::CURVED ? 180 : r.crease_angle;
}

/// With all options of fit_mesh.
Command_line fit_command_line();

/// \throw Usage_error
Fit_request fit_request(const Command_line& options);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIT_REQUEST_H
