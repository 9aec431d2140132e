// What export_surface and fit_mesh have in common for CAD: options, STEP files, and what is said of them.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_CAD_EXPORT_H
#define SIMPLE_MANIFOLDS_EXAMPLES_CAD_EXPORT_H

#include "figures.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Step_options.h>
#include <CGAL/Simple_manifolds/IO/write_step.h>
#include <CGAL/Simple_manifolds/cad/Cad_options.h>
#include <CGAL/Simple_manifolds/cad/Cad_report.h>
#include <CGAL/Simple_manifolds/cad/find_self_intersections.h>
#include <CGAL/Simple_manifolds/cad/surface_to_cad.h>

#include <CGAL/tags.h>

#include <boost/program_options.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tools {

namespace SM = CGAL::Simple_manifolds;
namespace po = boost::program_options;

/// What is asked of a STEP file.
struct Cad_request {
  SM::Cad_options cad; // a tolerance of 0: that of the fit decides
  SM::Step_options step;
  std::string name;    // of the body; of several the first part of their names
  std::string metrics; // file to write, or empty
};

/// The bodies of a STEP file with what is known of them.
struct Cad_parts {
  std::vector<SM::Step_body> bodies;
  std::vector<SM::Cad_report> reports;

  /// Adds a body, and looks where it meets itself.
  void add(const std::string& name, SM::Cad_surface surface, SM::Cad_report report)
  {
    SM::find_self_intersections(surface, report);
    bodies.push_back({name, std::move(surface)});
    reports.push_back(std::move(report));
  }
};

/// The options that a STEP file has.
void add_cad_options(po::options_description& options);

/// Of the options that were given, the first that only a STEP file has; empty: none.
std::string given_cad_option(const po::variables_map& values);

/// \throw po::error
Cad_request cad_request(const po::variables_map& values);

/// Approximates a surface.
template <class Surface>
void add_cad_part(const Surface& surface, const std::string& name, const SM::Cad_options& options,
                  Cad_parts& parts)
{
  SM::Cad_report report;
  SM::Cad_surface faces =
    SM::cad_surface<CGAL::Parallel_if_available_tag>(surface, SM::parameters::cad_tolerance(options.tolerance)
                                                                .face_cost(options.face_cost)
                                                                .max_faces(options.max_faces)
                                                                .max_controls(options.max_controls)
                                                                .cad_report(std::ref(report)));
  parts.add(name, std::move(faces), std::move(report));
}

Json metrics_of_cad(const SM::Cad_report& report, const SM::Cad_options& cad, const SM::Step_options& step);

/// Says what was written, in one line per body.
std::string cad_figures(const std::string& file, const Cad_parts& parts);

/// What the user should know of a body: deviations, places without a normal, a size that is not for CAD.
std::vector<std::string> cad_warnings(const SM::Cad_report& report, double tolerance,
                                      const SM::Step_options& step);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_CAD_EXPORT_H
