# SPDX-License-Identifier: MIT
# Installs the libraries, pliant.hpp with all that it includes, the licence, and what finds them:
# find_package(pliant) and pkg-config.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pliant)

# With BUILD_SHARED_LIBS they are shared, and show no symbols but those of namespace pliant.
if(BUILD_SHARED_LIBS)
  foreach(part core files record)
    set_target_properties(pliant_${part} PROPERTIES
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
      DEFINE_SYMBOL ""  # no source asks for it, and one precompiled header serves all
      INSTALL_RPATH $ORIGIN)
    if(NOT APPLE AND NOT WIN32)
      set(symbols ${CMAKE_CURRENT_LIST_DIR}/pliant.symbols)
      target_link_options(pliant_${part} PRIVATE LINKER:--version-script=${symbols})
      set_property(TARGET pliant_${part} APPEND PROPERTY LINK_DEPENDS ${symbols})
    endif()
  endforeach()
endif()

install(TARGETS pliant pliant_core pliant_files pliant_record
        EXPORT pliantTargets COMPONENT library
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT pliantTargets NAMESPACE pliant:: DESTINATION ${package_folder} COMPONENT library)

# The table of contents is what users may include; they get what that includes, and nothing else.
set(public_headers pliant/pliant.hpp)
set(unread ${public_headers})
while(unread)
  list(POP_FRONT unread header)
  set(path ${PROJECT_SOURCE_DIR}/src/${header})
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(STRINGS ${path} needed REGEX "^#include \"pliant/")
  list(TRANSFORM needed REPLACE "^#include \"([^\"]+)\".*" "\\1")
  list(REMOVE_ITEM needed ${public_headers})
  list(APPEND public_headers ${needed})
  list(APPEND unread ${needed})
endwhile()
foreach(header IN LISTS public_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/src/${header}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT library)
endforeach()

include(PliantNotices)
set(third_party Eigen3 GEMMI HDF5 PEGTL ZLIB fmt pugixml ${pliant_optional})
if(TARGET pliant_commands)
  list(APPEND third_party CLI11 nlohmann_json)
endif()
if(PLIANT_PYTHON)
  list(APPEND third_party nanobind)
endif()
if(PLIANT_PORTABLE)
  list(APPEND third_party BZip2 LibLZMA libcxx)
endif()
list(REMOVE_DUPLICATES third_party)
list(SORT third_party)
set(notices ${PROJECT_BINARY_DIR}/THIRD_PARTY_NOTICES.txt)
pliant_write_notices(${notices} ${third_party})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${notices}
        DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/pliant COMPONENT library)
if(SKBUILD)
  install(FILES ${notices} DESTINATION ${SKBUILD_PLATLIB_DIR}/pliant
          COMPONENT python EXCLUDE_FROM_ALL)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pliantConfig.cmake.in
  ${PROJECT_BINARY_DIR}/pliantConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/pliantConfig.cmake
  ${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/PliantDependencies.cmake
  DESTINATION ${package_folder} COMPONENT library)

set(pliant_optional_libraries "")  # by name: not every system tells pkg-config of libbz2
foreach(pair BZip2:-lbz2 LibLZMA:-llzma)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 package)
  list(GET pair 1 library)
  if(package IN_LIST pliant_optional)
    string(APPEND pliant_optional_libraries " ${library}")
  endif()
endforeach()

# Wherever the prefix is moved to, pkg-config finds it from the folder of these files.
file(RELATIVE_PATH prefix_from_pkgconfig
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig ${prefix_from_pkgconfig})
foreach(package pliant pliant-core)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in
    ${PROJECT_BINARY_DIR}/${package}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${package}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
endforeach()

if(TARGET pliant_command AND NOT PLIANT_PORTABLE)
  if(BUILD_SHARED_LIBS)
    set_target_properties(pliant_command PROPERTIES INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR})
  endif()
  install(TARGETS pliant_command COMPONENT command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(SKBUILD)  # beside the wheel's other scripts, so that it is found on PATH
    install(TARGETS pliant_command COMPONENT python EXCLUDE_FROM_ALL
            RUNTIME DESTINATION ${SKBUILD_SCRIPTS_DIR})
  endif()
endif()
