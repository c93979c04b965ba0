# SPDX-License-Identifier: MIT
"""Holds each folder of tests to its CPU seconds: check_seconds.py [--rows] REPORT...

--rows prints the table as these reports would have it.
"""

import math
import sys
from collections import defaultdict
from pathlib import Path
from statistics import median

import recorded_seconds

#: times its row without a word, and times its row that fail: a busy machine takes more CPU time
SAID, FAILS = 1.5, 3.0

#: seconds of a folder that are never too many, nor say how fast a machine is
FREE = 2.0

DEAREST = 5

#: name and seconds of the tests of each folder
Folders = dict[str, list[tuple[str, float]]]


def folders_of(reports: list[Path]) -> Folders:
    """What the reports say."""
    found = defaultdict(list)
    for report in reports:
        for name, path, seconds in recorded_seconds.cases(report):
            found[str(path.parent)].append((f"{path.name}: {name}", seconds))
    return found


def total(tests: list[tuple[str, float]]) -> float:
    """CPU seconds of the tests."""
    return sum(seconds for _, seconds in tests)


def slowness(folders: Folders, rows: dict[str, float]) -> float:
    """How much more time most folders take than their rows: on a slower machine all do."""
    ratios = [
        total(tests) / rows[name] for name, tests in folders.items() if rows.get(name, 0) > FREE
    ]
    return max(1.0, median(ratios)) if ratios else 1.0


def findings(folders: Folders, rows: dict[str, float]) -> tuple[list[str], list[str]]:
    """One text for each folder that takes too much, and for each that takes nearly too much."""
    too_much, much = [], []
    slow = slowness(folders, rows)
    for name, tests in sorted(folders.items()):
        allowed, taken = slow * max(FREE, rows.get(name, 0.0)), total(tests)
        if taken > SAID * allowed:
            dearest = sorted(tests, key=lambda test: -test[1])[:DEAREST]
            lines = [f"{name} took {taken:.1f} CPU seconds, and its row allows {allowed:.1f}"]
            lines += [f"  {seconds:6.1f} {test}" for test, seconds in dearest]
            (too_much if taken > FAILS * allowed else much).append("\n".join(lines))
    return too_much, much


def rows_of(folders: Folders) -> list[str]:
    """Rows of the table."""
    taken = {name: math.ceil(total(tests)) for name, tests in sorted(folders.items())}
    return [f'"{name}" = {seconds}' for name, seconds in taken.items() if seconds > FREE]


def main(words: list[str]) -> int:
    """1 if a folder takes too much."""
    reports = [Path(word) for word in words if word != "--rows"]
    folders = folders_of([report for report in reports if report.exists()])
    if "--rows" in words:
        print(*rows_of(folders), sep="\n")
        return 0
    too_much, much = findings(folders, recorded_seconds.table())
    for text in much:
        print(f"warning: {text}")
    for text in too_much:
        print(f"too slow: {text}\nMake them faster, or leave some to --all (tests/seconds.toml)")
    return int(bool(too_much))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
