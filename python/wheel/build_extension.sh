#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_extension.sh TARGET PYTHON: compiles for a system of targets.txt the extension that PYTHON's
# version loads, and the command as a program of its own, for trials, into build/portable/TARGET.
# What is compiled for one version serves the next. First build_dependencies.sh must have run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly target=$1 interpreter=$2
readonly folder=$PWD/build/portable/$target
readonly jobs=${PLIANT_JOBS:-$(nproc)}
version=$("$interpreter" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
readonly version headers=$folder/python$version

.venv/bin/python -m pip install --quiet 'abi3info==2026.9.25' 'nanobind>=3.1,<3.2' wheel
[ -d "$headers" ] || .venv/bin/python python/wheel/python_headers.py "$interpreter" "$target" "$headers"
[ ! -f "$headers/libpython.a" ] || library=$headers/libpython.a
cmake -S . -B "$folder/cmake" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/src/cmake/portable.cmake" -DPLIANT_PORTABLE="$folder" \
  -DPLIANT_UNITY=ON -DPLIANT_PYTHON=ON -DPLIANT_TESTS=OFF \
  -DPLIANT_FOREIGN_PYTHON="$version" -DPLIANT_FOREIGN_PYTHON_HEADERS="$headers/include" \
  -DPLIANT_FOREIGN_PYTHON_LIBRARY="${library:-}" \
  -Dnanobind_ROOT="$(.venv/bin/python -m nanobind --cmake_dir)"
cmake --build "$folder/cmake" -j "$jobs" --target pliant_extension pliant_command
