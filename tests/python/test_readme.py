# SPDX-License-Identifier: MIT
"""The README's Python example runs as it stands."""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_python_example_runs(tmp_path):
    code = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL).group(1)
    (tmp_path / "data").symlink_to(ROOT / "data")
    done = subprocess.run(
        [sys.executable, "-c", code + "\nprint(len(universe.trajectory), len(universe.bonds))"],
        cwd=tmp_path, capture_output=True, text=True, check=False, env=os.environ,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert "converged" in lines[0]
    assert lines[1] == "1001 25"


def test_console_example_is_what_the_command_prints():
    page = (ROOT / "README.md").read_text()
    printed = re.search(r"```console\n\$ pliant (.*?)\n(.*?)```", page, re.DOTALL)
    done = subprocess.run(
        [Path(sys.executable).parent / "pliant", *printed.group(1).split()],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout == printed.group(2)
