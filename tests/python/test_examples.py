# SPDX-License-Identifier: MIT
"""The table of examples and random graphs against numpy and networkx, which know nothing of us."""

import itertools

import expected_warnings
import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pliant

NAMES = [example.name for example in pliant.examples()]


def named(name):
    return next(example for example in pliant.examples() if example.name == name)


def rigidity_matrix(framework, positions):
    rows = np.zeros((framework.bar_count, framework.joint_count, 3))
    for k, (i, j) in enumerate(framework.bars):
        delta = positions[j] - positions[i]
        rows[k, i], rows[k, j] = -delta, delta
    return rows.reshape(framework.bar_count, 3 * framework.joint_count)


def relative_residuals(framework, positions):
    i, j = framework.bars.T
    lengths = np.linalg.norm(positions[j] - positions[i], axis=1)
    return np.abs(lengths - framework.rest_lengths) / framework.rest_lengths


def worst_limit(framework, positions):
    """By how much a distance leaves its interval, Angstrom; the spheres have a diameter of 1.2."""
    limits = framework.limits
    lengths = np.linalg.norm(positions[limits["b"]] - positions[limits["a"]], axis=1)
    off = np.maximum(limits["least"] - lengths, lengths - limits["most"])
    worst = max(0.0, off.max(initial=0))
    if framework.has_sterics:
        i, j = np.triu_indices(len(positions), 1)
        worst = max(worst, 1.2 - np.linalg.norm(positions[j] - positions[i], axis=1).min())
    return worst


@pytest.mark.parametrize("name", NAMES)
def test_facts_of_examples(name):
    example = named(name)
    facts, found = example.facts, example.framework.graph_facts()
    assert (found.components, found.cycles) == (facts.components, facts.cycles)
    assert (found.bridges, found.blocks) == (facts.bridges, facts.blocks)
    assert example.source
    if facts.rank is not None:
        matrix = rigidity_matrix(example.framework, example.positions)
        rank = np.linalg.matrix_rank(matrix, tol=1e-9) if matrix.size else 0
        assert rank == facts.rank
    worst = relative_residuals(example.framework, example.positions).max(initial=0)
    beyond = worst_limit(example.framework, example.positions)
    assert (worst < 1e-9 and beyond < 1e-9) == facts.whole


@pytest.mark.parametrize("technique", [row.name for row in pliant.techniques()])
@pytest.mark.parametrize("name", NAMES)
def test_converged_means_whole(name, technique):
    example = named(name)
    framework, positions = example.framework, example.positions
    positions += np.random.default_rng(4).normal(scale=0.05, size=positions.shape)
    try:
        with expected_warnings.of_fit(framework, technique):
            summary = pliant.resolve(framework, positions, technique, max_sweeps=500)
    except pliant.OptionError as error:
        if "is for trees only" in str(error):
            assert example.facts.cycles > 0
        else:
            assert "does not support limits" in str(error)
            assert len(framework.limits) or framework.has_sterics
        return
    assert np.isfinite(positions).all()
    worst = relative_residuals(framework, positions).max(initial=0)
    assert summary.max_residual == pytest.approx(worst, rel=1e-6, abs=1e-15)
    beyond = worst_limit(framework, positions)
    assert summary.converged == (
        worst <= 1e-6 and beyond <= (0.1 if framework.has_sterics else 1e-2)
    )
    if not example.facts.feasible:
        assert not summary.converged


@st.composite
def graphs(draw):
    count = draw(st.integers(1, 12))
    joint = st.integers(0, count - 1)
    pairs = draw(st.lists(st.tuples(joint, joint), max_size=25))
    return count, sorted({(min(a, b), max(a, b)) for a, b in pairs if a != b})


@given(graphs())
@settings(max_examples=200, deadline=None)
def test_components_bridges_and_blocks_are_those_of_networkx(graph):
    count, bars = graph
    framework = pliant.Framework(bars, np.ones(len(bars)), count)
    theirs = nx.Graph(bars)
    theirs.add_nodes_from(range(count))
    components = framework.components()
    assert len(set(components)) == nx.number_connected_components(theirs)
    for component in nx.connected_components(theirs):
        assert len({components[joint] for joint in component}) == 1
    bridges = {bar for bar, is_bridge in zip(bars, framework.bridges(), strict=True) if is_bridge}
    assert bridges == {tuple(sorted(bar)) for bar in nx.bridges(theirs)}
    blocks = {}
    for bar, block in zip(bars, framework.blocks(), strict=True):
        blocks.setdefault(block, set()).add(bar)
    expected = {
        frozenset(tuple(sorted(bar)) for bar in block)
        for block in nx.biconnected_component_edges(theirs)
    }
    assert {frozenset(block) for block in blocks.values()} == expected
    facts = framework.graph_facts()
    assert facts.cycles == len(bars) - count + facts.components
    assert facts.is_forest == nx.is_forest(theirs)


@given(graphs(), st.data())
@settings(max_examples=100, deadline=None)
def test_orderings_visit_each_bar_from_one_of_its_ends(graph, data):
    count, bars = graph
    framework = pliant.Framework(bars, np.ones(len(bars)), count)
    root = data.draw(st.integers(0, count - 1))
    for row in pliant.orderings():
        bar, near, is_tree = pliant.order(framework, row.name, root, seed=3)
        assert len(set(bar)) == len(bar)
        assert all(joint in bars[k] for k, joint in zip(bar, near, strict=True))
        if row.name.startswith(("bfs", "dfs")):
            tree = nx.Graph([bars[k] for k, tree in zip(bar, is_tree, strict=True) if tree])
            assert not tree or nx.is_forest(tree)
            assert is_tree.sum() == count - framework.graph_facts().components
        assert row.forests_only or len(bar) == len(bars)


@pytest.mark.parametrize("kind", [row.name for row in pliant.graph_classes()])
def test_generated_graphs_are_of_their_class(kind):
    family = next(row.family for row in pliant.graph_classes() if row.name == kind)
    expected = {"tree": 0, "1-cycle": 1, "2-cycle": 2, "n-cycle": 5}[family]
    for number in range(20):
        graph = pliant.generate(kind, 3, number, cycles=5)
        theirs = nx.Graph(graph.framework.bars.tolist())
        assert nx.is_connected(theirs)
        assert len(graph.cycles) == expected
        assert theirs.number_of_edges() - theirs.number_of_nodes() + 1 == expected
        for cycle in graph.cycles:
            assert all(theirs.has_edge(a, b) for a, b in itertools.pairwise(cycle))
            assert theirs.has_edge(cycle[-1], cycle[0])
        assert relative_residuals(graph.framework, graph.positions).max() < 1e-12
        again = pliant.generate(kind, 3, number, cycles=5)
        assert again.positions.tobytes() == graph.positions.tobytes()
    assert pliant.generate(kind, 4).positions.tobytes() != again.positions.tobytes()


def test_an_example_as_graph_xml(tmp_path):
    for example in pliant.examples():
        path = tmp_path / "example.xml"
        graph = pliant.Graph(example.framework, example.positions)
        path.write_text(graph.text())
        if not example.facts.feasible or example.framework.joint_count == 0:
            continue
        again = pliant.read_graph_xml(path)
        assert np.array_equal(again.positions, example.positions)
        assert np.array_equal(again.framework.rest_lengths, example.framework.rest_lengths)
        assert np.array_equal(again.framework.bars, example.framework.bars)
    with pytest.raises(IndexError, match=r"^joint 99 of 5 does not exist$"):
        pliant.Graph(named(NAMES[0]).framework, named(NAMES[0]).positions, [[0, 99]])
    path.write_text('<graph dimension="3"><joint id="a" x="0" y="0" z="zero"/></graph>')
    with pytest.raises(pliant.InputError, match=r"example\.xml:1: "):
        pliant.read_graph_xml(path)
