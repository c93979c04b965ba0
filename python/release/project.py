# SPDX-License-Identifier: MIT
"""The repository that is released: its texts, its version, its commit."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

try:
    import tomllib
except ModuleNotFoundError:  # Python 3.10
    from pip._vendor import tomli as tomllib

ROOT = Path(__file__).resolve().parents[2]


VERSION = re.compile(r"^project\(pliant VERSION ([\d.]+)", re.MULTILINE)


class Project(NamedTuple):
    """A checkout of Pliant, or what a tag has in it."""

    root: Path = ROOT
    tag: str = ""

    def text(self, name: str) -> str:
        """The text of a file, by its path from the top; empty if there is none."""
        if self.tag:
            return self.git("show", f"{self.tag}:{name}")
        path = self.root / name
        return path.read_text(encoding="utf-8") if path.is_file() else ""

    def version(self) -> str:
        """The version that CMakeLists.txt states."""
        found = VERSION.search(self.text("CMakeLists.txt"))
        if not found:
            raise ValueError("CMakeLists.txt: no line project(pliant VERSION ...)")
        return found[1]

    def address(self) -> str:
        """Where the repository can be read; empty if nowhere yet."""
        return str(self._settings()["project"].get("urls", {}).get("Source", "")).rstrip("/")

    def maintainers(self) -> list[str]:
        """Their accounts at that address."""
        return list(self._settings()["tool"]["pliant"]["maintainers"])

    def _settings(self) -> dict[str, Any]:
        return tomllib.loads(self.text("pyproject.toml"))

    def git(self, *words: str) -> str:
        """What git says; empty if it fails, or if this is no clone."""
        command = ["git", *words]
        done = subprocess.run(command, cwd=self.root, capture_output=True, text=True, check=False)
        return done.stdout.rstrip("\n") if done.returncode == 0 else ""

    def commit(self) -> str:
        """The commit that is checked out."""
        return self.git("rev-parse", "HEAD")

    def changed(self) -> list[str]:
        """Files that differ from the commit, or are not in it."""
        return [line[3:] for line in self.git("status", "--porcelain").splitlines()]

    def files(self) -> list[str]:
        """Every file that git knows, by its path from the top."""
        if self.tag:
            return self.git("ls-tree", "-r", "--name-only", self.tag).splitlines()
        return [name for name in self.git("ls-files").splitlines() if (self.root / name).is_file()]
