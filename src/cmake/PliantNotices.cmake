# SPDX-License-Identifier: MIT
# What Pliant is built with, and under which licences: a file that is installed and is in the wheel.

# name | licence (SPDX) | home | package of Debian whose folder in /usr/share/doc has the text
set(pliant_third_party
  "BZip2|bzip2-1.0.6|https://sourceware.org/bzip2|libbz2-dev"
  "CLI11|BSD-3-Clause|https://github.com/CLIUtils/CLI11|libcli11-dev"
  "Eigen3|MPL-2.0|https://eigen.tuxfamily.org|libeigen3-dev"
  "GEMMI|MPL-2.0|https://gemmi.readthedocs.io|gemmi-dev"
  "HDF5|BSD-3-Clause|https://www.hdfgroup.org/solutions/hdf5|libhdf5-dev"
  "LibLZMA|0BSD|https://tukaani.org/xz|liblzma-dev"
  "PEGTL|BSL-1.0 AND MIT|https://github.com/taocpp/PEGTL|tao-pegtl-dev"
  "ZLIB|Zlib|https://zlib.net|zlib1g-dev"
  "fmt|MIT|https://fmt.dev|libfmt-dev"
  "libcxx|Apache-2.0 WITH LLVM-exception|https://libcxx.llvm.org|"
  "nanobind|BSD-3-Clause|https://nanobind.readthedocs.io|"
  "nlohmann_json|MIT|https://json.nlohmann.me|nlohmann-json3-dev"
  "pugixml|MIT|https://pugixml.org|libpugixml-dev")

# Sets `out` to the file with the text of a licence on this machine; empty if there is none. Where the
# build takes a library from elsewhere, PLIANT_LICENSE_<name> names its text.
function(pliant_find_license name package out)
  set(found ${PLIANT_LICENSE_${name}})
  if(NOT found AND package AND EXISTS /usr/share/doc/${package}/copyright)
    set(found /usr/share/doc/${package}/copyright)
  endif()
  if(NOT found AND name STREQUAL "nanobind")
    file(GLOB found ${nanobind_DIR}/../../nanobind-*.dist-info/licenses/LICENSE)
  endif()
  if(NOT found AND name STREQUAL "libcxx")  # libc++, libc++abi and libunwind share it
    file(GLOB found
      ${PROJECT_SOURCE_DIR}/.venv/lib/python*/site-packages/ziglang/lib/libcxx/LICENSE.TXT)
  endif()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# pliant_write_notices(OUT NAME...): the notices of these rows; an unknown name is an error.
function(pliant_write_notices out)
  set(text "Pliant is under the MIT licence (file LICENSE). It is built with the following, which may be
part of its binaries or shared libraries beside them. A page of pliant play holds the notices of
what is in it.\n")
  foreach(name IN LISTS ARGN)
    set(rows ${pliant_third_party})
    list(FILTER rows INCLUDE REGEX "^${name}\\|")
    if(NOT rows)
      message(FATAL_ERROR "src/cmake/PliantNotices.cmake: no licence is known of ${name}")
    endif()
    string(REPLACE "|" ";" row "${rows}|")
    list(GET row 1 license)
    list(GET row 2 home)
    list(GET row 3 package)
    pliant_find_license(${name} "${package}" file)
    string(APPEND text "\n${name}\n  licence  ${license}\n  home     ${home}\n")
    if(file)
      file(READ ${file} license_text)
      string(APPEND text "\n${license_text}\n")
    else()
      string(APPEND text "  text     not on the machine that built this: see home\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${out} CONTENT "@text@" @ONLY)
endfunction()
