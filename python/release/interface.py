# SPDX-License-Identifier: MIT
"""What Pliant promises, as lists in the repository: those of each release, and those of now.

A list is a text file of lines in python/release/interface/VERSION. What a list of the last release
has must be there still, or be served by what came in its place: within a major version nothing
goes. In a new one may go what DEPRECATED names, if an earlier minor version deprecated it.
"""

from __future__ import annotations

import re
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import listed_commands
import listed_cpp
import listed_files
import listed_python
from project import Project

LISTS = Path("python") / "release" / "interface"
DEPRECATED = LISTS / "deprecated.txt"
PARTS: dict[str, ModuleType] = {
    "python": listed_python,
    "cpp": listed_cpp,
    "commands": listed_commands,
    "files": listed_files,
}


class Deprecation(NamedTuple):
    """A line of DEPRECATED: part, since which version, and the line of the list that may go."""

    part: str
    since: str
    line: str


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


def deprecations(project: Project) -> list[Deprecation]:
    """What DEPRECATED names; a line is `PART SINCE LINE`."""
    rows = project.text(str(DEPRECATED)).splitlines()
    return [
        Deprecation(*row.split(" ", maxsplit=2)) for row in rows if row and not row.startswith("#")
    ]


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
    last, present = known[-1], project.version()
    may_go: set[str] = set()
    if numbers(present)[0] > numbers(last)[0]:
        may_go = {
            one.line
            for one in deprecations(project)
            if one.part == part and _was_said_earlier(one.since, last)
        }
    gone = broken(listed(project, last, part), new, part)
    return [f"{part}: {line}: was in {last}" for line in gone if line not in may_go]


def _was_said_earlier(since: str, last: str) -> bool:
    """Whether the last version is a later minor version than the one that deprecated."""
    return numbers(since)[:2] < numbers(last)[:2]


def write(project: Project, version: str) -> None:
    """Writes the lists of a release."""
    folder = project.root / LISTS / version
    folder.mkdir(parents=True, exist_ok=True)
    for part, module in PARTS.items():
        text = "".join(f"{line}\n" for line in module.lines(project))
        (folder / f"{part}.txt").write_text(text, encoding="utf-8")
