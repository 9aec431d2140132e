// The operator new of the whole program. In a file of its own, or compilers take the pair of new and free() for a
// mistake.

#include "short_of_memory.h"

#include <cstddef>
#include <cstdlib>
#include <new>

thread_local long allocations_left = -1;

void* operator new(std::size_t size)
{
  void* p = allocations_left == 0 ? nullptr : std::malloc(size ? size : 1);
  if (!p) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  return p;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size ? size : 1); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
