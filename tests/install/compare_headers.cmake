# SPDX-License-Identifier: MIT
# Of the headers below INCLUDED each is included by another, but pliant.hpp, and has all it includes.
file(GLOB_RECURSE installed RELATIVE ${INCLUDED} ${INCLUDED}/*)
set(needed pliant/pliant.hpp)
foreach(header IN LISTS installed)
  file(STRINGS ${INCLUDED}/${header} lines REGEX "^#include \"pliant/")
  list(TRANSFORM lines REPLACE "^#include \"([^\"]+)\".*" "\\1")
  list(APPEND needed ${lines})
endforeach()

set(surplus ${installed})
list(REMOVE_ITEM surplus ${needed})
list(REMOVE_ITEM needed ${installed})
if(surplus OR needed)
  message(FATAL_ERROR "installed, but not included: ${surplus}; included, but not installed: ${needed}")
endif()
