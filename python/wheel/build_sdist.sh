#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_sdist.sh: the sources as one archive in build/sdist, with the page of `pliant play` inside. Who
# builds from it needs a C++ compiler and the libraries, but neither npm nor the compiler for
# WebAssembly. First ./dev play must have run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly made=python/prebuilt # where CMake looks first
readonly archives=build/sdist

trap 'rm -rf "$made"' EXIT
rm -rf "$made" "$archives"
mkdir -p "$made" "$archives"
cp build/play/pliant.html "$made"
.venv/bin/python -m pip install --quiet build
.venv/bin/python -m build --sdist --no-isolation --outdir "$archives"
