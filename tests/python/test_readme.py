# SPDX-License-Identifier: MIT
"""The README's Python example runs as it stands."""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

OPENED = """
import MDAnalysis, pliant.mdanalysis
print(len(MDAnalysis.Universe("out.h5md").trajectory), ensemble.positions.shape)
"""


def test_python_example_runs(tmp_path):
    code = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL).group(1)
    (tmp_path / "data").symlink_to(ROOT / "data")
    done = subprocess.run(
        [sys.executable, "-c", code + OPENED],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
        env=os.environ,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("20 (20, ")
