# PkgConfig::httplib, with the definitions that the library was built with: sizes of its classes hang on them.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(httplib QUIET IMPORTED_TARGET cpp-httplib)
endif()
if(NOT httplib_FOUND)
  message(FATAL_ERROR "expected cpp-httplib, found none; install libcpp-httplib-dev, or set INKEDGE_TUNE to OFF")
endif()
