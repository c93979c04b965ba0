# SPDX-License-Identifier: MIT
# Installs the library, its public headers and the package that find_package(pliant) reads.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pliant)

install(TARGETS pliant EXPORT pliantTargets COMPONENT library
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
# A header that only our own sources may include (it needs another library) ends in _internal.hpp.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/pliant DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT library
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*_internal.hpp" EXCLUDE)
install(EXPORT pliantTargets NAMESPACE pliant:: DESTINATION ${package_folder} COMPONENT library)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pliantConfig.cmake.in
  ${PROJECT_BINARY_DIR}/pliantConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/pliantConfig.cmake
  ${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/PliantDependencies.cmake
  DESTINATION ${package_folder} COMPONENT library)

if(TARGET pliant_command)
  install(TARGETS pliant_command COMPONENT command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(SKBUILD)  # beside the wheel's other scripts, so that it is found on PATH
    install(TARGETS pliant_command COMPONENT python EXCLUDE_FROM_ALL
            RUNTIME DESTINATION ${SKBUILD_SCRIPTS_DIR})
  endif()
endif()
