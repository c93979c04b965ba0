# SPDX-License-Identifier: MIT
"""Test sets from Python: what is written, resolved and read back."""

import csv
import gc
import statistics
from pathlib import Path
from xml.etree import ElementTree

import networkx
import numpy as np
import pytest

import pliant

COLUMNS = ("sweeps", "passes", "projections", "converged", "final_residual")


@pytest.fixture
def made(tmp_path):
    return pliant.write_test_set(
        tmp_path / "set",
        classes=["tree", "1-cycle-ring", "n-cycle"],
        graphs=2,
        forces=6,
        seed=5,
        cycles=4,
        techniques=["bfs_tree", "bfs_cycle"],
        weightings=[0.5, 1],
    )


def resolve_all(test_set, graph, technique, weighting):
    """One row a push, each from the graph's own positions."""
    rows = []
    start = graph.graph
    for joint, force in graph.pushes:
        positions = start.positions.copy()
        positions[joint] += 100 * test_set.timestep**2 * np.array(force)
        summary = pliant.resolve(
            start.framework,
            positions,
            technique,
            weighting,
            tolerance_length=test_set.tolerance_length,
            max_sweeps=test_set.max_sweeps,
            root=joint,
        )
        work = summary.sweeps, summary.sweeps, summary.projections
        rows.append((*work, summary.converged, summary.max_residual))
    return [list(column) for column in zip(*rows, strict=True)]


def test_the_set_says_what_it_holds(made):
    assert [kind.name for kind in made.classes] == ["tree", "1-cycle-ring", "n-cycle"]
    assert [kind.family for kind in made.classes] == ["tree", "1-cycle", "n-cycle"]
    assert (made.seed, made.forces, made.cycles, made.box) == (5, 6, 4, 10.0)
    assert (made.force, made.timestep, made.tolerance_length) == (50.0, 0.01, 0.01)
    tree, ring = made.classes[0].graphs[1], made.class_named("1-cycle-ring").graphs[0]
    assert (tree.name, tree.number) == ("graph-001", 1)
    assert [row.name for row in tree.heuristics] == [
        "bfs_tree-0.5",
        "bfs_tree-1",
        "bfs_cycle-0.5",
        "bfs_cycle-1",
    ]
    assert [row.name for row in ring.heuristics] == ["bfs_cycle-0.5", "bfs_cycle-1"]
    assert all(Path(row.directory).is_dir() for row in tree.heuristics)
    with pytest.raises(pliant.OptionError, match="no class in the test set named"):
        made.class_named("2-cycle-path")


@pytest.mark.parametrize("kind", [row.name for row in pliant.graph_classes()])
def test_written_graphs_are_of_their_class(tmp_path, kind):
    """By networkx, from the XML as Python's own parser reads it."""
    pliant.write_test_set(tmp_path, classes=[kind], graphs=8, forces=1, seed=3, cycles=5)
    family = next(row.family for row in pliant.graph_classes() if row.name == kind)
    cycles = {"tree": 0, "1-cycle": 1, "2-cycle": 2, "n-cycle": 5}[family]
    for path in sorted(tmp_path.glob("*/*/graph.xml")):
        root = ElementTree.parse(path).getroot()
        graph = networkx.Graph((bar.get("a"), bar.get("b")) for bar in root.iter("bar"))
        assert networkx.is_connected(graph)
        assert len(graph) == len(list(root.iter("joint")))
        assert len(networkx.cycle_basis(graph)) == len(list(root.iter("cycle"))) == cycles


def test_results_are_written_read_back_and_run_again_to_the_same_numbers(made):
    for kind in made.classes:
        for graph in kind.graphs:
            for row in graph.heuristics:
                columns = resolve_all(made, graph, row.technique, row.weighting)
                made.write_results(kind.name, graph.number, row.technique, row.weighting, *columns)
    made.save()
    back = pliant.read_test_set(made.directory)
    for kind in back.classes:
        for graph in kind.graphs:
            for row in graph.heuristics:
                table = back.read_results(kind.name, graph.number, row.technique, row.weighting)
                again = resolve_all(back, graph, row.technique, row.weighting)
                for name, column in zip(COLUMNS, again, strict=True):
                    np.testing.assert_array_equal(table[name], column)
                sweeps = table["sweeps"].tolist()
                assert row.results.mean == pytest.approx(statistics.mean(sweeps))
                assert row.results.sd == pytest.approx(statistics.stdev(sweeps))
                assert row.results.mode == min(statistics.multimode(sweeps))
                assert row.results.forces == 6
                assert row.results.converged == table["converged"].sum()
    trees = [row.results for graph in back.classes[0].graphs for row in graph.heuristics]
    assert (trees[1].mean, trees[1].mode, trees[1].sd) == (1, 1, 0)


def test_tables_are_plain_csv(made):
    columns = [1, 2, 3, 4, 5, 6], [0] * 6, [9] * 6, [True] * 5 + [False], [0.25] * 6
    made.write_results("tree", 0, "bfs_cycle", 0.5, *columns)
    row = made.classes[0].graphs[0].heuristics[2]
    with open(Path(row.directory) / "results.csv", encoding="utf-8", newline="") as file:
        table = list(csv.DictReader(file))
    assert table[5] == {
        "force": "5",
        "sweeps": "6",
        "passes": "0",
        "projections": "9",
        "converged": "false",
        "final_residual": "0.25",
    }
    assert (row.results.mean, row.results.mode, row.results.converged) == (3.5, 1, 5)


def test_a_heuristic_that_is_new_is_added(made):
    columns = [1] * 6, [1] * 6, [1] * 6, [True] * 6, [0.0] * 6
    results = made.write_results("tree", 1, "random", 0.25, *columns)
    made.save()
    last = pliant.read_test_set(made.directory).classes[0].graphs[1].heuristics[-1]
    assert (last.name, last.results) == ("random-0.25", results)


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"sweeps": [1]}, pliant.InputError, "expected five columns of one length, found 1 and 6"),
        ({"sweeps": [1.5] * 6}, TypeError, "sweeps: expected an array of integers"),
        ({"converged": [1] * 6}, TypeError, "converged: expected an array of truth values"),
        ({"final_residual": [np.nan] * 6}, pliant.InputError, "final_residual = nan"),
        ({"projections": [-1] * 6}, pliant.InputError, "projections = -1: must be finite"),
    ],
)
def test_results_that_are_none_are_refused(made, change, error, message):
    columns = dict(zip(COLUMNS, ([1] * 6, [1] * 6, [1] * 6, [True] * 6, [0.0] * 6), strict=True))
    with pytest.raises(error, match=message):
        made.write_results("tree", 0, "bfs_tree", 0.5, **(columns | change))
    assert made.classes[0].graphs[0].heuristics[0].results is None


def test_parts_outlive_the_name_of_their_set(tmp_path):
    heuristic = (
        pliant.write_test_set(tmp_path, classes=["tree"], graphs=1, forces=1)
        .class_named("tree")
        .graphs[0]
        .heuristics[0]
    )
    gc.collect()
    assert heuristic.technique == "random"


def test_a_graph_is_a_copy_of_ones_own(made):
    graph = made.classes[0].graphs[0]
    graph.graph.positions[:] = 0
    assert graph.graph.positions.any()
