# SPDX-License-Identifier: MIT
"""Frames that were spoilt in one known way are found to be."""

import numpy as np
import pytest
from expected_warnings import read_without_elements

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
pytest.importorskip("scipy")

from pliant.lab.structures import amino_part  # noqa: E402
from pliant.lab.validity.clashes import HeavyClashes  # noqa: E402
from pliant.lab.validity.stereochemistry import Checker  # noqa: E402
from pliant.measure.geometry import torsions_of  # noqa: E402
from scipy.spatial.transform import Rotation  # noqa: E402


@pytest.fixture(scope="module")
def model():
    """The first ten residues of adenylate kinase and more, with all hydrogens."""
    return pliant.build_model(amino_part(read_without_elements(MDA.PDB_small)))


@pytest.fixture(scope="module")
def start(model):
    return np.array(model.positions)


def looked(model, *frames):
    return Checker(model).look(np.array(frames))


def atom(model, residue, name):
    structure = model.structure
    return int(np.flatnonzero((structure.residue_ids == residue) & (structure.names == name))[0])


def test_the_start_itself_is_in_order(model, start):
    found = looked(model, start, start @ np.diag([-1.0, -1.0, 1.0]))  # a turn about z
    assert found.worst_bar < 1e-12
    assert (found.overlaps, found.flipped, found.turned) == (0, 0, 0)
    assert found.outliers == pytest.approx(found.outliers_of_start)
    assert found.residues > 150


def test_clashes_are_those_of_the_start_plus_one_made(model, start):
    structure = model.structure
    clashes = HeavyClashes(structure)
    before = clashes.pairs(start)
    spoilt = start.copy()
    carbon, oxygen = atom(model, 20, "C"), atom(model, 100, "O")
    far = start.max(axis=0) + 50.0
    spoilt[carbon], spoilt[oxygen] = far, far + np.array([2.81, 0.0, 0.0])
    made = {tuple(pair) for pair in clashes.pairs(spoilt)} - {tuple(pair) for pair in before}
    assert made == {(min(carbon, oxygen), max(carbon, oxygen))}
    spoilt[oxygen] = far + np.array([2.83, 0.0, 0.0])  # 1.70 + 1.52 - 2.83 = 0.39
    assert (carbon, oxygen) not in {tuple(pair) for pair in clashes.pairs(spoilt)}
    found = looked(model, start)
    assert found.clashes == found.clashes_of_start == clashes.score(start)


def test_what_may_form_a_hydrogen_bond_does_not_clash(model, start):
    clashes = HeavyClashes(model.structure)
    spoilt = start.copy()
    nitrogen, oxygen, other = atom(model, 20, "N"), atom(model, 100, "O"), atom(model, 60, "O")
    far = start.max(axis=0) + 50.0
    spoilt[[nitrogen, oxygen, other]] = far + np.array([[0, 0, 0], [2.5, 0, 0], [4.9, 0, 0]])
    near = [pair for pair in clashes.pairs(spoilt).tolist() if oxygen in pair]
    assert near == [sorted((oxygen, other))]  # 2.4 apart, and neither has a hydrogen


def test_a_mirror_image_flips_every_centre_and_breaks_no_bar(model, start):
    found = looked(model, start * [1.0, 1.0, -1.0])
    assert found.worst_bar < 1e-12
    alphas = (model.structure.names == "CA") & (model.structure.residue_names != "GLY")
    assert found.flipped >= alphas.sum()
    assert found.outliers > 0.15  # many lie where left-handed helices do


def test_an_atom_put_upon_another_is_one_overlap_and_breaks_its_bars(model, start):
    spoilt = start.copy()
    one, other = atom(model, 20, "O"), atom(model, 100, "O")
    spoilt[one] = spoilt[other] + [0.0, 0.0, 2.3]
    found = looked(model, spoilt)
    assert found.overlaps >= 1
    assert found.worst_overlap >= 0.3 - 1e-9
    assert found.worst_bar > 0.1


def test_overlaps_begin_at_a_tenth_of_an_angstrom():
    """Two carbons of 3.2 Angstrom at least, far from bonds."""
    structure = pliant.Structure(
        [[0, 0, 0], [1.5, 0, 0], [9, 0, 0], [10.5, 0, 0]],
        elements=[6] * 4,
        names=["C1", "C2", "C3", "C4"],
        residue_names=["LIG"] * 4,
        residue_ids=[1] * 4,
        chains=["A"] * 4,
        bonds=[[0, 1], [2, 3]],
    )
    model = pliant.build_model(structure, "molecule")
    for distance, count in ((3.2, 0), (3.11, 0), (3.09, 1)):
        frame = np.array(structure.positions)
        frame[2:, 0] += 1.5 + distance - 9
        found = looked(model, frame)
        assert found.overlaps == count
        assert found.worst_overlap == pytest.approx(3.2 - distance)


@pytest.mark.long
def test_a_turned_peptide_is_found_by_its_angle(model, start):
    """All after a peptide bond turned about it by 6 degrees: omega alone changes."""
    c, n = atom(model, 50, "C"), atom(model, 51, "N")
    axis = (start[n] - start[c]) / np.linalg.norm(start[n] - start[c])
    after = model.structure.residue_ids > 50
    for degrees, count in ((4.0, 0), (6.0, 1)):
        spoilt = start.copy()
        turn = np.radians(degrees)
        arm = start[after] - start[n]
        spoilt[after] = start[n] + (
            arm * np.cos(turn)
            + np.cross(axis, arm) * np.sin(turn)
            + np.outer(arm @ axis, axis) * (1 - np.cos(turn))
        )
        found = looked(model, spoilt)
        assert found.turned == count
        assert found.worst_turn == pytest.approx(degrees)


def test_ramachandran_angles_are_those_of_mdanalysis(model):
    mda = pytest.importorskip("MDAnalysis")
    ramachandran = pytest.importorskip("MDAnalysis.analysis.dihedrals").Ramachandran
    universe = mda.Universe(MDA.PDB_small)
    protein = universe.select_atoms("protein and not resname GLY PRO")
    inner = universe.residues[1:-1].atoms & protein
    angles = ramachandran(inner).run().results.angles[0]
    checker = Checker(model)
    rows = checker._phi_psi
    phi, psi = (torsions_of(np.array(model.positions), rows[:, k : k + 4]) for k in (0, 1))
    np.testing.assert_allclose(np.stack([phi, psi], axis=1), angles, atol=1e-3)


def test_a_side_chain_over_its_own_backbone_is_unusual(model, start):
    """Leucine 35 with chi1 of 0: N and gamma eclipse each other."""
    names = ("N", "CA", "CB", "CG")
    chi1 = np.array([[atom(model, 35, name) for name in names]])
    structure = model.structure
    is_side = ~np.isin(structure.names, ("N", "HN", "CA", "HA", "CB", "C", "O"))
    side = np.flatnonzero((structure.residue_ids == 35) & is_side)
    alpha, beta = start[chi1[0, 1:3]]
    axis = (beta - alpha) / np.linalg.norm(beta - alpha)
    angle = -np.radians(torsions_of(start, chi1)[0])
    turned = start.copy()
    turned[side] = beta + Rotation.from_rotvec(angle * axis).apply(start[side] - beta)
    assert torsions_of(turned, chi1)[0] == pytest.approx(0.0, abs=1e-6)
    found = looked(model, turned)
    assert 80 < 1 / (found.rotamers - found.rotamers_of_start) < 170  # side chains with chi2
