# Configures, builds and runs projects of users in the new folder WORK, against this package
#   WAY=installed     installed from the build folder BUILD into WORK/prefix: consumer/, and template/ of SOURCE
#   WAY=subdirectory  taken in with add_subdirectory(SOURCE): consumer/

cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "${line}\nended with ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
if(WAY STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config ${CONFIG})
  set(where -DCMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  set(where -DSIMPLE_MANIFOLDS_SOURCE_DIR=${SOURCE})
endif()

function(run_project folder)
  get_filename_component(name ${folder} NAME)
  set(build ${WORK}/${name}_build)
  run(${CMAKE_COMMAND} -S ${folder} -B ${build} -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER} -DCGAL_DIR=${CGAL_DIR} ${where})
  run(${CMAKE_COMMAND} --build ${build} --config Release)
  run(${CMAKE_CTEST_COMMAND} --test-dir ${build} -C Release --output-on-failure)
endfunction()

run_project(${CMAKE_CURRENT_LIST_DIR}/consumer)
if(WAY STREQUAL "installed")
  run_project(${SOURCE}/template)
endif()
