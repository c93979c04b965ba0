# SPDX-License-Identifier: MIT
"""The page without a browser: how hard it pulls on a live run, and how large it is."""

import gzip
import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from wasm_solver import ROOT

SCRIPT = ROOT / "apps/play/test/from_python/gain.mjs"


@pytest.mark.skipif(not shutil.which("node"), reason="node is not installed")
def test_a_slow_page_pulls_as_hard_as_a_fast_one():
    done = subprocess.run(["node", SCRIPT], check=True, capture_output=True, text=True, timeout=900)
    runs = json.loads(done.stdout)
    assert set(runs) == {"damped", "held_back", "slow_run", "free"}
    for name, rows in runs.items():
        assert [row["frames_per_second"] for row in rows] == [1, 2, 3, 6, 30]
        for row in rows:
            assert row["x"] > 25.0 and row["farthest"] < 31.0, (name, row)


#: what a person waits for, and hands on with each page that is shared
BUILT = Path(os.environ.get("PLIANT_PLAY", ROOT / "build/play")) / "pliant.html"
MOST_BYTES, MOST_PACKED = 2_000_000, 1_200_000


@pytest.mark.skipif(not BUILT.is_file(), reason="build/play/pliant.html: ./dev play")
def test_the_page_is_small():
    page = BUILT.read_bytes()
    assert len(page) <= MOST_BYTES
    assert len(gzip.compress(page, 9)) <= MOST_PACKED
