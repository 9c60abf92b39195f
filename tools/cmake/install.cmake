# What `cmake --install` puts where, so that find_package(inkedge) offers the target inkedge::inkedge.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/inkedge)

target_compile_features(inkedge PUBLIC cxx_std_20)  # the public headers need it
install(TARGETS inkedge EXPORT inkedgeTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS inkedge_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
install(DIRECTORY src/inkedge DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN *.h)
install(FILES src/c/inkedge.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(tools/cmake/inkedge.pc.in ${PROJECT_BINARY_DIR}/inkedge.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/inkedge.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
# The manual page and the completions are what the command itself prints.
if(NOT CMAKE_CROSSCOMPILING)
  set(texts ${PROJECT_BINARY_DIR}/texts)
  file(MAKE_DIRECTORY ${texts})
  add_custom_command(OUTPUT ${texts}/inkedge.1.gz VERBATIM DEPENDS inkedge_command
                     COMMAND sh -c "\"$1\" manual | gzip -9n > \"$2\"" sh $<TARGET_FILE:inkedge_command>
                             ${texts}/inkedge.1.gz)
  set(text_files ${texts}/inkedge.1.gz)
  foreach(text IN ITEMS "completion bash>inkedge" "completion zsh>_inkedge"
                        "completion fish>inkedge.fish")
    string(REGEX MATCH "^(.*)>(.*)$" matched ${text})
    separate_arguments(arguments UNIX_COMMAND ${CMAKE_MATCH_1})
    add_custom_command(OUTPUT ${texts}/${CMAKE_MATCH_2} VERBATIM DEPENDS inkedge_command
                       COMMAND $<TARGET_FILE:inkedge_command> ${arguments} > ${texts}/${CMAKE_MATCH_2})
    list(APPEND text_files ${texts}/${CMAKE_MATCH_2})
  endforeach()
  add_custom_target(inkedge_texts ALL DEPENDS ${text_files})
  install(FILES ${texts}/inkedge.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
  install(FILES ${texts}/inkedge DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT command)
  install(FILES ${texts}/_inkedge DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT command)
  install(FILES ${texts}/inkedge.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT command)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT license)

install(EXPORT inkedgeTargets NAMESPACE inkedge:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(tools/cmake/inkedgeConfig.cmake.in ${PROJECT_BINARY_DIR}/inkedgeConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/inkedgeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/inkedgeConfig.cmake ${PROJECT_BINARY_DIR}/inkedgeConfigVersion.cmake
        tools/cmake/inkedgeImageTest.cmake tools/cmake/inkedgeRunImageTest.cmake
        DESTINATION ${package_folder} COMPONENT development)
