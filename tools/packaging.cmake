# What `cmake --install` puts where, and the Debian packages that `cpack` makes: the programs, and the
# module for Python.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS toile ${toile_programs} RUNTIME COMPONENT programs)

# Man pages say what --help says.
add_executable(man_pages tools/man_pages.cpp)
target_link_libraries(man_pages PRIVATE toile_tools)
set(pages toile toile-fit toile-try toile-batch toile-compare ${toile_programs})
list(TRANSFORM pages REPLACE "(.+)" "${PROJECT_BINARY_DIR}/man/\\1.1")
add_custom_command(OUTPUT ${pages}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
  COMMAND man_pages ${PROJECT_BINARY_DIR}/man)
add_custom_target(man ALL DEPENDS ${pages})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)

install(DIRECTORY samples DESTINATION ${CMAKE_INSTALL_DATADIR}/toile COMPONENT programs)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/toile RENAME copyright
        COMPONENT programs)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-toile RENAME copyright
        COMPONENT python)

# The library, and the headers for its callers: find_package(Toile), then link Toile::toile.
install(TARGETS toile_library EXPORT Toile LIBRARY COMPONENT libraries)
install(DIRECTORY include/toile DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libraries)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Toile)
configure_package_config_file(tools/ToileConfig.cmake.in ToileConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(ToileConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ToileConfig.cmake
              ${PROJECT_BINARY_DIR}/ToileConfigVersion.cmake
        DESTINATION ${package} COMPONENT libraries)
install(EXPORT Toile NAMESPACE Toile:: FILE ToileTargets.cmake DESTINATION ${package}
        COMPONENT libraries)

# build/release/toile_VERSION_amd64.deb and python3-toile_VERSION_amd64.deb, by `cpack --config build/release/CPackConfig.cmake`. Needs
# dpkg-dev, which finds the libraries that the programs depend on. Pictures need a font.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME toile)
set(CPACK_PACKAGE_CONTACT "Toile's maintainers")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL programs python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME toile)
set(CPACK_DEBIAN_PROGRAMS_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-toile)
set(CPACK_DEBIAN_PYTHON_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
