# SPDX-License-Identifier: MIT
# What the library is built with as WebAssembly. PLIANT_HEADERS holds header-only libraries,
# PLIANT_PUGIXML pugixml's source, ZIG_LIB_DIR the libraries of zig. apps/play/build_wasm.sh makes
# these folders.
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
# Counts of 64 bits index memory of 32.
target_compile_options(pliant_flags INTERFACE -Wno-shorten-64-to-32)
set(PLIANT_LANES_X86 OFF CACHE INTERNAL "Levels of instructions of x86")
include(PliantHeaders)
add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)

add_library(pliant_pugixml STATIC ${PLIANT_PUGIXML}/pugixml.cpp)
target_include_directories(pliant_pugixml SYSTEM PUBLIC ${PLIANT_PUGIXML})
add_library(pugixml::pugixml ALIAS pliant_pugixml)

# libc++, libc++abi and the unwinder from the sources of zig: it would build them without exceptions.
set(cxx ${ZIG_LIB_DIR}/libcxx)
set(abi ${ZIG_LIB_DIR}/libcxxabi)
set(unwind ${ZIG_LIB_DIR}/libunwind)
set(cxx_parts algorithm any bind charconv chrono error_category exception expected
  filesystem/filesystem_clock filesystem/filesystem_error filesystem/path functional hash ios
  ios.instantiations iostream locale memory memory_resource new new_handler new_helpers optional
  ostream random ryu/d2fixed ryu/d2s ryu/f2s stdexcept string system_error typeinfo valarray
  variant vector verbose_abort)
set(abi_parts abort_message cxa_aux_runtime cxa_default_handlers cxa_exception
  cxa_exception_storage cxa_guard cxa_handlers cxa_personality cxa_vector cxa_virtual
  fallback_malloc private_typeinfo stdlib_exception stdlib_stdexcept stdlib_typeinfo)
list(TRANSFORM cxx_parts REPLACE "(.+)" "${cxx}/src/\\1.cpp")
list(TRANSFORM abi_parts REPLACE "(.+)" "${abi}/src/\\1.cpp")
add_library(pliant_cxx_runtime STATIC ${cxx_parts} ${abi_parts} ${unwind}/src/Unwind-wasm.c
  ${PROJECT_SOURCE_DIR}/apps/play/wasm/exception_tag.cpp)
target_include_directories(pliant_cxx_runtime PRIVATE
  ${cxx}/src ${cxx}/src/include ${cxx}/libc ${abi}/include ${abi}/src ${unwind}/include)
target_compile_definitions(pliant_cxx_runtime PRIVATE
  _LIBCPP_BUILDING_LIBRARY _LIBCXXABI_BUILDING_LIBRARY LIBCXX_BUILDING_LIBCXXABI
  _LIBCXXABI_HAS_NO_THREADS _LIBUNWIND_HIDE_SYMBOLS)
target_compile_options(pliant_cxx_runtime PRIVATE -w -Os)
set_target_properties(pliant_cxx_runtime PROPERTIES
  CXX_STANDARD 23 CXX_STANDARD_REQUIRED ON UNITY_BUILD OFF)
set_source_files_properties(${abi}/src/cxa_default_handlers.cpp
  PROPERTIES COMPILE_DEFINITIONS LIBCXXABI_NON_DEMANGLING_TERMINATE)
