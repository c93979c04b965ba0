#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try_lean.sh: builds a wheel without the laboratory into build/lean, installs it into an environment
# with NumPy and h5py alone, and runs it there: the demo, the commands that say what they lack, and
# the tests that the package brings along. Compiler and libraries are those of this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly folder=$PWD/build/lean
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

rm -rf "$folder/wheel"
PLIANT_LABORATORY=OFF .venv/bin/python -m pip wheel --quiet --no-build-isolation --no-deps \
  --wheel-dir "$folder/wheel" --config-settings="build-dir=$folder/cmake" \
  --config-settings=cmake.define.PLIANT_UNITY=ON .
.venv/bin/python -m venv "$scratch/venv"
cd "$scratch"
venv/bin/pip install --quiet numpy h5py pytest
venv/bin/pip install --quiet --no-index --no-deps "$folder"/wheel/*.whl
venv/bin/pliant demo -o demo --frames 50

# lacks COMMAND...: it ends with 1, and one line says that the laboratory is left out.
lacks() {
  local said code=0
  said=$(venv/bin/pliant "$@" 2>&1) || code=$?
  printf '$ pliant %s\n%s\n' "$*" "$said"
  [[ $code = 1 && $said = "pliant $1: error: needs the laboratory"* && $said != *$'\n'* ]]
}
lacks bench stress
lacks experiment -o study
lacks structgen -o tree.xml
venv/bin/python -c 'from pliant import *; import pliant; pliant.check, pliant.compare'
venv/bin/python -m pytest --quiet --pyargs pliant
