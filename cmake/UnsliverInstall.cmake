# What `cmake --install` lays down: headers, the archive, the program, and what CMake and pkg-config need to
# find them. tests/install proves it on consumers.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/unsliver)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/unsliver DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN *.hpp)
install(TARGETS unsliver EXPORT unsliverTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET unsliver_cli)
  install(TARGETS unsliver_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

install(EXPORT unsliverTargets NAMESPACE unsliver:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/unsliverConfig.cmake.in
  ${PROJECT_BINARY_DIR}/unsliverConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/unsliverConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/unsliverConfig.cmake ${PROJECT_BINARY_DIR}/unsliverConfigVersion.cmake
        DESTINATION ${package_dir})

# The way from the .pc file back to the prefix, so that an installed tree can be moved.
file(RELATIVE_PATH prefix_from_pc /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/unsliver.pc.in ${PROJECT_BINARY_DIR}/unsliver.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/unsliver.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
