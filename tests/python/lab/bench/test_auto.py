# SPDX-License-Identifier: MIT
"""auto beside every fixed technique: who takes part, what counts as whole, what is a fault."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
from pliant.lab.bench import auto as choosing
from pliant.lab.bench.command import main
from pliant.lab.bench.target import read_target, target_of

import pliant

MOLECULES = Path(__file__).parents[4] / "data" / "molecules"
BENZENE = MOLECULES / "benzene.sdf"


def test_every_molecule_of_the_sources_is_taken_by_default():
    assert choosing.molecules() == sorted(MOLECULES.iterdir())


def test_all_techniques_that_take_the_bars_take_part_with_every_weighting():
    ring = read_target(BENZENE)
    labels = [entry.label for entry in choosing.entries_for(ring, 1e-6)]
    assert labels[0] == "auto"
    expected = [(row.name, row.has_weighting) for row in pliant.techniques()
                if not row.forests_only and row.name != "auto"]  # fmt: skip
    assert len(labels) == 1 + sum(3 if weighted else 1 for _, weighted in expected)
    assert {"bfs_cycle 0.5", "bfs_cycle 0.75", "bfs_cycle 1", "blocks"} <= set(labels)
    tree = [entry.label for entry in choosing.entries_for(read_target(MOLECULES / "butane.sdf"), 1)]
    assert "bfs_tree 1" in tree and "bfs_tree 1" not in labels


def test_rows_name_the_quickest_whole_technique():
    with pytest.warns(pliant.PliantWarning, match="goes from bar to bar"):
        found = choosing.auto([BENZENE], copies=2, rounds=2)
    fixed = len(choosing.entries_for(read_target(BENZENE), 1e-6)) - 1
    assert [(r.bars_of, r.tolerance) for r in found.rows] == [
        ("bonds", 1e-6), ("bonds", 1e-10), ("angles", 1e-6), ("angles", 1e-10)]  # fmt: skip
    assert found.faults == []
    assert [r.chosen for r in found.rows] == ["blocks", "blocks", "units", "units"]
    for row in found.rows:
        assert row.ratio == pytest.approx(row.auto_microseconds / row.best_microseconds)
        assert row.runners[0].startswith(row.best + " ")
        assert row.bars == (12 if row.bars_of == "bonds" else 30)
        assert 0 < row.whole <= row.fixed == fixed
    # Planar centres are rigid to second order only: sweeps crawl there.
    assert found.rows[3].whole < found.rows[1].whole


def test_a_framework_that_cannot_be_whole_has_no_best():
    flat = pliant.Framework([[0, 1], [1, 2], [0, 2]], [1.0, 1.0, 3.0])
    target = target_of(flat, np.eye(3), np.ones(3), "impossible")
    row = choosing._one(target, "bonds", 1e-6, np.eye(3)[None], 1)
    assert (row.whole, row.best, row.faults) == (0, "", [])
    assert math.isnan(row.ratio)


def test_who_says_converged_beyond_the_tolerance_is_named(monkeypatch):
    monkeypatch.setattr(choosing.Target, "residual", lambda *_: 2e-6)
    found = choosing.auto([BENZENE], bars=("bonds",), tolerances=(1e-6,), copies=1, rounds=1)
    assert "auto says converged, but a bar is off by 2.0e-06" in found.rows[0].faults


def test_the_command_prints_a_table_and_writes_csv(capsys, tmp_path, monkeypatch):
    table = tmp_path / "auto.csv"
    words = ["auto", str(BENZENE), "--bars", "bonds", "--copies", "1", "--rounds", "1"]
    assert main([*words, "--csv", str(table)]) == 0
    out = capsys.readouterr().out
    assert "benzene.sdf, bonds" in out and "worst: " in out
    assert [row["chosen"] for row in csv.DictReader(table.open())] == ["blocks", "blocks"]
    whole = property(lambda entry: entry.is_fixed, lambda *_: None)
    monkeypatch.setattr(choosing.Entry, "whole", whole, raising=False)
    assert main([*words, "--json"]) == 1
    (fault, *_) = json.loads(capsys.readouterr().out)["rows"][0]["faults"]
    assert fault.startswith("auto leaves a bar broken")
