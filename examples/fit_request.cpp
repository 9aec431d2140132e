#include "fit_request.h"

#include "parts.h"
#include "program_tools.h"

#include <CGAL/Simple_manifolds/embedding/Fit_options.h>

#include <cmath>
#include <string>

namespace tools {

Command_line fit_command_line()
{
  Command_line options(
    "fit_mesh INPUT -o DIR [options]",
    "Fits a smooth surface to a mesh (OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF, COLLADA, with "
    "assimp\n"
    "glTF; closed, or a disk) and writes into DIR, with coordinates in the units of the "
    "file:\n"
    "map.ply (a map that suits the fit: angles before areas), surface.json, surface.ply,\n"
    "metrics.json, report.html (all this for a browser) and, with --samples, samples.csv.\n"
    "Of several bodies each has its files in DIR/part-1 (the largest), DIR/part-2, ...; surface.json,\n"
    "surface.ply, metrics.json and report.html in DIR are of all of them.\n"
    "With --method paper both the map and the fit are those of Grimm 2002.\n"
    "Exit status: 0 success, 1 tolerance not reached, or some bodies could not be served (the files are\n"
    "written), 2 usage, or files cannot be written, 3 unreadable input, 4 unsupported topology or "
    "geometry\n"
    "of all bodies, or too little memory, 129, 130 or 143 ended by SIGHUP, ctrl-C or kill. Above 1 no "
    "file\n"
    "is written.");
  options.add("surface", po::value<std::string>(),
              "what is fitted: hierarchical (splines), or patches (Grimm 2002, 7 x 7 controls each);\n"
              "default: hierarchical, with --method paper patches");
  options.add("max-patches", po::value<int>()->default_value(16), "limit of the patches of a chart");
  options.add("tolerance", po::value<double>()->default_value(2e-3, "0.002"),
              "error allowed, fraction of the bounding box diagonal: root mean square, or for patches the\n"
              "average of the weighted errors of a chart at its vertices");
  options.add("max-tolerance", po::value<double>(),
              "largest error allowed, likewise (default: 10 times that)");
  options.add("degree", po::value<int>()->default_value(3), "degree of the splines, 2 to 5");
  options.add("smoothness", po::value<int>()->default_value(2), "smoothness of the blend, 1 to 3");
  options.add("max-controls", po::value<long>()->default_value(0),
              "limit of the number of controls; 0: four for each vertex, from 10000 to 200000");
  options.add("target", po::value<std::string>()->default_value("automatic"),
              "what the errors are measured from: facets (of the mesh), curved (the smooth surface that its\n"
              "vertices are samples of) or automatic (the same with creases)");
  options.add(
    "fit-effort", po::value<std::string>()->default_value("fast"),
    "fast: each point is fitted to the point of the mesh with the same domain point; compact: points may\n"
    "slide along the surface, and tolerances are those of distances from it: far fewer controls");
  options.add(
    "reshape", po::value<std::string>()->default_value("auto"),
    "whether flat parts of the mesh get small triangles of good shape before it is mapped; then map.ply\n"
    "has these: auto (for meshes of CAD programs), always or never");
  options.add("crease-angle", po::value<double>()->default_value(40),
              "edges with a larger angle between the normals of their faces stay creases, degrees");
  options.add("marking", po::value<std::string>()->default_value("all"),
              "what has to be within the tolerance: all (the whole mesh) or vertices (fewer controls)");
  options.add("economy", po::bool_switch(), "fewer controls for the same largest error, more time");
  options.add("fairness", po::value<double>(),
              "weight of the thin plate energy against noise, from 0 to 1 (0; with --noise 0.003)");
  options.add("noise", po::value<double>()->default_value(0),
              "how far vertices are from where they should be, of the diagonal: tolerances are not below");
  add_position_option(options);
  options.add("correct-parameters", po::bool_switch(),
              "move the vertices in the domain to where the surface is closest, and fit once more");
  options.add("samples", po::value<long>()->default_value(0), "write this many random points of the surface");
  options.add(
    "cad", po::value<std::string>(),
    "FILE.step: write the bodies for CAD systems too, as few B-spline faces within the tolerance, which\n"
    "are fitted to the mesh apart from the surface (export_surface has more options)");
  return options;
}

Fit_request fit_request(const Command_line& options)
{
  Fit_request r;
  const std::string surface = options.has("surface") ? options.get<std::string>("surface")
                              : is_paper(options)    ? "patches"
                                                     : "hierarchical";
  options.require(surface == "hierarchical" || surface == "patches", "surface", "hierarchical or patches");
  r.is_patches = surface == "patches";
  const auto refuse = [&](const char* name, const char* other) {
    if (options.has(name))
      throw Usage_error(std::string("--") + name + " is for --surface " + other + " only");
  };
  if (r.is_patches)
    for (const char* name : {"smoothness", "max-controls", "marking", "economy", "fairness", "noise",
                             "correct-parameters", "target", "crease-angle", "fit-effort", "reshape"})
      refuse(name, "hierarchical");
  else
    refuse("max-patches", "patches");
  r.patches = options.get<int>("max-patches");
  options.require(r.patches >= 1 && r.patches <= 100, "max-patches", "from 1 to 100");
  r.average = options.get<double>("tolerance");
  r.maximum = options.has("max-tolerance") ? options.get<double>("max-tolerance") : 10 * r.average;
  r.degree = options.get<int>("degree");
  r.smoothness = options.get<int>("smoothness");
  r.samples = options.get<long>("samples");
  options.require(r.average > 0 && std::isfinite(r.average), "tolerance", "a positive number");
  options.require(r.maximum > 0 && std::isfinite(r.maximum), "max-tolerance", "a positive number");
  options.require(r.degree >= 2 && r.degree <= 5, "degree", "from 2 to 5");
  options.require(r.smoothness >= 1 && r.smoothness <= 3, "smoothness", "from 1 to 3");
  if (r.is_patches || r.smoothness != 2) require_not_demo("patches and other smoothness");
  r.controls = options.get<long>("max-controls");
  r.noise = options.get<double>("noise");
  options.require(r.noise >= 0 && r.noise <= 1, "noise", "from 0 to 1");
  SM::Fit_options fit;
  fit.rms_error = r.average;
  fit.max_error = r.maximum;
  fit.set_noise_level(r.noise);
  r.average = fit.rms_error;
  r.maximum = fit.max_error;
  r.fairness = options.has("fairness") ? options.get<double>("fairness") : fit.fairness;
  const std::string target = r.is_patches ? "facets" : options.get<std::string>("target");
  options.require(target == "facets" || target == "curved" || target == "automatic", "target",
                  "facets, curved or automatic");
  r.target = target == "facets"   ? SM::Fit_target::FACETS
             : target == "curved" ? SM::Fit_target::CURVED
                                  : SM::Fit_target::AUTOMATIC;
  const std::string reshape = r.is_patches ? "never" : options.get<std::string>("reshape");
  options.require(reshape == "auto" || reshape == "always" || reshape == "never", "reshape",
                  "auto, always or never");
  r.reshape = reshape == "auto"     ? Fit_request::Reshape::WHERE_NEEDED
              : reshape == "always" ? Fit_request::Reshape::ALWAYS
                                    : Fit_request::Reshape::NEVER;
  if (r.reshape == Fit_request::Reshape::ALWAYS && options.has("corners"))
    throw Usage_error("--reshape always changes the vertices that --corners names");
  position_frame(options); // which refuses other words
  const std::string effort = options.get<std::string>("fit-effort");
  options.require(effort == "fast" || effort == "compact", "fit-effort", "fast or compact");
  r.effort = effort == "fast" ? SM::Fit_effort::FAST : SM::Fit_effort::COMPACT;
  r.crease_angle = options.get<double>("crease-angle");
  options.require(r.crease_angle >= 0 && r.crease_angle <= 180, "crease-angle", "from 0 to 180 degrees");
  const std::string marking = options.get<std::string>("marking");
  r.marking = marking == "vertices" ? SM::Marking::VERTICES : SM::Marking::ALL_POINTS;
  r.joint = options.get<bool>("economy") ? SM::Joint_solve::ALWAYS : SM::Joint_solve::AT_END;
  options.require(marking == "all" || marking == "vertices", "marking", "all or vertices");
  options.require(r.controls == 0 || r.controls >= 1000, "max-controls", "at least 1000, or 0");
  options.require(r.fairness >= 0 && r.fairness <= 1, "fairness", "from 0 to 1");
  options.require(r.samples >= 0 && r.samples <= 100000000, "samples", "from 0 to 100000000");
  return r;
}

} // namespace tools
