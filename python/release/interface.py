# SPDX-License-Identifier: MIT
"""What Pliant promises, as lists in the repository: those of each release, and those of now.

A list is a text file of lines in python/release/interface/VERSION. What a list of the last release
has must be there still, or be served by what came in its place: within a major version nothing
goes. Until a version is released its lists may be written anew.
"""

from __future__ import annotations

import re
from pathlib import Path
from types import ModuleType

import listed_commands
import listed_cpp
import listed_files
import listed_python
from project import Project

LISTS = Path("python") / "release" / "interface"
PARTS: dict[str, ModuleType] = {
    "python": listed_python,
    "cpp": listed_cpp,
    "commands": listed_commands,
    "files": listed_files,
}


def numbers(version: str) -> tuple[int, ...]:
    """A version as numbers, which can be compared."""
    return tuple(int(one) for one in version.split("."))


def versions(project: Project) -> list[str]:
    """The versions that have lists, oldest first."""
    folders = [path.name for path in (project.root / LISTS).glob("[0-9]*") if path.is_dir()]
    return sorted(folders, key=numbers)


def listed(project: Project, version: str, part: str) -> list[str]:
    """The list of a release."""
    return project.text(str(LISTS / version / f"{part}.txt")).splitlines()


def broken(old: list[str], new: list[str], part: str) -> list[str]:
    """The lines of an old list that nothing in the new one serves."""
    there, missing = set(new), []
    for line in old:
        if line in there:
            continue
        head = re.split(r"[( ]", line)[0]
        near = [one for one in new if one.startswith(head)]
        if not any(PARTS[part].serves(one, line) for one in near):
            missing.append(line)
    return missing


def problems(project: Project, part: str, new: list[str]) -> list[str]:
    """One line for each promise of the last release that is not kept."""
    known = versions(project)
    if not known:
        return [f"{LISTS}: no list; ./dev release --prepare VERSION DATE writes one"]
    last = known[-1]
    if numbers(project.version())[0] > numbers(last)[0]:
        return []
    return [
        f"{part}: {line}: was in {last}" for line in broken(listed(project, last, part), new, part)
    ]


def write(project: Project, version: str) -> None:
    """Writes the lists of a release."""
    folder = project.root / LISTS / version
    folder.mkdir(parents=True, exist_ok=True)
    for part, module in PARTS.items():
        text = "".join(f"{line}\n" for line in module.lines(project))
        (folder / f"{part}.txt").write_text(text, encoding="utf-8")
