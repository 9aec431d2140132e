# The page of reports, made from the folder viewer/ and three.js (Debian: libjs-three):
#
#   simple_manifolds_report_page(<folder>)
#
# writes report_page.html and simple_manifolds_report_page.h, which holds it as a constant, into the folder. Also
# a script: cmake -DFOLDER=<folder> -P Simple_manifolds_report.cmake

find_file(SIMPLE_MANIFOLDS_THREE_JS three.min.js
  PATHS /usr/share/javascript/three PATH_SUFFIXES share/javascript/three share/javascript/three/build
  DOC "three.js, which shows reports")
mark_as_advanced(SIMPLE_MANIFOLDS_THREE_JS)
set(SIMPLE_MANIFOLDS_VIEWER "${CMAKE_CURRENT_LIST_DIR}/../viewer") # in our sources
if(NOT EXISTS "${SIMPLE_MANIFOLDS_VIEWER}/report.html")
  set(SIMPLE_MANIFOLDS_VIEWER "${CMAKE_CURRENT_LIST_DIR}/viewer") # installed
endif()

function(simple_manifolds_write_if_new file content) # what has not changed need not be compiled again
  set(old "")
  if(EXISTS "${file}")
    file(READ "${file}" old)
  endif()
  if(NOT old STREQUAL content)
    file(WRITE "${file}" "${content}")
  endif()
endfunction()

function(simple_manifolds_report_page folder)
  set(script "(() => {\n'use strict';\n\n")
  foreach(part data colours geometry places view controls plots parts main)
    file(READ "${SIMPLE_MANIFOLDS_VIEWER}/${part}.js" text)
    string(APPEND script "${text}\n")
    list(APPEND sources "${SIMPLE_MANIFOLDS_VIEWER}/${part}.js")
  endforeach()
  string(APPEND script "})();")
  file(READ "${SIMPLE_MANIFOLDS_VIEWER}/report.css" style)
  file(READ "${SIMPLE_MANIFOLDS_VIEWER}/three_js_licence.txt" licence)
  file(READ "${SIMPLE_MANIFOLDS_THREE_JS}" three)
  file(READ "${SIMPLE_MANIFOLDS_VIEWER}/report.html" page)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources}
    "${SIMPLE_MANIFOLDS_VIEWER}/report.html" "${SIMPLE_MANIFOLDS_VIEWER}/report.css")
  string(REPLACE "<!-- style -->" "${style}" page "${page}")
  string(REPLACE "<!-- script -->" "${script}" page "${page}")
  string(REPLACE "<!-- three -->" "/*\n${licence}*/\n${three}" page "${page}")
  simple_manifolds_write_if_new("${folder}/report_page.html" "${page}")
  string(CONCAT header "#ifndef SIMPLE_MANIFOLDS_REPORT_PAGE_H\n#define SIMPLE_MANIFOLDS_REPORT_PAGE_H\n\n"
    "#include <string_view>\n\ninline constexpr char simple_manifolds_report_text[] = R\"_page_(${page})_page_\";\n"
    "inline constexpr std::string_view simple_manifolds_report_page(simple_manifolds_report_text,\n"
    "  sizeof simple_manifolds_report_text - 1); // the compiler need not count\n\n#endif\n")
  simple_manifolds_write_if_new("${folder}/simple_manifolds_report_page.h" "${header}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  simple_manifolds_report_page("${FOLDER}")
endif()
