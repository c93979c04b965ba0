#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try_sdist.sh ARCHIVE: builds a wheel from the sources in an environment without a network, and
# looks whether the page and the viewer are in it. Compiler, libraries and the Python packages that
# build Pliant are those of this machine and of .venv.
set -euo pipefail

archive=$(readlink -f "$1")
python=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/.venv/bin/python
readonly archive python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

alone=()
unshare --map-root-user --net true 2>/dev/null && alone=(unshare --map-root-user --net)
PATH=$(dirname "$python"):$PATH "${alone[@]}" "$python" -m pip wheel --quiet --no-build-isolation \
  --no-deps --wheel-dir wheel --config-settings=cmake.define.PLIANT_UNITY=ON "$archive"
"$python" - wheel/*.whl <<'TEXT'
import sys
import zipfile

names = zipfile.ZipFile(sys.argv[1]).namelist()
for wanted in ("pliant/play/pliant.html", "pliant/static/view/scene.mjs"):
    if wanted not in names:
        sys.exit(f"{sys.argv[1]}: has no {wanted}")
print(f"{sys.argv[1]}: {len(names)} files, with page and viewer")
TEXT
