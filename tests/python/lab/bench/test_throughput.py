# SPDX-License-Identifier: MIT
"""Conformers a second, what a frame of `pliant sample` costs; what is broken is named."""

import json
import math

import numpy as np
import pytest
from pliant.lab.bench import frames as costs
from pliant.lab.bench import scaling as jobs
from pliant.lab.bench.command import main
from pliant.lab.bench.throughput import throughput

import pliant

CAFFEINE, PEPTIDE = "data/molecules/caffeine.sdf", "data/molecules/peptide_20.pdb"


@pytest.fixture
def clock(monkeypatch):
    """A clock on which a start takes 5 ms and each frame 2 ms, whatever else the machine does."""
    now, sample = [0.0], pliant.sample

    def timed(model, frames, **options):
        now[0] += 5e-3 + 2e-3 * frames
        return sample(model, frames, **options)

    monkeypatch.setattr(pliant, "sample", timed)
    monkeypatch.setattr(costs.time, "process_time", lambda: now[0])


def test_frames_with_polar_and_all_hydrogens(clock):
    found = costs.frame_costs([PEPTIDE, "data/molecules/benzene.sdf"], frames=4, rounds=2)
    polar, whole, *refused = found.rows
    assert (polar.hydrogens, whole.hydrogens) == ("polar", "all")
    assert polar.atoms < whole.atoms == 327
    for row in (polar, whole):
        assert [row.quarter, row.milliseconds, row.three_quarters] == pytest.approx([2.0] * 3)
        assert row.milliseconds_before == pytest.approx(7.0)
        assert row.frames == 4 and row.failed == 0
        assert 0 <= row.max_residual <= 1e-9
        assert row.max_limit <= 0.08 and row.max_overlap <= 0.08
    assert [row.refused for row in refused] == [
        "data/molecules/benzene.sdf: no residue has N, CA and C"
    ] * 2
    assert found.faults == [] and math.isnan(found.slopes["polar"])


def test_the_slope_is_that_of_the_logarithms():
    rows = [
        costs.FrameRow("a", "all", atoms=n, milliseconds=2e-3 * n**1.5) for n in (100, 200, 900)
    ]
    other = costs.FrameRow("a", "polar", atoms=100, milliseconds=5.0)
    assert costs.slope([*rows, other], "all") == pytest.approx(1.5)
    assert math.isnan(costs.slope([*rows, other], "polar"))


def test_broken_frames_are_named(monkeypatch):
    class Broken:
        """Frames whose last atom is 3 Angstrom away."""

        redrawn = failed = 0

        def __init__(self, model, frames, **_):
            x = np.array(model.positions)
            x[-1] += 3.0
            self.positions = np.stack([x] * frames)

    monkeypatch.setattr(pliant, "sample", Broken)
    found = costs.frame_costs([PEPTIDE], frames=2, rounds=1)
    assert found.faults and found.faults[0].startswith("peptide_20.pdb, polar: a bar is off by ")


def test_wrong_options_are_refused():
    with pytest.raises(pliant.OptionError, match="sampler none: must be one of"):
        costs.frame_costs([PEPTIDE], sampler="none")


def test_the_command(capsys):
    words = ["throughput", PEPTIDE, "--frames", "3", "--repeats", "1"]
    assert main([*words, "--json", "--quiet"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["sampler"] == "modes"
    assert [row["hydrogens"] for row in found["rows"]] == ["polar", "all"]
    assert main([*words, "--quiet"]) == 0
    assert "ms a frame" in capsys.readouterr().out
    assert main(["throughput", PEPTIDE, PEPTIDE]) == 2
    assert "several files need --frames" in capsys.readouterr().err


def test_throughput_is_whole_and_the_same_in_lanes_and_on_two_threads():
    found = throughput(CAFFEINE, conformers=5, repeats=1, techniques=("blocks", "random"))
    best = pliant.lane_levels()[0]
    assert [(row.technique, row.lanes, row.threads) for row in found.rows] == [
        ("blocks", "", 1),
        ("blocks", "", 2),
        ("blocks", best, 1),
        ("blocks", best, 2),
        ("random", "", 1),
        ("random", "", 2),
    ]
    assert all(row.same_bits and row.whole == row.conformers for row in found.rows)
    assert [row.conformers for row in found.rows] == [5, 10] * 3


def test_throughput_says_what_is_wrong():
    found = throughput(CAFFEINE, conformers=2, repeats=1, techniques=("blocks",), threads=(1,))
    assert found.faults == []
    found.rows[0].whole = 1
    found.rows[1].same_bits = False
    assert found.faults == [
        "blocks one by one, 1 threads: 1 of 2 whole",
        f"blocks {pliant.lane_levels()[0]}, 1 threads: 2 of 2 whole, with other bits than alone",
    ]


def test_throughput_by_the_command(capsys, tmp_path):
    words = ["throughput", CAFFEINE, "--csv", str(tmp_path / "a.csv")]
    words += "--repeats 1 --technique blocks".split()
    assert main([*words, "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert len(printed["rows"]) == 4
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 5
    assert main(words) == 0
    assert "conformers per second" in capsys.readouterr().out


def test_whole_jobs_on_several_threads():
    files = [PEPTIDE, "data/molecules/butane.sdf"]
    found = jobs.scaling(files, threads=(2, 1), frames=4, steps=2)
    names = [(row.job, row.input, row.threads) for row in found.rows]
    assert names == [
        *((job, "peptide_20.pdb", n) for job in jobs.PROTEIN_JOBS for n in (1, 2)),
        *(("conformers", "butane.sdf", n) for n in (1, 2)),
    ]
    assert found.faults == [] and all(row.digest for row in found.rows)
    assert len({row.digest for row in found.rows}) == 3, "the first frames of reach are of modes"
    for row in found.rows:
        assert 0 < row.seconds < math.inf and row.cpu_seconds > 0
        assert row.efficiency == pytest.approx(row.faster / row.threads)


def test_jobs_with_other_bits_are_named(capsys):
    rows = [jobs.ScalingRow("frames", "a.pdb", 2, same_bits=False)]
    found = jobs.Scaling(16, rows)
    assert found.faults == ["frames of a.pdb, 2 threads: other bits than on fewer"]
    found.print_report()
    assert "wrong: frames of a.pdb" in capsys.readouterr().out


def test_a_job_that_fails_says_why():
    with pytest.raises(pliant.InputError, match=r"frames of modes of none\.pdb: .*cannot read"):
        jobs.scaling(["none.pdb"])
