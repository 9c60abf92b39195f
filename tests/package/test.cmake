# Installs a build into a folder of its own, builds the project beside this file and the README's examples against it
# and runs them and the installed command.
# cmake -DBUILD=... -DWORK=... -DMODEL=... -DOTHER_MODEL=... -DREADME=... [-DCXX_COMPILER=... -DC_COMPILER=...
#       -DCXX_FLAGS=...] -P test.cmake
# With -DPYTHON=... -DPYTHON_FOLDER=... the installed Python module draws, too. With -DPREFIX=/usr instead of -DBUILD
# what is installed there is used.
cmake_minimum_required(VERSION 3.24)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(expect_start file bytes)
  file(READ ${file} start LIMIT 4 HEX)
  if(NOT start STREQUAL bytes)
    message(FATAL_ERROR "${file}: expected it to start with ${bytes}, found '${start}'")
  endif()
endfunction()

set(png 89504e47)
set(exr 762f3101)
set(xml 3c3f786d)

file(REMOVE_RECURSE ${WORK})
if(PREFIX)
  set(prefix ${PREFIX})
else()
  set(prefix ${WORK}/prefix)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/made)
  # Nothing may depend on where it was installed: move it.
  file(RENAME ${WORK}/made ${prefix})
endif()
if(NOT CXX_COMPILER)
  set(CXX_COMPILER c++)
  set(C_COMPILER cc)
endif()

# Builds the project in a folder of sources.
function(build sources folder)
  run(${CMAKE_COMMAND} -S ${sources} -B ${folder} -G Ninja -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
      -DCMAKE_EXE_LINKER_FLAGS=${LINKED_BESIDE} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()
build(${CMAKE_CURRENT_LIST_DIR} ${WORK}/build)

file(STRINGS ${WORK}/build/CMakeCache.txt found REGEX "^inkedge_DIR:")
if(NOT found MATCHES "=${prefix}/")
  message(FATAL_ERROR "expected find_package to find inkedge under ${prefix}, found ${found}")
endif()

# A library that may break with each MINOR has it in its name; inkedge.h is all headers.
file(GLOB library ${prefix}/lib/*/libinkedge.so ${prefix}/lib/libinkedge.so)
get_filename_component(library "${library}" DIRECTORY)
file(GLOB libraries ${library}/libinkedge.so.0.[0-9]*)
file(GLOB headers RELATIVE ${prefix}/include ${prefix}/include/inkedge/*.h)
list(REMOVE_ITEM headers inkedge/inkedge.h)
file(READ ${prefix}/include/inkedge/inkedge.h all)
foreach(header IN LISTS headers)
  if(NOT all MATCHES "#include <${header}>")
    message(FATAL_ERROR "expected inkedge.h to include ${header}, found that it does not")
  endif()
endforeach()
if(NOT libraries OR NOT headers)
  message(FATAL_ERROR "expected libinkedge.so.0.MINOR and headers under ${prefix}, found '${libraries}', "
                      "'${headers}'")
endif()

run(${WORK}/build/draw ${MODEL} ${WORK}/drawn.png ${WORK}/drawn.exr ${WORK}/drawn.svg)
expect_start(${WORK}/drawn.png ${png})
expect_start(${WORK}/drawn.exr ${exr})
expect_start(${WORK}/drawn.svg ${xml})

# Image tests as README has them, and one of a map: without references they fail, accepted ones hold, and another model
# fails with a picture of what changed.
file(READ ${README} readme)
if(NOT readme MATCHES "```cmake\n(find_package[^`]*inkedge_add_image_test[^`]*)```")
  message(FATAL_ERROR "expected an example of inkedge_add_image_test in README.md, found none")
endif()
set(suite ${WORK}/suite)
file(WRITE ${suite}/CMakeLists.txt "cmake_minimum_required(VERSION 3.24)\nproject(suite LANGUAGES CXX)\n"
     "${CMAKE_MATCH_1}"
     "inkedge_add_image_test(NAME bracket_depth MODEL bracket.glb SETTINGS --view iso --size 64x48 MAP depth "
     "REFERENCE expected/bracket_depth.png)\n")
file(COPY_FILE ${MODEL} ${suite}/bracket.glb)
run(${CMAKE_COMMAND} -S ${suite} -B ${suite}/build -G Ninja -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
function(expect_tests failing said_by_all)
  execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${suite}/build --output-on-failure RESULT_VARIABLE status
                  OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL failing OR NOT said MATCHES "${said_by_all}")
    message(FATAL_ERROR "expected ctest to end with ${failing} and '${said_by_all}', found ${status}: ${said}")
  endif()
endfunction()
expect_tests(8 "bracket_iso.png: expected a reference.*inkedge_accept_bracket_iso.*0% tests passed, 3 tests failed")
run(${CMAKE_COMMAND} --build ${suite}/build --target inkedge_accept)
expect_tests(0 "100% tests passed")
file(COPY_FILE ${OTHER_MODEL} ${suite}/bracket.glb)
expect_tests(8 "vanished   .*bracket_lines.difference.svg.*0% tests passed, 3 tests failed")
foreach(left IN ITEMS bracket_iso.png bracket_iso.difference.png bracket_lines.svg bracket_lines.difference.svg
                      bracket_depth.png bracket_depth.difference.png)
  if(NOT EXISTS ${suite}/build/image_tests/${left})
    message(FATAL_ERROR "expected ${left} to be left, found none")
  endif()
endforeach()
run(${CMAKE_COMMAND} --build ${suite}/build --target inkedge_accept_bracket_lines)
expect_tests(8 "33% tests passed, 2 tests failed")

# By pkg-config alone: from C with the strictest standard, for the header must be C.
execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${library}/pkgconfig pkg-config --cflags --libs inkedge
                OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${CXX_FLAGS} ${LINKED_BESIDE}")
list(APPEND flags -Wl,-rpath,${library})
run(${C_COMPILER} -std=c90 -Wall -Wextra -Wpedantic -Wno-long-long -Werror ${CMAKE_CURRENT_LIST_DIR}/main.c
    -o ${WORK}/build/draw_c ${flags})
run(${WORK}/build/draw_c ${MODEL} ${WORK}/c.png ${WORK}/c.svg)
expect_start(${WORK}/c.png ${png})
expect_start(${WORK}/c.svg ${xml})

# The README's examples, in a folder with the models that they name.
set(readme ${WORK}/readme)
file(MAKE_DIRECTORY ${readme})
find_program(python NAMES ${PYTHON} python3 REQUIRED)
run(${python} ${CMAKE_CURRENT_LIST_DIR}/readme.py ${README} ${readme})
file(COPY_FILE ${MODEL} ${readme}/part.glb)
file(WRITE ${readme}/part.ply "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
build(${readme} ${readme}/build)
run(${CXX_COMPILER} -std=c++20 -Wall -Wextra -Wno-unused -o ${readme}/snippets ${readme}/snippets.cpp ${flags})
run(${C_COMPILER} -Wall -Wextra -Werror -o ${readme}/outline_c ${readme}/outline.c ${flags})
foreach(program IN ITEMS build/outline snippets outline_c)
  run(${CMAKE_COMMAND} -E chdir ${readme} ./${program})
endforeach()
expect_start(${readme}/part.exr ${exr})
expect_start(${readme}/part_90.exr ${exr})
expect_start(${readme}/part.json 7b0a2020)

run(${prefix}/bin/inkedge render ${MODEL} --detector classic --size 64x64 --output ${WORK}/commanded.exr)
expect_start(${WORK}/commanded.exr ${exr})

if(PYTHON)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${WORK}/prefix/${PYTHON_FOLDER} PYTHONDONTWRITEBYTECODE=1
      ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/draw.py ${MODEL} ${WORK}/prefix)
endif()

if(PREFIX)
  return()
endif()

# Without its modules it still draws plain models, and says in one line what it lacks for the rest.
file(GLOB_RECURSE modules ${WORK}/prefix/*/inkedge_*.so)
if(NOT modules)
  message(FATAL_ERROR "expected modules under ${WORK}/prefix, found none")
endif()
file(REMOVE ${modules})
run(${WORK}/prefix/bin/inkedge render ${MODEL} --size 64x64 --output ${WORK}/plain.png)
expect_start(${WORK}/plain.png ${png})
function(expect_refusal status start)
  execute_process(COMMAND ${WORK}/prefix/bin/inkedge render ${MODEL} ${ARGN} RESULT_VARIABLE found ERROR_VARIABLE said)
  if(NOT found EQUAL status OR NOT said MATCHES "^inkedge: error: [^\n]*${start}.*; reinstall inkedge.*, or [^\n]*\n$")
    message(FATAL_ERROR "expected status ${status} and one line about ${start}, found ${found}: ${said}")
  endif()
endfunction()
expect_refusal(1 "lines from object space: expected inkedge_embree.so in " --lines-from object -o ${WORK}/lines.svg)
expect_refusal(1 "subdivision: expected inkedge_subdivision.so in " --subdivide 1 -o ${WORK}/smooth.png)
expect_refusal(5 "image formats: expected inkedge_image_formats.so in " -o ${WORK}/drawn.tif)
run(${WORK}/prefix/bin/inkedge render ${MODEL} --size 64x64 --maps depth --output ${WORK}/plain.exr)  # needs none
