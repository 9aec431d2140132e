# cmake -DOBJDUMP=<program> -DPROGRAM=<program> -P check_inner_loops.cmake
#
# Looks into the object code of a program that makes maps and evaluates surfaces in batches. Calls in the inner loops would
# halve the speed, and no result would show it: what the loops consist of must be no function of its own, and the versions
# for AVX2 must call nothing; those of the maps only roots of negative numbers and, for landmarks, the nearest integer,
# and they must divide by fours.

cmake_minimum_required(VERSION 3.22)
set(inlined "upper_atan2|one_if_positive|add_blended|tensor_sum_rows|transport|divide|complete|prefetch|prefetch_for_writing")
string(CONCAT script
  "/^[0-9a-f]+ <.*>:$/ {"
  "  name = $0; loops = name ~ /internal::call_with_avx2</; found += loops;"
  "  stars = name ~ /internal::call_for_avx2</ && name ~ /Coarse_to_fine_layout/;"
  "  if (name ~ /internal::([A-Za-z_]+<[^(]*>::)?(${inlined})[<(]/) print \"not inlined: \" name"
  "}"
  "loops && $2 ~ /^call/ { print name \" calls \" $0 }"
  "stars && $2 ~ /^call/ && !/<(sqrt|round)@plt>/ { print name \" calls \" $0 }"
  "stars && /vdivpd .*%ymm/ { ++divisions[name] }"
  "END { for (name in divisions) relaxing += divisions[name] >= 6; print \"stars: \" relaxing }"
  "END { print \"loops: \" found }")
execute_process(COMMAND "${OBJDUMP}" --disassemble --demangle --no-show-raw-insn --section=.text "${PROGRAM}"
  COMMAND awk "${script}"
  OUTPUT_VARIABLE found RESULTS_VARIABLE status)
if(NOT status STREQUAL "0;0")
  message(FATAL_ERROR "${OBJDUMP} and awk ended with ${status}")
endif()
if(NOT found MATCHES "^stars: ([0-9]*)\nloops: ([0-9]+)\n$")
  message(FATAL_ERROR "${found}")
endif()
if(NOT CMAKE_MATCH_1 EQUAL 3) # sphere, torus, square
  message(FATAL_ERROR "Stars of '${CMAKE_MATCH_1}' domains, not 3, are relaxed by vectors of four")
endif()
if(CMAKE_MATCH_2 LESS 12) # weights and sums, for each order of derivatives and each atlas
  message(FATAL_ERROR "${CMAKE_MATCH_2} functions are too few: ${PROGRAM} does not evaluate in batches")
endif()
message(STATUS "${CMAKE_MATCH_2} functions call nothing")
