# SPDX-License-Identifier: MIT
# What every target of the project is built with.
include(GNUInstallDirs)

add_library(pliant_flags INTERFACE)
target_compile_features(pliant_flags INTERFACE cxx_std_20)
target_compile_options(pliant_flags INTERFACE
  # The same input gives the same bits on every build: a fused multiply-add rounds once where
  # the source rounds twice, so the compiler must not form one by itself. -ffast-math breaks the
  # same promise and is refused in pliant/base/vec3.hpp.
  -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
  # Files of one batch see each other's names.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:PLIANT_BATCHES>>>:-Wshadow>
  # gcc 12 and 13 see an overlap in std::string's operator+ that is none (their bug 105329), and
  # an overflow too where its header is precompiled.
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,14>>:\
-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>")
if(PLIANT_WERROR)
  target_compile_options(pliant_flags INTERFACE -Werror)
endif()
if(PLIANT_SANITIZE)
  target_compile_options(pliant_flags INTERFACE
    -fsanitize=${PLIANT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(pliant_flags INTERFACE -fsanitize=${PLIANT_SANITIZE})
endif()
if(PLIANT_COVERAGE)
  target_compile_options(pliant_flags INTERFACE --coverage)
  target_link_options(pliant_flags INTERFACE --coverage)
endif()
if(PLIANT_FUZZ)
  # Every target counts its branches for libFuzzer; only the fuzzers link its main function.
  target_compile_options(pliant_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(pliant_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND PROJECT_IS_TOP_LEVEL)
  # It takes what a file includes from the compiler (-MD), not from a run of the preprocessor: that
  # is quicker, and it needs no other flag for precompiled headers. Paths below the base are taken
  # relative to the build folder: what one clone has compiled, another does not compile again.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_ctime,include_file_mtime
    ${CCACHE_PROGRAM})
endif()

# Read once a target, not once a file: half of the time to compile a file goes into these. A file
# includes what it uses all the same; the preset asan-ubsan, which reads each by itself, shows it.
set(PLIANT_COMMON_HEADERS
  <algorithm> <array> <charconv> <cmath> <cstdint> <functional> <limits> <map> <memory>
  <numbers> <numeric> <optional> <set> <span> <string> <string_view> <unordered_map> <utility>
  <vector>)

# pliant_compile_in_batches(TARGET [ALONE SOURCE...]) compiles several files of a target as one, if
# PLIANT_UNITY asks for it: what they share is compiled once, which halves the time of a whole build.
# ALONE are files that have a name in their unnamed namespace that another file has too.
function(pliant_compile_in_batches target)
  if(PLIANT_UNITY)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "ALONE")
    set_source_files_properties(${arg_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set_target_properties(${target} PROPERTIES PLIANT_BATCHES ON)
    # At the end, when all folders have added their files.
    cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]]
      CALL pliant_write_batches [[${target}]])")
  endif()
endfunction()

# pliant_write_batches(TARGET): files that include eight of its sources each, in place of these.
# CMake's own (UNITY_BUILD) name them by their full paths, so that ccache knows them in one clone only.
function(pliant_write_batches target)
  get_target_property(folder ${target} BINARY_DIR)
  get_target_property(source_folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  list(TRANSFORM sources PREPEND ${source_folder}/ REGEX "^[^/$]")
  set(kept "")
  set(batch "")
  set(count 0)
  set(number 0)
  foreach(source IN LISTS sources)
    pliant_is_alone(alone ${target} ${source})
    if(alone)
      list(APPEND kept ${source})
      continue()
    endif()
    file(RELATIVE_PATH path ${folder}/${target}.batches ${source})
    string(APPEND batch "#include \"${path}\"\n")
    math(EXPR count "${count} + 1")
    if(count EQUAL 8)
      pliant_write_batch()
    endif()
  endforeach()
  if(count)
    pliant_write_batch()
  endif()
  set_property(TARGET ${target} PROPERTY SOURCES ${kept})
endfunction()

# The end of a batch, of pliant_write_batches() alone. A file that says what it said keeps its time.
macro(pliant_write_batch)
  set(file ${folder}/${target}.batches/batch_${number}.cpp)
  file(CONFIGURE OUTPUT ${file} CONTENT "${batch}" @ONLY)
  list(APPEND kept ${file})
  math(EXPR number "${number} + 1")
  set(batch "")
  set(count 0)
endmacro()

# Whether a source is compiled by itself: it is to, has flags of its own, or is no C++.
function(pliant_is_alone result target source)
  get_target_property(folder ${target} SOURCE_DIR)
  set(alone OFF)
  if(NOT source MATCHES "^/.*[.]cpp$")
    set(alone ON)
  endif()
  foreach(property SKIP_UNITY_BUILD_INCLUSION COMPILE_OPTIONS COMPILE_DEFINITIONS)
    get_source_file_property(value ${source} DIRECTORY ${folder} ${property})
    if(value)
      set(alone ON)
    endif()
  endforeach()
  set(${result} ${alone} PARENT_SCOPE)
endfunction()

# For targets that are called, not waited for: their own code is not worth the time that -O3 takes
# to compile it. What computes and records always has it.
add_library(pliant_quick_compile INTERFACE)
target_compile_options(pliant_quick_compile INTERFACE $<$<CONFIG:Release>:-O1>)
