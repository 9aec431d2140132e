# What the tests of the programs have in common; WORK is their folder.

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# run(<status> <regular expression for stderr> <program> <argument>...)
# An empty expression wants an empty stderr, any other exactly one line that matches.
function(run status expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  string(REPLACE ";" " " shown "${ARGN}")
  if(NOT result STREQUAL status)
    message(SEND_ERROR "status ${result} instead of ${status}: ${shown}\n${err}")
  endif()
  if(expected STREQUAL "")
    if(NOT err STREQUAL "")
      message(SEND_ERROR "unexpected on stderr: ${shown}\n${err}")
    endif()
  elseif(NOT err MATCHES "^[a-z_]+: [^\n]*\n$" OR NOT err MATCHES "${expected}")
    message(SEND_ERROR "stderr is not one line with \"${expected}\": ${shown}\n${err}")
  endif()
  if(status GREATER 1 AND NOT out STREQUAL "")
    message(SEND_ERROR "unexpected on stdout: ${shown}\n${out}")
  endif()
endfunction()

# holds(<folder> <name>...): the folder, below WORK, holds these files and no others.
function(holds folder)
  file(GLOB_RECURSE found RELATIVE ${WORK}/${folder} LIST_DIRECTORIES true ${WORK}/${folder}/* ${WORK}/${folder}/.*)
  list(SORT found)
  set(expected ${ARGN})
  list(SORT expected)
  if(NOT "${found}" STREQUAL "${expected}") # an empty list is an unset variable
    message(SEND_ERROR "${folder} holds \"${found}\" instead of \"${expected}\"")
  endif()
endfunction()

# is(<JSON> <value> <key>...): what is there in it.
function(is json value)
  string(JSON found ERROR_VARIABLE error GET "${json}" ${ARGN})
  if(NOT found STREQUAL value)
    message(SEND_ERROR "${ARGN}: \"${found}\" instead of \"${value}\"")
  endif()
endfunction()
