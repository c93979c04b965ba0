# SPDX-License-Identifier: MIT
"""Runs the tests of a program of GoogleTest, many in a process, into one JUnit report:
run_cpp_tests.py PROGRAM REPORT [--jobs N] [--match REGEX]

Where a process dies, each of its tests runs again in a process of its own, to name those that die.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

#: tests in a process: starting it takes as long as a short test
TOGETHER = 25

#: seconds after which a process hangs, however busy the machine is
TIMEOUT = 3600 if os.environ.get("PLIANT_ALL") else 1800


def listed(program: str, match: str) -> list[str]:
    """The full names of the tests that match."""
    text = subprocess.run(
        [program, "--gtest_list_tests"], text=True, capture_output=True, check=True
    )
    names, suite = [], ""
    for line in text.stdout.splitlines():
        word = line.split("#")[0].strip()
        if not line.startswith(" "):
            suite = word
        elif "DISABLED_" not in suite + word:
            names.append(suite + word)
    return [name for name in names if re.search(match, name)]


def run_together(program: str, names: list[str]) -> tuple[list[ElementTree.Element], str]:
    """The cases of the report of one process; if there is none, why."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        words = [program, f"--gtest_filter={':'.join(names)}", f"--gtest_output=xml:{report}"]
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        try:
            ended = subprocess.run(words, **pipes, timeout=TIMEOUT, errors="replace")
        except subprocess.TimeoutExpired:
            return [], f"not ended after {TIMEOUT} s"
        found = list(ElementTree.parse(report).iter("testcase")) if report.exists() else []
        failed = any(case.find("failure") is not None for case in found)
        if len(found) != len(names) or ended.returncode != int(failed):
            return [], f"{ended.stdout}\nended with {ended.returncode}"
        return found, ""


def died(name: str, why: str) -> ElementTree.Element:
    """The case of a test that ended its process."""
    suite, _, test = name.rpartition(".")
    case = ElementTree.Element("testcase", name=test, classname=suite)
    printable = re.sub(r"[^\n\x20-\uFFFD]", "?", why)
    ElementTree.SubElement(case, "failure", message="died").text = printable
    return case


def run(program: str, names: list[str]) -> list[ElementTree.Element]:
    """The cases of these tests."""
    found, why = run_together(program, names)
    if not why:
        return found
    if len(names) == 1:
        return [died(names[0], why)]
    alone = [case for name in names for case in run(program, [name])]
    if all(case.find("failure") is None for case in alone):
        alone.append(died("Together." + "+".join(names), why))
    return alone


def say(cases: list[ElementTree.Element]) -> int:
    """Prints what failed, and how many passed; how many failed."""
    failures = [case for case in cases if case.find("failure") is not None]
    for case in failures:
        print(f"{case.get('classname')}.{case.get('name')} failed:")
        print(*(one.text or one.get("message") for one in case.iter("failure")), sep="\n")
    skipped = sum(case.find("skipped") is not None for case in cases)
    ran = len(cases) - skipped
    print(
        f"{ran - len(failures)} of {ran} C++ tests passed" if cases else "No C++ test has this name"
    )
    return len(failures)


def main() -> int:
    """1 if a test failed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("report", type=Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--match", default="")
    asked = parser.parse_args()
    names = listed(asked.program, asked.match)
    parts = [names[k : k + TOGETHER] for k in range(0, len(names), TOGETHER)]
    with ThreadPoolExecutor(asked.jobs) as pool:
        found = [
            case for part in pool.map(lambda part: run(asked.program, part), parts) for case in part
        ]
    suites = ElementTree.Element("testsuites")
    ElementTree.SubElement(suites, "testsuite", name="pliant_tests").extend(found)
    ElementTree.ElementTree(suites).write(asked.report, encoding="unicode", xml_declaration=True)
    return int(say(found) > 0)


if __name__ == "__main__":
    sys.exit(main())
