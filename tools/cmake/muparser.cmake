# muparser::muparser, found by hand: the files for CMake that come with it bring its version's flags along.
find_path(MUPARSER_INCLUDE_DIR muParser.h)
find_library(MUPARSER_LIBRARY muparser)
mark_as_advanced(MUPARSER_INCLUDE_DIR MUPARSER_LIBRARY)
if(NOT MUPARSER_INCLUDE_DIR OR NOT MUPARSER_LIBRARY)
  message(FATAL_ERROR "expected muParser 2.3, found none; install libmuparser-dev, or set INKEDGE_MUPARSER to OFF")
endif()
add_library(muparser::muparser SHARED IMPORTED)
set_target_properties(muparser::muparser PROPERTIES
  IMPORTED_LOCATION "${MUPARSER_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${MUPARSER_INCLUDE_DIR}")
