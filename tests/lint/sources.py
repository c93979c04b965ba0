# SPDX-License-Identifier: MIT
"""The files that the lint looks at, and how it reports."""

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("src", "apps", "python", "tests", "docs")
CPP = (".cpp", ".hpp")


def files(*suffixes: str, folders: tuple[str, ...] = FOLDERS) -> Iterator[Path]:
    """Every file below `folders` with one of these suffixes (any, if none), in a fixed order."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            wanted = not suffixes or path.suffix in suffixes
            if wanted and path.is_file() and "__pycache__" not in path.parts:
                yield path


def tracked(*words: str) -> list[str]:
    """What git ls-files lists of the project; skips the test where this is no clone."""
    command = ["git", "ls-files", *words]
    done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True, check=False)
    if not done.stdout:
        pytest.skip("this is no clone: git lists no files")
    return [name for name in done.stdout.splitlines() if (ROOT / name).is_file()]


def place(path: Path, line: int = 0) -> str:
    """`path` from the top of the project, with the line where there is one."""
    name = path.relative_to(ROOT).as_posix()
    return f"{name}:{line}" if line else name


def numbered_lines(path: Path) -> Iterator[tuple[int, str]]:
    """The lines of a text file with their numbers, from 1."""
    return enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)


def refuse(findings: list[str]) -> None:
    """Fails the test with one finding a line."""
    assert not findings, "\n" + "\n".join(findings)
