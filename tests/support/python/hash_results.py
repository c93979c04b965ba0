# SPDX-License-Identifier: MIT
"""Hashes what Pliant computes, to see that work on the code changes no bit of it.

    PYTHONPATH=PACKAGE hash_results.py OUT.txt --command PLIANT [--compare BEFORE.txt]

Whichever package is importable runs every technique with every weighting on every example, in every
level of lanes, and every sampler with every option; the command writes files. OUT.txt gets a sorted
line for each result: its name, two spaces, and a SHA-256 or what was refused. With --compare lines
that differ from those of an earlier file are printed, and the exit code is 1 if there are any.
--only samples leaves out all but samples, conformers and paths; --only runs leaves out these.
"""

import argparse
import sys
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

import hashed_command
import hashed_library
import hashed_samples
from digest import Line

import pliant

MOST_PRINTED = 40


RUNS, SAMPLES = [hashed_library, hashed_command], [hashed_samples]
PARTS = {"runs": RUNS, "samples": SAMPLES, "": RUNS + SAMPLES}


def lines_of(part: str, command: Path) -> Iterator[Line]:
    """The lines of a row of PARTS."""
    for module in PARTS[part]:
        if hasattr(module, "library_lines"):
            yield from module.library_lines()
        if hasattr(module, "command_lines"):
            yield from module.command_lines(command)


def all_lines(part: str, command: Path) -> list[str]:
    """Every result as a line of text, sorted. Raises ValueError if two have one name."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = dict(unique(lines_of(part, command)))
    return sorted(f"{name}  {value}" for name, value in found.items())


def unique(found: Iterable[Line]) -> Iterator[Line]:
    """The same lines, each name once."""
    names = set()
    for name, value in found:
        if name in names:
            raise ValueError(f"two results have the name {name}")
        names.add(name)
        yield name, value


def differences(before: list[str], after: list[str]) -> list[str]:
    """A text for each name whose line is another, is missing, or is new."""
    old, new = (dict(line.split("  ", 1) for line in text) for text in (before, after))
    found = []
    for name in sorted(old.keys() | new.keys()):
        if old.get(name) != new.get(name):
            found.append(f"{name}\n  before {old.get(name, '-')}\n  after  {new.get(name, '-')}")
    return found


def report(found: list[str], count: int) -> int:
    """Prints what differs; the exit code."""
    for text in found[:MOST_PRINTED]:
        print(text)
    if len(found) > MOST_PRINTED:
        kinds = Counter(text.split()[0] for text in found)
        counts = ", ".join(f"{number} of {kind}" for kind, number in kinds.items())
        print(f"and {len(found) - MOST_PRINTED} more; in all {counts}")
    print(f"{len(found)} of {count} results differ")
    return int(bool(found))


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", type=Path, help="file to write")
    parser.add_argument("--command", type=Path, required=True, help="the command pliant")
    parser.add_argument("--compare", type=Path, help="file written before")
    parser.add_argument("--only", choices=("runs", "samples"), default="", help="a part of it")
    arguments = parser.parse_args()
    after = all_lines(arguments.only, arguments.command.resolve())
    arguments.out.write_text("".join(f"{line}\n" for line in after), encoding="utf-8")
    print(f"{len(after)} results of {Path(pliant.__file__).parent} and {arguments.command}")
    if arguments.compare is None:
        return 0
    before = arguments.compare.read_text(encoding="utf-8").splitlines()
    return report(differences(before, after), len(after))


if __name__ == "__main__":
    sys.exit(main())
