# SPDX-License-Identifier: MIT
"""Test sets as folders: filled by an experiment, read back, and rerun to the same numbers."""

import csv
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from pliant.lab.experiment import command, folders
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.settings import Settings

import pliant

WORDS = (
    "--seed 5 --graphs 2 --forces 6 --class tree --class 2-cycle-path --technique "
    "bfs_cycle --technique bfs_tree --technique dfs_reverse --technique blocks --workers "
    "1 --quiet"
).split()


@pytest.fixture
def filled(tmp_path, capsys):
    """A test set made and filled by an experiment, and the experiment's folder."""
    words = ["--output", str(tmp_path / "study"), "--test-set", str(tmp_path / "set"), *WORDS]
    assert command.main(words) == 0
    assert "34 results written, 0 there already" in capsys.readouterr().out
    return tmp_path


def test_folders_have_what_the_table_has(filled):
    table = tables.read(filled / "study")
    made = pliant.read_test_set(filled / "set")
    path = filled / "set" / "2-cycle-path" / "graph-001" / "heuristics" / "dfs_reverse-0.75"
    with open(path / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = table.columns
    keep = (columns["class"] == b"2-cycle-path") & (columns["graph"] == 1)
    keep &= (columns["technique"] == b"dfs_reverse") & (columns["weighting"] == 0.75)
    for name in ("sweeps", "passes", "projections", "final_residual"):
        assert [float(row[name]) for row in rows] == columns[name][keep].tolist()
    heuristics = made.class_named("2-cycle-path").graphs[1].heuristics
    summary = next(h for h in heuristics if h.name == "dfs_reverse-0.75").results
    assert summary.mean == pytest.approx(np.mean(columns["sweeps"][keep]), rel=1e-12)
    assert summary.converged == columns["converged"][keep].sum()


def test_results_xml_names_every_heuristic(filled):
    root = ET.parse(filled / "set" / "results.xml").getroot()
    found = {
        kind.get("name"): [
            len(graph.findall("heuristic/results")) for graph in kind.findall("graph")
        ]
        for kind in root.findall("class")
    }
    assert found == {"tree": [10, 10], "2-cycle-path": [7, 7]}


def test_read_back_and_rerun_to_the_same_numbers(filled, capsys):
    words = ["--output", str(filled / "again"), "--test-set", str(filled / "set"), "--quiet"]
    assert command.main(words) == 0
    assert (
        "0 results written, 34 there already and the same, 0 different" in capsys.readouterr().out
    )
    one, two = (tables.read(filled / name) for name in ("study", "again"))
    for name in tables.COLUMNS:
        assert one.columns[name].tolist() == two.columns[name].tolist()


def test_other_numbers_are_reported_and_left(filled, capsys):
    made = pliant.read_test_set(filled / "set")
    rows = made.read_results("tree", 0, "bfs_tree", 1.0)
    rows.pop("force")
    rows["sweeps"] = rows["sweeps"] + 1
    made.write_results("tree", 0, "bfs_tree", 1.0, *rows.values())
    made.save()
    words = ["--output", str(filled / "again"), "--test-set", str(filled / "set"), "--quiet"]
    assert command.main(words) == 1
    ended = capsys.readouterr()
    assert "33 there already and the same, 1 different" in ended.out
    assert "bfs_tree-1: holds other numbers; they were left" in ended.err
    again = pliant.read_test_set(filled / "set").read_results("tree", 0, "bfs_tree", 1.0)
    assert again["sweeps"].tolist() == rows["sweeps"].tolist()


def test_a_set_of_structgen_is_run_and_its_own_graphs_are_used(tmp_path, capsys):
    counts = {"graphs": 2, "forces": 5, "force_files": 2, "seed": 9}
    of = {"classes": ["1-cycle-ring"], "techniques": ["bfs_cycle"]}
    pliant.write_test_set(tmp_path / "set", **counts, **of)
    words = ["--output", str(tmp_path / "study"), "--test-set", str(tmp_path / "set"), "--quiet"]
    assert command.main(words) == 0
    table = tables.read(tmp_path / "study")
    assert (len(table), set(table.columns["technique"])) == (30, {b"bfs_cycle"})
    # The same from its numbers alone, as generate() and make_force_file() have it.
    options = "--seed 9 --graphs 2 --forces 5 --class 1-cycle-ring --technique bfs_cycle --quiet"
    words = ["--output", str(tmp_path / "made"), *options.split()]
    assert command.main(words) == 0
    again = tables.read(tmp_path / "made")
    assert again.columns["final_residual"].tolist() == table.columns["final_residual"].tolist()
    assert pliant.read_test_set(tmp_path / "set").classes[0].graphs[0].heuristics[0].results
    assert capsys.readouterr().err == ""


def test_an_experiment_knows_its_test_set(tmp_path, capsys):
    """A folder of results is not taken for that of another set with the same settings."""
    for name, seed in (("one", 1), ("two", 1)):
        of = {"classes": ["tree"], "techniques": ["bfs_tree"]}
        pliant.write_test_set(tmp_path / name, graphs=1, forces=3, seed=seed, **of)
    path = tmp_path / "two" / "tree" / "graph-000" / "heuristics" / "forces" / "forces-0.txt"
    text = path.read_text()
    path.write_text(text.replace("\npush", "\n# moved\npush", 1))
    assert folders.settings_of_set(tmp_path / "one") == folders.settings_of_set(tmp_path / "two")
    line = next(row for row in text.split("\n") if row.startswith("push"))
    path.write_text(text.replace(line, " ".join([*line.split()[:2], "1", "2", "3"])))
    assert folders.settings_of_set(tmp_path / "one") != folders.settings_of_set(tmp_path / "two")
    words = ["--output", str(tmp_path / "study"), "--quiet", "--test-set"]
    assert command.main([*words, str(tmp_path / "one")]) == 0
    assert command.main([*words, str(tmp_path / "two")]) == 2
    assert "holds another experiment: test_set_digest" in capsys.readouterr().err


def test_folders_of_other_settings_are_refused(filled, capsys):
    words = [*WORDS, "--output", str(filled / "more"), "--test-set", str(filled / "set")]
    assert command.main([*words, "--force", "60"]) == 2
    assert "holds another test set: force 50.0 there, 60.0 asked" in capsys.readouterr().err


def test_a_set_half_made_is_made_again(tmp_path):
    (tmp_path / "set.part" / "tree").mkdir(parents=True)
    folders.make_set(
        Settings(graphs=1, forces=2, classes=("tree",), techniques=("bfs_tree",)), tmp_path / "set"
    )
    assert sorted(path.name for path in tmp_path.iterdir()) == ["set"]
    assert len(pliant.read_test_set(tmp_path / "set").classes) == 1
