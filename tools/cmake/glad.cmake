# inkedge_glad: OpenGL 4.5 core function tables, one a context, generated into the build tree.
# The generator belongs to Debian's own interpreter; another python3 may stand earlier on PATH.
find_program(GLAD_EXECUTABLE glad HINTS /usr/bin REQUIRED)
set(glad_folder ${PROJECT_BINARY_DIR}/glad)
add_custom_command(
  OUTPUT ${glad_folder}/src/gl.c ${glad_folder}/include/glad/gl.h
  COMMAND ${GLAD_EXECUTABLE} --quiet --reproducible --api gl:core=4.5 --extensions GL_KHR_debug
          --out-path ${glad_folder} c --mx
  COMMENT "Generating the OpenGL loader"
  VERBATIM)
add_library(inkedge_glad OBJECT ${glad_folder}/src/gl.c)
target_include_directories(inkedge_glad SYSTEM PUBLIC ${glad_folder}/include)
