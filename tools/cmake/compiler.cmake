# inkedge_compiler: the warnings and sanitizers that all of our own code is built with.
add_library(inkedge_compiler INTERFACE)
target_compile_options(inkedge_compiler INTERFACE -Wall -Wextra -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(inkedge_compiler INTERFACE -Wno-restrict)  # takes "text" + std::string for an overlap: bug 105651
endif()
if(INKEDGE_WARNINGS_AS_ERRORS)
  target_compile_options(inkedge_compiler INTERFACE -Werror)
endif()
if(INKEDGE_SANITIZE)
  target_compile_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE} -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=undefined)
  target_link_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE})
endif()
