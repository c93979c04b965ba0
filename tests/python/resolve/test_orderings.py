# SPDX-License-Identifier: MIT
"""Orderings against networkx's traversals: the printed graphs of the thesis and 200 random ones.

A tree bar leads to a joint that was not met before; levels are distances from the root. In breadth
first order a bar that closes a cycle spans at most one level; in depth first order it joins a
joint with one of its ancestors (Tarjan 1972).
"""

import random

import networkx as nx
import numpy as np
import pytest

import pliant

THESIS = [example for example in pliant.examples() if example.name.startswith("thesis_figure")]
KINDS = [row.name for row in pliant.graph_classes()]
BREADTH, DEPTH = ["bfs_tree", "bfs_cycle", "bfs_reverse"], ["dfs_tree", "dfs_cycle", "dfs_reverse"]


def in_file_order(bars, count):
    """A networkx graph whose neighbours stand in the order of the bars."""
    graph = nx.Graph()
    graph.add_nodes_from(range(count))
    graph.add_edges_from(bars)
    return graph


def random_bars(seed):
    """Of any density, connected or not, in any order and direction."""
    draws = random.Random(seed)
    count = draws.randint(2, 40)
    pairs = [(a, b) for a in range(count) for b in range(a)]
    bars = draws.sample(pairs, draws.randint(1, min(len(pairs), 3 * count)))
    return count, [bar if draws.random() < 0.5 else bar[::-1] for bar in bars]


def generated_bars(number):
    framework = pliant.generate(KINDS[number % len(KINDS)], 11, number, cycles=6).framework
    return framework.joint_count, [tuple(map(int, bar)) for bar in framework.bars]


def cases():
    for example in THESIS:
        bars = [tuple(map(int, bar)) for bar in example.framework.bars]
        yield example.name, (example.framework.joint_count, bars)
    yield from ((f"random_{seed}", random_bars(seed)) for seed in range(150))
    yield from ((f"generated_{number}", generated_bars(number)) for number in range(50))


CASES = dict(cases())


class Traversal:
    """What one ordering does with one graph, from each joint on."""

    def __init__(self, case, ordering, root):
        self.count, self.given = CASES[case]
        self.framework = pliant.Framework(self.given, np.ones(len(self.given)), self.count)
        self.bars = [tuple(map(int, bar)) for bar in self.framework.bars]
        self.graph = in_file_order(self.given, self.count)
        self.root = root
        self.bar, self.near, self.is_tree = pliant.order(self.framework, ordering, root)

    def tree_bars(self):
        """(near, far) of the tree bars in the component of the root, in the order of the visits."""
        inside = nx.node_connected_component(self.graph, self.root)
        ends = [self.ends(k) for k in range(len(self.bar)) if self.is_tree[k]]
        return [two for two in ends if two[0] in inside]

    def ends(self, visit):
        """Near and far joint of a visit."""
        a, b = self.bars[self.bar[visit]]
        near = int(self.near[visit])
        assert near in (a, b)
        return near, b if near == a else a

    def parents(self):
        """Of every joint that a tree bar leads to."""
        ends = [self.ends(k) for k in range(len(self.bar)) if self.is_tree[k]]
        parents = {far: near for near, far in ends}
        assert len(parents) == len(ends), "two tree bars lead to one joint"
        return parents

    def closing_bars(self):
        return [self.bars[k] for k, tree in zip(self.bar, self.is_tree, strict=True) if not tree]


def roots(case):
    count = CASES[case][0]
    return sorted({0, count // 2, count - 1})


def traversals(case, orderings):
    for root in roots(case):
        for ordering in orderings:
            yield Traversal(case, ordering, root)


def path_up(joint, parents):
    path = [joint]
    while path[-1] in parents:
        path.append(parents[path[-1]])
    return path


def test_there_are_at_least_200_random_graphs_with_and_without_cycles():
    graphs = [in_file_order(bars, count) for name, (count, bars) in CASES.items()]
    assert len(graphs) - len(THESIS) == 200
    assert len(THESIS) >= 7
    assert sum(nx.is_forest(graph) for graph in graphs) > 20
    assert sum(not nx.is_connected(graph) for graph in graphs) > 20


@pytest.mark.parametrize("case", CASES)
def test_neighbours_are_met_in_file_order(case):
    """The tree is networkx's, bar for bar and in its order."""
    for one in traversals(case, BREADTH):
        assert one.tree_bars() == list(nx.bfs_edges(one.graph, one.root))
    for one in traversals(case, DEPTH):
        assert one.tree_bars() == list(nx.dfs_edges(one.graph, one.root))


@pytest.mark.parametrize("case", CASES)
def test_levels_are_the_distances_from_the_root(case):
    for one in traversals(case, BREADTH):
        parents = one.parents()
        distances = nx.single_source_shortest_path_length(one.graph, one.root)
        for joint, distance in distances.items():
            path = path_up(joint, parents)
            assert (path[-1], len(path) - 1) == (one.root, distance)


@pytest.mark.parametrize("case", CASES)
def test_breadth_first_closing_bars_span_at_most_one_level(case):
    for one in traversals(case, ["bfs_cycle", "bfs_reverse"]):
        parents = one.parents()
        for a, b in one.closing_bars():
            up_a, up_b = path_up(a, parents), path_up(b, parents)
            assert up_a[-1] == up_b[-1], "in one component"
            assert abs(len(up_a) - len(up_b)) <= 1


@pytest.mark.parametrize("case", CASES)
def test_depth_first_closing_bars_join_a_joint_with_its_ancestor(case):
    for one in traversals(case, ["dfs_cycle", "dfs_reverse"]):
        parents = one.parents()
        for a, b in one.closing_bars():
            assert a in path_up(b, parents) or b in path_up(a, parents)


@pytest.mark.parametrize("case", CASES)
def test_closing_bars_come_after_both_their_joints_were_met(case):
    for one in traversals(case, ["bfs_cycle", "dfs_cycle"]):
        begun = set(one.graph) - set(one.parents())  # each component's first joint
        for k in range(len(one.bar)):
            near, far = one.ends(k)
            assert near in begun
            assert (far not in begun) == one.is_tree[k]
            begun.add(far)
