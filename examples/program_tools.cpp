#include "program_tools.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/paper/map/map_by_partition.h>

#include <CGAL/version.h>

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

namespace tools {

namespace {

// A signal is answered at the next step of the visitor or before files appear, a second one at once.
void answer_signals()
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

int status_of(const SM::Error& e)
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

long long peak_memory_in_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return 1024LL * usage.ru_maxrss;
#endif
}

} // namespace

Input read_input(const Command_line& options)
{
  Input input;
  input.file = options.get<std::string>("input");
  input.topology = SM::read_mesh(input.file, input.mesh);
  return input;
}

int run(const char* name, const std::function<int()>& program)
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

bool is_same_file(const std::string& a, const std::string& b)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto full = [&](const std::string& name) {
    return fs::weakly_canonical(fs::absolute(name, error), error).lexically_normal();
  };
  return a == b || (!full(a).empty() && full(a) == full(b));
}

void require_not_input(const Command_line& options, const std::string& output)
{
  if (is_same_file(output, options.get<std::string>("input")))
    throw Usage_error("INPUT would be overwritten by " + output);
}

SM::Close_borders close_borders(const Command_line& options)
{
  const std::string which = options.get<std::string>("close-borders");
  return which == "inner" ? SM::Close_borders::INNER
         : which == "all" ? SM::Close_borders::ALL
                          : SM::Close_borders::NONE;
}

SM::Any_mesh_map<Mesh> map_by_partition(const Command_line& options, const Input& input, Json& how,
                                        Progress& progress)
{
  SM::Partition_report r;
  auto map = SM::map_by_partition(input.mesh, SM::parameters::partition_report(std::ref(r))
                                                .close_borders(close_borders(options))
                                                .visitor(std::ref(progress)));
  how = {{"attempts", r.attempts},
         {"subdivisions", r.subdivisions},
         {"removed_vertices", r.removed_vertices},
         {"rounds", r.equalization.rounds},
         {"largest_deviation_of_faces", r.equalization.largest_deviation},
         {"stopped_by_rule", r.equalization.has_stopped_by_rule}};
  return map;
}

Json completed(Json metrics, const char* program, const Stopwatch& watch)
{
  metrics["seconds"] = watch.seconds();
  metrics["peak_memory_bytes"] = peak_memory_in_bytes();
  metrics["program"] = program;
  metrics["version"] = {{"simple_manifolds", SIMPLE_MANIFOLDS_VERSION}, {"cgal", CGAL_VERSION_STR}};
  return metrics;
}

void write_metrics(const std::string& file, const Json& metrics)
{
  SM::Atomic_file output(file);
  output.stream() << metrics.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  output.commit();
}

} // namespace tools
