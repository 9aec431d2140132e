# cmake -DPART=inspect -DMAP_MESH=<program> -DMESHES=<folder> -DWORK=<empty folder> -P check_inspect.cmake
#
# map_mesh --inspect: it succeeds for whatever can be read, writes nothing, and the command that it names works.

cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/check_tools.cmake)

set(four "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
set(tetrahedron "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
set(loop "0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n") # a ring of four squares
file(WRITE ${WORK}/sphere.off "OFF\n5 4 0\n${four}nan 0 0\n${tetrahedron}")
file(WRITE ${WORK}/ring.off "OFF\n8 4 0\n${loop}4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
file(WRITE ${WORK}/book.off "OFF\n5 3 0\n${four}0 0 -1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n")
file(WRITE ${WORK}/moebius.off "OFF\n5 5 0\n${four}1 1 1\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n")
file(WRITE ${WORK}/twice.off "OFF\n4 6 0\n${four}${tetrahedron}3 0 2 1\n3 1 1 2\n")
file(WRITE ${WORK}/nan.off "OFF\n4 4 0\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n${tetrahedron}")
file(WRITE ${WORK}/cloud.off "OFF\n4 0 0\n${four}")
file(WRITE ${WORK}/point.off "OFF\n4 4 0\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n${tetrahedron}")

# inspected(<file> <line that is printed> <JSON path> <value>): and what the JSON says.
function(inspected file expected path value)
  execute_process(COMMAND ${MAP_MESH} ${file} --inspect WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0 OR NOT err STREQUAL "" OR NOT out MATCHES "${expected}")
    message(SEND_ERROR "map_mesh ${file} --inspect: status ${status}, not \"${expected}\":\n${out}${err}")
  endif()
  execute_process(COMMAND ${MAP_MESH} ${file} --inspect --json WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE status OUTPUT_VARIABLE json ERROR_VARIABLE err)
  separate_arguments(keys UNIX_COMMAND "${path}")
  if(NOT status EQUAL 0 OR NOT err STREQUAL "")
    message(SEND_ERROR "map_mesh ${file} --inspect --json: status ${status}: ${err}")
  endif()
  is("${json}" ${value} ${keys})
endfunction()

inspected(${MESHES}/sphere.off "part-1 +162 +320 +closed +0 .*sphere\n.*command +map_mesh .*sphere.off -o OUT.ply\n"
  "read parts 0 surface" sphere)
inspected(sphere.off "5 vertices [(]1 of no face[)], 4 faces.*nothing to repair.*sphere" "unused_vertices" 1)
inspected(ring.off "part-1 +8 +4 +2 .*command +map_mesh ring.off -o OUT.ply --close-borders inner\n"
  "read parts 0 borders 0 length" 12.0)
inspected(book.off "1 edge belongs to more than two faces.*command +map_mesh book.off -o OUT.ply --repair"
  "read faults non_manifold_edges" 1)
inspected(moebius.off "1 component is one-sided.*with --repair" "read parts 0 orientable" OFF)
inspected(twice.off "1 degenerate face dropped.*1 duplicate face dropped.*part-1 +4 +4 +closed" "read repair dropped_degenerate" 1)
inspected(nan.off "1 vertex has a coordinate that is NaN.*with --repair" "served_parts" 1)
inspected(cloud.off "4 vertices [(]4 of no face[)], 0 faces.*no face.*command +none" "parts" 0)
inspected(point.off "degenerate|closed" "faces" 4)

# The command does what it says.
foreach(row "sphere" "ring;--close-borders;inner" "twice")
  list(POP_FRONT row file)
  run(0 "" ${MAP_MESH} ${WORK}/${file}.off -o ${WORK}/${file}.ply ${row} --quiet)
endforeach()
run(2 "--json" ${MAP_MESH} ${WORK}/sphere.off -o ${WORK}/none.ply --json)
run(2 "output" ${MAP_MESH} ${WORK}/sphere.off)
run(3 "none.off" ${MAP_MESH} ${WORK}/none.off --inspect)
if(EXISTS ${WORK}/none.ply OR EXISTS ${WORK}/OUT.ply)
  message(SEND_ERROR "--inspect: a file was written")
endif()
