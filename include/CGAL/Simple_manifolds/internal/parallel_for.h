// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_PARALLEL_FOR_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_PARALLEL_FOR_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_STD_THREADS
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

#include <type_traits>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_STD_THREADS
// In place of TBB for the thread sanitizer, which cannot look into TBB's library: there it sees races where TBB
// synchronises, and what hides them would hide ours. Relaxed, since the counter must not order the pieces.
template <class F>
void run_pieces(int begin, int end, int grain, const F& f)
{
  std::atomic<int> next(begin);
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (int first; (first = next.fetch_add(grain, std::memory_order_relaxed)) < end;)
        f(first, (std::min)(first + grain, end));
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
  if (error) std::rethrow_exception(error);
}
#elif defined(CGAL_LINKED_WITH_TBB)
template <class F>
void run_pieces(int begin, int end, int grain, const F& f)
{
  tbb::parallel_for(
    tbb::blocked_range<int>(begin, end, grain),
    [&](const tbb::blocked_range<int>& r) { f(r.begin(), r.end()); }, tbb::simple_partitioner());
}
#endif

// Calls f(first, last) for pieces that partition [begin,end). The pieces may run at the same time
// under Parallel_tag, so f must give the same result in any order: then it does for any number of
// threads. Short ranges are not worth a task switch and run here.
template <class ConcurrencyTag, class F>
void parallel_for(int begin, int end, const F& f)
{
  constexpr int grain = 1024;
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value && end - begin > 2 * grain) {
    run_pieces(begin, end, grain, f);
    return;
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag needs TBB: link CGAL::TBB_support, or use Parallel_if_available_tag");
  (void)grain;
#endif
  if (begin < end) f(begin, end);
}

// Calls f(k) for k = 0, ..., count-1: few heavy tasks, which may run at the same time.
template <class ConcurrencyTag, class F>
void parallel_tasks(int count, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value && count > 1) {
    run_pieces(0, count, 1, [&](int first, int last) {
      for (int k = first; k < last; ++k) f(k);
    });
    return;
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag needs TBB: link CGAL::TBB_support, or use Parallel_if_available_tag");
#endif
  for (int k = 0; k < count; ++k) f(k);
}

// The same by a flag: what follows is compiled once, not once per tag.
template <class F>
void run_tasks(bool is_parallel, int count, const F& f)
{
  if (is_parallel)
    parallel_tasks<Parallel_if_available_tag>(count, f);
  else
    parallel_tasks<Sequential_tag>(count, f);
}

// Whether a tag asks for threads.
template <class ConcurrencyTag>
constexpr bool is_parallel()
{
  constexpr bool result = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!result, "Parallel_tag needs TBB: link CGAL::TBB_support, or use Parallel_if_available_tag");
#endif
  return result;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_PARALLEL_FOR_H
