#include "program_tools.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>

#include <CGAL/version.h>

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>
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

Input read_input(const Command_line& options, const std::string& file)
{
  Input input;
  input.file = file;
  input.topology = SM::read_mesh(input.file, input.mesh,
                                 SM::parameters::repair_options(repair_options(options))
                                   .repair_report(std::ref(input.repair))
                                   .read_report(std::ref(input.read)));
  return input;
}

SM::Repair_options repair_options(const Command_line& options)
{
  SM::Repair_options o = options.get<bool>("repair") ? SM::repair_everything() : SM::Repair_options();
  if (!options.has("weld")) return o;
  const std::string text = options.get<std::string>("weld");
  std::istringstream in(text);
  double distance = -1;
  const bool is_number = in >> distance && in.peek() == std::istringstream::traits_type::eof();
  if (text != "none")
    options.require(is_number && distance >= 0 && std::isfinite(distance), "weld",
                    "none, or a number from 0 on");
  if (text == "none")
    o.weld_distance.reset();
  else
    o.weld_distance = distance;
  return o;
}

Json metrics_of_reading(const SM::Read_report& r)
{
  Json warnings = Json::array(), dropped = Json::array();
  for (const SM::Read_warning& w : r.warnings)
    warnings.push_back({{"count", w.count}, {"sentence", w.sentence()}});
  const auto names = [](const std::vector<SM::Mesh_property>& properties) {
    Json list = Json::array();
    for (const SM::Mesh_property& p : properties) list.push_back(p.name);
    return list;
  };
  for (const std::string& name : r.properties.dropped)
    dropped.push_back({{"name", name}, {"reason", "neither vertices nor faces have a value of it each"}});
  return {{"warnings", warnings},
          {"vertex_properties", names(r.properties.vertex)},
          {"face_properties", names(r.properties.face)},
          {"dropped_properties", dropped},
          {"unit", r.unit}};
}

Json metrics_of_repair(const SM::Repair_report& r)
{
  Json json, places = Json::object();
  const auto tell = [&](const char* name, const SM::Located_elements& e) {
    json[name] = e.count;
    for (const Eigen::Vector3d& p : e.places)
      places[name].push_back({number(p.x()), number(p.y()), number(p.z())});
  };
  tell("welded", r.welded);
  tell("joined_corners", r.joined_corners);
  tell("dropped_degenerate", r.dropped_degenerate);
  tell("dropped_duplicate", r.dropped_duplicate);
  tell("dropped_non_finite", r.dropped_non_finite);
  tell("flipped", r.flipped);
  tell("cut_edges", r.cut_edges);
  tell("cut_vertices", r.cut_vertices);
  tell("split_edges", r.split_edges);
  tell("dropped_debris", r.dropped_debris);
  json["dropped_debris_faces"] = r.dropped_debris_faces;
  json["unused_vertices"] = r.unused_vertices;
  if (r.has_changes()) json["sentence"] = r.sentence();
  json["places"] = std::move(places); // the first ones of each kind
  return json;
}

void say(const char* program, const std::string& message)
{
  std::string line = message;
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  std::cerr << program << ": " << line << std::endl;
}

int run(const char* name, const std::function<int()>& program)
{
  const auto fail = [name](const std::string& message, int status) {
    say(name, message);
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
  return which == "inner"                              ? SM::Close_borders::INNER
         : which == "small" && !options.has("corners") ? SM::Close_borders::SMALL
         : which == "all"                              ? SM::Close_borders::ALL
                                                       : SM::Close_borders::NONE;
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
