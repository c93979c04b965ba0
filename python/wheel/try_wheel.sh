#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try_wheel.sh WHEELS [PYTHON]: installs the wheel that fits PYTHON from the folder WHEELS into an
# environment with NumPy and h5py alone, and runs it there, away from the repository: the demo, and
# then the tests that the package brings along.
set -euo pipefail

wheels=$(cd "$1" && pwd)
python=${2:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/.venv/bin/python}
readonly wheels python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$python" -m venv "$scratch/venv"
cd "$scratch"
# numpy and h5py from the index, pliant from the folder and from nowhere else.
venv/bin/pip install --quiet numpy h5py
venv/bin/pip install --quiet --no-index --find-links "$wheels" pliant
venv/bin/pliant --version
venv/bin/pliant demo -o demo --frames 50
venv/bin/pip install --quiet pytest
venv/bin/python -m pytest --quiet --pyargs pliant
