# SPDX-License-Identifier: MIT
"""Adds up JUnit reports into one plain line: count_tests.py REPORT..."""

import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path


def count(report: Path) -> Counter:
    """How many test cases of a report passed, failed and were skipped."""
    result = Counter()
    for case in ElementTree.parse(report).iter("testcase"):
        kinds = {child.tag for child in case}
        if kinds & {"failure", "error"}:
            result["failed"] += 1
        elif "skipped" in kinds:
            result["skipped"] += 1
        else:
            result["passed"] += 1
    return result


def main(reports: list[Path]) -> int:
    """Prints the line; 1 if a test failed, or a report is missing, or nothing ran."""
    missing = [report for report in reports if not report.exists()]
    for report in missing:
        print(f"{report} was not written: its tests did not run to the end")
    total = sum((count(report) for report in reports if report.exists()), Counter())
    failed = total["failed"] + len(missing)
    skipped = f", {total['skipped']} skipped" if total["skipped"] else ""
    print(f"{total['passed']} passed, {failed} failed{skipped}")
    return int(failed > 0 or total["passed"] == 0)


if __name__ == "__main__":
    sys.exit(main([Path(name) for name in sys.argv[1:]]))
