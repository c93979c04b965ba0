# SPDX-License-Identifier: MIT
# The libraries that pliant is linked with. Read by the build and, once installed, by
# find_package(pliant): a static library hands its own dependencies on to whoever links it.
# Header-only ones are not wanted by the latter; they are found in CMakeLists.txt.
include(CMakeFindDependencyMacro)

get_property(pliant_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT C IN_LIST pliant_languages)
  enable_language(C)  # FindHDF5 tries its C library with a C program
endif()

find_dependency(Threads)
find_dependency(ZLIB)
find_dependency(fmt)
find_dependency(pugixml)
find_dependency(HDF5 COMPONENTS C)
