# cmake -DROOT=<include folder> -P check_layers.cmake
#
# A header includes only its own layer or the layers above it in this list, and of another layer nothing that is
# internal there; the folder internal/ beside the layers is the ground floor, which all of them stand on. Reads the
# #include lines of all headers below ROOT and names every edge that goes another way.

cmake_minimum_required(VERSION 3.22)
set(layers . atlas repair correspondence registration embedding paper tessellation cad IO draw.h) # . = Error.h, ..., and internal/
list(FIND layers cad convenience) # the last layer that simple_manifolds.h includes

# The paper's method is an annex of the layers before it, registration one of the engine of maps: they may use the rooms.
set(annex "^(paper|registration)/")

# What the atlas may take from elsewhere: it knows no mesh, no kernel and no solver.
set(atlas_may_include "^(Eigen/|CGAL/assertions\\.h$|[a-z_0-9]+$)")

# The position in the list of a path below CGAL/Simple_manifolds, -1 if it belongs to no layer.
function(layer_of path result)
  string(REGEX REPLACE "/.*" "" first "${path}")
  list(FIND layers "${first}" position)
  if(position EQUAL -1 AND (NOT path MATCHES "/" OR first STREQUAL "internal"))
    set(position 0)
  endif()
  set(${result} ${position} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers RELATIVE ${ROOT}/CGAL ${ROOT}/CGAL/*.h)
if(NOT headers)
  message(FATAL_ERROR "no header below ${ROOT}/CGAL")
endif()

foreach(header ${headers})
  if(header STREQUAL "simple_manifolds.h")
    set(own ${convenience})
  else()
    string(REGEX REPLACE "^Simple_manifolds/" "" path "${header}")
    layer_of("${path}" own)
    if(own EQUAL -1)
      message(SEND_ERROR "${header} is in no layer")
      continue()
    endif()
  endif()

  file(STRINGS ${ROOT}/CGAL/${header} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
  foreach(line ${lines})
    string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*)[>\"].*" "\\1" included "${line}")
    if(included MATCHES "^CGAL/Simple_manifolds/(.*)")
      set(other_path "${CMAKE_MATCH_1}")
      layer_of("${other_path}" other)
      if(other EQUAL -1)
        message(SEND_ERROR "${header} includes ${included}, which is in no layer")
      elseif(other GREATER own)
        message(SEND_ERROR "${header} includes ${included}, which is a later layer")
      elseif(NOT other EQUAL own AND other_path MATCHES "^[a-zA-Z]+/.*internal/" AND NOT path MATCHES "${annex}")
        message(SEND_ERROR "${header} includes ${included}, which is internal to another layer")
      elseif(NOT EXISTS ${ROOT}/${included})
        message(SEND_ERROR "${header} includes ${included}, which does not exist")
      endif()
    elseif(included STREQUAL "CGAL/simple_manifolds.h")
      message(SEND_ERROR "${header} includes the convenience header")
    elseif(line MATCHES "include[ \t]*\"")
      message(SEND_ERROR "${header} includes \"${included}\": write <CGAL/Simple_manifolds/...>")
    elseif(path MATCHES "^atlas/" AND NOT included MATCHES "${atlas_may_include}")
      message(SEND_ERROR "${header} includes ${included}, which the atlas must not know")
    endif()
  endforeach()
endforeach()

list(LENGTH headers count)
message(STATUS "${count} headers read")
