# cmake -DMAKE_MESHES=<program> -DMESHES=<folder> -DWORK=<folder> -P check_meshes.cmake
#
# The meshes in MESHES are those that MAKE_MESHES makes, byte for byte, no more and no fewer.

cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${MAKE_MESHES} ${WORK} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "make_meshes ended with ${status}")
endif()
file(GLOB made RELATIVE ${WORK} ${WORK}/*)
file(GLOB committed RELATIVE ${MESHES} ${MESHES}/*.off)
if(NOT made OR NOT made STREQUAL committed)
  message(FATAL_ERROR "made: ${made}; in ${MESHES}: ${committed}")
endif()
foreach(mesh ${made})
  file(SHA256 ${WORK}/${mesh} a)
  file(SHA256 ${MESHES}/${mesh} b)
  if(NOT a STREQUAL b)
    message(SEND_ERROR "${mesh} is not what make_meshes makes")
  endif()
endforeach()
