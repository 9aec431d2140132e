# headers_alone(<target> <include folder> [<regular expression of headers that are left out>])
#
# A program of one source file per header, which includes that header alone, and twice; one more source
# includes all headers, those too that have no file of their own. It compiles if every header brings what it needs and has a guard that works, and
# links if no header defines a function that is neither inline nor a template.

function(headers_alone target root)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_sources)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${root} ${root}/CGAL/*.h)
  set(sources)
  set(all "")
  foreach(header ${headers})
    if(header MATCHES "/IO/" AND NOT TARGET CGAL::Simple_manifolds_IO)
      continue()
    endif()
    if(header MATCHES "/IO/png_images" AND NOT TARGET CGAL::Simple_manifolds_PNG)
      continue()
    endif()
    if(header MATCHES "/IO/.*report" AND NOT ZLIB_FOUND)
      continue()
    endif()
    string(APPEND all "#include <${header}>\n")
    if(ARGC GREATER 2 AND header MATCHES "${ARGV2}")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${header}" name)
    file(CONFIGURE OUTPUT ${folder}/${name}.cpp CONTENT "#include <${header}>\n#include <${header}>\n")
    list(APPEND sources ${folder}/${name}.cpp)
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/all.cpp CONTENT "${all}\nint main() {}\n")

  add_executable(${target} ${sources} ${folder}/all.cpp)
  target_include_directories(${target} PRIVATE ${root})
  simple_manifolds_program(${target} NO_PCH HEADER_ONLY)
  # Only the compiler's judgement is wanted, so spend no time on good code.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
endfunction()
