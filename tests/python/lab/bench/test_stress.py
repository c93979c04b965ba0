# SPDX-License-Identifier: MIT
"""Nothing in the table of hard cases makes a technique lie, crash or lose a number."""

import dataclasses
import json
import math

import numpy as np
import pytest
from pliant.checks.openmm.child import Outcome
from pliant.lab.bench import stress_cases, stress_table
from pliant.lab.bench.command import main
from pliant.lab.bench.least_squares import least_squares_floor
from pliant.lab.bench.stress import _row, _their_row, stress, worst
from pliant.lab.bench.stress_cases import Case, broken

import pliant

CASES = stress_table.all_cases(shrink=2000, steps=50)


def few_sweeps(case):
    return dataclasses.replace(case, max_sweeps=min(case.max_sweeps, 100))


@pytest.fixture(scope="module")
def table():
    return stress([few_sweeps(case) for case in CASES], weightings=(1.0,), openmm=False)


def test_names_are_reported_apart():
    names = [case.name for case in CASES]
    assert len(set(names)) == len(names) > 130


@pytest.mark.long
def test_nothing_happens_that_must_never_happen(table):
    assert table.violations == []
    assert sum(len(case.rows) for case in table.cases) > 1400


@pytest.mark.long
def test_what_cannot_be_whole_is_infeasible_and_has_a_floor(table):
    impossible = [c for c in table.cases if c.feasible is False and c.group == "examples"]
    assert len(impossible) >= 8
    for case in impossible:
        assert {row.outcome for row in case.rows} == {"infeasible"}, case.name
        assert case.floor > 1e-3


@pytest.mark.long
def test_forests_are_whole_by_their_own_technique(table):
    for case in table.cases:
        known = case.feasible and case.group in ("examples", "offset", "push", "large", "peers")
        rows = [r for r in case.rows if r.method == "bfs_tree" and r.weighting == 1.0]
        if known and rows and not case.name.startswith("pinned"):
            assert rows[0].outcome == "converged" and rows[0].sweeps <= 2, case.name


@pytest.mark.long
def test_refusals_say_why(table):
    refused = {c.name: c.rows[0].note for c in table.cases if c.rows[0].outcome == "refused"}
    assert set(refused) == {
        "bar_of_0",
        "bar_of_1e-310",
        "bar_of_1e+200",
        "duplicate_bar_conflict_1_2",
    }
    assert all(refused.values())


def test_least_squares_of_a_triangle_that_cannot_close():
    # Relative residuals: sides 1 + a twice, base 2 (1 + a) = 3 (1 - b): least 2 a^2 + b^2 where
    # 2 a + 3 b = 1, which is a = 1/11 and b = 3/11.
    start = broken(np.eye(3), [[0, 1], [1, 2], [0, 2]], [1, 1, 3])
    x = least_squares_floor(start)
    lengths = [np.linalg.norm(x[i] - x[j]) for i, j in start.bars]
    assert lengths == pytest.approx([12 / 11, 12 / 11, 24 / 11], rel=1e-5)


def test_a_floor_is_not_asked_of_lengths_out_of_range():
    assert least_squares_floor(broken(np.eye(3)[:2], [[0, 1]], [1e-100])) is None


ONE_BAR = Case("one", "test", "", lambda: None)
START = broken([[0, 0, 0], [1.5, 0, 0]], [[0, 1]], [1.0])


def said(positions, stop="converged", residual=0.0):
    numbers = np.array([1.0, residual, 0.0, 0.0])
    arrays = {"positions": np.array(positions, float), "stop": np.array(stop), "numbers": numbers}
    return Outcome("done", arrays=arrays)


WHOLE, LONG = [[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [1.1, 0, 0]]


@pytest.mark.parametrize(
    ("case", "start", "outcome", "violation"),
    [
        (ONE_BAR, START, said(WHOLE), ""),
        (ONE_BAR, START, said(LONG, residual=0.1),
         "said to have converged, but 0 - 1 is off by 1.000e-01"),
        (ONE_BAR, START, said(LONG, "max_sweeps", 0.1), ""),
        (ONE_BAR, START, said(LONG, "max_sweeps", 0.2),
         "says that the worst bar is off by 2.000e-01, but it is 1.000e-01"),
        (ONE_BAR, START, said([[0, 0, 0], [math.nan, 0, 0]]),
         "a position is not a finite number"),
        (ONE_BAR, START, said([[0, 0, 0], [math.nan, 0, 0]], "not_finite"),
         "lengths that are not finite, but positions were not put back"),
        (ONE_BAR, START, said(START.positions, "not_finite", 0.5), ""),
        (dataclasses.replace(ONE_BAR, feasible=False), START, said(WHOLE),
         "said to have converged on what cannot be whole"),
        (ONE_BAR, dataclasses.replace(START, pinned=np.array([1])), said(WHOLE),
         "a pinned joint moved"),
        (ONE_BAR, START, Outcome("died", "SIGSEGV"), "the process died: SIGSEGV"),
        (ONE_BAR, START, Outcome("raised", "bar 0 - 1: length 0"), ""),
        (ONE_BAR, START, Outcome("too_slow", "took more than 1 s"), ""),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_must_never_happen_is_seen(case, start, outcome, violation):
    assert _row(case, start, "blocks", None, outcome).violation == violation


def test_what_openmm_leaves_is_measured_anew():
    def row(positions):
        arrays = {"positions": np.array([[positions]]) * 0.1, "seconds": np.ones((1, 1))}
        return _their_row(ONE_BAR, START, Outcome("done", arrays=arrays))

    assert row(WHOLE).outcome == "converged"
    assert row(LONG).outcome == "stopped short, says nothing"
    assert row(LONG).max_residual == pytest.approx(0.1)
    assert row([[0, 0, 0], [math.nan, 0, 0]]).outcome == "not_finite"


def test_the_worst_bar_has_a_name():
    start = broken(np.zeros((3, 3)), [[0, 1], [1, 2]], [1.0, 1.0])
    assert worst(start, np.array([[0, 0, 0], [1, 0, 0], [3.0, 0, 0]])) == (1.0, "1 - 2")


def test_examples_are_those_of_the_library():
    assert [c.name for c in stress_cases.examples()] == [row.name for row in pliant.examples()]


def test_the_command_shows_what_openmm_did(capsys):
    words = ["stress", "--only", "diamond", "--technique", "blocks"]
    assert main(words) == 0
    out = capsys.readouterr().out
    assert "openmm_3603_diamond_1e-08" in out and "violations: none" in out
    assert main([*words, "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["violations"] == []
    # The issue: fine to 1e-2, beyond that the coordinates explode and nothing is said.
    assert said["cases"][0]["openmm"]["outcome"] == "converged"
    assert all(c["rows"][0]["outcome"] == "converged" for c in said["cases"])


def test_no_such_case_is_one_line(capsys):
    assert main(["stress", "--only", "nonsense"]) == 2
    assert capsys.readouterr().err == (
        "pliant lab bench stress: error: --only: no case has 'nonsense' in its name or group\n"
    )


def test_a_violation_ends_with_1(capsys, monkeypatch):
    liar = dataclasses.replace(CASES[0], name="liar", group="liar", feasible=False)
    monkeypatch.setattr(stress_table, "all_cases", lambda *_: [liar])
    assert main(["stress", "--technique", "blocks", "--peers", "none"]) == 1
    assert "liar, blocks: said to have converged on what cannot be whole" in capsys.readouterr().out
