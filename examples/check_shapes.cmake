# cmake -DMAP_SHAPES=<program> -DSHAPES=<folder data/> -DWORK=<empty folder> -P check_shapes.cmake
#
# map_shapes: the contract of its files, figures and exit statuses.

cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/check_tools.cmake)

set(a ${SHAPES}/gumby.off)
set(b ${SHAPES}/gumby_thin_arms.off)
file(WRITE ${WORK}/pairs.txt "0 0 # twice\n0, 0\n100 100\n200;200\n")
file(WRITE ${WORK}/a.fcsv "# Markups fiducial file version = 4.11\n1,-0.5,2,0.1,0,0,0,1,1,1,0,F-1,,\n")
file(WRITE ${WORK}/b.mrk.json "{\"markups\":[{\"controlPoints\":[{\"position\":[-0.5,2,0.1]}]}]}")

function(expect_files folder)
  foreach(name ${ARGN})
    if(NOT EXISTS ${folder}/${name})
      message(SEND_ERROR "${folder}: no ${name}")
    endif()
  endforeach()
endfunction()
# expect(<folder> <JSON path> <regular expression>): what metrics.json says.
function(expect folder path value)
  file(READ ${folder}/metrics.json json)
  separate_arguments(keys UNIX_COMMAND "${path}")
  string(JSON found ERROR_VARIABLE error GET "${json}" ${keys})
  if(NOT found MATCHES "^(${value})$")
    message(SEND_ERROR "${folder}/metrics.json: ${path} is ${found}, not ${value}")
  endif()
endfunction()

run(0 "" ${MAP_SHAPES} ${a} ${b} -o ${WORK}/two --landmarks ${WORK}/pairs.txt --effort fast --quiet)
expect_files(${WORK}/two 1.map.ply 2.map.ply 1_on_2.ply 1_on_2.csv landmarks.csv metrics.json report.html)
expect(${WORK}/two "pairs 0 landmarks exact" 4)
expect(${WORK}/two "pairs 0 landmarks max" 0.0)
expect(${WORK}/two "pairs 0 sd_a" "1[.][0-9]+")
expect(${WORK}/two "shapes 1 map flipped" 0)

# A file for each shape, points that go to the next vertex, and a folder of shapes with one template.
run(0 "" ${MAP_SHAPES} ${a} ${b} -o ${WORK}/points --landmarks ${WORK}/a.fcsv ${WORK}/b.mrk.json --effort fast --quiet)
expect(${WORK}/points "pairs 0 landmarks exact" 1)
file(COPY ${a} ${b} DESTINATION ${WORK}/folder)
file(COPY_FILE ${b} ${WORK}/folder/third.off)
run(0 "" ${MAP_SHAPES} ${WORK}/folder -o ${WORK}/three --template 3 --effort fast --quiet)
expect_files(${WORK}/three 3.map.ply 1_on_3.csv mean.ply)
expect(${WORK}/three "pairs 2 median" "1[.]0[0-9]*") # the same twice
expect(${WORK}/three "statistics compactness 0" "1[.]0|0[.]9[0-9]*")

# What is wrong is said, and nothing is written.
file(WRITE ${WORK}/bad.txt "0 0\n0 1\n")
file(WRITE ${WORK}/words.txt "0 zero\n")
file(WRITE ${WORK}/many.txt "0 4000000\n")
run(1 "2 of 2 landmarks contradict each other: vertex 0 to 0, 1 to 0|vertex 0 to 0, 0 to 1"
  ${MAP_SHAPES} ${a} ${b} -o ${WORK}/none --landmarks ${WORK}/bad.txt)
run(3 "words.txt, line 1" ${MAP_SHAPES} ${a} ${b} -o ${WORK}/none --landmarks ${WORK}/words.txt)
run(2 "no vertex 4000000" ${MAP_SHAPES} ${a} ${b} -o ${WORK}/none --landmarks ${WORK}/many.txt)
run(2 "at least two" ${MAP_SHAPES} ${a} -o ${WORK}/none)
run(2 "--corners" ${MAP_SHAPES} ${a} ${b} -o ${WORK}/none --corners 1,2,3,4)
run(4 "torus.off: .*genus" ${MAP_SHAPES} ${a} ${SHAPES}/torus.off -o ${WORK}/none)
if(EXISTS ${WORK}/none)
  message(SEND_ERROR "something was written where nothing could be done")
endif()
