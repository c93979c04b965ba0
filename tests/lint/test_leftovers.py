# SPDX-License-Identifier: MIT
"""A run of pytest fails that leaves anything in the checkout, an empty folder too."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SUPPORT = Path(__file__).parents[1] / "support" / "python" / "leftovers.py"

CONFTEST = """
from pathlib import Path
import leftovers

def pytest_configure(config):
    leftovers.watch(config, Path(__file__).parent)
"""

TESTS = """
from pathlib import Path

def test_first():
    for made in MADE:
        (Path(__file__).parent / made).mkdir(parents=True)

def test_second():
    pass
"""


def run_of(folder, made, processes):
    subprocess.run(["git", "init", "--quiet"], cwd=folder, check=True)
    shutil.copy(SUPPORT, folder)
    (folder / "conftest.py").write_text(CONFTEST)
    (folder / ".gitignore").write_text("/build*/\n__pycache__/\n.pytest_cache/\n/src/kept/\n")
    (folder / "src").mkdir()
    (folder / "src/a.cpp").touch()
    subprocess.run(["git", "add", "--all"], cwd=folder, check=True)
    (folder / "test_one.py").write_text(TESTS.replace("MADE", repr(made)))
    words = ["-q", "-c", "/dev/null", "--rootdir", folder]
    words += ["-p", "xdist", "-n", processes, folder] if processes else [folder]
    return subprocess.run(
        [sys.executable, "-m", "pytest", *map(str, words)],
        cwd=folder,
        env={**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"},
        capture_output=True,
        text=True,
        timeout=900,
    )


@pytest.mark.parametrize(("made", "processes"), [("empty-report", 0), ("src/empty", 2)])
def test_what_is_left_behind_fails_the_run(tmp_path, made, processes):
    ended = run_of(tmp_path, [made], processes)
    assert ended.returncode == 1, ended.stdout + ended.stderr
    assert ended.stdout.count(f"left behind by the tests: {made}/\n") == 1
    assert "2 passed" in ended.stdout


def test_what_git_ignores_may_be_left(tmp_path):
    ended = run_of(tmp_path, ["build/report", "src/kept"], 0)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "left behind" not in ended.stdout
