# SPDX-License-Identifier: MIT
"""The installed command, and small molecules to run it on."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from forked import ended_command, is_forkable

COMMAND = Path(os.environ.get("PLIANT_COMMAND", Path(sys.executable).parent / "pliant"))

ETHANOL = """9
ethanol
C  -0.8883  0.1670 -0.0273
C   0.4658 -0.5116 -0.0368
O   1.4311  0.3229  0.5867
H  -0.8487  1.1175 -0.5695
H  -1.6471 -0.4704 -0.4896
H  -1.1964  0.3978  0.9977
H   0.7920 -0.7224 -1.0597
H   0.4246 -1.4559  0.5138
H   1.4671  1.1550  0.0848
"""


@dataclass
class Ended:
    code: int
    out: str
    err: str


@pytest.fixture(scope="session")
def command():
    """Path of the installed command."""
    return COMMAND


@pytest.fixture
def pliant(tmp_path):
    """Runs pliant in an empty folder; pliant("info", "x.xyz") gives code, out, err."""

    def run(*arguments, **options):
        words = [*map(str, arguments)]
        options = {"cwd": tmp_path, "timeout": 900, **options}
        if is_forkable(words, **options):
            done = ended_command(words, **options)
        else:
            done = subprocess.run([COMMAND, *words], capture_output=True, text=True, **options)
        return Ended(done.returncode, done.stdout, done.stderr)

    return run


@pytest.fixture
def ethanol(tmp_path):
    path = tmp_path / "ethanol.xyz"
    path.write_text(ETHANOL)
    return path
