# inkedge_shaders(TARGET programs... FUNCTIONS VERTEX+FRAGMENT): expands, validates and embeds GLSL programs.
#
# Each program is written NAME=VERTEX+FRAGMENT[:DEFINE[=VALUE]...]; the stages are files under shaders/. The target then
# offers the header gl/embedded_programs.h with one enumerator a program and its text.
# FUNCTIONS names the stages around each file of shaders/functions.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

function(inkedge_shaders target)
  cmake_parse_arguments(shaders "" "FUNCTIONS" "" ${ARGN})
  set(folder ${PROJECT_BINARY_DIR}/shaders)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
  set(script ${PROJECT_SOURCE_DIR}/tools/cmake/embed_shaders.py)
  add_custom_command(
    OUTPUT ${folder}/gl/embedded_programs.h ${folder}/embedded_programs.cpp
    COMMAND ${Python3_EXECUTABLE} ${script} --glslang ${GLSLANG_VALIDATOR} --shaders ${PROJECT_SOURCE_DIR}/shaders
            --out ${folder} --functions ${shaders_FUNCTIONS} ${shaders_UNPARSED_ARGUMENTS}
    DEPENDS ${sources} ${script}
    COMMENT "Validating and embedding shaders"
    VERBATIM)
  add_library(${target} OBJECT ${folder}/embedded_programs.cpp ${folder}/gl/embedded_programs.h)
  target_include_directories(${target} PUBLIC ${folder})
endfunction()
