# SPDX-License-Identifier: MIT
"""CPU seconds of files of tests: as reports of runs have them, and what to expect of the next run.

recorded_seconds.py REPORT... keeps them for that.
"""

import json
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath

try:
    import tomllib
except ModuleNotFoundError:
    from pip._vendor import tomli as tomllib

ROOT = Path(__file__).resolve().parents[3]

#: CPU seconds of each folder of tests
TABLE = ROOT / "tests" / "seconds.toml"

#: what the last run of each file took here
RECORDED = ROOT / "build" / "test_seconds.json"

#: where nothing is known of the folder
UNKNOWN = 1.0


def cases(report: Path) -> Iterator[tuple[str, PurePosixPath, float]]:
    """Name, file and CPU seconds of the cases of a JUnit report that have them."""
    for case in ElementTree.parse(report).iter("testcase"):
        found = {one.get("name"): one.get("value", "") for one in case.iter("property")}
        if {"cpu", "source"} <= set(found):
            # Compilers name a file as it is included: BUILD/../tests/unit/FILE.
            place = PurePosixPath("tests") / found["source"].rpartition("tests/")[2]
            yield case.get("name", ""), place, float(found["cpu"])


def table() -> dict[str, float]:
    """The rows of the table."""
    return tomllib.loads(TABLE.read_text())["seconds"] if TABLE.exists() else {}


def recorded() -> dict[str, float]:
    """What the last run of each file took."""
    return json.loads(RECORDED.read_text()) if RECORDED.exists() else {}


def record(reports: Iterable[Path]) -> None:
    """Keeps the seconds of these reports for the next estimates."""
    total: Counter[str] = Counter()
    for report in reports:
        for _, path, seconds in cases(report):
            total[str(path)] += seconds
    RECORDED.write_text(json.dumps({**recorded(), **total}, indent=0))


def estimates(tests: Iterable[PurePosixPath]) -> dict[PurePosixPath, float]:
    """What each file took last; else the mean of its folder, by the table."""
    tests = list(tests)
    files = Counter(test.parent for test in tests)
    known, rows = recorded(), table()

    def mean(folder: PurePosixPath) -> float:
        return rows[str(folder)] / files[folder] if str(folder) in rows else UNKNOWN

    return {test: known.get(str(test), mean(test.parent)) for test in tests}


if __name__ == "__main__":
    record(path for path in map(Path, sys.argv[1:]) if path.exists())
