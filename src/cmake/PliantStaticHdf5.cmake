# SPDX-License-Identifier: MIT
# The command takes HDF5 from the static library if there is one that a program can be linked with.
# Debian's shared one brings curl, GnuTLS, Kerberos and thirty more, whose symbols the dynamic linker
# would look up each time: five of six instructions of `pliant --help`.
include(CheckCSourceCompiles)

function(pliant_link_hdf5_statically target)
  get_target_property(kind pliant_record TYPE)
  if(NOT kind STREQUAL "STATIC_LIBRARY")
    return()
  endif()
  get_target_property(shared hdf5::hdf5 IMPORTED_LOCATION)
  if(NOT shared)
    get_target_property(shared hdf5::hdf5 INTERFACE_LINK_LIBRARIES)
  endif()
  string(REGEX REPLACE "\\.so.*$" ".a" static "${shared}")
  if(static STREQUAL "${shared}" OR NOT EXISTS "${static}" OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
    return()
  endif()
  set(libraries ${static} sz z ${CMAKE_DL_LIBS} m Threads::Threads)
  get_target_property(includes hdf5::hdf5 INTERFACE_INCLUDE_DIRECTORIES)
  set(CMAKE_REQUIRED_INCLUDES ${includes})
  set(CMAKE_REQUIRED_LIBRARIES ${libraries})
  check_c_source_compiles("
    #include <hdf5.h>
    int main(void) { return H5Fopen(\"\", H5F_ACC_RDONLY, H5P_DEFAULT) < 0; }"
    PLIANT_HDF5_IS_STATIC)
  if(PLIANT_HDF5_IS_STATIC)
    # Behind the part of the library that asks for its symbols (by its file: CMake would move the
    # target to the end), and before the shared one, which then has nothing left to give.
    target_link_options(${target} PRIVATE LINKER:--as-needed)
    target_link_libraries(${target} PRIVATE $<TARGET_FILE:pliant_record> ${libraries})
  endif()
endfunction()
