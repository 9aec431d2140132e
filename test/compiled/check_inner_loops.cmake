# cmake -DOBJDUMP=<program> -DPROGRAM=<program> -P check_inner_loops.cmake
#
# Looks into the object code of a program that evaluates surfaces in batches. Calls in the inner loops would halve the
# speed, and no result would show it: what the loops consist of must be no function of its own, and the versions for AVX2
# must call nothing.

cmake_minimum_required(VERSION 3.22)
set(inlined "upper_atan2|one_if_positive|add_blended|tensor_sum_rows|transport|divide|complete|prefetch|prefetch_for_writing")
string(CONCAT script
  "/^[0-9a-f]+ <.*>:$/ {"
  "  name = $0; loops = name ~ /internal::call_with_avx2</; found += loops;"
  "  if (name ~ /internal::([A-Za-z_]+<[^(]*>::)?(${inlined})[<(]/) print \"not inlined: \" name"
  "}"
  "loops && $2 ~ /^call/ { print name \" calls \" $0 }"
  "END { print \"loops: \" found }")
execute_process(COMMAND "${OBJDUMP}" --disassemble --demangle --no-show-raw-insn --section=.text "${PROGRAM}"
  COMMAND awk "${script}"
  OUTPUT_VARIABLE found RESULTS_VARIABLE status)
if(NOT status STREQUAL "0;0")
  message(FATAL_ERROR "${OBJDUMP} and awk ended with ${status}")
endif()
if(NOT found MATCHES "^loops: ([0-9]+)\n$")
  message(FATAL_ERROR "${found}")
endif()
if(CMAKE_MATCH_1 LESS 12) # weights and sums, for each order of derivatives and each atlas
  message(FATAL_ERROR "${CMAKE_MATCH_1} functions are too few: ${PROGRAM} does not evaluate in batches")
endif()
message(STATUS "${CMAKE_MATCH_1} functions call nothing")
