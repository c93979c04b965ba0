# SPDX-License-Identifier: MIT
"""Rotatable bonds and torsion angles, against MDAnalysis and angles that were set."""

import MDAnalysis
import numpy as np
import pliant.mdanalysis  # noqa: F401
import pytest
from MDAnalysisTests.datafiles import DCD, PSF
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.torsions import circular_moments

from pliant.measure import TorsionDistributions, rotatable_torsions


def molecule(elements, bonds, names=None):
    universe = MDAnalysis.Universe.empty(len(elements), trajectory=True)
    universe.add_TopologyAttr("elements", list(elements))
    universe.add_TopologyAttr("names", names or [f"{e}{k}" for k, e in enumerate(elements)])
    universe.add_TopologyAttr(
        "masses", [{"H": 1.0, "C": 12.0, "N": 14.0, "O": 16.0}[e] for e in elements]
    )
    universe.add_TopologyAttr("bonds", bonds)
    return universe


def middles(torsions):
    return {tuple(sorted(t.atoms[1:3])) for t in torsions}


def test_butane_has_one_rotatable_bond():
    butane = molecule("CCCC", [(0, 1), (1, 2), (2, 3)])
    (torsion,) = rotatable_torsions(butane.atoms)
    assert torsion.atoms == (0, 1, 2, 3)
    assert torsion.label == "C0-C1-C2-C3"


def test_methyl_groups_turn_only_if_hydrogens_count():
    ethane = molecule(
        "CC" + "H" * 6, [(0, 1)] + [(0, k) for k in (2, 3, 4)] + [(1, k) for k in (5, 6, 7)]
    )
    assert rotatable_torsions(ethane.atoms) == []
    (torsion,) = rotatable_torsions(ethane.atoms, heavy_only=False)
    assert torsion.atoms == (2, 0, 1, 5)


def test_a_ring_is_rigid_but_what_hangs_on_it_turns():
    ring = [(k, (k + 1) % 6) for k in range(6)]
    other = [(6 + k, 6 + (k + 1) % 6) for k in range(6)]
    biphenyl = molecule("C" * 12, [*ring, *other, (0, 6)])
    assert middles(rotatable_torsions(biphenyl.atoms)) == {(0, 6)}
    toluene = molecule("C" * 7, [*ring, (0, 6)])
    assert rotatable_torsions(toluene.atoms) == []


def test_the_outer_atoms_are_the_heaviest_then_the_first():
    #  C0(C4)(O5)-C1-C2(C3)(N6)
    branched = molecule("CCCCCON", [(0, 1), (1, 2), (2, 3), (0, 4), (0, 5), (2, 6)])
    assert {t.atoms for t in rotatable_torsions(branched.atoms)} == {(5, 0, 1, 2), (0, 1, 2, 6)}


def test_bonds_that_occur_twice_count_once():
    butane = molecule("CCCC", [(0, 1), (1, 2), (2, 3)])
    twice = [(0, 1), (1, 2), (2, 1), (2, 3), (1, 2)]
    assert middles(rotatable_torsions(butane.atoms, bonds=twice)) == {(1, 2)}


def test_without_bonds_there_is_one_clear_message():
    universe = MDAnalysis.Universe.empty(4, trajectory=True)
    with pytest.raises(ValueError, match="there are no bonds: give bonds, or a topology that has"):
        rotatable_torsions(universe.atoms)


@pytest.fixture(scope="module")
def adk():
    return MDAnalysis.Universe(PSF, DCD)


def test_hydrogens_by_mass_where_the_topology_has_no_elements(adk):
    assert not hasattr(adk.atoms, "elements")
    np.testing.assert_array_equal(is_hydrogen(adk.atoms), [n[0] == "H" for n in adk.atoms.names])


def test_torsions_of_a_protein_carry_their_names(adk):
    torsions = rotatable_torsions(adk.atoms)
    kinds = {kind: [t for t in torsions if t.kind == kind] for kind in ("phi", "psi", "chi1")}
    by_residue = {t.residue: t for t in kinds["psi"]}
    for residue in adk.residues[:-1]:
        assert tuple(residue.psi_selection().ix) == by_residue[residue.resindex].atoms
    by_residue = {t.residue: t for t in kinds["phi"]}
    for residue in adk.residues[1:]:
        if residue.resname == "PRO":  # in a ring
            assert residue.resindex not in by_residue
        else:
            assert tuple(residue.phi_selection().ix) == by_residue[residue.resindex].atoms
    by_residue = {t.residue: t for t in kinds["chi1"]}
    for residue in adk.residues:
        chi = residue.chi1_selection()
        if chi is None or residue.resname in ("PRO", "GLY", "ALA"):
            assert residue.resindex not in by_residue
        else:
            assert tuple(chi.ix) == by_residue[residue.resindex].atoms
    assert by_residue[1].label == "ARG2 chi1"


def test_side_chains_go_up_to_chi5(adk):
    arginine = adk.select_atoms("resid 2")
    chis = {t.kind: tuple(adk.atoms[list(t.atoms)].names) for t in rotatable_torsions(arginine)}
    assert chis["chi1"] == ("N", "CA", "CB", "CG")
    assert chis["chi4"] == ("CG", "CD", "NE", "CZ")
    assert chis["chi5"] == ("CD", "NE", "CZ", "NH1")


def test_angles_follow_turns_that_were_made(tmp_path, pentane, write_run):
    set_to = np.arange(-180, 180, 15.0)
    start = pentane.turned(pentane.positions, 1, 2, 180.0)  # cis
    trajectory = [pentane.turned(start, 1, 2, degrees) for degrees in set_to]
    universe = MDAnalysis.Universe(write_run(tmp_path / "turn.h5md", pentane, trajectory))
    found = TorsionDistributions(universe.atoms, bonds=pentane.bonds, bins=24).run()
    assert [t.atoms for t in found.torsions] == [(0, 1, 2, 3), (1, 2, 3, 4)]
    difference = (found.results.angles[:, 0] - set_to + 180) % 360 - 180
    np.testing.assert_allclose(difference, 0, atol=1e-4)
    np.testing.assert_allclose(np.abs(found.results.angles[:, 1]), 180, atol=1e-4)
    np.testing.assert_allclose(found.results.density.sum(axis=1) * 15, 1.0)


def test_angles_are_those_of_mdanalysis(adk):
    found = TorsionDistributions(adk.select_atoms("resid 2:5")).run(step=20)
    for frame, angles in zip(range(0, 98, 20), found.results.angles, strict=True):
        adk.trajectory[frame]
        for torsion, angle in zip(found.torsions, angles, strict=True):
            theirs = adk.atoms[list(torsion.atoms)].dihedral.value()
            assert (angle - theirs + 180) % 360 - 180 == pytest.approx(0, abs=1e-3)


def test_circular_mean_and_spread():
    angles = np.array(
        [[170.0, 10.0, 0.0], [-170.0, -10.0, 90.0], [180.0, 0.0, 180.0], [180.0, 0.0, -90.0]]
    )
    mean, spread = circular_moments(angles)
    assert abs(mean[0]) == pytest.approx(180)
    assert mean[1] == pytest.approx(0, abs=1e-12)
    length = (2 + 2 * np.cos(np.radians(10))) / 4
    assert spread[0] == pytest.approx(np.degrees(np.sqrt(-2 * np.log(length))))
    assert spread[0] == pytest.approx(spread[1])
    assert spread[2] == pytest.approx(360)  # all around


def test_no_torsion_gives_empty_tables():
    ethane = molecule("CC", [(0, 1)])
    found = TorsionDistributions(ethane.atoms, bins=12).run()
    assert found.torsions == []
    assert found.results.angles.shape == (1, 0)
    assert found.results.density.shape == (0, 12)
