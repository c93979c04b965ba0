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
