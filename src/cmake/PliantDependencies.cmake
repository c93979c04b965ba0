# SPDX-License-Identifier: MIT
# The libraries that Pliant is linked with. Read by the build and, once installed, by
# find_package(pliant): a static library hands its own dependencies on to whoever links it. Of the
# component `core` alone none is needed but threads. Header-only ones are not wanted by the latter;
# they are found in CMakeLists.txt.
include(CMakeFindDependencyMacro)

find_dependency(Threads)
if(NOT pliant_FIND_COMPONENTS STREQUAL "core")
  find_dependency(ZLIB)
  find_dependency(fmt)
  find_dependency(pugixml)
  # Optional, for inputs that are compressed so: once installed, those that the build had.
  if(NOT DEFINED pliant_optional)
    set(pliant_optional "")
    foreach(package BZip2 LibLZMA)
      find_package(${package})
      if(${package}_FOUND)
        list(APPEND pliant_optional ${package})
      else()
        message(STATUS "Without ${package}: inputs that are compressed so will be refused")
      endif()
    endforeach()
  else()
    foreach(package IN LISTS pliant_optional)
      find_dependency(${package})
    endforeach()
  endif()
endif()
if(NOT pliant_FIND_COMPONENTS MATCHES "^(core|files|core;files|files;core)$")
  get_property(pliant_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT C IN_LIST pliant_languages)
    enable_language(C)  # FindHDF5 tries its C library with a C program
  endif()
  find_dependency(HDF5 COMPONENTS C)
endif()
