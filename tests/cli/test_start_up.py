# SPDX-License-Identifier: MIT
"""What it takes to start, in instructions: a busy machine changes nothing about them."""

import os
import shutil
import sys

import pytest
from start_up import STARTS, Counts, Start, findings, row, split

DUMP = """ob=(1) /lib64/ld-linux-x86-64.so.2
fn=(1) do_lookup_x
1 3000000
ob=(2) /bin/pliant
fn=(2) main
1 500000
calls=1 1
1 3000000
""".splitlines()


def test_the_linker_is_counted_apart():
    assert split(DUMP) == Counts(3.0, 0.5)


@pytest.mark.parametrize("start", STARTS, ids=lambda start: start.name)
def test_a_fifth_more_is_refused(start):
    """Whatever is within the budget: a fifth more of it is not."""
    least = Counts(*(most / 1.2 for most in start.most))
    assert findings(start, least) == []
    for name in Counts._fields:
        more = least._replace(**{name: 1.201 * getattr(least, name)})
        assert f"{name} takes" in findings(start, more)[0]
    assert "allow less" in findings(start, least._replace(other=0.9 * least.other))[0]


# An import takes valgrind as long as all commands do.
COUNTED = [
    pytest.param(start, marks=[pytest.mark.long] if start.name.startswith("import") else [])
    for start in STARTS
]


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="valgrind is missing: ./dev test")
@pytest.mark.skipif("PLIANT_COMMAND" in os.environ, reason="the budgets are of the optimised build")
@pytest.mark.parametrize("start", COUNTED, ids=lambda start: start.name)
def test_starting_stays_within_its_budget(start: Start, capsys):
    if start.name.startswith("import") and sys.version_info[:2] != (3, 11):
        pytest.skip("counted with Python 3.11")
    found = start.count()
    with capsys.disabled():
        print(f"\n{row(start, found)}")
    assert findings(start, found) == []
