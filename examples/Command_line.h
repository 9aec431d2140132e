// The command line of map_mesh and fit_mesh.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_COMMAND_LINE_H
#define SIMPLE_MANIFOLDS_EXAMPLES_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace tools {

namespace po = boost::program_options;

/// A command line that makes no sense.
struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is thrown to end the program early without an error: after --help and --version.
struct Done {};

/// Refuses what the build of scripts/demo leaves out, so that it takes less time.
inline void require_not_demo([[maybe_unused]] const std::string& what)
{
#ifdef SIMPLE_MANIFOLDS_DEMO
  throw Usage_error("scripts/demo has built this program without " + what +
                    "; cmake --preset release && cmake --build build/release makes one that has all");
#endif
}

/// The command line: INPUT, and the options of the programs; each adds its own.
class Command_line {
public:
  /// \param takes_several  whether INPUT may be several files: "inputs"
  Command_line(std::string synopsis, std::string summary, bool takes_several = false);

  void add(const char* name, const po::value_semantic* value, const char* help);

  /// \throw Done, Usage_error, po::error
  void parse(int argc, char** argv);

  bool has(const char* name) const { return values_.count(name) && !values_[name].defaulted(); }

  template <class T>
  T get(const char* name) const
  {
    return values_[name].as<T>();
  }

  void require_choice(const char* name, std::initializer_list<const char*> choices) const;

  void require(bool is_right, const char* name, const std::string& range) const
  {
    if (!is_right) throw Usage_error(std::string("--") + name + " must be " + range);
  }

private:
  void limit_threads();

  std::string synopsis_, summary_;
  bool takes_several_;
  po::options_description options_;
  po::variables_map values_;
};

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_COMMAND_LINE_H
