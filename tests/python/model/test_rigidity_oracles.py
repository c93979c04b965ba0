# SPDX-License-Identifier: MIT
"""Degrees of freedom of molecules beside the rank of rigidity matrices: numpy's, and PyRigi's.

Each atom a body, each single bond a hinge: such a molecule with graph G, each atom of which has two
bonds or more, has as many internal freedoms as joints and bars in space on the square of G, which
has a bar for each bond and for each angle (the molecular
conjecture: N. Katoh, S. Tanigawa, Discrete Comput. Geom. 45 (2011) 647).
"""

import networkx
import numpy as np
import pytest

import pliant


def molecule(graph):
    """Carbons joined by single bonds; positions count for nothing."""
    atoms = graph.number_of_nodes()
    positions = np.random.default_rng(1).normal(size=(atoms, 3))
    bonds = np.array(graph.edges)
    return pliant.Structure(
        positions, elements=[6] * atoms, bonds=bonds, bond_orders=[1] * len(bonds)
    )


def freedoms(graph):
    return pliant.rigidity(molecule(graph), contacts=[]).degrees_of_freedom


def rigidity_matrix(graph, seed=0):
    """(bars, 3 joints) at random positions, and these."""
    joints = graph.number_of_nodes()
    positions = np.random.default_rng(seed).normal(size=(joints, 3))
    matrix = np.zeros((graph.number_of_edges(), joints, 3))
    for row, (a, b) in zip(matrix, graph.edges, strict=True):
        row[a] = positions[a] - positions[b]
        row[b] = -row[a]
    return matrix.reshape(len(matrix), -1), positions


def freedoms_of_bars(graph, seed=0):
    """Coordinates - rank - motions of the whole."""
    rank = np.linalg.matrix_rank(rigidity_matrix(graph, seed)[0], tol=1e-9)
    return 3 * graph.number_of_nodes() - rank - 6


def square(graph):
    """With an edge between each two nodes that are one or two edges apart."""
    return networkx.Graph(networkx.power(graph, 2).edges)


def random_molecule(seed):
    """Connected, from a ring to far too many bonds; every atom has two bonds or more."""
    random = np.random.default_rng(seed)
    atoms = int(random.integers(4, 15))
    graph = networkx.cycle_graph(atoms)
    if seed % 2:  # two rings on a chain, so that there are several clusters
        graph = networkx.disjoint_union(graph, networkx.cycle_graph(int(random.integers(3, 9))))
        graph.add_edge(0, atoms)
    for _ in range(int(random.integers(0, 4))):
        a, b = random.choice(graph.number_of_nodes(), 2, replace=False)
        graph.add_edge(int(a), int(b))
    return graph


@pytest.mark.parametrize(("atoms", "expected"), [(5, 0), (6, 0), (7, 1), (8, 2), (12, 6)])
def test_a_ring_of_six_is_rigid_and_each_atom_more_is_a_freedom(atoms, expected):
    ring = networkx.cycle_graph(atoms)
    assert freedoms(ring) == expected
    assert freedoms_of_bars(square(ring)) == expected


def test_a_ring_of_six_locks_one_of_seven_that_it_shares_a_bond_with():
    """12 hinges, two loops that take six freedoms each."""
    fused = networkx.cycle_graph(7)
    networkx.add_path(fused, [0, 7, 8, 9, 10, 1])
    assert freedoms(fused) == freedoms_of_bars(square(fused)) == 0


def test_random_molecules_have_the_freedoms_of_their_squares():
    found = []
    for seed in range(300):
        graph = random_molecule(seed)
        ours = freedoms(graph)
        assert ours == freedoms_of_bars(square(graph), seed=seed), f"seed {seed}"
        found.append(ours)
    assert found.count(0) > 20 and max(found) > 5


def test_clusters_of_random_molecules_are_rigid_in_their_squares():
    """No motion that the bars of the square allow changes a distance within a cluster."""
    for seed in range(40):
        graph = random_molecule(seed)
        matrix, positions = rigidity_matrix(square(graph))
        _, values, motions = np.linalg.svd(matrix)
        free = motions[np.count_nonzero(values > 1e-9) :].reshape(-1, len(positions), 3)
        cluster = pliant.rigidity(molecule(graph), contacts=[]).cluster
        a, b = np.nonzero(np.triu(cluster[:, None] == cluster[None], 1))
        apart = np.einsum("mpi,pi->mp", free[:, a] - free[:, b], positions[a] - positions[b])
        assert np.abs(apart).max(initial=0.0) < 1e-8, f"seed {seed}"


@pytest.mark.parametrize("seed", range(4))
def test_pyrigi_counts_the_same(seed):
    """Where it is installed: it needs Python 3.11."""
    pyrigi = pytest.importorskip("pyrigi")
    graph = random_molecule(seed)
    squared = pyrigi.Graph(square(graph).edges)
    framework = pyrigi.Framework.Random(squared, dim=3)
    assert freedoms(graph) == len(framework.nontrivial_inf_flexes(numerical=True))
