# SPDX-License-Identifier: MIT
"""Where the version and its date are written: read, compared, and written anew."""

from __future__ import annotations

import re
from pathlib import Path

from project import Project

#: a file, and what stands around the version in it; the first one leads
VERSIONS = {
    "CMakeLists.txt": r"^(project\(pliant VERSION )([\d.]+)()",
    "CITATION.cff": r"^(version: )([\d.]+)()$",
    "CHANGELOG.md": r"^(## )([\d.]+)( \()",
    "docs/pages/cite.md": r"^(  version = \{)([\d.]+)(\})",
}
#: the same of the day of the release
DATES = {
    "CHANGELOG.md": r"^(## [\d.]+ \()([^)]+)(\))",
    "CITATION.cff": r"^(date-released: )(\S+)()$",
}
DATE = re.compile(r"\d{4}-\d\d-\d\d")
UNRELEASED = "not released"  #: in place of the day, until --prepare writes it


def stated(project: Project, places: dict[str, str]) -> dict[str, str]:
    """What each file says; empty where it says nothing."""
    found = {name: re.search(p, project.text(name), re.MULTILINE) for name, p in places.items()}
    return {name: match[2] if match else "" for name, match in found.items()}


def differences(project: Project) -> list[str]:
    """One line for each file that disagrees with the first of its table."""
    problems = []
    for what, places in (("version", VERSIONS), ("date", DATES)):
        (first, expected), *others = stated(project, places).items()
        expected = "" if expected == UNRELEASED else expected
        problems += [
            f"{name}: {what} {value or 'is missing'}, but {first} has {expected or 'none'}"
            for name, value in others
            if value != expected
        ]
    day = stated(project, DATES)["CHANGELOG.md"]
    if not DATE.fullmatch(day) and day != UNRELEASED:
        problems.append(f"CHANGELOG.md: {day!r} is no date such as 2026-11-26")
    return problems


def is_released(project: Project) -> bool:
    """Whether the changelog has a day for the newest version."""
    return stated(project, DATES)["CHANGELOG.md"] != UNRELEASED


def write(project: Project, version: str, day: str) -> None:
    """Writes version and day into every file; the newest section of the changelog gets them.

    A version that is new there gets a section of its own, with nothing in it yet.
    """
    changes = project.text("CHANGELOG.md")
    if not re.search(rf"^## {re.escape(version)} \(", changes, re.MULTILINE):
        new = f"## {version} ({day})\n\n### Added\n\n### Changed\n\n### Fixed\n\n"
        changes = re.sub(r"^(?=## )", new, changes, count=1, flags=re.MULTILINE)
        (project.root / "CHANGELOG.md").write_text(changes, encoding="utf-8")
    cited = project.text("CITATION.cff")
    if "date-released:" not in cited:
        cited = re.sub(r"^(version: .*\n)", r"\1date-released: -\n", cited, flags=re.MULTILINE)
        (project.root / "CITATION.cff").write_text(cited, encoding="utf-8")
    for places, value in ((VERSIONS, version), (DATES, day)):
        for name, pattern in places.items():
            _write_one(project.root / name, pattern, value)


def _write_one(path: Path, pattern: str, value: str) -> None:
    text = path.read_text(encoding="utf-8")
    text = re.sub(pattern, rf"\g<1>{value}\g<3>", text, count=1, flags=re.MULTILINE)
    path.write_text(text, encoding="utf-8")
