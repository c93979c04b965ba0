# SPDX-License-Identifier: MIT
"""What formatters and checkers of others say: clang-format, ruff, shellcheck."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from sources import CPP, ROOT, files


def tool(name: str) -> str:
    """The tool beside this Python, or on PATH; skips the test where there is none."""
    beside = Path(sys.executable).with_name(name)
    found = str(beside) if beside.exists() else shutil.which(name)
    if found is None:
        pytest.skip(f"{name} is not installed")
    return found


def passes(*command: str) -> None:
    """Runs a command in the top folder and fails with its output."""
    result = subprocess.run(command, cwd=ROOT, text=True, capture_output=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


def test_cpp_is_formatted():
    sources = [str(path) for path in files(*CPP)]
    passes(tool("clang-format"), "--dry-run", "--Werror", *sources)


def test_python_is_formatted():
    passes(tool("ruff"), "format", "--diff", "--quiet", "python", "tests", "docs", "data")


def test_python_passes_ruff():
    passes(tool("ruff"), "check", "--quiet", "python", "tests", "docs", "data")


def test_scripts_pass_shellcheck():
    folders = ("apps/play", "python/wheel", "src/cmake")
    scripts = [str(path) for folder in folders for path in sorted((ROOT / folder).glob("*.sh"))]
    passes(tool("shellcheck"), "--external-sources", "dev", ".ci/run", *scripts)
