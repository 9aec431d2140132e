// Mistakes that headers must not make, one at a time: the options of main_templates.cpp have to find each of them.

#include <algorithm>

#include "windows_macros.h"

#if defined(MISTAKE_MIN_MAX)
int larger(int a, int b) { return std::max(a, b); }
#elif defined(MISTAKE_SHADOW)
int sum(int a)
{
  for (int i = 0, n = a; i < n; ++i) {
    const int a = i;
    n -= a;
  }
  return a;
}
#elif defined(MISTAKE_CONVERSION)
float rounded(double x) { return x; }
#endif
