# SPDX-License-Identifier: MIT
"""C++ tests run many in a process, and what ends one is named; folders keep to their seconds."""

import os
import stat
import subprocess
import sys

import check_seconds
import count_tests
import pytest
import recorded_seconds
from sources import ROOT

RUNNER = ROOT / "tests/support/running/run_cpp_tests.py"

#: speaks as GoogleTest does: a test passes, Fails, Dies, or dies after another one in its process
PROGRAM = f"""#!{sys.executable}
import sys
if "--gtest_list_tests" in sys.argv:
    print("Running main()\\nSuite.\\n  Passes/0  # GetParam() = 1\\n  NAMES  DISABLED_Old", sep="")
    sys.exit()
names = sys.argv[1].partition("=")[2].split(":")
if "Suite.Dies" in names or ("Suite.Second" in names and len(names) > 1):
    print("what it said last")
    sys.exit(134)
cases = []
for name in names:
    suite, _, test = name.rpartition(".")
    inside = '<failure message="2 is not 3"/>' if test == "Fails" else ""
    inside += '<properties><property name="cpu" value="0.5"/><property name="source" '
    inside += 'value="/x/tests/b/../../tests/unit/a_test.cpp"/></properties>'
    cases.append(f'<testcase name="{{test}}" classname="{{suite}}">{{inside}}</testcase>')
with open(sys.argv[2].partition(":")[2], "w") as file:
    file.write("<testsuites><testsuite>" + "".join(cases) + "</testsuite></testsuites>")
sys.exit("Suite.Fails" in names)
"""


def run(folder, *names):
    program = folder / "program"
    program.write_text(PROGRAM.replace("NAMES", "\\n  ".join([*names, ""])))
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    words = [sys.executable, RUNNER, program, folder / "report.xml", "--jobs", "1"]
    return subprocess.run(list(map(str, words)), text=True, capture_output=True, timeout=900)


@pytest.mark.parametrize(
    ("names", "code", "said"),
    [
        ([], 0, "1 of 1 C++ tests passed"),
        (["More"], 0, "2 of 2 C++ tests passed"),
        (["Fails"], 1, "Suite.Fails failed:\n2 is not 3\n1 of 2 "),
        (["Dies"], 1, "Suite.Dies failed:\nwhat it said last\n\nended with 134\n1 of 2 "),
        (["Second"], 1, "Together.Suite.Passes/0+Suite.Second failed:\nwhat it said last\n"),
    ],
)  # fmt: skip
def test_what_fails_or_ends_its_process_is_named(tmp_path, names, code, said):
    ended = run(tmp_path, *names)
    assert said in ended.stdout, ended.stdout + ended.stderr
    assert ended.returncode == code


def test_the_report_counts_single_tests_and_has_their_seconds(tmp_path):
    run(tmp_path, "Fails", "More")
    report = tmp_path / "report.xml"
    assert count_tests.count(report) == {"passed": 2, "failed": 1}
    assert [(str(path), seconds) for _, path, seconds in recorded_seconds.cases(report)] == [
        ("tests/unit/a_test.cpp", 0.5)
    ] * 3


def test_a_folder_that_takes_too_much_is_found():
    rows = dict.fromkeys("abcde", 10.0)

    def said(**seconds):
        folders = {name: [("long", taken - 1), ("short", 1)] for name, taken in seconds.items()}
        too_much, much = check_seconds.findings(folders, rows)
        return [[text.split()[0] for text in texts] for texts in (too_much, much)]

    assert said(a=14, b=10, c=10, d=10, e=10) == [[], []]
    assert said(a=16, b=10, c=10, d=10, e=10) == [[], ["a"]]
    assert said(a=31, b=10, c=10, d=10, e=10) == [["a"], []]
    assert said(a=23, b=20, c=20, d=20, e=20) == [[], []]  # a machine of half the speed
    assert said(without_a_row=7) == [["without_a_row"], []]


def test_every_row_is_a_folder_of_tests():
    missing = [name for name in recorded_seconds.table() if not os.path.isdir(ROOT / name)]
    assert not missing
