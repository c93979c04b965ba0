# SPDX-License-Identifier: MIT
"""How hard the page pulls on a live run: as hard, however many frames a second it draws."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[3] / "apps/play/test/from_python/gain.mjs"


@pytest.mark.skipif(not shutil.which("node"), reason="node is not installed")
def test_a_slow_page_pulls_as_hard_as_a_fast_one():
    done = subprocess.run(["node", SCRIPT], check=True, capture_output=True, text=True, timeout=900)
    runs = json.loads(done.stdout)
    assert set(runs) == {"damped", "held_back", "slow_run", "free"}
    for name, rows in runs.items():
        assert [row["frames_per_second"] for row in rows] == [1, 2, 3, 6, 30]
        for row in rows:
            assert row["x"] > 25.0 and row["farthest"] < 31.0, (name, row)
