// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_VALUES_OR_ERRORS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_VALUES_OR_ERRORS_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/parallel_for.h>

#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The visitor of several tasks that may run at the same time: they call it one at a time. Of one task it shows the
// phases, of several one phase, in which the share that is done grows as they end. When it throws, once, all end.
class Joint_visitor {
public:
  Joint_visitor(const Visitor_reference& visitor, bool is_alone, const char* phase, double total)
    : visitor_(visitor), is_alone_(is_alone), phase_(phase), total_(total)
  {
    if (!is_alone_) visitor_.start_phase(phase_);
  }

  // What a task calls.
  void start_phase(const char* name)
  {
    if (is_alone_) call([&] { visitor_.start_phase(name); });
  }
  void progress(double fraction)
  {
    call([&] { visitor_.progress(is_alone_ ? fraction : done_ / total_); });
  }
  void end_phase()
  {
    if (is_alone_) call([&] { visitor_.end_phase(); });
  }

  // A task of this size has ended.
  void add(double size)
  {
    if (!is_alone_)
      call([&] {
        done_ += size;
        visitor_.progress(done_ / total_);
      });
  }
  // What the visitor threw is no error of a task.
  void rethrow()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (thrown_) std::rethrow_exception(thrown_);
  }
  void end()
  {
    if (!is_alone_) visitor_.end_phase();
  }

private:
  template <class F>
  void call(const F& f)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (thrown_) std::rethrow_exception(thrown_);
    try {
      f();
    } catch (...) {
      thrown_ = std::current_exception();
      throw;
    }
  }

  const Visitor_reference& visitor_;
  bool is_alone_;
  const char* phase_;
  double total_, done_ = 0;
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

// make(k, visitor) for k = 0, 1, ..., or the Error that it throws; anything else that it throws goes on. The calls may
// run at the same time. sizes: of the tasks, relative to one another.
template <class Value, class Make>
std::vector<std::variant<Value, Error>> values_or_errors(bool has_threads, const std::vector<double>& sizes,
                                                         const Visitor_reference& visitor, const char* phase,
                                                         const Make& make)
{
  double total = 0;
  for (const double size : sizes) total += size;
  Joint_visitor joint(visitor, sizes.size() == 1, phase, total);
  std::vector<std::optional<std::variant<Value, Error>>> made(sizes.size());
  parallel_tasks(has_threads, static_cast<int>(sizes.size()), [&](int k) {
    try {
      made[k].emplace(std::in_place_index<0>, make(k, Visitor_reference(joint)));
    } catch (const Error& e) {
      joint.rethrow();
      made[k].emplace(std::in_place_index<1>, e);
    }
    joint.add(sizes[k]);
  });
  joint.end();
  std::vector<std::variant<Value, Error>> results;
  results.reserve(made.size());
  for (auto& result : made) results.push_back(std::move(*result));
  return results;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_VALUES_OR_ERRORS_H
