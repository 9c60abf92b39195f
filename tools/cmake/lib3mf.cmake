# Lib3MF::lib3mf, version 1.8, found by hand: Debian's package brings no files for CMake.
find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(LIB3MF_LIBRARY 3MF)
mark_as_advanced(LIB3MF_INCLUDE_DIR LIB3MF_LIBRARY)
if(NOT LIB3MF_INCLUDE_DIR OR NOT LIB3MF_LIBRARY)
  message(FATAL_ERROR "expected lib3mf 1.8, found none; install lib3mf-dev, or set INKEDGE_3MF to OFF")
endif()
add_library(Lib3MF::lib3mf SHARED IMPORTED)
set_target_properties(Lib3MF::lib3mf PROPERTIES
  IMPORTED_LOCATION "${LIB3MF_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${LIB3MF_INCLUDE_DIR}")

find_package(ZLIB REQUIRED)  # what its archives are packed with
