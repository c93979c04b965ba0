# SPDX-License-Identifier: MIT
# Toolchain of a wheel: the compilers that python/wheel/build_dependencies.sh makes, zig's clang for
# glibc 2.28 with libc++ inside.
get_filename_component(tools ${CMAKE_CURRENT_LIST_DIR}/../../build/portable/bin ABSOLUTE)
set(CMAKE_C_COMPILER ${tools}/cc)
set(CMAKE_CXX_COMPILER ${tools}/c++)
set(CMAKE_AR ${tools}/ar CACHE FILEPATH "Archiver")
set(CMAKE_RANLIB ${tools}/ranlib CACHE FILEPATH "Indexer of archives")
