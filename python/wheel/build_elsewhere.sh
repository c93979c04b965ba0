#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_elsewhere.sh TARGET [PYTHON...]: the wheels of another system of targets.txt into
# build/wheels, one for each that build_wheels.sh has made of this machine: all in them but the
# extension is the same. First build_dependencies.sh TARGET must have run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=python/wheel/targets.sh
. python/wheel/targets.sh
# shellcheck source=python/wheel/interpreters.sh
. python/wheel/interpreters.sh

readonly target=$1 wheels=$PWD/build/wheels
readonly raw=$wheels/raw-$target

# The wheel of this machine for PYTHON's version.
own_wheel() {
  local tag
  tag=cp$(say_version "$1" | tr -d .)
  find "$wheels/raw" -name "pliant-*-$tag-*.whl"
}

build_wheel() {
  python/wheel/build_extension.sh "$target" "$1"
  .venv/bin/python python/wheel/retarget_wheel.py "$(own_wheel "$1")" "$target" \
    "build/portable/$target/cmake/python/_core.so" "$raw"
}

rm -rf "$raw" "$wheels"/*"$(target_field "$target" platform)".whl
mkdir -p "$raw"
given=("${@:2}")
((${#given[@]})) || mapfile -t given < <(interpreters)
for one in "${given[@]}"; do
  build_wheel "$one"
done
python/wheel/finish_wheels.sh "$target" "$raw"/*.whl
