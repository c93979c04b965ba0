# SPDX-License-Identifier: MIT
"""Domains of known pairs, how assignments agree, and ``pliant lab bench domains``."""

import csv
import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

MDA = pytest.importorskip("MDAnalysisTests.datafiles")

from pliant.lab.bench.command import main  # noqa: E402
from pliant.lab.pairs.agreement import agreement, contradicted, found  # noqa: E402
from pliant.lab.pairs.pair_domains import pair_domains, ratio  # noqa: E402


def backbones():
    """(R, 3, 3) N, CA and C of adenylate kinase, closed and open."""
    import MDAnalysis

    universe = MDAnalysis.Universe(MDA.PSF, MDA.DCD)
    atoms = universe.select_atoms("protein and name N CA C")
    made = []
    for frame in (0, -1):
        universe.trajectory[frame]
        made.append(atoms.positions.astype(float).reshape(-1, 3, 3))
    return made


def test_the_kinase_has_core_lid_and_nmp_whichever_is_the_start():
    closed, open_ = backbones()
    numbers = np.arange(1, 215)
    for start, end in ((closed, open_), (open_, closed)):
        known = pair_domains(start, end, numbers)
        core, lid, nmp = (set(known[a:b].tolist()) for a, b in ((10, 25), (122, 154), (34, 56)))
        assert known.max() == 2 and core == {0} and {*lid, *nmp} == {1, 2} and len(lid) == 1


def test_what_does_not_turn_is_one_piece():
    closed, _ = backbones()
    turned = Rotation.from_euler("x", 70, degrees=True).apply(closed.reshape(-1, 3))
    moved = turned.reshape(closed.shape) + np.random.default_rng(1).normal(0, 0.1, closed.shape)
    assert set(pair_domains(closed, moved, np.arange(214)).tolist()) == {0}


def test_the_ratio_is_large_for_rigid_halves_and_small_for_what_bends():
    random = np.random.default_rng(2)
    start = 10 * random.standard_normal((60, 3, 3))
    first, second = np.arange(30), np.arange(30, 60)
    end = start.copy()
    end[second] = (
        Rotation.from_euler("z", 40, degrees=True)
        .apply(start[second].reshape(-1, 3))
        .reshape(30, 3, 3)
    )
    assert ratio(start, end, first, second) > 1e4
    assert ratio(start, start + random.normal(0, 1, start.shape), first, second) < 0.5


def test_assignments_agree_by_pairs_of_residues():
    known = np.array([0, 0, 0, 0, 1, 1, 1, -1])
    assert agreement(np.array([1, 1, 1, 1, 0, 0, 0, -1]), known) == 1.0
    assert agreement(np.array([0, 0, 1, 1, 2, 2, 2, 2]), known) == pytest.approx(17 / 21)
    assert np.isnan(agreement(np.full(8, -1), known))
    assert found(np.array([0, 0, -1, -1, 1, -1, -1, -1]), known).tolist() == [True, False]
    assert found(np.full(8, -1), known).tolist() == [False, False]


def test_contradictions_are_pairs_together_here_and_apart_there():
    one = np.array([0, 0, 1, 1, -1])
    assert contradicted([one, one, np.full(5, -1)]) == 0
    assert contradicted([one, np.array([1, 1, 0, 0, 0])]) == 0, "labels have no meaning"
    assert contradicted([one, np.zeros(5, dtype=int)]) == 4
    assert contradicted([one, np.array([0, -1, 1, 0, 0])]) == 2


@pytest.mark.long
def test_the_command_measures_a_pair_and_a_structure_alone(tmp_path, capsys):
    import MDAnalysis

    universe = MDAnalysis.Universe(MDA.PSF, MDA.DCD)
    atoms = universe.select_atoms("protein and name N CA C O")
    (tmp_path / "kinase").mkdir()
    for name, frame in (("closed", 0), ("open", -1)):
        universe.trajectory[frame]
        atoms.write(tmp_path / "kinase" / f"{name}.pdb")
    table = tmp_path / "domains.csv"
    words = ["domains", "--data", str(tmp_path), "--repeats", "2", "--frames", "120"]
    words += ["--also", str(tmp_path / "kinase" / "open.pdb"), "--csv", str(table)]
    assert main([*words, "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["structure"] for row in rows] == ["closed", "open", "open"]
    assert [row["pair"] for row in rows] == [3, 3, None]
    assert all(row["contradicted"] == 0 for row in rows)
    opened = rows[1]
    assert min(opened["numbers"]) >= 2 and opened["numbers"] == rows[2]["numbers"]
    assert opened["found"].count(2) >= 2, "60 frames may leave the third undecided"
    assert opened["worst"] >= 0.8
    with open(table, newline="") as file:
        assert [row["numbers"] for row in csv.DictReader(file)][1].count(";") == 1
