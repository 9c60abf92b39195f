# inkedge_compiler: the warnings and sanitizers that all of our own code is built with.
add_library(inkedge_compiler INTERFACE)
target_compile_options(inkedge_compiler INTERFACE -Wall -Wextra -Wconversion -Wshadow)
if(INKEDGE_WARNINGS_AS_ERRORS)
  target_compile_options(inkedge_compiler INTERFACE -Werror)
endif()
if(INKEDGE_SANITIZE)
  target_compile_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE} -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=undefined)
  target_link_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE})
endif()
