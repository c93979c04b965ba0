# SPDX-License-Identifier: MIT
# Checks that FOLDER holds our licence, and notices with each of NAMES (a,b,c).
file(READ ${FOLDER}/LICENSE ours)
if(NOT ours MATCHES "MIT License")
  message(FATAL_ERROR "${FOLDER}/LICENSE: is not the MIT licence")
endif()
file(READ ${FOLDER}/THIRD_PARTY_NOTICES.txt notices)
string(REPLACE "," ";" NAMES "${NAMES}")
foreach(name IN LISTS NAMES)
  if(NOT notices MATCHES "\n${name}\n  licence  [^\n]+\n  home     https://")
    message(FATAL_ERROR "${FOLDER}/THIRD_PARTY_NOTICES.txt: has no notice of ${name}")
  endif()
endforeach()
