# SPDX-License-Identifier: MIT
# The headers below INCLUDED are those that CONTENTS (pliant.hpp) names, itself among them.
file(GLOB_RECURSE installed RELATIVE ${INCLUDED} ${INCLUDED}/*)
file(STRINGS ${CONTENTS} named REGEX "^#include \"pliant/")
list(TRANSFORM named REPLACE "^#include \"([^\"]+)\".*" "\\1")
list(APPEND named pliant/pliant.hpp)

set(surplus ${installed})
list(REMOVE_ITEM surplus ${named})
list(REMOVE_ITEM named ${installed})
if(surplus OR named)
  message(FATAL_ERROR "installed, but not named: ${surplus}; named, but not installed: ${named}")
endif()
