# headers_alone(<target> <include folder> [EXCEPT <regular expression>] [ALL <source>] [COMPILED])
#
# A program of one source file per header, which includes that header alone, and twice, except for headers that match;
# one more source includes all headers. It compiles if every header brings what it needs and has a guard that works, and
# links if no header defines a function that is neither inline nor a template.
#
# ALL is a source with a main() instead of the one that is made here. It includes <all_headers.h> and, before that if
# it wants, <headers_of_others.h>: those that our headers include, of the standard library, of CGAL, Eigen and others.
#
# With COMPILED the headers are those of the compiled library's users, if it is built, which have no definitions and are
# compiled in half the time; the source that includes all of them sees the definitions nevertheless.

function(headers_alone target root)
  cmake_parse_arguments(PARSE_ARGV 2 arg "COMPILED" "EXCEPT;ALL" "")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_sources)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${root} ${root}/CGAL/*.h)
  set(sources)
  set(all "")
  set(others)
  foreach(header ${headers})
    if(header MATCHES "/IO/" AND NOT TARGET CGAL::Simple_manifolds_IO)
      continue()
    endif()
    if(header MATCHES "/IO/png_images" AND NOT TARGET CGAL::Simple_manifolds_PNG)
      continue()
    endif()
    if(header MATCHES "/IO/internal/read_gltf" AND NOT TARGET CGAL::Simple_manifolds_assimp)
      continue()
    endif()
    if(header MATCHES "/IO/.*report" AND NOT ZLIB_FOUND)
      continue()
    endif()
    string(APPEND all "#include <${header}>\n")
    file(STRINGS ${root}/${header} lines REGEX "^ *# *include <")
    string(REGEX REPLACE "[^;<]*<([^>]*)>[^;]*" "\\1" names "${lines}")
    list(APPEND others ${names})
    if(arg_EXCEPT AND header MATCHES "${arg_EXCEPT}")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${header}" name)
    file(CONFIGURE OUTPUT ${folder}/${name}.cpp CONTENT "#include <${header}>\n#include <${header}>\n")
    list(APPEND sources ${folder}/${name}.cpp)
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/all_headers.h CONTENT "${all}")
  if(arg_ALL)
    list(REMOVE_DUPLICATES others)
    list(FILTER others EXCLUDE REGEX "^CGAL/([Ss]imple_manifolds|draw_|Graphics_scene|.*Basic_viewer)") # Qt
    set(foreign "")
    foreach(header ${others})
      set(needed ${header})
      if(header STREQUAL "Eigen/CholmodSupport")
        set(needed cholmod.h)
      endif()
      string(APPEND foreign "#if __has_include(<${needed}>)\n#include <${header}>\n#endif\n")
    endforeach()
    file(CONFIGURE OUTPUT ${folder}/headers_of_others.h CONTENT "${foreign}")
  else()
    set(arg_ALL ${folder}/all.cpp)
    file(CONFIGURE OUTPUT ${arg_ALL} CONTENT "#include <all_headers.h>\n\nint main() {}\n")
  endif()

  add_executable(${target} ${sources} ${arg_ALL})
  target_include_directories(${target} PRIVATE ${root} ${folder})
  if(arg_COMPILED)
    simple_manifolds_program(${target} NO_PCH)
    set_source_files_properties(${arg_ALL} PROPERTIES COMPILE_OPTIONS -UCGAL_SIMPLE_MANIFOLDS_COMPILED)
  else()
    simple_manifolds_program(${target} NO_PCH HEADER_ONLY)
  endif()
  # Only the compiler's judgement is wanted, so spend no time on good code.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
endfunction()
