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

// A function of a piece of a range behind one type, so that what runs pieces at the same time is compiled once. It
// must outlive this.
class Piece_function {
public:
  template <class F>
  explicit Piece_function(const F& f)
    : function_(&f),
      call_([](const void* g, int first, int last) { (*static_cast<const F*>(g))(first, last); })
  {
  }

  void operator()(int first, int last) const { call_(function_, first, last); }

private:
  const void* function_;
  void (*call_)(const void*, int, int);
};

#ifdef CGAL_SIMPLE_MANIFOLDS_USE_STD_THREADS
// In place of TBB for the thread sanitizer, which cannot look into TBB's library: there it sees races where TBB
// synchronises, and what hides them would hide ours. Relaxed, since the counter must not order the pieces.
inline void run_pieces(int begin, int end, int grain, const Piece_function& f)
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
inline void run_pieces(int begin, int end, int grain, const Piece_function& f)
{
  tbb::parallel_for(
    tbb::blocked_range<int>(begin, end, grain),
    [&](const tbb::blocked_range<int>& r) { f(r.begin(), r.end()); }, tbb::simple_partitioner());
}
#endif

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

// Calls f(first, last) for pieces that partition [begin,end). The pieces may run at the same time if `has_threads`, so
// f must give the same result in any order: then it does for any number of threads. A piece has at least `grain` steps,
// fewer are not worth a task switch: short ranges run here.
template <class F>
void parallel_for(bool has_threads, int begin, int end, [[maybe_unused]] int grain, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (has_threads && end - begin > 2 * grain) {
    run_pieces(begin, end, grain, Piece_function(f));
    return;
  }
#else
  (void)has_threads;
#endif
  if (begin < end) f(begin, end);
}
template <class F>
void parallel_for(bool has_threads, int begin, int end, const F& f)
{
  parallel_for(has_threads, begin, end, 1024, f);
}
template <class ConcurrencyTag, class F>
void parallel_for(int begin, int end, const F& f)
{
  parallel_for(is_parallel<ConcurrencyTag>(), begin, end, f);
}

// Calls f(k) for k = 0, ..., count-1: few heavy tasks, which may run at the same time.
template <class F>
void parallel_tasks(bool has_threads, int count, const F& f)
{
  const auto piece = [&f](int first, int last) {
    for (int k = first; k < last; ++k) f(k);
  };
#ifdef CGAL_LINKED_WITH_TBB
  if (has_threads && count > 1) {
    run_pieces(0, count, 1, Piece_function(piece));
    return;
  }
#else
  (void)has_threads;
#endif
  piece(0, count);
}
template <class ConcurrencyTag, class F>
void parallel_tasks(int count, const F& f)
{
  parallel_tasks(is_parallel<ConcurrencyTag>(), count, f);
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_PARALLEL_FOR_H
