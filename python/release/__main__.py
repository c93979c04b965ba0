# SPDX-License-Identifier: MIT
"""./dev release: checks that a version can be released, and makes what its tag has.

    release [--quick] [--tag]            check; without --quick also make build/release/VERSION
    release --prepare VERSION DATE       write version and day

Nothing is published, and nothing is tagged without --tag.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import checks
import product
import versions
from project import Project

MOST_DETAILS = 12


def show(check: checks.Check, result: checks.Result) -> None:
    """One row, and what was found."""
    print(
        f"  {check.name:<12}{'passed' if result.passed else 'FAILED':<8}{result.text}", flush=True
    )
    for line in result.details[:MOST_DETAILS]:
        print(f"      {line}")
    if len(result.details) > MOST_DETAILS:
        print(f"      and {len(result.details) - MOST_DETAILS} more")


def failed(project: Project, table: tuple[checks.Check, ...]) -> int:
    """How many checks of a table fail; each is shown."""
    failures = 0
    for check in table:
        result = check.look(project)
        show(check, result)
        failures += not result.passed
    return failures


def prepare(project: Project, version: str, day: str) -> int:
    """Writes what belongs to a new version; a tagged one is left alone."""
    if project.git("tag", "--list", f"v{version}"):
        print(f"release: v{version} is tagged: its date stays", file=sys.stderr)
        return 1
    if not versions.DATE.fullmatch(day):
        print(f"release: {day!r} is no date such as 2026-11-26", file=sys.stderr)
        return 2
    versions.write(project, version, day)
    print(f"{version} of {day}: look at the differences, write the changelog, commit")
    return 0


def make(project: Project, tag: bool) -> None:
    """Makes the folder and says, or does, what is left."""
    folder = project.root / "build" / "release" / project.version()
    for path in product.make(project, folder):
        print(f"  {path.stat().st_size:>10}  {path.relative_to(project.root)}")
    notes = (folder / "RELEASE_NOTES.md").relative_to(project.root)
    words = ["tag", "-a", f"v{project.version()}", "--cleanup=verbatim", "-F", str(notes)]
    if tag:
        project.git(*words)
        print(f"\ntagged v{project.version()}")
    else:
        print(f"\nAll is there. To tag it:\n  git {' '.join(words)}")


def main() -> int:
    """What ./dev release runs."""
    parser = argparse.ArgumentParser(prog="./dev release", description="checks and makes a release")
    parser.add_argument("--quick", action="store_true", help="what takes seconds, and make nothing")
    parser.add_argument("--tag", action="store_true", help="tag the commit if all passes")
    parser.add_argument("--prepare", nargs=2, metavar=("VERSION", "DATE"), help="write them")
    options = parser.parse_args()
    project = Project()
    if options.prepare:
        return prepare(project, *options.prepare)
    failures = failed(project, checks.QUICK)
    if not failures and not options.quick:  # what takes an hour comes after what takes seconds
        failures = failed(project, checks.LONG)
    if failures:
        print(f"\n{failures} of the checks failed")
        return 1
    if not options.quick:
        make(project, options.tag)
    return 0


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    sys.exit(main())
