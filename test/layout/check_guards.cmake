# cmake -DROOT=<include folder> -P check_guards.cmake
#
# Every header starts with the licence and has the include guard that its path gives:
# CGAL/Simple_manifolds/atlas/Jet.h -> CGAL_SIMPLE_MANIFOLDS_ATLAS_JET_H.

cmake_minimum_required(VERSION 3.22)
file(GLOB_RECURSE headers RELATIVE ${ROOT} ${ROOT}/CGAL/*.h)
if(NOT headers)
  message(FATAL_ERROR "no header below ${ROOT}/CGAL")
endif()

foreach(header ${headers})
  string(MAKE_C_IDENTIFIER "${header}" guard)
  string(TOUPPER "${guard}" guard)
  file(READ ${ROOT}/${header} text)
  if(NOT text MATCHES "^// Copyright [^\n]*\n(//[^\n]*\n)*// SPDX-License-Identifier: GPL-3.0-or-later\n")
    message(SEND_ERROR "${header} does not start with the licence")
  endif()
  # Nothing but comments before the guard, nothing after its end.
  if(NOT text MATCHES "^(//[^\n]*\n|\n)*#ifndef ${guard}\n#define ${guard}\n.*\n#endif // ${guard}\n$")
    message(SEND_ERROR "${header} does not have the guard ${guard}")
  endif()
endforeach()

list(LENGTH headers count)
message(STATUS "${count} headers read")
