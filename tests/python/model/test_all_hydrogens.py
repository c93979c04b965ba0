# SPDX-License-Identifier: MIT
"""Hydrogens on carbon placed by rule, and how few of them run into others in frames."""

from collections import Counter

import expected_warnings
import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
sparse = pytest.importorskip("scipy.sparse")
spatial = pytest.importorskip("scipy.spatial")

SERIOUS = 0.4  #: Angstrom of overlap
BONDED = 0.6  #: Angstrom that a hydrogen bond allows besides
#: Angstrom, of Probe with hydrogens at nuclear positions
RADII = {1: 1.22, 6: 1.70, 7: 1.55, 8: 1.40, 15: 1.80, 16: 1.80, 34: 1.90}
POLAR_H, AROMATIC_H, CARBONYL_C = 1.05, 1.05, 1.65  #: Angstrom
OTHER = 1.80  #: Angstrom, of elements that are not listed
POLAR = (7, 8, 16)


class Clashes:
    """Counts clashes of a molecule in any of its frames, as MolProbity does.

    Serious clashes (overlaps of van der Waals spheres of 0.4 Angstrom and more) of atoms more than
    three bonds apart, four if one of them is a hydrogen, for each 1000 atoms, all hydrogens
    included (Word et al., J. Mol. Biol. 285 (1999) 1711; Chen et al., Acta Cryst. D66 (2010) 12). A
    hydrogen on N, O or S may come 0.6 Angstrom nearer to an acceptor (N, O, S) before it counts.
    Spheres are compared by distance, not by dots: neighbours that hide a clash from a probe do not
    hide it here.
    """

    def __init__(self, elements, bonds):
        """elements: (N,) atomic numbers; bonds: (M, 2) atoms."""
        self._elements = np.asarray(elements, dtype=np.int64)
        self._count = len(self._elements)
        self._graph = _graph(np.asarray(bonds, dtype=np.int64).reshape(-1, 2), self._count)
        parents = self._parents()
        self._is_polar_h = (self._elements == 1) & np.isin(parents, POLAR)
        self._is_acceptor = np.isin(self._elements, POLAR)
        self._radii = self._radii_of(parents)
        self._near3, self._near4 = self._within(3), self._within(4)

    def pairs(self, positions):
        """(K, 2) atoms that clash at positions (N, 3), and (K,) their overlaps, Angstrom."""
        reach = 2.0 * self._radii.max() - SERIOUS
        pairs = spatial.cKDTree(positions).query_pairs(reach, output_type="ndarray")
        a, b = pairs[:, 0], pairs[:, 1]
        apart = np.linalg.norm(positions[a] - positions[b], axis=1)
        overlap = self._radii[a] + self._radii[b] - apart
        overlap -= BONDED * self._may_bond(a, b)
        kept = (overlap >= SERIOUS) & ~self._is_bonded(a, b)
        order = np.lexsort((b[kept], a[kept]))
        return pairs[kept][order], overlap[kept][order]

    def score(self, positions):
        """Clashes per 1000 atoms at positions (N, 3)."""
        return 1000.0 * len(self.pairs(positions)[0]) / self._count

    def _parents(self):
        """(N,) the element of the first atom that each is bonded to; 0: of none."""
        parents = np.zeros(self._count, dtype=np.int64)
        rows, columns = self._graph.nonzero()
        parents[rows[::-1]] = self._elements[columns[::-1]]
        return parents

    def _radii_of(self, parents):
        radii = np.array([RADII.get(int(element), OTHER) for element in self._elements])
        radii[self._is_polar_h] = POLAR_H
        degree = np.diff(self._graph.indptr)
        is_flat = (self._elements == 6) & (degree == 3)
        rows, columns = self._graph.nonzero()
        ends_in_oxygen = np.zeros(self._count, dtype=bool)
        ends_in_oxygen[rows[(self._elements[columns] == 8) & (degree[columns] == 1)]] = True
        radii[is_flat & ends_in_oxygen] = CARBONYL_C
        on_flat = np.zeros(self._count, dtype=bool)
        on_flat[rows[is_flat[columns]]] = True
        radii[(self._elements == 1) & (parents == 6) & on_flat] = AROMATIC_H
        return radii

    def _within(self, bonds):
        """(N, N) whether atoms are at most so many bonds apart."""
        near = self._graph.copy()
        for _ in range(bonds - 1):
            near = near + near @ self._graph
            near.data[:] = 1
        return near.tocsr()

    def _is_bonded(self, a, b):
        has_hydrogen = (self._elements[a] == 1) | (self._elements[b] == 1)
        near3 = np.asarray(self._near3[a, b]).ravel() > 0
        near4 = np.asarray(self._near4[a, b]).ravel() > 0
        return np.asarray(near3 | (near4 & has_hydrogen))

    def _may_bond(self, a, b):
        one, other = self._is_polar_h, self._is_acceptor
        return np.asarray((one[a] & other[b]) | (one[b] & other[a]))


def _graph(bonds, count):
    ends = np.concatenate([bonds, bonds[:, ::-1]])
    made = sparse.csr_matrix(
        (np.ones(len(ends), dtype=np.int32), (ends[:, 0], ends[:, 1])), shape=(count, count)
    )
    made.sum_duplicates()
    made.data[:] = 1
    return made


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
