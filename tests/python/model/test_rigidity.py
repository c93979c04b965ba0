# SPDX-License-Identifier: MIT
"""pliant.rigidity: arrays that agree with each other, and with networkx and numpy."""

from pathlib import Path

import networkx
import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

OPEN = Path(MDAnalysisTests.__file__).parent / "data" / "adk_open.pdb"


@pytest.fixture(scope="module")
def structure():
    with pytest.warns(pliant.PliantWarning, match="no element"):
        return pliant.read(OPEN)


@pytest.fixture(scope="module")
def found(structure):
    return pliant.rigidity(structure)


def test_totals_follow_from_the_arrays(found, structure):
    assert found.cluster.shape == (len(structure),)
    assert (np.bincount(found.cluster) == found.cluster_sizes).all()
    assert (np.diff(found.cluster_sizes) <= 0).all()
    assert found.bars == found.edge_bars.sum()
    assert found.redundant == found.edge_redundant.sum()
    graph = networkx.MultiGraph(found.edges.tolist())
    graph.add_nodes_from(range(len(structure)))
    assert found.parts == networkx.number_connected_components(graph)
    rank = found.bars - found.redundant
    assert found.degrees_of_freedom == 6 * (len(structure) - found.parts) - rank
    is_bond = found.edge_contact < 0
    ends = found.cluster[found.edges]
    turning = is_bond & (found.edge_bars == 5)
    assert found.hinges == turning.sum()
    assert found.flexible_bonds == (turning & (ends[:, 0] != ends[:, 1])).sum()


def test_flexibility_adds_up_over_blocks_of_networkx(found):
    """Degrees of freedom of each block: 6 (clusters - 1) - bars."""
    ends = found.cluster[found.edges]
    between = np.flatnonzero(ends[:, 0] != ends[:, 1])
    graph = networkx.Graph(ends[between].tolist())
    block_of = {}
    nodes = []
    for k, edges in enumerate(networkx.biconnected_component_edges(graph)):
        edges = list(edges)
        nodes.append(len({node for edge in edges for node in edge}))
        block_of |= {frozenset(edge): k for edge in edges}
    blocks = np.array([block_of[frozenset(ends[k].tolist())] for k in between])
    bars = np.bincount(blocks, weights=found.edge_bars[between])
    own = np.bincount(blocks, weights=6 - found.edge_bars[between])
    expected = (6 * (np.array(nodes) - 1) - bars) / own
    np.testing.assert_allclose(found.edge_flexibility[between], expected[blocks], rtol=1e-12)
    locked = np.setdiff1d(np.arange(len(ends)), between)
    assert (found.edge_flexibility[locked] <= 0).all()


def test_residues_are_rated_by_their_backbone(found):
    structure = found.structure
    names, residue = structure.names, structure.residue_of
    bond = found.edges[:, 0], found.edges[:, 1]
    pairs = np.sort(np.column_stack([names[bond[0]], names[bond[1]]]), axis=1)
    backbone = (pairs == ["CA", "N"]).all(axis=1) | (pairs == ["C", "CA"]).all(axis=1)
    counted = backbone & (found.edge_contact < 0)
    sums = np.bincount(residue[bond[0][counted]], weights=found.edge_flexibility[counted])
    np.testing.assert_allclose(found.residue_flexibility, sums / 2, atol=1e-12)


def test_dilution_only_breaks_clusters(structure):
    """But for hydrogens, which count with their donor once their bond is gone."""
    rows = pliant.rigidity(structure, hbond_cutoff=0.0, ends_turn=False).dilution()
    assert rows["cutoff"][-1] == -np.inf
    assert (np.diff(rows["cutoff"]) <= 0).all()
    assert (np.diff(rows["degrees_of_freedom"]) >= 0).all()
    assert (np.diff(rows["largest"]) <= 0).all()
    assert (np.diff(rows["hydrogen_bonds"]) == -1).all()


def test_a_model_is_taken_as_it_is(structure, found):
    model = pliant.build_model(structure)
    again = pliant.rigidity(model)
    assert (again.cluster == found.cluster).all()
    none = pliant.rigidity(model, contacts=model.contacts[:0])
    assert none.redundant < found.redundant
    assert none.degrees_of_freedom > found.degrees_of_freedom
