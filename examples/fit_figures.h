// What fit_mesh says of a fit: its metrics, and sentences.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIT_FIGURES_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIT_FIGURES_H

#include "figures.h"
#include "fit_request.h"

#include <CGAL/Simple_manifolds/embedding/Fit_report.h>

#include <string>

namespace tools {

Json metrics_of_surface(const SM::Fit_report& report);

/// Why it is no better, and where it is worst.
std::string reason(const SM::Fit_report& report);

/// How often the surface turns over, and where.
std::string folds_sentence(const SM::Fit_report& report);

/// Whether what is written keeps what the errors of the fit promise: these are measured from the target, and vertices
/// alone or the paper's weighted errors promise nothing of the rest.
/// \param written  the distances both ways, see written_distances()
bool is_within_tolerance(const Fit_request& request, const SM::Fit_report& report, const Json& written,
                         double chord_error);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIT_FIGURES_H
