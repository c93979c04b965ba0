# SPDX-License-Identifier: MIT
"""What must hold before a release: a table of checks, each with its result in one line."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Sequence
from typing import NamedTuple

import changelog
import interface
import product
import recipes
import versions
from project import Project

DONE = "build/done"  # ./dev notes there which command passed with which commit
LINTS = ("links", "workflows")  # of tests/lint


class Result(NamedTuple):
    """Whether a check passed, and what there is to say."""

    passed: bool
    text: str
    details: Sequence[str] = ()


class Check(NamedTuple):
    """A row of the table."""

    name: str
    look: Callable[[Project], Result]


def _of(problems: list[str], passed: str) -> Result:
    if not problems:
        return Result(True, passed)
    return Result(False, f"{len(problems)} found", problems)


def tree(project: Project) -> Result:
    """All that is released is in the commit."""
    return _of([f"{name}: not in the commit" for name in project.changed()], project.commit()[:12])


def version(project: Project) -> Result:
    """All files name one version and one day."""
    day = versions.stated(project, versions.DATES)["CHANGELOG.md"]
    found = versions.differences(project)
    if not versions.is_released(project):
        found.append(f"CHANGELOG.md: {day}: ./dev release --prepare VERSION DATE writes the day")
    return _of(found, f"{project.version()} in {len(versions.VERSIONS)} files, {day}")


def changes(project: Project) -> Result:
    """The changelog has this version, one line a change."""
    lines = changelog.section(project.text("CHANGELOG.md"), project.version())
    return _of(changelog.problems(lines), f"{len(changelog.changes(lines))} changes, a line each")


def lints(project: Project) -> Result:
    """Links and pictures lead somewhere, no address is invented, the workflows hang together."""
    files = [f"tests/lint/test_{name}.py" for name in LINTS]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *files]
    done = subprocess.run(command, cwd=project.root, capture_output=True, text=True, check=False)
    said = [line[2:].strip() for line in done.stdout.splitlines() if line.startswith("E ")]
    missing = recipes.missing(project)
    kit = f"; no file for the registry of MDAKits without {' and '.join(missing)}"
    passed = f"of {', '.join(LINTS)}{kit if missing else ''}"
    return _of([] if done.returncode == 0 else said or ["pytest: " + done.stderr[-200:]], passed)


def promises(project: Project) -> Result:
    """What the last tagged version promised is there."""
    tag = interface.last_tag(project)
    return _of(interface.problems(project), f"keeps what {tag} promised" if tag else "the first")


def _passes(project: Project, *commands: str) -> Result:
    """Whether one of the commands of ./dev passed with this commit; else the last one is run."""
    for command in commands:
        noted = project.text(f"{DONE}/{command.replace(' ', '')}").strip()
        if noted and noted == project.commit():
            return Result(True, f"./dev {command} passed with this commit")
    last = commands[-1]
    code = subprocess.run(["./dev", *last.split()], cwd=project.root, check=False).returncode
    return Result(code == 0, f"./dev {last} {'passed' if code == 0 else 'failed'}")


def tests(project: Project) -> Result:
    """The tests of every change pass."""
    return _passes(project, "test --all", "test")


def docs(project: Project) -> Result:
    """The site is built, and every link of it leads somewhere."""
    return _passes(project, "docs")


def wheels(project: Project) -> Result:
    """There is a wheel for each system and Python."""
    made = _passes(project, "wheel --all")
    if not made.passed:
        return made
    missing = [f"no wheel for {name}" for name in product.missing_wheels(project)]
    return _of(missing, f"{len(product.wheels(project))} wheels; {made.text}")


def archive(project: Project) -> Result:
    """There is an archive of the sources, and a wheel can be made of it."""
    made = _passes(project, "sdist")
    if made.passed and not product.sources(project).is_file():
        return Result(False, f"there is no {product.sources(project).name}")
    return made


QUICK = (
    Check("clean tree", tree),
    Check("version", version),
    Check("changelog", changes),
    Check("lints", lints),
    Check("interface", promises),
)
LONG = (
    Check("tests", tests),
    Check("docs", docs),
    Check("wheels", wheels),
    Check("sources", archive),
)
