# SPDX-License-Identifier: MIT
"""Steps after a push of one joint, in small and in large frameworks."""

import csv
import json

import pytest
from pliant.lab.bench import step as stepping
from pliant.lab.bench.command import main

import pliant


@pytest.mark.long
def test_local_techniques_look_at_as_many_bars_in_any_size():
    found = stepping.steps_of_pushes(
        (1000, 10_000), techniques=("blocks", "bfs_cycle"), steps=200, rounds=2
    )
    assert found.faults == []
    sizes = [(row.technique, row.joints) for row in found.rows]
    assert sizes == [
        ("blocks", 1020),
        ("blocks", 10_020),
        ("bfs_cycle", 1020),
        ("bfs_cycle", 10_020),
    ]
    small, large, all_small, all_large = found.rows
    assert large.projections == pytest.approx(small.projections, rel=0.5)
    assert all_large.projections > 5 * all_small.projections > 100 * small.projections
    for row in found.rows:
        assert row.max_residual <= 1e-6 and row.unconverged == 0
        assert 0 < row.quarter <= row.step_microseconds <= row.three_quarters
        assert row.ratio_least <= row.ratio <= row.ratio_most
    assert small.ratio == all_small.ratio == 1


def test_broken_ends_are_named(monkeypatch):
    monkeypatch.setattr(stepping._bars, "worst_residual", lambda *_: 1e-3)
    found = stepping.steps_of_pushes((100,), techniques=("blocks",), steps=2, rounds=1)
    assert found.faults == ["protein of 120, blocks: a bar is off by 1.0e-03 in the end"]


def test_unknown_kinds_are_refused():
    with pytest.raises(pliant.OptionError, match='no kind named "sheet"; known: chain'):
        stepping.steps_of_pushes(kinds=("sheet",))


def test_the_command_prints_a_table_and_writes_csv(capsys, tmp_path, monkeypatch):
    table = tmp_path / "rows.csv"
    words = ["step", "--sizes", "100,200", "--kinds", "chain", "--steps", "5", "--repeats", "1"]
    assert main([*words, "--csv", str(table)]) == 0
    assert "us a step" in capsys.readouterr().out
    assert [row["joints"] for row in csv.DictReader(table.open())] == ["100", "200"] * 2
    monkeypatch.setattr(stepping._bars, "worst_residual", lambda *_: 1.0)
    assert main([*words, "--json"]) == 1
    assert len(json.loads(capsys.readouterr().out)["rows"]) == 4
