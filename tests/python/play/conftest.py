# SPDX-License-Identifier: MIT
"""The solver of the page, where it has been built."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))  # so that tests can import what lies beside them


@pytest.fixture(scope="module")
def solver():
    """A worker of its own for each file of tests."""
    from wasm_solver import Solver, is_there

    if not is_there():
        pytest.skip("build/play/pliant.wasm: ./dev play")
    with Solver() as solver:
        yield solver
