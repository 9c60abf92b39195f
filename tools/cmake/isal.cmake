# Isal::isal (ISA-L), found by hand: Debian's package brings no files for CMake.
find_path(ISAL_INCLUDE_DIR isa-l/igzip_lib.h)
find_library(ISAL_LIBRARY isal)
mark_as_advanced(ISAL_INCLUDE_DIR ISAL_LIBRARY)
if(NOT ISAL_INCLUDE_DIR OR NOT ISAL_LIBRARY)
  message(FATAL_ERROR "expected ISA-L, found none; install libisal-dev")
endif()
add_library(Isal::isal SHARED IMPORTED)
set_target_properties(Isal::isal PROPERTIES
  IMPORTED_LOCATION "${ISAL_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${ISAL_INCLUDE_DIR}")
