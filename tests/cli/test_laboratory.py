# SPDX-License-Identifier: MIT
"""The thesis laboratory at the command line: forces, orderings, graphs and test sets."""

import json

import h5py
import numpy as np
import pytest
from h5md_contents import contents

TRIANGLE = """<graph>
<joint id="a" x="0" y="0" z="0"/><joint id="b" x="1" y="0" z="0"/>
<joint id="c" x="0" y="1" z="0"/><joint id="d" x="0" y="1" z="1"/>
<bar a="a" b="b"/><bar a="b" b="c"/><bar a="c" b="a"/><bar a="c" b="d"/>
</graph>
"""


@pytest.fixture
def triangle(tmp_path):
    """A triangle with a tail, in the folder where pliant runs."""
    path = tmp_path / "triangle.xml"
    path.write_text(TRIANGLE)
    return path


def moved(path):
    """What a trajectory holds below /particles and /observables."""
    parts = ("particles/", "observables/")
    return {name: value for name, value in contents(path).items() if name.startswith(parts)}


def assert_same(one, two):
    assert one.keys() == two.keys()
    for name, values in one.items():
        np.testing.assert_array_equal(values, two[name], err_msg=name)


def test_recorded_forces_hold_the_settings_of_the_run(pliant, ethanol, tmp_path):
    words = "--steps 1 --timestep 0.005 --tolerance-length 0.001 --max-sweeps 77"
    pliant("run", ethanol, *words.split(), "--record-forces", "f.txt")
    lines = (tmp_path / "f.txt").read_text().splitlines()
    assert lines[0] == "pliant-forces 3"
    assert lines[1].startswith("structure ")
    assert lines[2:8] == [
        "joints 9",
        "bars 8",
        "input bars bonds",
        "set timestep 0.005",
        "set tolerance_length 0.001",
        "set max_sweeps 77",
    ]
    assert lines[8].startswith("push ")
    assert len(lines) == 9


def test_each_walker_records_its_own_forces(pliant, ethanol, tmp_path):
    ended = pliant("run", ethanol, "--walkers", 2, "--steps", 3, "--record-forces", "f.txt")
    assert ended.code == 0
    assert (tmp_path / "f-0.txt").read_text() != (tmp_path / "f-1.txt").read_text()


def test_recorded_forces_replace_nothing_unless_asked(pliant, ethanol, tmp_path):
    (tmp_path / "f.txt").write_text("mine")
    ended = pliant("run", ethanol, "--steps", 1, "--record-forces", "f.txt")
    assert (ended.code, ended.err) == (1, "pliant: error: f.txt: exists; --overwrite replaces it\n")
    assert (tmp_path / "f.txt").read_text() == "mine"
    ended = pliant("run", ethanol, "--forces", "f.txt", "--record-forces", "f.txt", "--overwrite")
    assert ended.code in (1, 2)
    assert (tmp_path / "f.txt").read_text() == "mine"


def test_generated_forces_are_those_of_a_run(pliant, ethanol, tmp_path):
    ended = pliant("lab", "forcegen", ethanol, "--steps", 20, "--force", 80, "--seed", 4)
    assert (ended.code, ended.out) == (0, "20 pushes in ethanol-forces.txt\n")
    run = ("run", ethanol, "--seed", 4, "--force", 80)
    assert pliant(*run, "--steps", 20, "-o", "1.h5md").code == 0
    assert pliant(*run, "--forces", "ethanol-forces.txt", "-o", "2.h5md").code == 0
    assert_same(moved(tmp_path / "1.h5md"), moved(tmp_path / "2.h5md"))


def test_generated_forces_as_json(pliant, ethanol):
    report = json.loads(pliant("lab", "forcegen", ethanol, "-o", "f.txt", "--json").out)
    assert report == {
        "input": str(ethanol),
        "output": "f.txt",
        "pushes": 50,
        "force": 50.0,
        "seed": 0,
    }


@pytest.mark.parametrize("command", ["forcegen", "order"])
def test_files_are_not_replaced_unless_asked(pliant, ethanol, tmp_path, command):
    (tmp_path / "out.txt").write_text("mine")
    ended = pliant("lab", command, ethanol, "-o", "out.txt")
    assert ended.code == 1
    assert "out.txt: exists already" in ended.err
    assert (tmp_path / "out.txt").read_text() == "mine"
    assert pliant("lab", command, ethanol, "-o", "out.txt", "--overwrite").code == 0
    assert (tmp_path / "out.txt").read_text().startswith("pliant-")
    assert "is both input and output" in pliant("lab", command, ethanol, "-o", ethanol).err


def test_an_ordering_is_printed_bar_by_bar(pliant, triangle):
    ended = pliant("lab", "order", triangle, "--ordering", "dfs_cycle", "--root", "b")
    assert ended.out == (
        "pliant-ordering 1\nbar b a tree\nbar a c tree\nbar b c non_tree\nbar c d tree\n"
    )
    bars = json.loads(pliant("lab", "order", triangle, "--ordering", "input", "--json").out)["bars"]
    assert [(bar["near"], bar["far"], bar["is_tree"]) for bar in bars] == [
        (0, 1, True),
        (1, 2, True),
        (2, 0, True),
        (2, 3, True),
    ]


def test_an_ordering_that_leaves_bars_out_is_refused(pliant, triangle):
    ended = pliant("lab", "order", triangle, "--ordering", "bfs_tree")
    assert (ended.code, ended.err) == (1, "pliant: error: ordering file: bar b - c is missing\n")


def test_a_run_with_an_ordering_file_is_that_of_its_technique(pliant, triangle, tmp_path):
    """One push on the root from which the file was made, so that both see the same ordering."""
    (tmp_path / "f.txt").write_text("pliant-forces 3\npush c 40 0 30\n")
    settings = ("--timestep", 0.01, "--tolerance-length", 1e-6, "--max-sweeps", 1000)
    assert pliant("lab", "order", triangle, "--root", "c", "-o", "o.txt").code == 0
    run = ("run", triangle, "--forces", "f.txt", "--weighting", 0.75, *settings)
    assert pliant(*run, "--ordering", "o.txt", "-o", "1.h5md").code == 0
    assert pliant(*run, "--technique", "bfs_cycle", "-o", "2.h5md").code == 0
    one, two = moved(tmp_path / "1.h5md"), moved(tmp_path / "2.h5md")
    assert one["observables/sweeps/value"][1] > 1
    assert_same(one, two)
    with h5py.File(tmp_path / "1.h5md") as file:
        assert file["parameters/run/technique"].asstr()[()] == "input"
        assert file["parameters/run/ordering"].asstr()[()] == "o.txt"


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("bar a zz tree", 'o.txt:2: joint: no joint is named "zz"'),
        ("bar a d tree", 'o.txt:2: bar "a" - "d": the framework has no such bar'),
        ("bar a b tree", "o.txt: bar b - c is missing: expected 4 bars, found 1"),
    ],
)
def test_a_bad_ordering_file_is_named(pliant, triangle, tmp_path, lines, message):
    (tmp_path / "o.txt").write_text(f"pliant-ordering 1\n{lines}\n")
    ended = pliant("run", triangle, "--ordering", "o.txt")
    assert (ended.code, ended.err) == (1, f"pliant: error: {message}\n")


def test_an_ordering_file_goes_with_no_other_technique(pliant, triangle, tmp_path):
    (tmp_path / "o.txt").write_text("")
    ended = pliant("run", triangle, "--ordering", "o.txt", "--technique", "blocks")
    assert ended.code == 2
    assert "--ordering: goes with --technique input or none, not with blocks" in ended.err


def test_one_graph_of_a_class(pliant, tmp_path):
    made = pliant("lab", "structgen", "2-cycle-tree", "--seed", 7, "--ring", 12, "--json")
    report = json.loads(made.out)
    assert (report["cycles"], report["output"]) == (2, "2-cycle-tree.xml")
    seen = json.loads(pliant("info", "2-cycle-tree.xml", "--json").out)
    assert (seen["joints"], seen["bars"], seen["cycles"], seen["components"]) == (
        report["joints"],
        report["bars"],
        2,
        1,
    )
    before = (tmp_path / "2-cycle-tree.xml").read_bytes()
    refused = pliant("lab", "structgen", "2-cycle-tree", "--seed", 8)
    assert refused.code == 1
    assert "2-cycle-tree.xml: exists already" in refused.err
    assert (tmp_path / "2-cycle-tree.xml").read_bytes() == before
    pliant("lab", "structgen", "2-cycle-tree", "--seed", 8, "--overwrite")
    assert (tmp_path / "2-cycle-tree.xml").read_bytes() != before


def test_a_generated_graph_runs_records_and_replays(pliant, tmp_path):
    assert pliant("lab", "structgen", "2-cycle-path", "-o", "g.xml").code == 0
    assert pliant("lab", "forcegen", "g.xml", "-o", "f.txt", "--steps", 12, "--force", 90).code == 0
    ended = pliant("run", "g.xml", "--forces", "f.txt", "--record-forces", "back.txt", "--json")
    assert (ended.code, json.loads(ended.out)["steps"]) == (0, 12)
    assert (tmp_path / "back.txt").read_text() == (tmp_path / "f.txt").read_text()


def test_a_test_set_reruns_to_what_its_graphs_and_forces_say(pliant, tmp_path):
    words = "--class tree,1-cycle-bar --graphs 3 --forces 4 --seed 2 --technique bfs_cycle"
    words += " --weighting 0.5,1 --json"
    made = pliant("lab", "structgen", "--test-set", "set", *words.split())
    assert made.code == 0
    assert json.loads(made.out)["classes"] == [
        {"name": name, "graphs": 3, "heuristics": ["bfs_cycle-0.5", "bfs_cycle-1"]}
        for name in ("tree", "1-cycle-bar")
    ]
    # A graph of the set is the graph of that number, its forces are those of forcegen.
    graph = tmp_path / "set/1-cycle-bar/graph-002"
    pliant("lab", "structgen", "1-cycle-bar", "--seed", 2, "--number", 2, "-o", "g.xml")
    assert (tmp_path / "g.xml").read_bytes() == (graph / "graph.xml").read_bytes()
    forces = graph / "heuristics/forces/forces-0.txt"
    words = ["--forces", forces, "--ordering", graph / "ordering.txt", "-o", "o.h5md"]
    run = pliant("run", graph / "graph.xml", *words)
    assert run.code == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "expected a class of graphs (tree, 1-cycle-bar, "),
        (("treee",), 'no class of graphs named "treee" (did you mean "tree"?)'),
        (("tree", "--test-set", "x"), "CLASS: does not go with --test-set"),
        (("tree", "--graphs", 2), "--graphs: goes with --test-set alone"),
        (("tree", "--ring", 2), '--ring: expected a whole number from 3, found "2"'),
        (
            ("--test-set", "x", "--weighting", "0.5,nan"),
            '--weighting: expected a number from 0 to 1, found "nan"',
        ),
        (("--test-set", "x", "--technique", "bfs"), 'no technique named "bfs"'),
        (("--test-set", "x", "--class", "tree,tree"), "classes: tree is given twice"),
    ],
)
def test_options_of_structgen_are_checked(pliant, tmp_path, arguments, message):
    ended = pliant("lab", "structgen", *arguments)
    assert ended.code == 2
    assert message in ended.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("lines", "options", "missing"),
    [
        ("", (), "--timestep, --tolerance, --max-sweeps"),
        ("set timestep 0.01\n", ("--max-sweeps", 10), "--tolerance"),
        ("set tolerance_length 0.1\nset max_sweeps 9\n", (), "--timestep"),
        ("set timestep 0.01\nset max_sweeps 9\n", ("--tolerance-length", 0.1), None),
    ],
)
def test_settings_that_no_one_gives_are_named(pliant, triangle, tmp_path, lines, options, missing):
    (tmp_path / "f.txt").write_text(f"pliant-forces 3\n{lines}push c 4 0 3\n")
    ended = pliant("run", triangle, "--forces", "f.txt", *options)
    if missing is None:
        assert (ended.code, ended.err) == (0, "")
    else:
        assert (ended.code, ended.err) == (
            1,
            f"pliant: error: f.txt: lacks settings, which must be given as options: {missing}\n",
        )
