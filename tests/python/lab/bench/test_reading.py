# SPDX-License-Identifier: MIT
"""What MDAnalysis takes to read a frame; other positions than DCD's are named."""

import json

import pytest
from pliant.lab.bench import reading as bench
from pliant.lab.bench.command import main
from pliant.trajectory.h5md import FramesOfH5md

CAFFEINE, PEPTIDE = "data/molecules/caffeine.sdf", "data/molecules/peptide_20.pdb"


@pytest.fixture
def clock(monkeypatch):
    """A clock on which reading takes 3 ms of our files, and 2 ms of all others."""
    seconds = {"PLIANT": 3e-3, "DCD": 2e-3}
    monkeypatch.setattr(bench, "_seconds", lambda trajectory, _: seconds[trajectory.format])


def test_a_row_for_each_molecule_and_way(clock):
    found = bench.reading([CAFFEINE, PEPTIDE], frames=10, repeats=2)
    assert [(row.atoms, row.frames, row.way) for row in found.rows] == [
        (24, 10, "all"),
        (24, 4, "every third"),
        (327, 10, "all"),
        (327, 4, "every third"),
    ]
    for row in found.rows:
        assert row.microseconds == pytest.approx(3000 / row.frames)
        assert row.ratio == pytest.approx(1.5)
    assert found.faults == []


def test_other_positions_are_a_fault(monkeypatch, capsys):
    read = FramesOfH5md.read
    monkeypatch.setattr(FramesOfH5md, "read", lambda self, frames: read(self, frames) + 1e-3)
    words = ["reading", CAFFEINE, "--frames", "4", "--repeats", "1"]
    assert main(words) == 1
    assert "caffeine.sdf, every third: other positions than DCD\n" in capsys.readouterr().out


def test_by_the_command(capsys):
    words = ["reading", CAFFEINE, "--frames", "4", "--repeats", "1"]
    assert main([*words, "--json"]) == 0
    assert [row["same"] for row in json.loads(capsys.readouterr().out)["rows"]] == [True, True]
    assert main(words) == 0
    assert "of DCD" in capsys.readouterr().out
