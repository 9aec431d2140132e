# cmake -DFIT_MESH=<program> -DEXPORT_SURFACE=<program> -DMESHES=<folder> -DWORK=<empty folder>
#       -P check_export.cmake
#
# export_surface: the exit status, and the files that it leaves. Their contents are tested elsewhere.

cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/check_tools.cmake)

# Leaves exactly these files in WORK/out.
function(exports files)
  file(MAKE_DIRECTORY ${WORK}/out)
  run(0 "" ${EXPORT_SURFACE} ${ARGN})
  holds(out ${files})
  file(REMOVE_RECURSE ${WORK}/out)
endfunction()

run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/fit --tolerance 0.05 --quiet)
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

# The triangles are within half the tolerance of the fit, and it says how far they are; a grid is what it is.
foreach(options "" "--subdivisions;5")
  execute_process(COMMAND ${EXPORT_SURFACE} ${surface} -o ${WORK}/s.ply ${options} OUTPUT_VARIABLE said)
  if(options AND NOT said MATCHES " 300 triangles")
    message(SEND_ERROR "export_surface --subdivisions makes another grid:\n${said}")
  endif()
  string(REGEX MATCH " at most ([0-9.e-]+) of the diagonal from the surface\n$" found "${said}")
  if(NOT found OR (NOT options AND NOT CMAKE_MATCH_1 LESS_EQUAL 0.025))
    message(SEND_ERROR "export_surface is not within half the tolerance:\n${said}")
  endif()
endforeach()

exports("s.obj" ${surface} -o ${out}.obj --subd 4)
run(0 "" ${EXPORT_SURFACE} ${surface} -o ${WORK}/cage.obj --subd 4)
file(STRINGS ${WORK}/cage.obj quads REGEX "^f [0-9]+ [0-9]+ [0-9]+ [0-9]+$")
list(LENGTH quads count)
if(NOT count EQUAL 96)
  message(SEND_ERROR "a cage of 4 cells per side has ${count} quads")
endif()
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.obj --subd 1)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.glb --subd 4)
run(2 "." ${EXPORT_SURFACE} ${map} -o ${out}.obj --subd 4)

# For CAD: a solid; its figures; a tolerance that is out of reach; and bodies that are fitted to the mesh.
exports("s.json;s.step" ${surface} -o ${out}.step --cad-tolerance 0.01 --unit inch --scale 2 --name ball --max-faces 6
        --face-cost 100 --schema ap242 --colour 1,0.5,0 --metrics ${out}.json)
run(0 "" ${EXPORT_SURFACE} ${surface} -o ${WORK}/a.stp)
file(STRINGS ${WORK}/a.stp solids REGEX "MANIFOLD_SOLID_BREP\\('a',")
file(STRINGS ${WORK}/a.stp faces REGEX "ADVANCED_FACE")
list(LENGTH faces count)
if(NOT solids OR NOT count EQUAL 6)
  message(SEND_ERROR "a.stp has ${count} faces, and the solids \"${solids}\"")
endif()
run(0 "" ${EXPORT_SURFACE} ${surface} -o ${WORK}/b.stp --name a)
run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/a.stp ${WORK}/b.stp) # deterministic
run(0 "" ${FIT_MESH} ${MESHES}/torus_quad.off -o ${WORK}/torus --tolerance 0.02 --quiet --cad ${WORK}/torus.step)
# Genus 2: a face for each of six hyperbolic squares.
run(0 "" ${FIT_MESH} ${MESHES}/eight.off -o ${WORK}/eight --tolerance 0.003 --quiet --cad ${WORK}/eight.step)
file(STRINGS ${WORK}/eight.step faces REGEX "ADVANCED_FACE")
file(STRINGS ${WORK}/eight.step solids REGEX "MANIFOLD_SOLID_BREP")
list(LENGTH faces count)
if(NOT solids OR NOT count EQUAL 6)
  message(SEND_ERROR "a body of genus 2 has ${count} faces")
endif()
# The STEP file appears with the folder, in it or elsewhere, or not at all.
run(0 "" ${FIT_MESH} ${MESHES}/torus_quad.off -o ${WORK}/with_cad --tolerance 0.02 --quiet
    --cad ${WORK}/with_cad/torus.step)
run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/torus.step ${WORK}/with_cad/torus.step)
run(2 "." ${FIT_MESH} ${MESHES}/torus_quad.off -o ${WORK}/without --tolerance 0.02 --quiet --cad ${WORK}/no/torus.step)
run(2 "." ${FIT_MESH} ${MESHES}/torus_quad.off -o ${WORK}/without --tolerance 0.02 --quiet --cad ${WORK}/map.ply)
if(EXISTS ${WORK}/without OR EXISTS ${WORK}/no OR EXISTS ${WORK}/map.ply)
  message(SEND_ERROR "fit_mesh --cad has left something of what it could not write")
endif()
run(0 "" ${EXPORT_SURFACE} ${WORK}/torus -o ${WORK}/whole.step --max-faces 1)
file(STRINGS ${WORK}/whole.step seams REGEX "SEAM_CURVE")
file(STRINGS ${WORK}/torus.step faces REGEX "ADVANCED_FACE")
list(LENGTH seams count)
list(LENGTH faces nine)
if(NOT count EQUAL 2 OR NOT nine EQUAL 9)
  message(SEND_ERROR "the torus has ${nine} faces, its whole one ${count} seams")
endif()
foreach(wrong "--cad-tolerance 0" "--unit mile" "--scale 0" "--schema ap203" "--colour 1,2,3" "--max-faces 0"
              "--face-cost -1" "--map ${map}" "--subdivisions 5" "--texture checker")
  separate_arguments(wrong)
  run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.step ${wrong})
endforeach()
run(2 "." ${EXPORT_SURFACE} ${map} -o ${out}.step)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.ply --unit mm)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.step --metrics ${surface})

run(0 "" ${EXPORT_SURFACE} --help)

# Properties of the mesh go on, or are named; z points upwards unless it is y.
file(WRITE ${WORK}/coloured.ply "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
  "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float heat\n"
  "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0 9 8 7 1\n1 0 0 9 8 7 2\n0 1 0 9 8 7 3\n"
  "0 0 1 9 8 7 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
run(0 "" ${FIT_MESH} ${WORK}/coloured.ply -o ${WORK}/coloured --tolerance 0.3 --quiet)
execute_process(COMMAND ${EXPORT_SURFACE} ${WORK}/coloured/map.ply -o ${WORK}/map.obj OUTPUT_VARIABLE said)
if(NOT said MATCHES "images\n  dropped, without a place in the format: heat of vertices\n$")
  message(SEND_ERROR "export_surface says of the properties:\n${said}")
endif()
foreach(up z y)
  run(0 "" ${EXPORT_SURFACE} ${WORK}/coloured/surface.json --map ${WORK}/coloured/map.ply -o ${WORK}/${up}.glb --up ${up})
  file(STRINGS ${WORK}/${up}.glb ${up} REGEX "_HEAT")
endforeach()
run(0 "" ${EXPORT_SURFACE} ${WORK}/coloured/surface.json --map ${WORK}/coloured/map.ply -o ${WORK}/default.glb)
run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/default.glb ${WORK}/z.glb)
if(NOT z OR NOT y OR z STREQUAL y)
  message(SEND_ERROR "export_surface --up: the same file for y and z, or one without properties")
endif()

# What is refused could be written: the folder exists, and stays empty.
file(MAKE_DIRECTORY ${WORK}/out)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.stl)
run(2 "." ${EXPORT_SURFACE} ${surface})
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.obj --chord-error 0)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.vtp --texture normals)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.obj --texture wood)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${out}.glb --up x)
run(2 "." ${EXPORT_SURFACE} ${map} -o ${out}.obj --texture normals)
run(2 "." ${EXPORT_SURFACE} ${map} --map ${map} -o ${out}.glb)
run(2 "." ${EXPORT_SURFACE} ${surface} -o ${WORK}/none/s.glb) # there is no such folder
run(3 "." ${EXPORT_SURFACE} ${WORK}/none.json -o ${out}.obj)
run(3 "." ${EXPORT_SURFACE} ${surface} --map ${surface} -o ${out}.glb)
file(GLOB found ${WORK}/out/*)
if(found OR EXISTS ${WORK}/none)
  message(SEND_ERROR "a failed export left files: ${found}")
endif()

# The inputs stay, also one that has the name of the file of materials.
configure_file(${surface} ${WORK}/out/s.mtl COPYONLY)
run(2 "." ${EXPORT_SURFACE} ${out}.mtl -o ${out}.obj)
run(2 "." ${EXPORT_SURFACE} ${map} -o ${map})
run(0 "" ${CMAKE_COMMAND} -E compare_files ${surface} ${out}.mtl)
