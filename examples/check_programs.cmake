# cmake -DPART=good_input|properties|corners|bad_input|usage -DMAP_MESH=<program> -DFIT_MESH=<program> -DMESHES=<folder>
#       -DWORK=<empty folder> -DHAS_REPORT=ON|OFF -P check_programs.cmake
#
# The contract of map_mesh and fit_mesh: exit status, one line on stderr with the numbers, and either all
# files or none.

cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/check_tools.cmake)

# ---- Input that must work ---------------------------------------------------------------------------
if(PART STREQUAL good_input)
  set(fitted map.ply surface.json surface.ply metrics.json)
  if(HAS_REPORT)
    list(APPEND fitted report.html)
    run(0 "" ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/reported.ply --report ${WORK}/reported.html)
    run(2 "none" ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/none.ply --report ${WORK}/none/r.html)
    if(NOT EXISTS ${WORK}/reported.html OR EXISTS ${WORK}/none.ply)
      message(SEND_ERROR "map_mesh --report: no report, or a map without its report")
    endif()
  endif()
  foreach(mesh sphere torus_quad nefertiti)
    run(0 "" ${MAP_MESH} ${MESHES}/${mesh}.off -o ${WORK}/${mesh}.ply --metrics ${WORK}/${mesh}.json)
    run(0 "" ${MAP_MESH} ${MESHES}/${mesh}.off -o ${WORK}/paper.ply --metrics ${WORK}/paper.json --method paper)
    run(0 "" ${FIT_MESH} ${MESHES}/${mesh}.off -o ${WORK}/new/${mesh} --tolerance 0.05 --samples 10 --quiet)
    holds(new/${mesh} ${fitted} samples.csv)
    # The paper's method: the same map by both programs.
    run(0 "" ${FIT_MESH} ${MESHES}/${mesh}.off -o ${WORK}/new/paper --method paper --tolerance 0.05 --quiet)
    holds(new/paper ${fitted})
    run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/paper.ply ${WORK}/new/paper/map.ply)
  endforeach()

  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/options --max-tolerance 0.05 --marking vertices
    --economy --fairness 1e-9 --max-controls 3000 --correct-parameters --quiet)
  holds(new/options ${fitted})

  file(READ ${WORK}/new/sphere/metrics.json metrics)
  foreach(path "input vertices" "input faces" "input genus" "seconds read" "seconds map" "seconds certify"
      "seconds fit" "seconds tessellate" "seconds write" "peak_memory_bytes" "map flipped" "map degree"
      "map angle" "map area" "map symmetric_dirichlet" "map l2_efficiency" "map min_area" "map chart_counts 5"
      "map stars_without_chart" "surface controls" "surface patches_per_chart 5" "surface rms_error"
      "surface max_error" "surface charts 5 controls" "surface levels 0 controls" "surface bytes samples"
      "surface normal_deviation" "surface closest_point_rms" "surface closest_point_max" "parameters tolerance"
      "version simple_manifolds" "version cgal")
    separate_arguments(keys UNIX_COMMAND "${path}")
    string(JSON value ERROR_VARIABLE error GET "${metrics}" ${keys})
    if(error OR value STREQUAL "")
      message(SEND_ERROR "metrics.json has no ${path}")
    endif()
  endforeach()
  is("${metrics}" 162 input vertices)
  file(STRINGS ${WORK}/new/sphere/samples.csv samples)
  list(LENGTH samples count)
  if(NOT count EQUAL 11)
    message(SEND_ERROR "samples.csv has ${count} lines instead of 11")
  endif()
  list(GET samples 0 names)
  file(STRINGS ${WORK}/new/sphere/surface.ply confidence REGEX "^property double confidence$")
  if(NOT confidence OR NOT names MATCHES ",confidence$")
    message(SEND_ERROR "surface.ply or samples.csv without confidence: ${names}")
  endif()

  # Vertices of no face are left out: that is said, and map.ply has the numbers of the others.
  set(tetrahedron "0 0 0\n1 0 0\n8 8 8\n0 1 0\n0 0 1\n3 1 4 2\n3 1 2 5\n3 2 4 5\n3 4 1 5\n")
  file(WRITE ${WORK}/unused.off "OFF\n6 4 0\n9 9 9\n${tetrahedron}")
  execute_process(COMMAND ${MAP_MESH} ${WORK}/unused.off -o ${WORK}/unused.ply OUTPUT_VARIABLE out)
  file(STRINGS ${WORK}/unused.ply numbered REGEX "^property int input_vertex$")
  file(STRINGS ${WORK}/sphere.ply not_numbered REGEX "^property int input_vertex$")
  if(NOT out MATCHES "left out +2 vertices of no face\n" OR NOT numbered OR not_numbered)
    message(SEND_ERROR "vertices of no face: they are not named in the map, or others are:\n${out}")
  endif()

  # What a person reads: a dozen lines with units, none of them long, and a row per chart.
  function(says expected) # program, arguments
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out)
    foreach(line ${expected})
      if(NOT out MATCHES "\n +${line}\n")
        message(SEND_ERROR "there is no line \"${line}\":\n${out}")
      endif()
    endforeach()
    string(REPLACE "\n" ";" lines "${out}")
    list(POP_FRONT lines file) # its name may be long
    list(LENGTH lines count)
    foreach(line ${lines})
      string(LENGTH "${line}" length)
      if(count GREATER 22 OR length GREATER 100)
        message(SEND_ERROR "${count} lines, and one with ${length} characters: ${line}")
      endif()
    endforeach()
  endfunction()
  set(map "mesh +162 vertices, 320 faces, closed, genus 0" "map +onto the sphere, .* 0 faces flipped, degree 1"
    "memory +[0-9.]+ MB at most")
  set(fit ${map} "normals +[0-9.]+ degrees rms from those of the faces"
    "time +[0-9.e-]+ s to map and fit, [0-9.e-]+ s in all")
  says("${map};time +[0-9.e-]+ s to map, [0-9.e-]+ s in all;chart +vertices;5 +[0-9]+"
    ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/sphere.ply)
  says("${fit};rms error +[0-9.e-]+ % of the diagonal [(]tolerance 5 %[)];5 +[0-9]+ +[0-9]+ +1 +[0-9.e-]+ % +[0-9.e-]+ %"
    ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/sphere --tolerance 0.05 --samples 10)
  says("${fit};weighted error +.* in the worst chart [(]tolerance 5 %[)];chart +vertices +controls +patches +rms error +largest"
    ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/paper --method paper --tolerance 0.05)

  # The paper's map and patches together, and each with the other's partner.
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/paper --method paper --tolerance 0.01 --samples 10 --quiet)
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/patches --surface patches --tolerance 0.01 --quiet)
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/splines --method paper --surface hierarchical
    --tolerance 0.05 --quiet)
  foreach(row "paper;paper;patches" "patches;certified;patches" "splines;paper;hierarchical")
    list(GET row 0 name)
    list(GET row 1 method)
    list(GET row 2 surface)
    file(READ ${WORK}/new/${name}/metrics.json metrics)
    string(JSON wrote_method GET "${metrics}" parameters method)
    string(JSON wrote_surface GET "${metrics}" parameters surface)
    string(JSON partition ERROR_VARIABLE no_partition GET "${metrics}" partition attempts)
    string(JSON delta ERROR_VARIABLE no_delta GET "${metrics}" surface charts 5 average_delta)
    if(NOT wrote_method STREQUAL method OR NOT wrote_surface STREQUAL surface)
      message(SEND_ERROR "${name}: metrics.json says ${wrote_method} and ${wrote_surface}")
    endif()
    if((method STREQUAL paper AND no_partition) OR (surface STREQUAL patches AND no_delta)
        OR (method STREQUAL certified AND NOT no_partition) OR (surface STREQUAL hierarchical AND NOT no_delta))
      message(SEND_ERROR "${name}: metrics.json has partition ${partition}, average_delta ${delta}")
    endif()
  endforeach()
  # One patch per chart, and no more than that is allowed.
  run(1 "tolerance was not reached: weighted error .*average [(]tolerance 0.0001[)].*294 controls.*written"
    ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/one --method paper --tolerance 1e-4 --max-patches 1 --quiet)
  holds(one ${fitted})
  file(READ ${WORK}/one/metrics.json metrics)
  is("${metrics}" 1 surface patches_per_chart 5)

  # The smallest disk: its border gets the fourth corner that the square has.
  file(WRITE ${WORK}/triangle.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
  run(0 "" ${FIT_MESH} ${WORK}/triangle.off -o ${WORK}/new/triangle --quiet)
  holds(new/triangle ${fitted})

  # An inward oriented mesh is mapped as it is, and the metrics say so.
  file(WRITE ${WORK}/inward.off
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n")
  run(0 "" ${MAP_MESH} ${WORK}/inward.off -o ${WORK}/inward.ply --metrics ${WORK}/inward.json)
  file(READ ${WORK}/inward.json metrics)
  is("${metrics}" ON input inward_oriented)

  # Balanced and refined, a tetrahedron meets the paper's criteria: every star has a chart.
  run(0 "" ${MAP_MESH} ${WORK}/inward.off -o ${WORK}/refined.ply --balance --refine --metrics ${WORK}/refined.json)
  file(READ ${WORK}/refined.json metrics)
  is("${metrics}" 0 map criteria stars_without_chart)
  is("${metrics}" 0 map criteria vertices_outside_of_their_star)
  string(JSON vertices GET "${metrics}" map vertices)
  if(NOT vertices GREATER 4)
    message(SEND_ERROR "the refined tetrahedron has ${vertices} vertices")
  endif()

  # A map is a mesh too. The number of threads changes nothing. Foreign files stay, our own are replaced.
  run(0 "" ${MAP_MESH} ${WORK}/sphere.ply -o ${WORK}/again.ply --threads 1 --quiet)
  run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/sphere.ply ${WORK}/again.ply)
  file(WRITE ${WORK}/new/sphere/mine.txt "mine")
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/new/sphere/ --tolerance 0.05 --threads 2 --quiet)
  holds(new/sphere ${fitted} samples.csv mine.txt)
  # The map of a fit is the one that suits a fit.
  run(0 "" ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/for_fit.ply --energy amips --lambda 0.1 --area-floor 0.02)
  run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/for_fit.ply ${WORK}/new/sphere/map.ply)
  # Both lie where they are asked to.
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/placed --tolerance 0.05 --position shape --quiet)
  run(1 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/placed/map.ply ${WORK}/new/sphere/map.ply)
  run(0 "" ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/placed.ply --energy amips --lambda 0.1 --area-floor 0.02
    --position shape)
  run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/placed.ply ${WORK}/placed/map.ply)

  # A compact fit moves the map. What is written does not turn over where the mesh does not; of a thin wedge both do.
  run(0 "" ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/compact --tolerance 0.01 --fit-effort compact --quiet)
  run(1 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/compact/map.ply ${WORK}/new/sphere/map.ply)
  file(READ ${WORK}/compact/metrics.json metrics)
  is("${metrics}" 0 written turning_edges mesh)
  is("${metrics}" 0 written turning_edges surface)
  file(WRITE ${WORK}/wedge.off "OFF\n6 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 0.1\n0 0 -0.1\n"
    "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 0 5\n3 2 1 5\n3 3 2 5\n3 0 3 5\n")
  run(0 "" ${FIT_MESH} ${WORK}/wedge.off -o ${WORK}/wedge --tolerance 0.05 --max-tolerance 1 --quiet)
  file(READ ${WORK}/wedge/metrics.json metrics)
  is("${metrics}" 4 written turning_edges mesh)

  # Flat faces of few triangles get more of them, if that is wanted.
  file(WRITE ${WORK}/bar.off "OFF\n8 12 0\n0 0 0\n9 0 0\n9 1 0\n0 1 0\n0 0 1\n9 0 1\n9 1 1\n0 1 1\n"
    "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")
  foreach(reshape never always)
    run(0 "" ${FIT_MESH} ${WORK}/bar.off -o ${WORK}/bar --tolerance 0.05 --max-tolerance 1 --reshape ${reshape} --quiet)
    file(READ ${WORK}/bar/metrics.json metrics)
    string(JSON vertices GET "${metrics}" map vertices)
    if((reshape STREQUAL never AND NOT vertices EQUAL 8) OR (reshape STREQUAL always AND NOT vertices GREATER 50))
      message(SEND_ERROR "--reshape ${reshape}: ${vertices} vertices")
    endif()
  endforeach()

  # Not reached: status 1, the numbers, and all files.
  run(1 "tolerance was not reached: rms error [0-9.e-]+ .*max [0-9.e-]+ .*written"
    ${FIT_MESH} ${MESHES}/sphere.off -o ${WORK}/tight --tolerance 1e-12 --max-controls 2000 --quiet)
  holds(tight ${fitted})
endif()

# ---- What a file has beside its mesh ----------------------------------------------------------------
if(PART STREQUAL properties)
  # Colours go on, texcoord of corners has no place in a map, the points at the end are passed over.
  file(WRITE ${WORK}/in.ply "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\n"
    "property list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty int label\n"
    "element edge 1\nproperty int v\nend_header\n0 0 0 9 8 7\n1 0 0 9 8 7\n0 1 0 9 8 7\n0 0 1 9 8 7\n"
    "3 0 2 1 0 5\n3 0 1 3 0 6\n3 1 2 3 0 7\n3 2 0 3 0 8\n4\n")
  execute_process(COMMAND ${MAP_MESH} ${WORK}/in.ply --inspect OUTPUT_VARIABLE out)
  execute_process(COMMAND ${MAP_MESH} ${WORK}/in.ply --inspect --json OUTPUT_VARIABLE json)
  string(JSON face_property ERROR_VARIABLE error GET "${json}" face_properties 0)
  if(NOT out MATCHES "\n +warning +1 element that is no face.*\n +properties +colour, label\n"
      OR NOT face_property STREQUAL label)
    message(SEND_ERROR "--inspect says nothing of the properties:\n${out}")
  endif()
  foreach(program ${MAP_MESH} ${FIT_MESH})
    set(output ${WORK}/fit)
    set(options --tolerance 0.3)
    set(files ${WORK}/fit/map.ply ${WORK}/fit/surface.ply)
    set(metrics ${WORK}/fit/metrics.json)
    if(program STREQUAL "${MAP_MESH}")
      set(output ${WORK}/map.ply)
      set(metrics ${WORK}/map.json)
      set(options --refine --metrics ${metrics})
      set(files ${WORK}/map.ply)
    endif()
    execute_process(COMMAND ${program} ${WORK}/in.ply -o ${output} ${options} OUTPUT_VARIABLE out ERROR_VARIABLE err)
    foreach(line "warning +1 element that is no face is skipped: edge" "properties +colour, label"
        "dropped +face list texcoord: neither vertices nor faces")
      if(NOT out MATCHES "\n +${line}")
        message(SEND_ERROR "there is no line \"${line}\":\n${out}${err}")
      endif()
    endforeach()
    foreach(file ${files})
      file(STRINGS ${file} header REGEX "^property (uchar (red|green|blue)|int label)$")
      list(LENGTH header count)
      if(NOT count EQUAL 4)
        message(SEND_ERROR "${file} has not all properties: ${header}")
      endif()
    endforeach()
    file(READ ${metrics} json)
    foreach(path "warnings 0 count" "vertex_properties 0" "face_properties 0" "dropped_properties 0 reason")
      separate_arguments(keys UNIX_COMMAND "${path}")
      string(JSON value ERROR_VARIABLE error GET "${json}" input ${keys})
      if(error OR value STREQUAL "")
        message(SEND_ERROR "metrics.json has no input ${path}")
      endif()
    endforeach()
  endforeach()
endif()

# Facets that have collapsed in 32 bits are named as the possible cause of a refusal.
if(PART STREQUAL properties)
  set(header "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
  file(WRITE ${WORK}/tube.ply ${header} "4e6 0 0\n4e6 0 0\n4000001 0 0\n4e6 1 0\n4e6 0 1\n4e6 0 1\n4000001 0 1\n4e6 1 1\n"
    "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
  run(4 "border.* edges of faces have no length since the numbers of 32 bits" ${MAP_MESH} ${WORK}/tube.ply
    -o ${WORK}/tube.map.ply)
endif()

# ---- The corners of the square: those of a patch by itself, or others on demand ---------------------
if(PART STREQUAL corners)
  set(grid "OFF\n25 16 0\n")
  foreach(i RANGE 24)
    math(EXPR x "${i} % 5")
    math(EXPR y "${i} / 5")
    string(APPEND grid "${x} ${y} 0\n")
  endforeach()
  foreach(i RANGE 3)
    foreach(j RANGE 3)
      math(EXPR a "5 * ${i} + ${j}")
      math(EXPR b "${a} + 1")
      math(EXPR c "${a} + 6")
      math(EXPR d "${a} + 5")
      string(APPEND grid "4 ${a} ${b} ${c} ${d}\n")
    endforeach()
  endforeach()
  file(WRITE ${WORK}/grid.off "${grid}")
  run(0 "" ${MAP_MESH} ${WORK}/grid.off -o ${WORK}/grid.ply --quiet)
  run(0 "" ${MAP_MESH} ${WORK}/grid.off -o ${WORK}/same.ply --corners 0,4,24,20 --quiet --metrics ${WORK}/same.json)
  run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/grid.ply ${WORK}/same.ply)
  run(0 "" ${MAP_MESH} ${WORK}/grid.off -o ${WORK}/other.ply --corners 2,14,22,10 --energy amips --lambda 0.1
    --area-floor 0.02 --quiet)
  # A square goes to the square with hardly any distortion; turned by 45 degrees it does not.
  file(READ ${WORK}/same.json metrics)
  string(JSON angle GET "${metrics}" map angle)
  run(0 "" ${FIT_MESH} ${WORK}/grid.off -o ${WORK}/fit --corners 2,14,22,10 --quiet)
  file(READ ${WORK}/fit/metrics.json metrics)
  string(JSON turned GET "${metrics}" map angle)
  if(angle GREATER 1.1 OR turned LESS 1.5)
    message(SEND_ERROR "--corners: angle distortion ${angle} and ${turned}")
  endif()
  run(0 "" ${CMAKE_COMMAND} -E compare_files ${WORK}/other.ply ${WORK}/fit/map.ply)
  foreach(row "0,4,24;four vertices are needed, not 3" "0,4,24,20,15;not 5" "0,4,,20;is no number" "0,4,24,-1;-1.*no number"
      "0,4,24,x;x.*no number" "0,4,24,25;no vertex 25, the mesh has 25" "0,4,12,20;vertex 12 is not on the border"
      "0,20,24,4;counterclockwise" "0,4,4,20;counterclockwise")
    list(POP_BACK row message)
    run(2 "--corners: .*${message}" ${MAP_MESH} ${WORK}/grid.off -o ${WORK}/none.ply --corners ${row})
    run(2 "--corners: .*${message}" ${FIT_MESH} ${WORK}/grid.off -o ${WORK}/none --corners ${row})
  endforeach()
  run(2 "only a disk has corners, and the mesh is closed" ${MAP_MESH} ${MESHES}/sphere.off -o ${WORK}/none.ply
    --corners 0,1,2,3)
  run(2 "the method paper" ${FIT_MESH} ${WORK}/grid.off -o ${WORK}/none --corners 0,4,24,20 --method paper)
  if(EXISTS ${WORK}/none.ply OR EXISTS ${WORK}/none)
    message(SEND_ERROR "--corners: a file was written in spite of an error")
  endif()
endif()

# ---- Input that must be refused ---------------------------------------------------------------------
if(PART STREQUAL bad_input)
  set(in ${WORK}/in)
  file(WRITE ${in}/empty.off "")
  file(WRITE ${in}/text.off "Dear reader,\nthis is a letter.\n")
  file(WRITE ${in}/text.ply "Dear reader,\nthis is a letter.\n")
  file(WRITE ${in}/text.stl "Dear reader,\nthis is a letter.\n")
  file(WRITE ${in}/text.obj "Dear reader,\nthis is a letter.\n")
  file(WRITE ${in}/mesh.xyz "0 0 0\n1 0 0\n0 1 0\n")
  file(MAKE_DIRECTORY ${in}/folder.off)
  file(CREATE_LINK circle.off ${in}/circle.off SYMBOLIC)
  string(REPEAT "long" 75 long)
  set(four "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
  file(WRITE ${in}/truncated.off "OFF\n4 4 0\n${four}3 0 2 1\n3 0 1 3\n")
  file(WRITE ${in}/huge.off "OFF\n1000000000 4 0\n${four}")
  file(WRITE ${in}/index.off "OFF\n4 1 0\n${four}3 0 1 4\n")
  file(WRITE ${in}/nan.off "OFF\n4 4 0\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
  file(WRITE ${in}/point.off "OFF\n4 4 0\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
  file(WRITE ${in}/cloud.off "OFF\n4 0 0\n${four}")
  file(WRITE ${in}/edge.off "OFF\n5 3 0\n${four}0 0 -1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n")
  file(WRITE ${in}/orientation.off "OFF\n4 2 0\n${four}3 0 1 2\n3 0 1 3\n")
  file(WRITE ${in}/face.off "OFF\n4 1 0\n${four}3 0 1 1\n")
  # A ring of quads: two border loops.
  file(WRITE ${in}/loops.off "OFF\n8 4 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n"
    "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
  # Two tori of seven vertices, joined at a triangle, and a hole: genus 2, but not closed.
  set(faces "")
  foreach(i RANGE 6)
    foreach(pair "1;3" "3;2")
      list(GET pair 0 j)
      list(GET pair 1 k)
      math(EXPR j "(${i} + ${j}) % 7")
      math(EXPR k "(${i} + ${k}) % 7")
      if(NOT "${i} ${j} ${k}" STREQUAL "0 1 3")
        if(i LESS 6) # a large hole: small ones are closed
          string(APPEND faces "3 ${i} ${j} ${k}\n")
        endif()
        set(mirrored "")
        foreach(v ${i} ${k} ${j}) # of the second torus: 2 4 5 6 become 7 8 9 10
          if(v EQUAL 2)
            set(v 7)
          elseif(v GREATER 3)
            math(EXPR v "${v} + 4")
          endif()
          string(APPEND mirrored " ${v}")
        endforeach()
        string(APPEND faces "3${mirrored}\n")
      endif()
    endforeach()
  endforeach()
  set(points "")
  foreach(i RANGE 10)
    math(EXPR square "${i} * ${i}")
    math(EXPR cube "${i} * ${square}")
    string(APPEND points "${i} ${square} ${cube}\n")
  endforeach()
  file(WRITE ${in}/genus2.off "OFF\n11 24 0\n${points}${faces}")

  file(MAKE_DIRECTORY ${WORK}/out ${WORK}/existing)
  foreach(row
      "3;missing.off;does not exist" "3;empty.off;empty" "3;text.off;Dear" "3;text.ply;PLY" "3;text.stl;STL"
      "3;text.obj;OBJ" "3;mesh.xyz;extension" "3;folder.off;regular file" "3;circle.off;link" "3;${long}.off;too long"
      "3;${long};too long" "3;truncated.off;line 9.*ends"
      "3;huge.off;1000000000 vertices" "3;index.off;face 0 refers to vertex 4"
      "4;nan.off;1 vertex .*NaN.*--repair" "4;cloud.off;no faces"
      "4;edge.off;1 edge belongs to more than two faces at .*--repair" "4;face.off;no face is left: 1 degenerate"
      "4;loops.off;2 border loops" "4;genus2.off;genus 2")
    list(GET row 0 status)
    list(GET row 1 name)
    list(GET row 2 message)
    run(${status} "${message}" ${MAP_MESH} ${in}/${name} -o ${WORK}/out/map.ply --metrics ${WORK}/out/map.json)
    run(${status} "${message}" ${FIT_MESH} ${in}/${name} -o ${WORK}/out/fit --samples 5)
    run(${status} "${message}" ${FIT_MESH} ${in}/${name} -o ${WORK}/existing)
  endforeach()
  # What cannot change the object is mended without being asked.
  run(0 "" ${MAP_MESH} ${in}/orientation.off -o ${WORK}/turned.ply --metrics ${WORK}/turned.json)
  file(READ ${WORK}/turned.json metrics)
  string(JSON turned GET "${metrics}" repair flipped)
  if(turned EQUAL 0)
    message(SEND_ERROR "no face of orientation.off was turned over")
  endif()
  # Faces that share no vertex, as exporters leave them, are welded; unless the user says that they are not to be.
  file(WRITE ${in}/seams.off "OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n0 0 0\n0 0 1\n0 1 0\n"
    "1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n")
  run(0 "" ${MAP_MESH} ${in}/seams.off -o ${WORK}/seams.ply --metrics ${WORK}/seams.json)
  file(READ ${WORK}/seams.json metrics)
  is("${metrics}" 8 repair welded)
  is("${metrics}" sphere map atlas)
  run(0 "" ${MAP_MESH} ${in}/seams.off -o ${WORK}/seams.ply --metrics ${WORK}/seams.json --weld none)
  file(READ ${WORK}/seams.json metrics)
  is("${metrics}" 4 totals served)
  # What changes the object is done when it is asked for: two tetrahedra that share an edge come apart.
  file(WRITE ${in}/bridge.off "OFF\n6 8 0\n0 0 0\n0 0 1\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
    "3 1 2 3\n3 0 4 1\n3 0 1 5\n3 0 5 4\n3 1 4 5\n")
  run(4 "1 edge belongs to more than two faces.*--repair" ${MAP_MESH} ${in}/bridge.off -o ${WORK}/out/map.ply)
  run(0 "" ${MAP_MESH} ${in}/bridge.off -o ${WORK}/bridge.ply --repair)
  file(STRINGS ${WORK}/bridge.2.ply repaired REGEX "^comment repaired$")
  if(NOT repaired)
    message(SEND_ERROR "bridge.off was not cut into two bodies, or the map does not say so")
  endif()
  # A mesh without extent can be mapped, but there is no diagonal to measure a fit by.
  run(4 "coincide" ${FIT_MESH} ${in}/point.off -o ${WORK}/out/fit)
  holds(out)
  holds(existing)
  run(0 "" ${MAP_MESH} ${in}/point.off -o ${WORK}/point.ply --metrics ${WORK}/point.json)
endif()

# ---- Command lines that make no sense, or ask for what is not there yet -----------------------------
if(PART STREQUAL usage)
  set(mesh ${MESHES}/sphere.off)
  file(WRITE ${WORK}/file "")
  foreach(row
      "output" "${mesh};output" "-o;${WORK}/o;INPUT" "${mesh};-o;${WORK}/o;--bogus;bogus" "${mesh};${mesh};-o;${WORK}/o;positional"
      "${mesh};-o;${WORK}/o;--threads;0;threads" "${mesh};-o;${WORK}/o;--threads;1025;from 1 to 1024" "${mesh};-o;${WORK}/o;--method;other;certified, paper")
    list(POP_BACK row message)
    run(2 "${message}|INPUT" ${MAP_MESH} ${row})
    run(2 "${message}|INPUT" ${FIT_MESH} ${row})
  endforeach()
  foreach(row "--area-floor;0;above 0" "--effort;much;fast, default, quality" "--position;left;none, shape, space" "--close-borders;some;none, small, inner" "--weld;much;none, or a number"
      "--energy;none;symmetric_dirichlet, amips"
      "--lambda;0;positive" "--lambda;x;lambda" "--metrics;${WORK}/none/m.json;m.json"
      "--metrics;${WORK}/o;another result is written to" "--metrics;${WORK}/./o;another result is written to"
      "--metrics;${mesh};INPUT would be overwritten")
    list(POP_BACK row message)
    run(2 "${message}" ${MAP_MESH} ${mesh} -o ${WORK}/o ${row})
  endforeach()
  foreach(row "--tolerance;0;positive" "--tolerance;nan;positive" "--max-tolerance;inf;positive" "--degree;9;2 to 5"
      "--smoothness;0;1 to " "--samples;-1;from 0" "--tol;1;tol" "--surface;mesh;hierarchical or patches"
      "--method;paper;--marking;all;marking is for --surface hierarchical" "--surface;patches;--economy;economy is for"
      "--max-patches;3;max-patches is for --surface patches" "--surface;patches;--max-patches;0;from 1 to 100")
    list(POP_BACK row message)
    run(2 "${message}" ${FIT_MESH} ${mesh} -o ${WORK}/o ${row})
  endforeach()
  run(2 "o.ply" ${MAP_MESH} ${mesh} -o ${WORK}/none/o.ply)
  # A shell hands over the empty names, which a list would lose.
  run(2 "name of a file is empty" sh -c "exec \"$@\" -o ''" sh ${MAP_MESH} ${mesh})
  run(2 "name of a file is empty" sh -c "exec \"$@\" --metrics ''" sh ${MAP_MESH} ${mesh} -o ${WORK}/o)
  run(2 "not a folder" sh -c "exec \"$@\" -o ''" sh ${FIT_MESH} ${mesh})
  # A file in the place of INPUT, also behind a link.
  file(WRITE ${WORK}/in/map.ply "mine")
  file(CREATE_LINK map.ply ${WORK}/in/link SYMBOLIC)
  run(2 "INPUT would be overwritten" ${MAP_MESH} ${WORK}/in/map.ply -o ${WORK}/in/link)
  run(2 "INPUT would be overwritten" ${FIT_MESH} ${WORK}/in/link -o ${WORK}/in)
  holds(in map.ply link)
  file(REMOVE_RECURSE ${WORK}/in)
  run(2 "not a folder" ${FIT_MESH} ${mesh} -o ${WORK}/file)
  run(0 "" ${MAP_MESH} --help)
  run(0 "" ${FIT_MESH} --help)
  run(0 "" ${FIT_MESH} --version)
  holds(. file)
endif()
