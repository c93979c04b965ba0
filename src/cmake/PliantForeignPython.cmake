# SPDX-License-Identifier: MIT
# Python of another system than this one, for extensions of wheels: PLIANT_FOREIGN_PYTHON is its
# version, such as 3.12, PLIANT_FOREIGN_PYTHON_HEADERS and, on Windows, _LIBRARY are what
# python/wheel/python_headers.py makes. In place of find_package(Python).
set(Python_VERSION ${PLIANT_FOREIGN_PYTHON})
set(Python_INTERPRETER_ID Python)
set(Python_INCLUDE_DIRS ${PLIANT_FOREIGN_PYTHON_HEADERS})
set(Python_EXECUTABLE ${PROJECT_SOURCE_DIR}/.venv/bin/python) # runs what builds, not what is built
# The wheel gives the file its name.
set(NB_SUFFIX .so CACHE INTERNAL "")
set(NB_SUFFIX_S .so CACHE INTERNAL "")

add_executable(Python::Interpreter IMPORTED)
set_target_properties(Python::Interpreter PROPERTIES IMPORTED_LOCATION ${Python_EXECUTABLE})
add_library(Python::Module INTERFACE IMPORTED)
target_include_directories(Python::Module SYSTEM INTERFACE ${PLIANT_FOREIGN_PYTHON_HEADERS})
target_link_libraries(Python::Module INTERFACE ${PLIANT_FOREIGN_PYTHON_LIBRARY})
if(NOT Python_VERSION VERSION_LESS 3.12)
  add_library(Python::SABIModule INTERFACE IMPORTED)
  target_link_libraries(Python::SABIModule INTERFACE Python::Module)
endif()

# pliant_foreign_extension(TARGET): on macOS the names of Python are left to be found in whoever loads
# it. nanobind lists them in a file, which zig's linker does not read; python/wheel/check_wheel.py sees
# to it that nothing else is left so.
function(pliant_foreign_extension target)
  if(APPLE)
    get_target_property(options ${target} LINK_OPTIONS)
    list(FILTER options EXCLUDE REGEX "darwin-ld-")
    set_property(TARGET ${target} PROPERTY LINK_OPTIONS ${options} "LINKER:-undefined,dynamic_lookup")
  endif()
endfunction()
