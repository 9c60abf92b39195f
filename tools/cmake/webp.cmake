# WebP::webp, found by hand: Debian 12's package brings no files for CMake.
find_path(WEBP_INCLUDE_DIR webp/decode.h)
find_library(WEBP_LIBRARY webp)
mark_as_advanced(WEBP_INCLUDE_DIR WEBP_LIBRARY)
if(NOT WEBP_INCLUDE_DIR OR NOT WEBP_LIBRARY)
  message(FATAL_ERROR "expected libwebp, found none; install libwebp-dev")
endif()
add_library(WebP::webp SHARED IMPORTED)
set_target_properties(WebP::webp PROPERTIES
  IMPORTED_LOCATION "${WEBP_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${WEBP_INCLUDE_DIR}")
