# cmake -DPROGRAM=<file> -DCOMPILER=<g++ or clang++> -DINCLUDES=<folder>|... -P check_wrong_program.cmake
#
# The compiler refuses the program, and what it says in its first five lines is the sentence in the program's
# first line.

cmake_minimum_required(VERSION 3.22)
file(STRINGS ${PROGRAM} sentence LIMIT_COUNT 1)
if(NOT sentence MATCHES "^// says: (.+)$")
  message(FATAL_ERROR "${PROGRAM} does not start with the sentence that the compiler has to say")
endif()
string(REPLACE "\\;" ";" sentence "${CMAKE_MATCH_1}") # which file() has escaped

string(REPLACE "|" ";" includes "${INCLUDES}")
list(TRANSFORM includes PREPEND "-I")
execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only ${includes} ${PROGRAM}
  RESULT_VARIABLE status ERROR_VARIABLE output)
if(status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} compiles")
endif()
string(REGEX MATCH "^([^\n]*\n?[^\n]*\n?[^\n]*\n?[^\n]*\n?[^\n]*)" start "${output}")
string(FIND "${start}" "${sentence}" position)
if(position EQUAL -1)
  message(FATAL_ERROR "the compiler does not start with \"${sentence}\", but with\n${start}")
endif()
