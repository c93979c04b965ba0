# SPDX-License-Identifier: MIT
"""pliant sample --around: frames that open or close one place."""

import json
from pathlib import Path

import h5py
import numpy as np
import pytest
from real_files import PEPTIDE

PLACE = "resid 30-67 or resid 118-160"  # of adenylate kinase: AMP site and lid


def positions(path: Path) -> np.ndarray:
    with h5py.File(path) as file:
        return file["particles/trajectory/position/value"][:]


def test_it_says_what_the_place_is_and_goes_on(pliant, tmp_path):
    arguments = ("sample", PEPTIDE, "--around", "resid 5-9", "--amplitude", 0.4, "--json")
    ended = pliant(*arguments, "-o", "whole.h5md", "--frames", 8)
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    assert report["sampler"] == "pocket"
    assert report["pocket"] == ["A:THR5", "A:ALA6", "A:TRP7", "A:LEU8", "A:VAL9"]
    assert pliant(*arguments, "-o", "part.h5md", "--frames", 3).code == 0
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 8)
    assert ended.code == 0, ended.err
    assert "pocket          5 residues: A:THR5" in ended.out
    np.testing.assert_array_equal(
        positions(tmp_path / "part.h5md"), positions(tmp_path / "whole.h5md")
    )
    with h5py.File(tmp_path / "whole.h5md") as file:
        drawn_by = file["observables/sampler/value"][:]
    assert set(drawn_by) == {5}


@pytest.mark.long
def test_the_place_comes_nearer_to_a_known_state_than_by_modes(pliant, tmp_path):
    """Adenylate kinase, all atoms, closed to open: the mean distance of backbone atoms of the place
    with all else superposed."""
    files = pytest.importorskip("MDAnalysisTests.datafiles")
    mda = pytest.importorskip("MDAnalysis")
    from MDAnalysis.analysis.align import rotation_matrix

    closed = mda.Universe(files.PDB_closed).select_atoms("backbone")
    goal = mda.Universe(files.PDB_small).select_atoms("backbone").positions.astype(float)
    is_place = np.isin(
        np.arange(closed.n_atoms),
        np.flatnonzero([atom.resid in {*range(30, 68), *range(118, 161)} for atom in closed]),
    )
    nearest = {}
    for name, more in {"modes": ("--sampler", "modes"), "pocket": ("--around", PLACE)}.items():
        path = tmp_path / f"{name}.h5md"
        ended = pliant("sample", files.PDB_closed, "-o", path, "--frames", 60, "--json", *more)
        assert ended.code == 0, ended.err
        report = json.loads(ended.out)
        assert report["worst_residual"] < 1e-12
        assert report["worst_overlap"] < 0.1
        assert (report["let_go_mean"] > 1) == (name == "pocket")
        away = []
        for frame in positions(path)[:, closed.ix]:
            middles = frame[~is_place].mean(0), goal[~is_place].mean(0)
            turn, _ = rotation_matrix(frame[~is_place] - middles[0], goal[~is_place] - middles[1])
            fitted = (frame[is_place] - middles[0]) @ turn.T
            away.append(np.linalg.norm(fitted + middles[1] - goal[is_place], axis=1).mean())
        nearest[name] = min(away)
    assert nearest["pocket"] < nearest["modes"]
