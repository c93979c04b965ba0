# SPDX-License-Identifier: MIT
"""What must hold before a release: a table of checks, each with its result in one line."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Sequence
from typing import NamedTuple

import addresses
import changelog
import interface
import pictures
import product
import registry_kit
import versions
from project import Project

DONE = "build/done"  # ./dev notes there which command passed with the files of which commit
# What a command does not read: what it showed still holds where nothing else was changed since.
UNREAD = {
    "wheel--all": (
        ".github",
        "CMakePresets.json",
        "CONTRIBUTING.md",
        "docs",
        "python/release",
        *(f"tests/{name}" for name in ("bench", "cli", "corpus", "docs", "examples", "fuzz")),
        *(f"tests/{name}" for name in ("golden", "law", "lint", "python", "threads", "unit")),
        "tests/seconds.toml",
    )
}
TESTS_OF_LINKS = "tests/lint/test_links.py"
TESTS_OF_WORKFLOWS = "tests/lint/test_workflows.py"


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


def address(project: Project) -> Result:
    """The address is written once, or there is none anywhere."""
    missing = registry_kit.missing(project)
    said = project.address() or "none yet: what is published names none"
    kit = f"; no file for the registry of MDAKits without {' and '.join(missing)}"
    return _of(addresses.problems(project), said + (kit if missing else ""))


def links(project: Project) -> Result:
    """Links of all pages lead somewhere."""
    return _pytest(project, TESTS_OF_LINKS, "lead somewhere")


def workflows(project: Project) -> Result:
    """The workflows of GitHub hang together."""
    return _pytest(project, TESTS_OF_WORKFLOWS, "hang together")


def _pytest(project: Project, file: str, passed: str) -> Result:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", file]
    done = subprocess.run(command, cwd=project.root, capture_output=True, text=True, check=False)
    said = [line[2:].strip() for line in done.stdout.splitlines() if line.startswith("E ")]
    return _of([] if done.returncode == 0 else said or ["pytest: " + done.stderr[-200:]], passed)


def shown(project: Project) -> Result:
    """Pictures that pages show are there, and made by scripts."""
    return _of(pictures.problems(project), f"{len(set(pictures.shown(project)))} shown")


def promises(project: Project) -> Result:
    """The interface is listed for this version, as it is now, and keeps what was promised."""
    known, now = interface.versions(project), project.version()
    if now not in known:
        return Result(False, f"no list of {now}: ./dev release --prepare {now} DATE writes it")
    found, count = [], 0
    for part, module in interface.PARTS.items():
        lines, listed = module.lines(project), interface.listed(project, now, part)
        count += len(lines)
        found += [f"{part}: {line}: is not in the list" for line in lines if line not in listed]
        found += [f"{part}: {line}: is no more" for line in listed if line not in lines]
    return _of(found, f"{count} lines, as listed for {now}")


def noted(project: Project, name: str) -> str:
    """The commit that a command of ./dev passed with last; empty if there is none."""
    commit = project.text(f"{DONE}/{name}").strip()
    return project.git("rev-parse", "--verify", f"{commit}^{{commit}}")


def holds(project: Project, name: str) -> bool:
    """Whether a command of ./dev passed with all that it reads of this commit."""
    commit = noted(project, name)
    unread = [f":(exclude){path}" for path in UNREAD.get(name, ())]
    changed = project.git("diff", "--name-only", commit, "HEAD", "--", ".", *unread)
    return bool(commit) and not changed


def done(project: Project, *names: str) -> str:
    """The first of these commands of ./dev that need not be run again; empty if all must."""
    return next((name for name in names if holds(project, name)), "")


def _spoken(name: str) -> str:
    return name.replace("--", " --")


def _passed_with(project: Project, name: str) -> str:
    commit = noted(project, name)
    if commit == project.commit():
        return "this commit"
    return f"{commit[:12]}, and what it reads is the same"


def _made_by(project: Project, command: str, *instead: str) -> Result:
    """Whether a command of ./dev passes; it is run unless it has, with all that it reads."""
    name = done(project, *instead, command)
    if name:
        return Result(True, f"./dev {_spoken(name)} passed with {_passed_with(project, name)}")
    words = _spoken(command)
    code = subprocess.run(["./dev", *words.split()], cwd=project.root, check=False).returncode
    return Result(code == 0, f"./dev {words} {'passed' if code == 0 else 'failed'}")


def tests(project: Project) -> Result:
    """The tests of every change pass."""
    return _made_by(project, "test", "test--all")


def docs(project: Project) -> Result:
    """The site is built, and every link of it leads somewhere."""
    return _made_by(project, "docs")


def wheels(project: Project) -> Result:
    """There is a wheel for each system and Python."""
    made = _made_by(project, "wheel--all")
    if not made.passed:
        return made
    missing = [f"no wheel for {name}" for name in product.missing_wheels(project)]
    return _of(missing, f"{len(product.wheels(project))} wheels; {made.text}")


def archive(project: Project) -> Result:
    """There is an archive of the sources, and a wheel can be made of it."""
    made = _made_by(project, "sdist")
    if made.passed and not product.sources(project).is_file():
        return Result(False, f"there is no {product.sources(project).name}")
    return made


QUICK = (
    Check("clean tree", tree),
    Check("version", version),
    Check("changelog", changes),
    Check("address", address),
    Check("links", links),
    Check("pictures", shown),
    Check("interface", promises),
    Check("workflows", workflows),
)
LONG = (
    Check("tests", tests),
    Check("docs", docs),
    Check("wheels", wheels),
    Check("sources", archive),
)
