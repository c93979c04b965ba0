#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_wheels.sh [PYTHON...]: wheels for manylinux_2_28 of this machine's processor into
# build/wheels, one for each interpreter that is given; that of 3.12 serves every later one (abi3).
# Without PYTHON those of .venv and of PATH. First build_dependencies.sh must have run. What is
# compiled for one serves the next.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=python/wheel/targets.sh
. python/wheel/targets.sh
# shellcheck source=python/wheel/interpreters.sh
. python/wheel/interpreters.sh

folder=$PWD/build/portable/$(this_target)
readonly folder wheels=$PWD/build/wheels

# environment PYTHON: sets `python` to one that has what builds a wheel.
environment() {
  local here
  here=$folder/environment$(say_version "$1")
  python=$here/bin/python
  [ -x "$python" ] || "$1" -m venv "$here"
  "$python" -m pip install --quiet 'scikit-build-core>=0.11' 'nanobind>=3.1,<3.2' \
    'hatch-fancy-pypi-readme>=23.2' ninja
}

build_wheel() {
  environment "$1"
  "$python" -m pip wheel --no-build-isolation --no-deps --wheel-dir "$wheels/raw" \
    --config-settings="build-dir=$folder/cmake" \
    --config-settings="cmake.define.CMAKE_TOOLCHAIN_FILE=$PWD/src/cmake/portable.cmake" \
    --config-settings="cmake.define.PLIANT_PORTABLE=$folder" \
    --config-settings=cmake.define.PLIANT_UNITY=ON .
}

rm -rf "$wheels"
mkdir -p "$wheels"
given=("$@")
(($#)) || mapfile -t given < <(interpreters)
for one in "${given[@]}"; do
  build_wheel "$one"
done
python/wheel/finish_wheels.sh "$(this_target)" "$wheels"/raw/*.whl
