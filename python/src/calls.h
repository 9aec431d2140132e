// How Python calls C++: progress, interrupts, and words for enumerators.

#ifndef SIMPLE_MANIFOLDS_PYTHON_CALLS_H
#define SIMPLE_MANIFOLDS_PYTHON_CALLS_H

#include "arrays.h"

#include <chrono>
#include <initializer_list>
#include <string>
#include <utility>

namespace simple_manifolds_python {

// What long functions report to: calls `callback(phase, fraction)`, if there is one, and hears ctrl-C. Exceptions of
// the callback, KeyboardInterrupt among them, pass through the function and leave everything as it was. Members are
// called without the interpreter's lock and take it, a few times a second at most.
class Python_visitor {
public:
  explicit Python_visitor(py::object callback) : callback_(std::move(callback)) {}

  void start_phase(const char* name)
  {
    phase_ = name;
    call(0);
  }
  void progress(double fraction)
  {
    if (Clock::now() - last_ > std::chrono::milliseconds(50)) call(fraction);
  }
  void end_phase() { call(1); }

private:
  using Clock = std::chrono::steady_clock;

  void call(double fraction)
  {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback_.is_none()) callback_(phase_, fraction);
    last_ = Clock::now();
  }

  py::object callback_;
  std::string phase_;
  Clock::time_point last_;
};

// f() without the interpreter's lock: other threads of Python run meanwhile.
template <class F>
auto without_lock(const F& f)
{
  const py::gil_scoped_release release;
  return f();
}

// f(first, last) for pieces of 0..n, without the lock; ctrl-C is heard between them.
template <class F>
void in_pieces(std::size_t n, const F& f)
{
  constexpr std::size_t piece = 1 << 18;
  for (std::size_t first = 0; first < n; first += piece) {
    without_lock([&] { f(first, (std::min)(n, first + piece)); });
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

// The enumerator that a word names.
template <class Enum>
Enum choice(const std::string& word, const char* parameter,
            std::initializer_list<std::pair<const char*, Enum>> all)
{
  std::string names;
  for (const auto& [name, value] : all) {
    if (word == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  wrong(std::string(parameter) + " is '" + word + "', not one of " + names);
}

// A value of a dictionary of options.
template <class T>
T option(const py::dict& options, const char* name)
{
  try {
    return options[name].cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) + " is " + py::repr(options[name]).cast<std::string>());
  }
}

// Each translation unit adds its part to the module.
void add_errors(py::module_& m);
void add_meshes(py::module_& m);
void add_maps(py::module_& m);
void add_map_functions(py::module_& m);
void add_surfaces(py::module_& m);
void add_evaluation(py::module_& m);
void add_closest_points(py::module_& m);
void add_tessellations(py::module_& m);
void add_cad(py::module_& m);
void add_registration(py::module_& m);

} // namespace simple_manifolds_python

#endif // SIMPLE_MANIFOLDS_PYTHON_CALLS_H
