# inkedge_compiler: the warnings and sanitizers that all of our own code is built with.
add_library(inkedge_compiler INTERFACE)
target_compile_options(inkedge_compiler INTERFACE -Wall -Wextra -Wconversion -Wshadow)
# Several sources at once are no header, and a name that one of them has for itself is shadowed nowhere else.
target_compile_options(inkedge_compiler INTERFACE
  $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-shadow>
  $<$<AND:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # It takes "text" + std::string for an overlap: bug 105651.
  target_compile_options(inkedge_compiler INTERFACE -Wno-restrict)
endif()
if(INKEDGE_WARNINGS_AS_ERRORS)
  target_compile_options(inkedge_compiler INTERFACE -Werror)
endif()
if(INKEDGE_SANITIZE)
  target_compile_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE} -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=undefined)
  target_link_options(inkedge_compiler INTERFACE -fsanitize=${INKEDGE_SANITIZE})
endif()
if(INKEDGE_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "INKEDGE_FUZZ: expected clang++ as the compiler, found ${CMAKE_CXX_COMPILER_ID}")
  endif()
  target_compile_options(inkedge_compiler INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize-recover=all)
  target_compile_definitions(inkedge_compiler INTERFACE _GLIBCXX_ASSERTIONS)
endif()
