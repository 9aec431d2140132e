// Catch2 version 2 (one header) and version 3 behind one include.

#ifndef SIMPLE_MANIFOLDS_TEST_CATCH_H
#define SIMPLE_MANIFOLDS_TEST_CATCH_H

#if __has_include(<catch2/catch_test_macros.hpp>)

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>

using Catch::Approx;

#else

#include <catch2/catch.hpp>

namespace Catch::Matchers {

/// The name that version 3 gives to `Contains(string)`.
inline auto ContainsSubstring(const std::string& part) { return Contains(part); }

} // namespace Catch::Matchers

#endif

#endif // SIMPLE_MANIFOLDS_TEST_CATCH_H
