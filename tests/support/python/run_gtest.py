# SPDX-License-Identifier: MIT
"""Runs the tests of programs with GoogleTest, many in a process: run_gtest.py [OPTION...] PROGRAM...

ctest starts a process for each test, which takes longer than most of them. Here a process has a batch;
where one dies, its tests are run again, each alone, so that the one which kills is named.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

BATCH = 48  # tests of a process
SECONDS = 3600


@dataclass(frozen=True)
class Batch:
    program: str
    tests: tuple[str, ...]


@dataclass
class Ended:
    cases: list[ElementTree.Element]
    output: str
    cpu_seconds: float = 0.0


def listed(program):
    """The names of all tests of a program, in its order."""
    words = [program, "--gtest_list_tests"]
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    names, suite = [], ""
    for line in text.splitlines():
        name = line.partition("#")[0].rstrip()
        if name.startswith("  "):
            names.append(suite + name.strip())
        elif name.endswith("."):
            suite = name
    return [name for name in names if "DISABLED_" not in name]


def batches(program, pattern):
    names = [name for name in listed(program) if re.search(pattern, name)]
    parts = [tuple(names[k : k + BATCH]) for k in range(0, len(names), BATCH)]
    return [Batch(program, part) for part in parts]


def waited(words, output):
    """The exit status of a program, and seconds of processor time of it and its children."""
    process = subprocess.Popen(words, stdout=output, stderr=subprocess.STDOUT)
    with process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def died(test, code, output):
    """The report of a test that ended its process."""
    suite, _, name = test.rpartition(".")
    case = ElementTree.Element("testcase", classname=suite, name=name, time="0")
    ElementTree.SubElement(case, "failure", message=f"ended its process with {code}")
    return Ended([case], f"{output}\n[  FAILED  ] {test}: ended its process with {code}\n")


def run(batch):
    """Runs a batch; each test alone if the process dies."""
    with tempfile.TemporaryDirectory() as folder:
        report, log = Path(folder, "report.xml"), Path(folder, "log")
        words = [batch.program, f"--gtest_filter={':'.join(batch.tests)}"]
        words = ["timeout", str(SECONDS), *words, f"--gtest_output=xml:{report}"]
        with log.open("wb") as output:
            code, seconds = waited(words, output)
        text = log.read_text(errors="replace")
        if code in (0, 1) and report.exists():
            cases = list(ElementTree.parse(report).iter("testcase"))
            return Ended(cases, text if code else "", seconds)
    if len(batch.tests) == 1:
        return died(batch.tests[0], code, text)
    ends = [run(Batch(batch.program, (test,))) for test in batch.tests]
    cases = [case for end in ends for case in end.cases]
    return Ended(cases, "".join(end.output for end in ends), sum(end.cpu_seconds for end in ends))


def folder_of(case):
    """Which folder of the tests a case lies in: tests/unit/record."""
    parts = Path(os.path.normpath(case.get("file", ""))).parts
    below = parts[len(parts) - parts[::-1].index("tests") : -1] if "tests" in parts else ()
    return "/".join(("tests", *below[:2]))


def add_cpu(ended, table):
    """Shares the processor time of a batch among folders as its tests took time."""
    total = sum(float(case.get("time")) for case in ended.cases) or 1.0
    for case in ended.cases:
        share = ended.cpu_seconds * float(case.get("time")) / total
        table[folder_of(case)] = table.get(folder_of(case), 0.0) + share


def write_report(path, ends):
    root = ElementTree.Element("testsuites")
    suite = ElementTree.SubElement(root, "testsuite", name="pliant_tests")
    table = {}
    for ended in ends:
        suite.extend(ended.cases)
        add_cpu(ended, table)
    properties = ElementTree.SubElement(root, "properties")
    for folder, seconds in sorted(table.items()):
        ElementTree.SubElement(properties, "property", name=f"cpu:{folder}", value=f"{seconds:.2f}")
    ElementTree.ElementTree(root).write(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    parser.add_argument("--pattern", default="", help="of names of tests, as ctest -R takes it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--report", type=Path, required=True, help="a JUnit report")
    options = parser.parse_args()
    work = [one for program in options.programs for one in batches(program, options.pattern)]
    with ThreadPoolExecutor(options.jobs) as pool:
        ends = list(pool.map(run, work))
    write_report(options.report, ends)
    for ended in ends:
        print(ended.output, end="")
    return int(any(case.find("failure") is not None for end in ends for case in end.cases))


if __name__ == "__main__":
    sys.exit(main())
