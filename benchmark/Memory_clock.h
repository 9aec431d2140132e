// How much the memory of the process grows, at its peak; only Linux tells.

#ifndef SIMPLE_MANIFOLDS_BENCHMARK_MEMORY_CLOCK_H
#define SIMPLE_MANIFOLDS_BENCHMARK_MEMORY_CLOCK_H

#include <fstream>
#include <limits>
#include <string>

#if defined(__GLIBC__) // which the headers above define
#include <malloc.h>
#endif

class Memory_clock {
public:
  Memory_clock()
  {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << 5; // the peak begins anew
    start_ = kilobytes("VmRSS:");
  }
  double bytes() const { return 1024 * (kilobytes("VmHWM:") - start_); }

private:
  static double kilobytes(const std::string& key)
  {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
      if (line.compare(0, key.size(), key) == 0) return std::stod(line.substr(key.size()));
    return std::numeric_limits<double>::quiet_NaN();
  }

  double start_;
};

#endif // SIMPLE_MANIFOLDS_BENCHMARK_MEMORY_CLOCK_H
