# SPDX-License-Identifier: MIT
"""How large the page is: what a person waits for, and hands on with each page that is shared."""

import gzip
import os
from pathlib import Path

import pytest
from wasm_solver import ROOT

BUILT = Path(os.environ.get("PLIANT_PLAY", ROOT / "build/play")) / "pliant.html"
MOST_BYTES, MOST_PACKED = 2_000_000, 1_200_000


@pytest.mark.skipif(not BUILT.is_file(), reason="build/play/pliant.html: ./dev play")
def test_the_page_is_small():
    page = BUILT.read_bytes()
    assert len(page) <= MOST_BYTES
    assert len(gzip.compress(page, 9)) <= MOST_PACKED
