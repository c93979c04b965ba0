# SPDX-License-Identifier: MIT
# Header-only libraries for builds that cannot take the system's folder of headers, since its C
# library is another: PLIANT_HEADERS is a folder of theirs alone, as src/cmake/zig.sh makes it.
set(GEMMI_INCLUDE_DIR ${PLIANT_HEADERS})
set(PEGTL_INCLUDE_DIR ${PLIANT_HEADERS})

function(pliant_headers_alone target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${ARGN})
endfunction()
pliant_headers_alone(Eigen3::Eigen ${PLIANT_HEADERS}/eigen3)
pliant_headers_alone(nlohmann_json::nlohmann_json ${PLIANT_HEADERS})
pliant_headers_alone(CLI11::CLI11 ${PLIANT_HEADERS})
pliant_headers_alone(fmt::fmt ${PLIANT_HEADERS})
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
