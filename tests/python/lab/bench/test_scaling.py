# SPDX-License-Identifier: MIT
"""Time and memory against size, and conformers a second."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from pliant.lab.bench import scaling as sizes
from pliant.lab.bench.command import main
from pliant.lab.bench.large_frameworks import KINDS, snake
from pliant.lab.bench.scaling import SizeRow, slope_of
from pliant.lab.bench.throughput import throughput

import pliant

CAFFEINE = Path(__file__).parents[4] / "data" / "molecules" / "caffeine.sdf"


def test_a_snake_goes_by_unit_steps_and_never_crosses_itself():
    for count in (1, 2, 27, 28, 1000):
        places = snake(count)
        assert np.all(np.linalg.norm(np.diff(places, axis=0), axis=1) == 1)
        assert len(np.unique(places, axis=0)) == count


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("joints", [300, 3000])
def test_large_frameworks_are_what_they_are_called(kind, joints):
    large = KINDS[kind](joints)
    facts = pliant.Framework(large.bars, positions=large.positions).graph_facts()
    assert facts.components == 1
    assert facts.joints == pytest.approx(joints, rel=0.1)
    assert np.abs(large.positions).max() < 8.0 * joints ** (1 / 3) + 20
    if kind == "protein":  # a ring of six in each 60 joints
        assert facts.blocks == facts.cycles == facts.joints // 60
        assert facts.largest_block == 6
    else:
        assert facts.is_forest
    degrees = np.bincount(large.bars.ravel())
    assert degrees.max() == 2 if kind == "chain" else degrees.max() > 2


def test_slopes_and_their_confidence_of_a_known_law():
    rows = [SizeRow("chain", n, seconds=3.0 * n**1.25) for n in (10, 100, 1000)]
    slope = slope_of("chain", rows)
    assert slope.slope == pytest.approx(1.25, rel=1e-12)
    assert slope.confidence < 1e-9
    # By hand: y = 0, 1, 1 over x = 0, 1, 2: slope 1/2; residuals -1/6, 1/3, -1/6; Student 12.706.
    rows = [SizeRow("tree", 10**k, seconds=s) for k, s in enumerate((1.0, 10.0, 10.0))]
    slope = slope_of("tree", rows)
    assert slope.slope == pytest.approx(0.5)
    assert slope.confidence == pytest.approx(12.7062 * math.sqrt(1 / 6 / 2), rel=1e-5)


def test_scaling_measures_and_says_what_it_left_out(monkeypatch):
    found = sizes.scaling((300, 1000), kinds=("protein",), technique="bfs_cycle", repeats=1)
    assert [row.outcome for row in found.rows] == ["converged", "converged"]
    assert all(row.max_residual <= 1e-6 and row.ns_per_bar > 0 for row in found.rows)
    assert all(row.bytes_peak > 0 for row in found.rows)
    monkeypatch.setattr(sizes, "_free_bytes", lambda: 1e6)
    (row,) = sizes.scaling((1e6,), kinds=("chain",)).rows
    assert (row.outcome, row.note) == ("left out", "more memory than is free")


def test_sizes_that_are_not_what_they_say_are_named():
    found = sizes.Scaling("blocks", 0.5, 1e-6)
    found.rows = [SizeRow("chain", 10, outcome="converged", max_residual=r) for r in (1e-6, 2e-6)]
    found.rows += [SizeRow("tree", 20, outcome="failed", note="no memory"), SizeRow("tree", 30)]
    assert found.faults == [
        "chain of 10: counts as whole, but a bar is off by 2.0e-06",
        "tree of 20: failed: no memory",
    ]


def test_the_command_prints_a_table(capsys):
    assert main(["scaling", "--sizes", "100,200,400", "--kinds", "chain", "--repeats", "1"]) == 0
    out = capsys.readouterr().out
    assert "converged" in out and "chain: time grows with the number of joints to the power " in out


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
    assert [row.method for row in found.openmm] == ["ccma", "ccma_dynamics"]
    assert all(row.max_residual < 2e-6 for row in found.openmm)
    ccma = found.openmm[0]
    for row in found.rows:
        assert row.ratio_to_openmm == pytest.approx(ccma.ns_per_bar / row.ns_per_bar)


def test_throughput_says_what_is_wrong():
    found = throughput(
        CAFFEINE, conformers=2, repeats=1, techniques=("blocks",), threads=(1,), openmm=False
    )
    assert found.wrong() == []
    found.rows[0].whole = 1
    found.rows[1].same_bits = False
    assert found.wrong() == [
        "blocks one by one, 1 threads: 1 of 2 whole",
        f"blocks {pliant.lane_levels()[0]}, 1 threads: 2 of 2 whole, with other bits than alone",
    ]


def test_throughput_by_the_command(capsys, tmp_path):
    words = ["throughput", str(CAFFEINE), "--csv", str(tmp_path / "a.csv")]
    words += "--repeats 1 --technique blocks --peers none".split()
    assert main([*words, "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert len(printed["rows"]) == 4
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 5
    assert printed["openmm"] == [] and printed["rows"][0]["ratio_to_openmm"] is None
    assert main(words) == 0
    assert "conformers per second" in capsys.readouterr().out
