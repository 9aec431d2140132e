# cmake -DONE=<program> -DOTHER=<program> -P compare.cmake
#
# Both programs succeed and print the same, and more than a thousand lines.

cmake_minimum_required(VERSION 3.22)
foreach(program ONE OTHER)
  execute_process(COMMAND ${${program}} RESULT_VARIABLE status OUTPUT_VARIABLE ${program}_output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${${program}} ended with ${status}")
  endif()
endforeach()
if(NOT ONE_output STREQUAL OTHER_output)
  message(FATAL_ERROR "${ONE} and ${OTHER} print different numbers")
endif()
string(REGEX MATCHALL "\n" lines "${ONE_output}")
list(LENGTH lines count)
if(count LESS 1000)
  message(FATAL_ERROR "${count} lines are too few to compare")
endif()
message(STATUS "${count} lines are the same")
