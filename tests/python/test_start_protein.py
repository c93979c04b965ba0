# SPDX-License-Identifier: MIT
"""The protein with which the page begins is a protein: helices, bonds, nothing too near."""

import bond_tool
import numpy as np
import pytest

FILE = bond_tool.ROOT / "data" / "proteins" / "three_helices.pdb"


def test_three_whole_helices_by_dssp():
    mda = pytest.importorskip("MDAnalysis")
    dssp = pytest.importorskip("MDAnalysis.analysis.dssp")
    found = "".join(dssp.DSSP(mda.Universe(str(FILE))).run().results.dssp[0])
    assert [len(part) for part in found.split("-") if part] == [14, 14, 15]


def test_bonds_are_whole_and_nothing_is_too_near():
    radii = {"H": 0.31, "C": 0.76, "N": 0.71, "O": 0.66}
    lines = [line for line in FILE.read_text().splitlines() if line.startswith("ATOM")]
    points = np.array([[float(line[k : k + 8]) for k in (30, 38, 46)] for line in lines])
    reach = np.array([radii[line[76:78].strip()] for line in lines])
    sums = reach[:, None] + reach
    far = np.linalg.norm(points[:, None] - points[None], axis=2)
    same = np.eye(len(lines), dtype=bool)
    bonded = (far < 1.25 * sums) & ~same
    assert len(lines) == 901
    assert bonded.sum() // 2 == 906  # a tree has 900; and 2 prolines, PHE, TYR, TRP twice
    assert np.abs((far / sums)[bonded] - 0.95).max() < 0.1
    near = bonded.astype(int) @ bonded.astype(int) > 0
    assert far[~(near | bonded | same)].min() > 1.9
