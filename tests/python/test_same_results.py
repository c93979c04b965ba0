# SPDX-License-Identifier: MIT
"""What compares results and instructions before and after work on the code sees what it must."""

import numpy as np
import pytest
from count_instructions import costs, findings, is_counted, with_sums
from digest import digest, lines
from hash_results import differences, unique
from hashed_library import Subject, Way, moving_lines

import pliant

SHAPE = np.array([[0, 0, 0], [1.5, 0, 0], [2, 1.4, 0.3], [0.7, 2.2, 0.6], [-0.5, 1.3, 0.2]])
RING = pliant.Framework([[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]], positions=SHAPE)

DUMP = """# callgrind format
events: Ir

ob=(1) /lib/libm.so.6
fn=(1) exp
12 300
ob=(2) /package/pliant/_core.so
fn=(2) sweep
10 100
+3 20
calls=5 12
* 5000
cob=(1)
cfn=(1)
calls=1 12
-2 7000
* 7
ob=(3) /usr/bin/python3.11
fn=(3) eval
1 900

ob=(1)
fn=(1)
13 1
""".splitlines()


def test_a_digest_sees_every_bit():
    last_bit = SHAPE.copy()
    last_bit[2, 1] = np.nextafter(last_bit[2, 1], 2.0)
    arrays = [SHAPE, last_bit, SHAPE.ravel(), np.array(["C", "N"]), np.array(["C", "O"])]
    others = [[SHAPE], [SHAPE, SHAPE], {"a": b"b"}, b"a", "a", 0.0, -0.0, (1, 0.1), (1, 0.2), 1]
    things = arrays + others
    assert len({digest(thing) for thing in things}) == len(things)
    assert digest([SHAPE, (1, 0.1)]) == digest([SHAPE.copy(), (1, 0.1)])


def test_what_is_refused_is_a_result():
    refused = list(lines("a", lambda: {"x": pliant.order(RING, "none")}))
    assert refused[0][0] == "a"
    assert refused[0][1].startswith("OptionError: ")


def test_changed_missing_and_new_results_are_reported():
    before, after = ["a b  1", "c  2", "d  3"], ["a b  1", "c  4", "e  OptionError: no  more"]
    assert differences(before, after) == [
        "c\n  before 2\n  after  4",
        "d\n  before 3\n  after  -",
        "e\n  before -\n  after  OptionError: no  more",
    ]
    with pytest.raises(ValueError, match="two results have the name a"):
        list(unique([("a", "1"), ("a", "2")]))


@pytest.mark.parametrize("technique", ["bfs_random", "blocks", "newton"])
def test_results_are_the_same_again_and_in_lanes(technique):
    subject, way = Subject("ring", RING, SHAPE), Way("way", {"technique": technique})
    found = list(moving_lines(subject, way))
    assert found == list(moving_lines(subject, way))
    in_lanes = {value for name, value in found if name.startswith("lanes") and "positions" in name}
    assert len(in_lanes) == 1
    assert len(set(found)) > 6


def test_instructions_are_those_of_the_library_itself():
    found = list(costs(DUMP))
    assert sum(cost for library, cost in found if library.endswith("_core.so")) == 127
    assert sum(cost for library, cost in found if is_counted(library)) == 428
    assert is_counted("/python/pliant/_core.cpython-311.so")
    assert not is_counted("/site-packages/numpy/_core/_multiarray_umath.so")


def test_what_became_slower_is_reported():
    before = with_sums({"step a": {"instructions": 100, "bars": 0}})
    assert findings(with_sums({"step a": {"instructions": 103, "bars": 0}}), before) == []
    assert findings(with_sums({"step a": {"instructions": 104, "bars": 1}}), before) == [
        "all of step: 1.040 times the instructions",
        "all of step: 2.000 times the bars",
        "step a: 1.040 times the instructions",
        "step a: 2.000 times the bars",
    ]
    assert findings({}, {"a": {}}) == ["a: is in one of both only"]
