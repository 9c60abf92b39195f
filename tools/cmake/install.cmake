# What `cmake --install` puts where, so that find_package(inkedge) offers the target inkedge::inkedge.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/inkedge)

target_compile_features(inkedge PUBLIC cxx_std_20)  # the public headers need it
install(TARGETS inkedge EXPORT inkedgeTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS inkedge_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY src/inkedge DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT inkedgeTargets NAMESPACE inkedge:: DESTINATION ${package_folder})
configure_package_config_file(tools/cmake/inkedgeConfig.cmake.in ${PROJECT_BINARY_DIR}/inkedgeConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/inkedgeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/inkedgeConfig.cmake ${PROJECT_BINARY_DIR}/inkedgeConfigVersion.cmake
        DESTINATION ${package_folder})
