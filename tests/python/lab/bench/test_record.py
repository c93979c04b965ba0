# SPDX-License-Identifier: MIT
"""What recording costs, and that files which are not what the run said are found out."""

import csv
import json
from pathlib import Path
from types import SimpleNamespace

import h5py
import numpy as np
import pytest
from pliant.lab.bench import record as recording
from pliant.lab.bench.command import main

import pliant

CAFFEINE = Path(__file__).parents[4] / "data" / "molecules" / "caffeine.sdf"


def test_shares_and_rates_are_those_of_the_runs():
    found = recording.record(CAFFEINE, steps=30, repeats=2)
    assert [(r.perturb, r.technique) for r in found.rows] == [
        (p, t) for p in recording.PERTURBATIONS for t in recording.TECHNIQUES]  # fmt: skip
    assert found.faults == []
    for row in found.rows:
        assert row.frames == 31
        assert 0 < row.share_least <= row.share <= row.share_most < 1
        assert row.file_megabytes > 31 * 24 * 3 * 8 / 1e6
        assert row.record_microseconds > 0 and row.megabytes_per_second > 0


def test_rates_follow_from_times_and_sizes():
    rounds = [
        recording._Round(SimpleNamespace(
            frames=4, steps=3, seconds=2.0, perturb_seconds=0.3, resolve_seconds=0.6,
            observe_seconds=observed), 1_000_000, 0.25)
        for observed in (0.5, 1.0, 0.8)
    ]  # fmt: skip
    row = recording.RecordRow("force", "auto")
    recording._fill(row, rounds)
    assert (row.share_least, row.share, row.share_most) == (0.25, 0.4, 0.5)
    assert row.step_microseconds == pytest.approx(0.9e6 / 3)
    assert row.record_microseconds == pytest.approx(0.8e6 / 4)
    assert row.megabytes_per_second == pytest.approx(1 / 0.8)
    assert row.over_plain == pytest.approx(0.8 / 0.25)


def test_single_precision_takes_half_of_the_bytes():
    double, single = (
        recording.record(CAFFEINE, perturbations=("force",), techniques=("auto",), steps=2000,
                         repeats=1, single=s) for s in (False, True))  # fmt: skip
    assert double.faults == single.faults == []
    saved = double.rows[0].file_megabytes - single.rows[0].file_megabytes
    assert saved == pytest.approx(2001 * 24 * 3 * 4 / 1e6, rel=0.1)


@pytest.fixture
def recorded(tmp_path):
    structure = pliant.read(CAFFEINE)
    framework = structure.framework("bonds")
    path = tmp_path / "run.h5md"
    summary = pliant.run(framework, pliant.State(structure.positions), path,
                         structure=structure, steps=5, perturb="displacement")  # fmt: skip
    return path, summary, framework, {"tolerance": 1e-6}


def test_a_file_as_the_run_left_it_has_no_fault(recorded):
    assert recording.faults_of(*recorded) == []


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda p: p["value"].resize(5, axis=0) or p["step"].resize(5, axis=0), "5 frames for 5"),
        (lambda p: p["value"].write_direct(np.zeros((24, 3)), dest_sel=np.s_[5]), "last frame"),
        (lambda p: p["value"].write_direct(np.eye(24, 3), dest_sel=np.s_[2]), "step 2 counts"),
    ],
)
def test_a_spoilt_file_is_found_out(recorded, spoil, said):
    with h5py.File(recorded[0], "r+") as file:
        spoil(file["particles/trajectory/position"])
    assert any(said in fault for fault in recording.faults_of(*recorded))


def test_the_command_prints_a_table_and_writes_csv(capsys, tmp_path, monkeypatch):
    table = tmp_path / "rows.csv"
    words = ["record", str(CAFFEINE), "--steps", "5", "--repeats", "1", "--perturb", "force"]
    assert main([*words, "--csv", str(table), "--folder", str(tmp_path)]) == 0
    assert "share of the run" in capsys.readouterr().out
    assert [row["technique"] for row in csv.DictReader(table.open())] == ["auto", "bfs_cycle"]
    assert list(tmp_path.iterdir()) == [table], "files are removed again"
    monkeypatch.setattr(recording, "faults_of", lambda *_: ["is spoilt"])
    assert main([*words, "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["rows"][0]["faults"] == ["is spoilt"]
