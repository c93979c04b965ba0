#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_sdist.sh: the sources as one archive in build/sdist, with what JavaScript has made inside:
# the page of `pliant play` and the viewer of reports. Who builds from it needs a C++ compiler and
# the libraries, but neither npm nor the compiler for WebAssembly. First ./dev play must have run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly made=python/prebuilt # where CMake looks first
readonly archives=build/sdist

trap 'rm -rf "$made"' EXIT
rm -rf "$made" "$archives"
mkdir -p "$made" "$archives"
cp build/play/pliant.html "$made"
.venv/bin/python python/fetch_viewer.py "$made"
[ -f "$made/3Dmol-min.js" ] || { printf '3Dmol.js was not fetched\n' >&2 && exit 1; }
.venv/bin/python -m pip install --quiet build
.venv/bin/python -m build --sdist --no-isolation --outdir "$archives"
