# cmake -DREADME=<file> -DPROGRAM=<file> -P check_readme.cmake
#
# The C++ program that README.md shows is, byte for byte, the program that is compiled and run.

cmake_minimum_required(VERSION 3.22)
file(READ ${README} readme)
file(READ ${PROGRAM} program)
get_filename_component(name ${PROGRAM} NAME)

string(FIND "${readme}" "```cpp\n${program}```\n" position)
if(position EQUAL -1)
  message(FATAL_ERROR "README.md does not quote ${name} as it is")
endif()
