# SPDX-License-Identifier: MIT
"""The repository that is released: its texts, its version, its commit."""

from __future__ import annotations

import importlib.util
import re
import subprocess
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]


def _module_beside(name: str) -> ModuleType:
    """A module of the folder `python`, in no package.

    The folder is put on no path: `pliant` in it is a source, which hides the installed package.
    """
    spec = importlib.util.spec_from_file_location(name, ROOT / "python" / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


package_metadata = _module_beside("package_metadata")
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
        return package_metadata.repository(self.root)

    def maintainers(self) -> list[str]:
        """Their accounts at that address."""
        return list(package_metadata.project_settings(self.root)["maintainers"])

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
