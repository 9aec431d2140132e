# cmake -DFIT_MESH=<program> -DEXPORT_SURFACE=<program> -DMESHES=<folder> -DWORK=<empty folder>
#       -P check_export.cmake
#
# export_surface: the exit status, and the files that it leaves. Their contents are tested elsewhere.

cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# run(<status> <program> <argument>...)
function(run status)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE err)
  if(NOT result STREQUAL status)
    string(REPLACE ";" " " shown "${ARGN}")
    message(SEND_ERROR "status ${result} instead of ${status}: ${shown}\n${err}")
  endif()
endfunction()

# Leaves exactly these files in WORK/out.
function(exports files)
  file(MAKE_DIRECTORY ${WORK}/out)
  run(0 ${EXPORT_SURFACE} ${ARGN})
  file(GLOB found RELATIVE ${WORK}/out ${WORK}/out/*)
  if(NOT found STREQUAL files)
    message(SEND_ERROR "export_surface left \"${found}\" instead of \"${files}\"")
  endif()
  file(REMOVE_RECURSE ${WORK}/out)
endfunction()

run(0 ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/fit --tolerance 0.05 --quiet)
set(surface ${WORK}/fit/surface.json)
set(map ${WORK}/fit/map.ply)
set(out ${WORK}/out/s)
set(images s_chart0.png s_chart1.png s_chart2.png s_chart3.png s_chart4.png s_chart5.png)
exports("s.mtl;s.obj" ${surface} -o ${out}.obj --subdivisions 5)
exports("s.mtl;s.obj;${images}" ${surface} -o ${out}.obj --subdivisions 5 --texture normals --texels 16)
exports("s.mtl;s.obj;${images}" ${map} -o ${out}.obj --texture checker --texels 16)
exports("s.vtp" ${surface} -o ${out}.vtp --subdivisions 5 --map ${map})
exports("s.glb" ${surface} -o ${out}.glb --chord-error 0.001)
exports("s.ply" ${map} -o ${out}.ply)
exports("s.glb" ${surface} -o ${out}.glb --subdivisions 5 --texture curvature --texels 16)

run(0 ${EXPORT_SURFACE} --help)

# What is refused could be written: the folder exists, and stays empty.
file(MAKE_DIRECTORY ${WORK}/out)
run(2 ${EXPORT_SURFACE} ${surface} -o ${out}.stl)
run(2 ${EXPORT_SURFACE} ${surface})
run(2 ${EXPORT_SURFACE} ${surface} -o ${out}.obj --chord-error 0)
run(2 ${EXPORT_SURFACE} ${surface} -o ${out}.vtp --texture normals)
run(2 ${EXPORT_SURFACE} ${surface} -o ${out}.obj --texture wood)
run(2 ${EXPORT_SURFACE} ${map} -o ${out}.obj --texture normals)
run(2 ${EXPORT_SURFACE} ${map} --map ${map} -o ${out}.glb)
run(2 ${EXPORT_SURFACE} ${surface} -o ${WORK}/none/s.glb) # there is no such folder
run(3 ${EXPORT_SURFACE} ${WORK}/none.json -o ${out}.obj)
run(3 ${EXPORT_SURFACE} ${surface} --map ${surface} -o ${out}.glb)
file(GLOB found ${WORK}/out/*)
if(found OR EXISTS ${WORK}/none)
  message(SEND_ERROR "a failed export left files: ${found}")
endif()

# The inputs stay, also one that has the name of the file of materials.
configure_file(${surface} ${WORK}/out/s.mtl COPYONLY)
run(2 ${EXPORT_SURFACE} ${out}.mtl -o ${out}.obj)
run(2 ${EXPORT_SURFACE} ${map} -o ${map})
run(0 ${CMAKE_COMMAND} -E compare_files ${surface} ${out}.mtl)
