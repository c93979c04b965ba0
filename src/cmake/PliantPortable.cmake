# SPDX-License-Identifier: MIT
# What a wheel is built with, so that it needs no library but the C library of its system:
# PLIANT_PORTABLE is the folder of static libraries that python/wheel/build_dependencies.sh makes.
# A wheel has the library once, in the extension, and with it the command (apps/CMakeLists.txt).
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
add_compile_options(-ffunction-sections -fdata-sections)
if(APPLE)
  # zig's linker makes no bundles; Python loads a library as well.
  set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS -shared)
  add_link_options(-Wl,-dead_strip)
  add_compile_options(-Werror=unguarded-availability) # of what is newer than the oldest system
else()
  add_link_options(-Wl,--gc-sections)
endif()
target_compile_options(pliant_quick_compile INTERFACE -Os)
set(PLIANT_HEADERS ${PLIANT_PORTABLE}/../headers)
include(PliantHeaders)
find_package(Threads REQUIRED)

function(pliant_static_library target file)
  add_library(${target} STATIC IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${PLIANT_PORTABLE}/lib/${file}
    IMPORTED_LINK_INTERFACE_LIBRARIES "${ARGN}")
  target_include_directories(${target} SYSTEM INTERFACE ${PLIANT_PORTABLE}/include)
endfunction()
pliant_static_library(ZLIB::ZLIB libz.a)
pliant_static_library(BZip2::BZip2 libbz2.a)
pliant_static_library(LibLZMA::LibLZMA liblzma.a)
pliant_static_library(hdf5::hdf5 libhdf5.a ZLIB::ZLIB ${CMAKE_DL_LIBS} m)
pliant_static_library(pugixml::pugixml libpugixml.a)
target_include_directories(pugixml::pugixml SYSTEM INTERFACE ${PLIANT_PORTABLE}/../pugixml)
foreach(package ZLIB BZip2 LibLZMA)
  set(${package}_FOUND TRUE)
endforeach()
