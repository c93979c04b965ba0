# SPDX-License-Identifier: MIT
# Toolchain of a wheel: zig's clang with libc++ inside, as python/wheel/build_dependencies.sh sets it
# up in PLIANT_PORTABLE/bin. The folder has the name of the target, such as macos-arm64.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PLIANT_PORTABLE)
set(tools ${PLIANT_PORTABLE}/bin)
set(CMAKE_C_COMPILER ${tools}/cc)
set(CMAKE_CXX_COMPILER ${tools}/c++)
set(CMAKE_AR ${tools}/ar CACHE FILEPATH "Archiver")
set(CMAKE_RANLIB ${tools}/ranlib CACHE FILEPATH "Indexer of archives")

cmake_path(GET PLIANT_PORTABLE FILENAME target)
string(REGEX MATCH "^[a-z]+" system ${target})
string(REGEX REPLACE "^[a-z]+-" "" processor ${target})
if(NOT target STREQUAL "linux-${CMAKE_HOST_SYSTEM_PROCESSOR}")
  string(REPLACE "linux" "Linux" CMAKE_SYSTEM_NAME ${system})
  string(REPLACE "macos" "Darwin" CMAKE_SYSTEM_NAME ${CMAKE_SYSTEM_NAME})
  string(REPLACE "windows" "Windows" CMAKE_SYSTEM_NAME ${CMAKE_SYSTEM_NAME})
  set(CMAKE_SYSTEM_PROCESSOR ${processor})
  # What is looked for is the target's, but for programs.
  set(CMAKE_FIND_ROOT_PATH ${PLIANT_PORTABLE})
  set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
endif()
if(system STREQUAL "macos")
  set(CMAKE_OSX_SYSROOT "" CACHE STRING "zig has the system's headers")
  set(CMAKE_OSX_DEPLOYMENT_TARGET "" CACHE STRING "zig's target says it")
  set(CMAKE_INSTALL_NAME_TOOL true CACHE FILEPATH "Nothing is renamed")
endif()
