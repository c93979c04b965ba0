# SPDX-License-Identifier: MIT
"""Nothing in the table of hard cases makes a technique lie, crash or lose a number."""

import csv
import dataclasses
import json
import math

import numpy as np
import pytest
from pliant.checks.openmm.child import Outcome
from pliant.lab.bench import stress_cases
from pliant.lab.bench.command import main
from pliant.lab.bench.stress import Row, _fill, stress, worst
from pliant.lab.bench.stress_cases import Case
from pliant.lab.bench.stress_frameworks import broken

import pliant

CASES = stress_cases.all_cases(shrink=2000, steps=50)


def few_sweeps(case):
    return dataclasses.replace(case, max_sweeps=min(case.max_sweeps, 100))


@pytest.fixture(scope="module")
def table():
    return stress([few_sweeps(case) for case in CASES], weightings=(1.0,))


def test_names_are_reported_apart():
    names = [case.name for case in CASES]
    assert len(set(names)) == len(names) > 130


@pytest.mark.long
def test_nothing_happens_that_must_never_happen(table):
    assert table.faults == []
    assert len(table.rows) > 1400


@pytest.mark.long
def test_what_cannot_be_whole_is_left_broken(table):
    impossible = {c.name for c in CASES if c.feasible is False and c.group == "examples"}
    assert len(impossible) >= 8
    rows = [row for row in table.rows if row.case in impossible]
    assert {row.outcome for row in rows} == {"max_sweeps"}
    assert min(row.max_residual for row in rows) > 1e-3


@pytest.mark.long
def test_forests_are_whole_by_their_own_technique(table):
    groups = ("examples", "offset", "push", "large", "peers")
    known = {case.name for case in CASES if case.feasible and case.group in groups}
    rows = [row for row in table.rows if row.method == "bfs_tree" and row.case in known]
    assert len(rows) > 30
    for row in rows:
        if not row.case.startswith("pinned"):
            assert row.outcome == "converged" and row.sweeps <= 2, row.case


@pytest.mark.long
def test_refusals_say_why(table):
    refused = {row.case: row.note for row in table.rows if row.outcome == "refused"}
    assert set(refused) == {
        "bar_of_0",
        "bar_of_1e-310",
        "bar_of_1e+200",
        "duplicate_bar_conflict_1_2",
    }
    assert all(refused.values())


ONE_BAR = Case("one", "test", lambda: None)
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
    row = Row("one", 1, 0, "blocks", None, "")
    _fill(case, start, row, outcome)
    assert row.violation == violation


def test_the_worst_bar_has_a_name():
    start = broken(np.zeros((3, 3)), [[0, 1], [1, 2]], [1.0, 1.0])
    assert worst(start, np.array([[0, 0, 0], [1, 0, 0], [3.0, 0, 0]])) == (1.0, "1 - 2")


def test_examples_are_those_of_the_library():
    assert [c.name for c in stress_cases.examples()] == [row.name for row in pliant.examples()]


def test_the_command_prints_and_writes(capsys, tmp_path):
    table = tmp_path / "stress.csv"
    words = ["stress", "--only", "diamond", "--technique", "blocks", "--csv", str(table)]
    assert main(words) == 0
    out = capsys.readouterr().out
    assert "openmm_3603_diamond_1e-08" in out and "violations: none" in out
    assert [row["outcome"] for row in csv.DictReader(table.open())] == ["converged"] * 3
    assert main([*words, "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert all(row["outcome"] == "converged" and row["violation"] == "" for row in rows)


def test_no_such_case_is_one_line(capsys):
    assert main(["stress", "--only", "nonsense"]) == 2
    assert capsys.readouterr().err == (
        "pliant lab bench stress: error: --only: no case has 'nonsense' in its name or group\n"
    )


def test_a_violation_ends_with_1(capsys, monkeypatch):
    liar = dataclasses.replace(CASES[0], name="liar", group="liar", feasible=False)
    monkeypatch.setattr(stress_cases, "all_cases", lambda *_: [liar])
    assert main(["stress", "--technique", "blocks"]) == 1
    assert "liar, blocks: said to have converged on what cannot be whole" in capsys.readouterr().out
