# Debian packages, one a component of what is installed; tools/package makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME inkedge)
set(CPACK_PACKAGE_CONTACT "Inkedge developers <inkedge@example.org>")
set(CPACK_PACKAGE_VENDOR Inkedge)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL command library development)
if(inkedge_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(exact "libinkedge0 (= ${PROJECT_VERSION})")
set(about "Inkedge turns 3D models into line drawings, vector files\nand maps of lines, depth, normals and ids.")

# inkedge_package(COMPONENT NAME SECTION SUMMARY DEPENDS)
function(inkedge_package component name section summary depends)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${about}" PARENT_SCOPE)
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/${name})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${documents} RENAME copyright COMPONENT ${component}
          EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/package/changelog.gz DESTINATION ${documents} COMPONENT ${component}
          EXCLUDE_FROM_ALL)
endfunction()
inkedge_package(command inkedge graphics "line drawings of 3D models, without a screen" "${exact}")
inkedge_package(library libinkedge0 libs "line drawings of 3D models: library"
                "libegl1, libegl-mesa0 | libegl-vendor, libgl1-mesa-dri")
inkedge_package(development libinkedge-dev libdevel "line drawings of 3D models: headers for C and C++"
                "${exact}, libglm-dev")
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
inkedge_package(python python3-inkedge python "line drawings of 3D models: module for Python"
                "${exact}, python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
file(WRITE ${PROJECT_BINARY_DIR}/package/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/triggers)
# A module calls nothing of libc. Scripts that call ldconfig are CPack's own, and harmless beside the trigger. The name
# has the major version alone: all that depends on the library names its whole version.
file(WRITE ${PROJECT_BINARY_DIR}/package/libinkedge0
     "libinkedge0: library-not-linked-against-libc *\n"
     "libinkedge0: maintscript-calls-ldconfig *\n"
     "libinkedge0: package-name-doesnt-match-sonames *\n")
install(FILES ${PROJECT_BINARY_DIR}/package/libinkedge0 DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
        COMPONENT library EXCLUDE_FROM_ALL)

include(CPack)
