# cmake -DEXPECTED=<regular expression> -P check_output.cmake -- <program> <argument>...
# The program succeeds and prints what is expected; PASS_REGULAR_EXPRESSION would forget the first.

math(EXPR last "${CMAKE_ARGC} - 1")
foreach(k RANGE ${last})
  if(is_after)
    list(APPEND command "${CMAKE_ARGV${k}}")
  elseif(CMAKE_ARGV${k} STREQUAL "--")
    set(is_after TRUE)
  endif()
endforeach()
execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
message("${out}${err}")
if(NOT result EQUAL 0 OR "${out}${err}" MATCHES "ERROR OCCURRED") # with which Google Benchmark succeeds
  message(SEND_ERROR "status ${result}: ${command}")
endif()
if(NOT "${out}${err}" MATCHES "${EXPECTED}")
  message(SEND_ERROR "no \"${EXPECTED}\" in the output of ${command}")
endif()
