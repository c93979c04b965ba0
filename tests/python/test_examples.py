# SPDX-License-Identifier: MIT
"""The table of examples and random graphs against numpy and networkx, which know nothing of us."""

import networkx as nx
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import pliant


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
