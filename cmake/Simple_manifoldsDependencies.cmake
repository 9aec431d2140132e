# What the headers need. Used by the build tree and by the installed package alike, so that both agree.
#
# Needed:   CGAL >= 5.5, Eigen 3.4 or later, Boost.
# Optional: nlohmann_json  -> CGAL::Simple_manifolds_IO       (files of surfaces and metrics)
#           libpng         -> CGAL::Simple_manifolds_PNG      (images of textures)
#           zlib           -> CGAL::Simple_manifolds_ZLIB     (compressed meshes, 3MF)
#           assimp         -> CGAL::Simple_manifolds_assimp   (glTF meshes)
#           zlib, three.js -> CGAL::Simple_manifolds_report   (pages that show maps and surfaces)
#           CHOLMOD        -> CGAL::Simple_manifolds_CHOLMOD  (faster sparse least squares)
#           oneTBB         -> CGAL::TBB_support               (CGAL::Parallel_tag)

# Targets stay visible to a project that takes this one in with add_subdirectory().
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)

# CGAL's own version file refuses another major version than the one asked for: ask for none, then look.
if(NOT TARGET CGAL::CGAL)
  find_package(CGAL REQUIRED QUIET)
endif()
if(CGAL_VERSION AND CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "Simple_manifolds needs CGAL 5.5 or later, found ${CGAL_VERSION}")
endif()
# Without a version: Eigen 5 refuses requests for 3.x.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(Boost REQUIRED QUIET)

set(EIGEN3_FOUND ${Eigen3_FOUND})
include(CGAL_Eigen3_support)

find_package(TBB QUIET)
if(TBB_FOUND)
  include(CGAL_TBB_support)
endif()

foreach(support Eigen3_support TBB_support)
  if(TARGET CGAL::${support})
    get_target_property(is_global CGAL::${support} IMPORTED_GLOBAL)
    if(NOT is_global)
      set_target_properties(CGAL::${support} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endif()
endforeach()

find_package(nlohmann_json 3 QUIET)
if(nlohmann_json_FOUND AND NOT TARGET CGAL::Simple_manifolds_IO)
  add_library(CGAL::Simple_manifolds_IO INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_IO PROPERTIES
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds;nlohmann_json::nlohmann_json")
endif()

find_package(PNG QUIET)
if(PNG_FOUND AND NOT TARGET CGAL::Simple_manifolds_PNG)
  add_library(CGAL::Simple_manifolds_PNG INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_PNG PROPERTIES
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds;PNG::PNG")
endif()

find_package(assimp QUIET)
if(TARGET assimp::assimp AND NOT TARGET CGAL::Simple_manifolds_assimp)
  add_library(CGAL::Simple_manifolds_assimp INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_assimp PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_SIMPLE_MANIFOLDS_USE_ASSIMP
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds;assimp::assimp")
endif()

find_package(ZLIB QUIET)
if(ZLIB_FOUND AND NOT TARGET CGAL::Simple_manifolds_ZLIB)
  add_library(CGAL::Simple_manifolds_ZLIB INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_ZLIB PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_SIMPLE_MANIFOLDS_USE_ZLIB
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds;ZLIB::ZLIB")
endif()
include("${CMAKE_CURRENT_LIST_DIR}/Simple_manifolds_report.cmake")
if(TARGET CGAL::Simple_manifolds_IO AND ZLIB_FOUND AND SIMPLE_MANIFOLDS_THREE_JS
   AND NOT TARGET CGAL::Simple_manifolds_report)
  set(report_dir "${CMAKE_BINARY_DIR}/simple_manifolds_report")
  simple_manifolds_report_page("${report_dir}")
  add_library(CGAL::Simple_manifolds_report INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_report PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS SIMPLE_MANIFOLDS_HAS_REPORT
    INTERFACE_INCLUDE_DIRECTORIES "${report_dir}"
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds_IO;ZLIB::ZLIB")
endif()

find_path(SIMPLE_MANIFOLDS_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(SIMPLE_MANIFOLDS_CHOLMOD_LIBRARY cholmod)
mark_as_advanced(SIMPLE_MANIFOLDS_CHOLMOD_INCLUDE_DIR SIMPLE_MANIFOLDS_CHOLMOD_LIBRARY)
if(SIMPLE_MANIFOLDS_CHOLMOD_INCLUDE_DIR AND SIMPLE_MANIFOLDS_CHOLMOD_LIBRARY
   AND NOT TARGET CGAL::Simple_manifolds_CHOLMOD)
  add_library(CGAL::Simple_manifolds_CHOLMOD INTERFACE IMPORTED GLOBAL)
  set_target_properties(CGAL::Simple_manifolds_CHOLMOD PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_SIMPLE_MANIFOLDS_USE_CHOLMOD
    INTERFACE_INCLUDE_DIRECTORIES "${SIMPLE_MANIFOLDS_CHOLMOD_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "CGAL::Simple_manifolds;${SIMPLE_MANIFOLDS_CHOLMOD_LIBRARY};${CMAKE_DL_LIBS}")
endif()
