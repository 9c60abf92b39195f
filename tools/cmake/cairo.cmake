# Cairo::cairo, found by hand: Debian's package brings no files for CMake.
find_path(CAIRO_INCLUDE_DIR cairo-pdf.h PATH_SUFFIXES cairo)
find_library(CAIRO_LIBRARY cairo)
mark_as_advanced(CAIRO_INCLUDE_DIR CAIRO_LIBRARY)
if(NOT CAIRO_INCLUDE_DIR OR NOT CAIRO_LIBRARY)
  message(FATAL_ERROR "expected Cairo with PDF, found none; install libcairo2-dev")
endif()
add_library(Cairo::cairo SHARED IMPORTED)
set_target_properties(Cairo::cairo PROPERTIES
  IMPORTED_LOCATION "${CAIRO_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${CAIRO_INCLUDE_DIR}")
