# SPDX-License-Identifier: MIT
"""Hydrogens on carbon placed by rule, and how few of them run into others in frames."""

from collections import Counter

import expected_warnings
import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
Clashes = pytest.importorskip("pliant.measure.clashscore").Clashes


def without(structure, out):
    """A copy without the atoms that are marked (N,), bonds perceived."""
    kept = np.flatnonzero(~out)
    part = pliant.Structure(
        structure.positions[kept],
        elements=structure.elements[kept],
        names=[str(name) for name in structure.names[kept]],
        residue_names=[str(name) for name in structure.residue_names[kept]],
        residue_ids=structure.residue_ids[kept],
        chains=[str(name) for name in structure.chains[kept]],
    )
    part.perceive_bonds()
    return part


def on_carbon(structure):
    """(N,) bool: hydrogens that are bonded to carbon."""
    marked = np.zeros(len(structure), dtype=bool)
    for a, b in structure.bonds:
        for one, other in ((a, b), (b, a)):
            if structure.elements[one] == 1 and structure.elements[other] == 6:
                marked[one] = True
    return marked


@pytest.fixture(scope="module")
def kinase():
    """All hydrogens in the file, placed by CHARMM."""
    structure = expected_warnings.read_without_elements(
        f"{MDA.PDB_small.rpartition('/')[0]}/adk_open.pdb"
    )
    structure.perceive_bonds()
    return structure


def counts(structure):
    """How many hydrogens each carbon of each residue has."""
    found = Counter()
    for a, b in structure.bonds:
        for one, other in ((a, b), (b, a)):
            if structure.elements[one] == 1 and structure.elements[other] == 6:
                found[int(structure.residue_of[other]), str(structure.names[other])] += 1
    return found


def test_each_carbon_gets_as_many_as_a_force_field_gives_it(kinase):
    bare = without(kinase, on_carbon(kinase))
    made = pliant.prepare(bare, all_hydrogens=True)
    assert counts(made.structure) == counts(kinase)
    assert any("hydrogens on carbon placed by rule" in line for line in made.steps)
    assert len(made.structure) == len(kinase)


def test_they_lie_where_chemistry_has_them(kinase):
    """Against CHARMM's, but for methyls, whose turn is free: within 0.25 Angstrom, mean 0.07."""
    bare = without(kinase, on_carbon(kinase))
    made = pliant.prepare(bare, all_hydrogens=True).structure
    heavy = {
        (int(made.residue_of[a]), str(made.names[a])): a for a in np.flatnonzero(made.elements == 6)
    }
    theirs = {
        (int(kinase.residue_of[a]), str(kinase.names[a])): a
        for a in np.flatnonzero(kinase.elements == 6)
    }
    hydrogens, apart = [neighbours(made), neighbours(kinase)], []
    for key, carbon in heavy.items():
        one, other = hydrogens[0][carbon], hydrogens[1][theirs[key]]
        if len(one) in (1, 2):
            for atom in one:
                away = np.linalg.norm(kinase.positions[other] - made.positions[atom], axis=1)
                apart.append(away.min())
    assert len(apart) > 900
    assert np.mean(apart) < 0.1 and np.max(apart) < 0.4


def neighbours(structure):
    found = {int(a): [] for a in np.flatnonzero(structure.elements == 6)}
    for a, b in structure.bonds:
        for one, other in ((a, b), (b, a)):
            if structure.elements[one] == 1 and structure.elements[other] == 6:
                found[int(other)].append(int(one))
    return found


def test_frames_have_no_more_clashes_than_the_start(kinase):
    model = pliant.build_model(kinase, all_hydrogens=True)
    clashes = Clashes(model.structure.elements, model.structure.bonds)
    start = clashes.score(np.array(model.positions))
    frames = [clashes.score(x) for x in pliant.sample(model, 10).positions]
    assert start > 5.0
    assert np.mean(frames) < start


def test_a_clash_is_an_overlap_of_spheres_of_atoms_far_apart_in_bonds():
    elements = np.array([6, 1, 6, 8, 1])
    bonds = np.array([[0, 1], [3, 4]])
    clashes = Clashes(elements, bonds)
    x = np.array([[0.0, 0, 0], [1.09, 0, 0], [9.0, 0, 0], [20.0, 0, 0], [20.96, 0, 0]])
    assert len(clashes.pairs(x)[0]) == 0
    x[2] = [1.09 + 2.5, 0, 0]  # C..H: 1.70 + 1.22 - 2.50 = 0.42, and C..C 0.0
    pairs, overlap = clashes.pairs(x)
    assert pairs.tolist() == [[1, 2]]
    assert overlap[0] == pytest.approx(0.42)
    assert clashes.score(x) == pytest.approx(200.0)
    x[2] = [1.09 + 2.53, 0, 0]
    assert len(clashes.pairs(x)[0]) == 0


def test_hydrogen_bonds_are_no_clashes():
    elements, bonds = np.array([7, 1, 8]), np.array([[0, 1]])
    clashes = Clashes(elements, bonds)
    assert len(clashes.pairs(np.array([[0.0, 0, 0], [1.01, 0, 0], [2.91, 0, 0]]))[0]) == 0
    assert len(clashes.pairs(np.array([[0.0, 0, 0], [1.01, 0, 0], [2.3, 0, 0]]))[0]) >= 1


def test_neighbours_in_bonds_are_none():
    elements = np.array([6] * 6)
    chain = np.array([[k, k + 1] for k in range(5)])
    x = np.zeros((6, 3))
    x[:, 0] = 0.5 * np.arange(6)
    pairs, _ = Clashes(elements, chain).pairs(x)
    assert pairs.tolist() == [[0, 4], [0, 5], [1, 5]]  # four bonds apart and more


RING = """\
ATOM      1  N   HIS A   1      -0.676  -1.294   0.000  1.00  0.00           N
ATOM      2  CA  HIS A   1       0.000   0.000   0.000  1.00  0.00           C
ATOM      3  C   HIS A   1       1.527   0.000   0.000  1.00  0.00           C
ATOM      4  O   HIS A   1       2.153  -1.059   0.000  1.00  0.00           O
ATOM      5  N   GLY A   2       2.110   1.196   0.000  1.00  0.00           N
ATOM      6  CA  GLY A   2       3.556   1.360   0.000  1.00  0.00           C
ATOM      7  C   GLY A   2       3.935   2.838   0.000  1.00  0.00           C
ATOM      8  O   GLY A   2       3.072   3.717   0.000  1.00  0.00           O
"""


@pytest.mark.filterwarnings("ignore")  # a side chain is built
def test_a_histidine_that_has_hydrogens_on_carbon_alone_gets_one_on_nitrogen():
    whole = pliant.prepare(
        pliant.prepare(pliant.read_text(RING), fill_side_chains=True).structure, all_hydrogens=True
    ).structure
    on_ring = [name for name in whole.names if name in ("HD1", "HE2")]
    assert len(on_ring) == 1
    carbons_alone = whole.select(f"not name {on_ring[0]}")
    again = pliant.prepare(carbons_alone, all_hydrogens=True).structure
    assert sorted(again.names) == sorted(whole.names)
