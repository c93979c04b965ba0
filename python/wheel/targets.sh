# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by what builds for the systems of targets.txt. Called in the root of the repository.

# The names of all, one a line.
target_names() { awk '!/^#/ { print $1 }' python/wheel/targets.txt; }

# That of the machine this runs on.
this_target() { printf 'linux-%s\n' "$(uname -m)"; }

# target_field NAME FIELD: a word of its row.
target_field() {
  local column
  case $2 in zig) column=2 ;; platform) column=3 ;; oldest) column=4 ;; tried) column=5 ;; esac
  awk -v name="$1" -v column="$column" '$1 == name { print $column; found = 1 }
    END { if (!found) { print "targets.txt: no target " name > "/dev/stderr"; exit 1 } }' \
    python/wheel/targets.txt
}

# at_once FUNCTION ARGUMENT...: calls it for each, in processes side by side; fails where one fails.
at_once() {
  local one running=()
  for one in "${@:2}"; do
    "$1" "$one" &
    running+=($!)
  done
  for one in "${running[@]}"; do wait "$one"; done
}
