// Lets allocations fail: operator new of the whole test program, in short_of_memory.cpp.

#ifndef SIMPLE_MANIFOLDS_TEST_SHORT_OF_MEMORY_H
#define SIMPLE_MANIFOLDS_TEST_SHORT_OF_MEMORY_H

// While this is not negative, it is how many allocations of this thread succeed; then none does until it is set again.
extern thread_local long allocations_left;

#endif // SIMPLE_MANIFOLDS_TEST_SHORT_OF_MEMORY_H
