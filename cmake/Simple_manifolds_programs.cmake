# What our tests, examples and benchmarks have in common.
#
#   simple_manifolds_program(<target> [NO_PCH] [HEADER_ONLY])
#
# gives an existing target the library with all optional parts that were found, our warnings, and
# floating point arithmetic that does not depend on the machine. It uses one precompiled header for all,
# except with NO_PCH, and the compiled library if that is built, except with HEADER_ONLY.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(SIMPLE_MANIFOLDS_CCACHE ccache)
  mark_as_advanced(SIMPLE_MANIFOLDS_CCACHE)
  if(SIMPLE_MANIFOLDS_CCACHE)
    # The sloppiness is what ccache's manual asks for with precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${SIMPLE_MANIFOLDS_CCACHE})
  endif()
endif()

set(SIMPLE_MANIFOLDS_CGAL_DATA "${PROJECT_SOURCE_DIR}/build/cgal-data" CACHE PATH
  "Folder that holds meshes/ of CGAL's data; scripts/setup fills the default")
if(NOT EXISTS "${SIMPLE_MANIFOLDS_CGAL_DATA}/meshes")
  message(STATUS "CGAL's meshes are not in ${SIMPLE_MANIFOLDS_CGAL_DATA}: run scripts/setup, or set "
                 "SIMPLE_MANIFOLDS_CGAL_DATA; tests on real meshes fail without them")
endif()

add_library(simple_manifolds_settings INTERFACE)
target_link_libraries(simple_manifolds_settings INTERFACE CGAL::Simple_manifolds)
foreach(part CGAL::Simple_manifolds_IO CGAL::Simple_manifolds_PNG CGAL::Simple_manifolds_ZLIB CGAL::Simple_manifolds_assimp
             CGAL::Simple_manifolds_CHOLMOD CGAL::TBB_support)
  if(TARGET ${part})
    target_link_libraries(simple_manifolds_settings INTERFACE ${part})
  endif()
endforeach()
# CGAL_DATA_DIR, which CGAL::data_file_path() reads, has to be known to the precompiled header too.
target_compile_definitions(simple_manifolds_settings INTERFACE
  CGAL_DATA_DIR="${SIMPLE_MANIFOLDS_CGAL_DATA}"
  SIMPLE_MANIFOLDS_CGAL_DATA="${SIMPLE_MANIFOLDS_CGAL_DATA}"
  SIMPLE_MANIFOLDS_DATA="${PROJECT_SOURCE_DIR}/data"
  SIMPLE_MANIFOLDS_VERSION="${PROJECT_VERSION}")
if(NOT MSVC)
  # Fused multiply-add would make results depend on the processor.
  target_compile_options(simple_manifolds_settings INTERFACE -Wall -Wextra -ffp-contract=off)
  # At -O3 GCC suspects storage of Eigen and of Boost.Multiprecision, inlined into ours, without reason.
  target_compile_options(simple_manifolds_settings INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(SIMPLE_MANIFOLDS_WARNINGS_AS_ERRORS)
    target_compile_options(simple_manifolds_settings INTERFACE -Werror)
  endif()
endif()

set(pch_source "${PROJECT_BINARY_DIR}/simple_manifolds_pch.cpp")
if(NOT EXISTS "${pch_source}")
  file(WRITE "${pch_source}" "")
endif()
add_library(simple_manifolds_pch OBJECT EXCLUDE_FROM_ALL "${pch_source}")
target_link_libraries(simple_manifolds_pch PRIVATE simple_manifolds_settings)
if(TARGET CGAL::Simple_manifolds_compiled)
  target_link_libraries(simple_manifolds_pch PRIVATE CGAL::Simple_manifolds_compiled)
endif()
target_precompile_headers(simple_manifolds_pch PRIVATE
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/helpers.h>
  <Eigen/Dense>
  <Eigen/Sparse>
  <cmath>
  <string>
  <vector>)

function(simple_manifolds_program target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_PCH;HEADER_ONLY" "" "")
  target_link_libraries(${target} PRIVATE simple_manifolds_settings)
  if(TARGET CGAL::Simple_manifolds_compiled AND NOT arg_HEADER_ONLY)
    target_link_libraries(${target} PRIVATE CGAL::Simple_manifolds_compiled)
  endif()
  if(NOT arg_NO_PCH AND NOT arg_HEADER_ONLY AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM simple_manifolds_pch)
  endif()
endfunction()
