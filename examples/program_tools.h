// What map_mesh and fit_mesh have in common: exit statuses, progress, figures.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_PROGRAM_TOOLS_H
#define SIMPLE_MANIFOLDS_EXAMPLES_PROGRAM_TOOLS_H

#include "Command_line.h"
#include "figures.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/Read_report.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/repair/Repair_options.h>
#include <CGAL/Simple_manifolds/repair/Repair_report.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef SIMPLE_MANIFOLDS_HAS_REPORT // of the CMake target CGAL::Simple_manifolds_report
#include <CGAL/Simple_manifolds/IO/write_report.h>

#include <simple_manifolds_report_page.h>
#endif

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

namespace tools {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

enum Status {
  SUCCESS = 0,
  TOLERANCE_NOT_REACHED = 1,
  PARTLY_SERVED = 1, // some bodies of a file could not be mapped or fitted
  USAGE = 2,
  UNREADABLE_INPUT = 3,
  UNSUPPORTED_INPUT = 4,
  INTERRUPTED = 128 // plus the number of the signal
};

/// What is thrown when a signal has asked the program to end: destructors then remove its temporary files.
struct Interrupted {};

inline std::atomic<int> interrupting_signal{0};

inline void throw_if_interrupted()
{
  if (interrupting_signal != 0) throw Interrupted();
}

/// Runs a program; whatever goes wrong becomes one line on stderr and an exit status.
int run(const char* name, const std::function<int()>& program);

/// One line on stderr: what a program has to say. Names of files can hold anything.
void say(const char* program, const std::string& message);

/// Shows the running phase on a terminal, in one line that is wiped at the end; nothing into a pipe. Ends the
/// program when a signal asks for it.
class Progress : public SM::Default_visitor {
public:
  explicit Progress(bool is_quiet) : is_shown_(!is_quiet && isatty(STDERR_FILENO)) {}
  ~Progress() { wipe(); }

  void start_phase(const char* name)
  {
    name_ = name;
    percent_ = -1;
    progress(0);
  }
  void progress(double fraction)
  {
    throw_if_interrupted();
    const int percent = int(100 * fraction);
    if (!is_shown_ || percent == percent_) return;
    percent_ = percent;
    std::fprintf(stderr, "\r\033[K%s %d %%", name_, percent);
  }
  void end_phase() { wipe(); }

private:
  void wipe()
  {
    if (is_shown_) std::fputs("\r\033[K", stderr);
  }

  bool is_shown_;
  const char* name_ = "";
  int percent_ = -1;
};

/// Wall clock seconds of the phases of a program.
class Stopwatch {
public:
  /// Calls f() and adds its time to `phase`.
  template <class F>
  decltype(auto) time(const char* phase, const F& f)
  {
    struct Lap {
      Stopwatch& watch;
      const char* phase;
      Clock::time_point start = Clock::now();
      ~Lap()
      {
        Json& seconds = watch.seconds_[phase];
        seconds = (seconds.is_null() ? 0. : seconds.get<double>()) +
                  std::chrono::duration<double>(Clock::now() - start).count();
      }
    } lap{*this, phase};
    return f();
  }

  Json seconds() const
  {
    Json s = seconds_;
    s["total"] = total();
    return s;
  }
  double total() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Json seconds_ = Json::object();
};

struct Input {
  std::string file;
  Mesh mesh;
  SM::Mesh_topology topology; // of the repaired mesh
  SM::Repair_report repair;   // what was done to the file's one
  SM::Read_report read;       // what the file has beside it
  Json reshape;               // what fit_mesh did to its triangles; null for nothing
};

/// What --repair and --weld ask for.
SM::Repair_options repair_options(const Command_line& options);

Input read_input(const Command_line& options, const std::string& file);
inline Input read_input(const Command_line& options)
{
  return read_input(options, options.get<std::string>("input"));
}

/// Whether two paths lead to the same file, or will when there is one.
bool is_same_file(const std::string& a, const std::string& b);

/// \throw Usage_error  when a file that is going to be written is INPUT
void require_not_input(const Command_line& options, const std::string& output);

SM::Close_borders close_borders(const Command_line& options);

inline bool is_paper(const Command_line& options) { return options.get<std::string>("method") == "paper"; }

/// The map of --method paper; `how` receives how it came to be.
SM::Any_mesh_map<Mesh> map_by_partition(const Command_line& options, const Input& input, Json& how,
                                        Progress& progress);

/// What a file has beside its mesh: what was passed over, and which properties go on or are dropped.
Json metrics_of_reading(const SM::Read_report& report);

/// What was done to a mesh: a count for each step, and where the first ones were done.
Json metrics_of_repair(const SM::Repair_report& report);

/// A number for JSON, which knows no infinity.
inline Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

template <class Map>
Json metrics_of_input(const Input& input, const Map& map)
{
  Json metrics = {{"file", input.file},
                  {"vertices", input.topology.vertices},
                  {"faces", input.topology.faces},
                  {"genus", input.topology.genus},
                  {"border_loops", input.topology.border_loops},
                  {"isolated_vertices", input.topology.isolated_vertices},
                  {"inward_oriented", map.is_inward_oriented()},
                  {"diagonal", map.diagonal()}};
  metrics.update(metrics_of_reading(input.read));
  return metrics;
}

/// Certifies the map once more, as it is going to be written, and measures it.
template <class Map>
Json metrics_of_map(const Map& map, Stopwatch& watch)
{
  const SM::Certificate certificate =
    watch.time("certify", [&] { return SM::certify(map.atlas(), map.domain_points(), map.faces()); });
  if (!certificate.is_valid())
    throw SM::Numeric_error(SM::Error_code::map_not_bijective, certificate.sentence());
  const SM::Distortion d = SM::distortion(map);
  const SM::Chart_report charts = SM::chart_report(map);
  return {{"atlas", Map::Atlas::name},
          {"vertices", map.number_of_vertices()},
          {"faces", map.number_of_faces()},
          {"virtual_faces", map.number_of_virtual_faces()},
          {"flipped", certificate.flipped},
          {"degree", certificate.degree},
          {"angle", number(d.angle_mean)},
          {"area", number(d.area_mean_abs_log10)},
          {"symmetric_dirichlet", number(d.symmetric_dirichlet)},
          {"l2_efficiency", number(d.l2_efficiency)},
          {"min_area", number(d.smallest_domain_area)},
          {"chart_counts", charts.chart_counts},
          {"stars_without_chart", charts.stars_without_chart},
          {"faces_without_chart", charts.faces_without_chart}};
}

/// The metrics with those that both programs have; call it last, since it reads the clock.
Json completed(Json metrics, const char* program, const Stopwatch& watch);

/// Writes metrics as a JSON file.
void write_metrics(const std::string& file, const Json& metrics);

#ifdef SIMPLE_MANIFOLDS_HAS_REPORT
constexpr bool has_report = true;
#else
constexpr bool has_report = false;
#endif

/// Writes the report of a map, or of a surface too: `surface_and_fit_report`. Nothing without `has_report`. It shows
/// the metrics without those that change while it is written.
template <class Map, class... Surface_and_fit_report>
void write_page([[maybe_unused]] const std::string& file, [[maybe_unused]] Json metrics,
                [[maybe_unused]] const Map& map,
                [[maybe_unused]] const Surface_and_fit_report&... surface_and_fit_report)
{
#ifdef SIMPLE_MANIFOLDS_HAS_REPORT
  metrics["seconds"].erase("total");
  metrics.erase("peak_memory_bytes");
  SM::write_report(file, map, surface_and_fit_report..., metrics, simple_manifolds_report_page);
#endif
}

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_PROGRAM_TOOLS_H
