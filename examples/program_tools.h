// What map_mesh and fit_mesh have in common: exit statuses, progress, figures.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_PROGRAM_TOOLS_H
#define SIMPLE_MANIFOLDS_EXAMPLES_PROGRAM_TOOLS_H

#include "Command_line.h"
#include "figures.h"

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/certify.h>
#include <CGAL/Simple_manifolds/correspondence/distortion.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#ifdef SIMPLE_MANIFOLDS_HAS_REPORT // of the CMake target CGAL::Simple_manifolds_report
#include <CGAL/Simple_manifolds/IO/write_report.h>

#include <simple_manifolds_report_page.h>
#endif

#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace tools {

namespace SM = CGAL::Simple_manifolds;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

enum Status {
  SUCCESS = 0,
  TOLERANCE_NOT_REACHED = 1,
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

/// A signal is answered at the next step of the visitor or before files appear, a second one at once.
inline void answer_signals()
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is one that cannot be written
  for (int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, [](int s) {
      interrupting_signal = s;
      std::signal(s, SIG_DFL);
    });
    if (before == SIG_IGN) std::signal(signal, SIG_IGN); // as nohup wants it
  }
}

inline int status_of(const SM::Error& e)
{
  switch (e.code()) {
  case SM::Error_code::cannot_open:
  case SM::Error_code::unsupported_format:
  case SM::Error_code::syntax_error:
    return UNREADABLE_INPUT;
  case SM::Error_code::cannot_write:
    return USAGE;
  default:
    return UNSUPPORTED_INPUT;
  }
}

/// Runs a program; whatever goes wrong becomes one line on stderr and an exit status.
template <class Program>
int run(const char* name, const Program& program)
{
  const auto fail = [name](const std::string& message, int status) {
    std::string line = message; // names of files can hold anything
    for (char& c : line)
      if (static_cast<unsigned char>(c) < ' ') c = '?';
    std::cerr << name << ": " << line << std::endl;
    return status;
  };
  try {
    answer_signals();
    return program();
  } catch (const Done&) {
    return SUCCESS;
  } catch (const Interrupted&) {
    return fail("interrupted, nothing is written", INTERRUPTED + interrupting_signal);
  } catch (const Usage_error& e) {
    return fail(e.what() + std::string(" (see ") + name + " --help)", USAGE);
  } catch (const po::error& e) {
    return fail(e.what() + std::string(" (see ") + name + " --help)", USAGE);
  } catch (const SM::Error& e) {
    return fail(e.what(), status_of(e));
  } catch (const std::bad_alloc&) {
    return fail("the memory is not sufficient", UNSUPPORTED_INPUT);
  } catch (const std::exception& e) {
    return fail(e.what(), UNSUPPORTED_INPUT);
  }
}

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
  SM::Mesh_topology topology;
};

inline Input read_input(const Command_line& options)
{
  Input input;
  input.file = options.get<std::string>("input");
  input.topology = SM::read_mesh(input.file, input.mesh);
  return input;
}

/// Whether two paths lead to the same file, or will when there is one.
inline bool is_same_file(const std::string& a, const std::string& b)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto full = [&](const std::string& name) {
    return fs::weakly_canonical(fs::absolute(name, error), error).lexically_normal();
  };
  return a == b || (!full(a).empty() && full(a) == full(b));
}

/// \throw Usage_error  when a file that is going to be written is INPUT
inline void require_not_input(const Command_line& options, const std::string& output)
{
  if (is_same_file(output, options.get<std::string>("input")))
    throw Usage_error("INPUT would be overwritten by " + output);
}

inline SM::Close_borders close_borders(const Command_line& options)
{
  const std::string which = options.get<std::string>("close-borders");
  return which == "inner" ? SM::Close_borders::INNER
         : which == "all" ? SM::Close_borders::ALL
                          : SM::Close_borders::NONE;
}

inline bool is_paper(const Command_line& options) { return options.get<std::string>("method") == "paper"; }

/// The map of --method paper.
inline SM::Any_mesh_map<Mesh> map_by_partition(const Command_line& options, const Input& input,
                                               SM::Partition_report& report, Progress& progress)
{
  return SM::map_by_partition(input.mesh, SM::parameters::partition_report(std::ref(report))
                                            .close_borders(close_borders(options))
                                            .visitor(std::ref(progress)));
}

/// How the paper's method came to its map.
inline Json metrics_of_partition(const SM::Partition_report& r)
{
  return {{"attempts", r.attempts},
          {"subdivisions", r.subdivisions},
          {"removed_vertices", r.removed_vertices},
          {"rounds", r.equalization.rounds},
          {"largest_deviation_of_faces", r.equalization.largest_deviation},
          {"stopped_by_rule", r.equalization.has_stopped_by_rule}};
}

/// A number for JSON, which knows no infinity.
inline Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

template <class Map>
Json metrics_of_input(const Input& input, const Map& map)
{
  return {{"file", input.file},
          {"vertices", input.topology.vertices},
          {"faces", input.topology.faces},
          {"genus", input.topology.genus},
          {"border_loops", input.topology.border_loops},
          {"isolated_vertices", input.topology.isolated_vertices},
          {"inward_oriented", map.is_inward_oriented()},
          {"diagonal", map.diagonal()}};
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

inline long long peak_memory_in_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return 1024LL * usage.ru_maxrss;
#endif
}

/// The metrics with those that both programs have; call it last, since it reads the clock.
inline Json completed(Json metrics, const char* program, const Stopwatch& watch)
{
  metrics["seconds"] = watch.seconds();
  metrics["peak_memory_bytes"] = peak_memory_in_bytes();
  metrics["program"] = program;
  metrics["version"] = {{"simple_manifolds", SIMPLE_MANIFOLDS_VERSION}, {"cgal", CGAL_VERSION_STR}};
  return metrics;
}

/// Writes metrics as a JSON file.
inline void write_metrics(const std::string& file, const Json& metrics)
{
  SM::Atomic_file output(file);
  output.stream() << metrics.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  output.commit();
}

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
