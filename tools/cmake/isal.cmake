# Deflate::deflate, found by hand: Debian 12's package brings no files for CMake.
find_path(DEFLATE_INCLUDE_DIR libdeflate.h)
find_library(DEFLATE_LIBRARY deflate)
mark_as_advanced(DEFLATE_INCLUDE_DIR DEFLATE_LIBRARY)
if(NOT DEFLATE_INCLUDE_DIR OR NOT DEFLATE_LIBRARY)
  message(FATAL_ERROR "expected libdeflate, found none; install libdeflate-dev")
endif()
add_library(Deflate::deflate SHARED IMPORTED)
set_target_properties(Deflate::deflate PROPERTIES
  IMPORTED_LOCATION "${DEFLATE_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${DEFLATE_INCLUDE_DIR}")
