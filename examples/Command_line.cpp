#include "Command_line.h"

#include <CGAL/version.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

namespace tools {

Command_line::Command_line(std::string synopsis, std::string summary, bool takes_several)
  : synopsis_(std::move(synopsis)), summary_(std::move(summary)), takes_several_(takes_several),
    options_("Options", 100)
{
  add("output,o", po::value<std::string>(), "where to write (required)");
  add("method", po::value<std::string>()->default_value("certified"),
      "how to map: certified, or paper (Grimm 2002), which may fail; the result is certified either way");
  add("repair", po::bool_switch(),
      "cut the mesh where it is no manifold, turn bodies outward, drop debris and faces without finite\n"
      "corners; what cannot change the object is mended in any case");
  add("weld", po::value<std::string>(),
      "join border edges that coincide up to this distance, a fraction of the diagonal (default: 1e-6), or\n"
      "none: no weld");
  add("close-borders", po::value<std::string>()->default_value("small"),
      "border loops to close by virtual faces: none, small (up to a thousandth of the area), inner (all but\n"
      "the longest), all");
  add("corners", po::value<std::string>(),
      "a,b,c,d: the vertices of a disk that go to the corners of the square, counterclockwise on its\n"
      "border; numbers of the file, from 0 (default: its own corners)");
  add(
    "components", po::value<std::string>()->default_value("all"),
    "which bodies of a file are served, by their numbers of faces: all, largest, or so many of the largest");
  add("threads", po::value<int>(), "threads to use, 1 to 1024; results do not depend on it");
  add("quiet,q", po::bool_switch(), "print nothing but errors");
  add("help,h", po::bool_switch(), "print this and end");
  add("version", po::bool_switch(), "print the version and end");
}

void Command_line::add(const char* name, const po::value_semantic* value, const char* help)
{
  options_.add_options()(name, value, help);
}

void Command_line::parse(int argc, char** argv)
{
  namespace style = po::command_line_style;
  po::options_description all = options_;
  po::positional_options_description positional;
  if (takes_several_) {
    all.add_options()("inputs", po::value<std::vector<std::string>>(), "");
    positional.add("inputs", -1);
  } else {
    all.add_options()("input", po::value<std::string>()->required(), "");
    positional.add("input", 1);
  }
  po::store(po::command_line_parser(argc, argv)
              .options(all)
              .positional(positional)
              .style(style::unix_style & ~style::allow_guessing)
              .run(),
            values_);
  if (get<bool>("help")) {
    std::cout << "Usage: " << synopsis_ << "\n\n" << summary_ << "\n\n" << options_;
    throw Done();
  }
  if (get<bool>("version")) {
    std::cout << "Simple_manifolds " << SIMPLE_MANIFOLDS_VERSION << ", CGAL " << CGAL_VERSION_STR << '\n';
    throw Done();
  }
  if (!values_.count(takes_several_ ? "inputs" : "input")) throw Usage_error("no INPUT is given");
  const bool is_inspection = values_.count("inspect") && get<bool>("inspect");
  if (!values_.count("output") && !is_inspection) throw po::required_option("--output");
  po::notify(values_);
  require_choice("method", {"certified", "paper"});
  require_choice("close-borders", {"none", "small", "inner", "all"});
  limit_threads();
}

void Command_line::require_choice(const char* name, std::initializer_list<const char*> choices) const
{
  std::string list;
  for (const char* choice : choices) {
    if (get<std::string>(name) == choice) return;
    list += (list.empty() ? "" : ", ") + std::string(choice);
  }
  throw Usage_error(std::string("--") + name + " is one of " + list + ", not \"" + get<std::string>(name) +
                    '"');
}

void Command_line::limit_threads()
{
  if (!has("threads")) return;
  const int threads = get<int>("threads"); // the memory for very many would be asked for at once
  require(threads >= 1 && threads <= 1024, "threads", "from 1 to 1024");
#ifdef CGAL_LINKED_WITH_TBB
  // For the whole run, and never destroyed: that would start threads, which aborts when memory is short.
  static const auto* const control =
    new tbb::global_control(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  (void)control;
#endif
}

} // namespace tools
