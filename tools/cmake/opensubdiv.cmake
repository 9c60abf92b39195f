# OpenSubdiv::osdCPU, found by hand: Debian's package names static libraries that it does not bring, and CMake refuses
# it.
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OPENSUBDIV_CPU_LIBRARY osdCPU)
mark_as_advanced(OPENSUBDIV_INCLUDE_DIR OPENSUBDIV_CPU_LIBRARY)
if(NOT OPENSUBDIV_INCLUDE_DIR OR NOT OPENSUBDIV_CPU_LIBRARY)
  message(FATAL_ERROR "expected OpenSubdiv 3.5, found none; install libosd-dev, or set INKEDGE_OPENSUBDIV to OFF")
endif()
add_library(OpenSubdiv::osdCPU SHARED IMPORTED)
set_target_properties(OpenSubdiv::osdCPU PROPERTIES
  IMPORTED_LOCATION "${OPENSUBDIV_CPU_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${OPENSUBDIV_INCLUDE_DIR}")
