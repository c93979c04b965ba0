# SPDX-License-Identifier: MIT
"""The table of pliant lab experiment: what is in it, the same again and after a kill."""

import csv
import dataclasses
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from pliant.lab.experiment import command, laboratory
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.laboratory import run_experiment
from pliant.lab.experiment.settings import NO_WEIGHTING, Settings, reverse_techniques
from pliant.lab.experiment.subject import make_subject, measure_subject

import pliant

SMALL = Settings(seed=7, graphs=3, forces=8)


def rows_of(folder):
    with open(folder / "table.csv", newline="") as file:
        return list(csv.DictReader(file))


def select(table, **wanted):
    keep = np.ones(len(table), bool)
    for name, value in wanted.items():
        column = table.columns["class" if name == "kind" else name]
        keep &= column == (value.encode() if isinstance(value, str) else value)
    return keep


def test_every_class_graph_force_technique_and_weighting_has_one_row(experiment_folder):
    rows = rows_of(experiment_folder)
    found = {(r["class"], r["graph"], r["force"], r["technique"], r["weighting"]) for r in rows}
    assert len(found) == len(rows)
    forests = {row.name for row in pliant.techniques() if row.forests_only}
    tried = [row for row in pliant.techniques() if row.name != "auto"]
    combinations = sum(3 if row.has_weighting else 1 for row in tried)
    kinds = len(pliant.graph_classes())
    assert len(rows) == 24 * (kinds * combinations - (kinds - 1) * 3 * len(forests))
    assert {r["technique"] for r in rows if r["class"] != "tree"}.isdisjoint(forests)
    assert {r["weighting"] for r in rows if r["technique"] == "blocks"} == {""}


def test_csv_and_hdf5_hold_the_same(experiment_folder):
    rows, table = rows_of(experiment_folder), tables.read(experiment_folder)
    assert list(rows[0]) == list(tables.COLUMNS)
    for name in ("graph", "force", "sweeps", "passes", "projections", "final_residual"):
        assert [float(row[name]) for row in rows] == table.columns[name].tolist()
    for name in ("class", "technique"):
        assert [row[name].encode() for row in rows] == table.columns[name].tolist()
    assert [row["converged"] == "true" for row in rows] == table.columns["converged"].tolist()
    weightings = [float(row["weighting"] or NO_WEIGHTING) for row in rows]
    assert weightings == table.columns["weighting"].tolist()


def test_two_runs_give_the_same_bytes_on_any_number_of_processes(experiment_folder, tmp_path):
    run_experiment(SMALL, tmp_path / "again", workers=2)
    for name in ("table.csv", "table.h5", "settings.json"):
        assert (tmp_path / "again" / name).read_bytes() == (experiment_folder / name).read_bytes()


def test_another_seed_gives_another_table(experiment_folder, tmp_path):
    settings = dataclasses.replace(SMALL, seed=8, classes=("tree",))
    other = run_experiment(settings, tmp_path / "other")
    assert other.columns["sweeps"].tolist() != (
        tables.read(experiment_folder).columns["sweeps"][: len(other)].tolist()
    )


def test_numbers_are_those_of_pliant_run():
    """Forces in turn are what a run replays; the first of them begins at rest in both ways."""
    in_turn = dataclasses.replace(SMALL, consecutive=True, forces=12)
    subject = make_subject(in_turn, "2-cycle-path", 2)
    for technique, weighting in (("bfs_cycle", 0.5), ("random", 1.0), ("dfs_reverse", 0.75)):
        place = in_turn.combinations(subject.kind).index((technique, weighting))
        rows = measure_subject(subject, in_turn)
        rows = rows[rows["combination"] == place]
        frames = []

        def look(f, kept=frames):
            kept.append((f.sweeps, f.projections, f.max_residual))

        way = {"technique": technique, "weighting": weighting, "tolerance_length": 0.01}
        way |= {"steps": 12, "seed": 7, "walker": 2, "observers": [look]}
        pliant.run(subject.framework, subject.positions.copy(), **way)
        assert frames[1:] == rows[["sweeps", "projections", "final_residual"]].tolist()
        at_rest = measure_subject(subject, dataclasses.replace(in_turn, consecutive=False))
        at_rest = at_rest[at_rest["combination"] == place]
        assert at_rest[0]["final_residual"] == rows[0]["final_residual"]


def test_on_trees_cycle_orderings_are_the_tree_orderings(experiment_folder):
    table = tables.read(experiment_folder)
    for name in ("sweeps", "projections", "final_residual"):
        column = table.columns[name]
        for search in ("bfs", "dfs"):
            tree, cycle = (
                column[select(table, kind="tree", technique=f"{search}_{word}")].tolist()
                for word in ("tree", "cycle")
            )
            assert tree == cycle


def test_passes_are_half_the_sweeps_of_reverse_techniques_only(experiment_folder):
    columns = tables.read(experiment_folder).columns
    reverse = np.isin(columns["technique"], [name.encode() for name in reverse_techniques()])
    assert reverse.any() and not reverse.all()
    assert np.all(columns["passes"][~reverse] == columns["sweeps"][~reverse])
    assert np.all(columns["passes"][reverse] == np.ceil(columns["sweeps"][reverse] / 2))


def test_reverse_is_cycle_in_its_first_sweep(experiment_folder):
    table = tables.read(experiment_folder)
    cycle, reverse = (
        table.columns["sweeps"][select(table, technique=name, weighting=1.0)] == 1
        for name in ("bfs_cycle", "bfs_reverse")
    )
    assert cycle.any() and cycle.tolist() == reverse.tolist()


def test_what_is_done_is_not_done_again(tmp_path, monkeypatch):
    settings = dataclasses.replace(SMALL, classes=("tree", "1-cycle-bar"))
    stop_after = 4

    def interrupted(settings, kind, number):
        nonlocal stop_after
        if stop_after == 0:
            raise KeyboardInterrupt
        stop_after -= 1
        return make_subject(settings, kind, number)

    with pytest.raises(KeyboardInterrupt):
        run_experiment(settings, tmp_path / "cut", source=interrupted)
    assert not (tmp_path / "cut" / "table.csv").exists()
    stop_after = 2  # just enough for what is missing
    run_experiment(settings, tmp_path / "cut", source=interrupted)
    run_experiment(settings, tmp_path / "whole")
    for name in ("table.csv", "table.h5"):
        assert (tmp_path / "cut" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
    stop_after = 0
    run_experiment(settings, tmp_path / "cut", source=interrupted)  # nothing is missing
    assert not (tmp_path / "cut" / laboratory.PARTS).exists()


def test_killed_and_run_again(tmp_path, experiment_folder):
    words = [
        sys.executable,
        *"-m pliant.lab.experiment.command --output".split(),
        str(tmp_path / "study"),
        *"--seed 7 --graphs 3 --forces 8 --workers 2".split(),
    ]
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL, start_new_session=True)
    parts = tmp_path / "study" / "parts"
    until = time.monotonic() + 900
    while time.monotonic() < until and child.poll() is None:
        if parts.is_dir() and len(list(parts.glob("*.npy"))) >= 2:
            break
        time.sleep(0.001)
    os.killpg(child.pid, signal.SIGKILL)
    child.wait()
    assert subprocess.run(words, stdout=subprocess.DEVNULL, timeout=900).returncode == 0
    for name in ("table.csv", "table.h5"):
        assert (tmp_path / "study" / name).read_bytes() == (experiment_folder / name).read_bytes()


def test_interrupted_it_ends_at_once(tmp_path):
    words = [
        sys.executable,
        *"-m pliant.lab.experiment.command --output".split(),
        str(tmp_path / "study"),
        *"--graphs 2000 --workers 2".split(),
    ]
    child = subprocess.Popen(
        words,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    until = time.monotonic() + 900
    while time.monotonic() < until and not list(tmp_path.glob("study/parts/*.npy")):
        time.sleep(0.02)
    child.send_signal(signal.SIGINT)
    try:
        assert "interrupted" in child.communicate(timeout=900)[1]
        assert child.returncode == 130
    finally:
        if child.poll() is None:
            os.killpg(child.pid, signal.SIGKILL)


def test_a_folder_of_another_experiment_is_refused(experiment_folder, capsys):
    words = ["--output", str(experiment_folder), "--seed", "7", "--graphs", "3", "--forces", "9"]
    assert command.main(words) == 2
    assert "holds another experiment: forces 8 there, 9 asked" in capsys.readouterr().err


def test_an_empty_folder_is_taken(tmp_path, capsys):
    (tmp_path / "new").mkdir()
    words = [
        "--output",
        str(tmp_path / "new"),
        *"--class tree --graphs 1 --forces 2 --technique bfs_tree --workers 1".split(),
    ]
    assert command.main(words) == 0
    assert (tmp_path / "new" / "table.csv").is_file()


def test_a_folder_of_something_else_is_refused(tmp_path, capsys):
    (tmp_path / "thesis.txt").write_text("mine")
    assert command.main(["--output", str(tmp_path)]) == 2
    assert "is there and holds no experiment" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--technique", "bfs"], 'no technique named "bfs"; known: auto, random, '),
        (["--class", "ring"], "no class 'ring'; there is tree, "),
        (["--weighting", "1.5"], "weighting = 1.5: must be from 0 to 1"),
        (["--class", "tree", "--class", "tree"], "class tree is named twice"),
        (["--graphs", "0"], "expected a whole number from 1, found '0'"),
        (["--depth", "63"], "depth = 63, children = 3, ring = 8, joints = 0: make more than 10"),
        (["--children", "1000000"], "make more than 100000000 joints"),
        (["--workers", "100000"], "expected a whole number from 1 to 1024, found '100000'"),
        (["--tolerance-length", "-1"], "expected a number above 0, found '-1'"),
    ],
)
def test_bad_options(words, message, tmp_path, capsys):
    try:
        code = command.main(["--output", str(tmp_path / "new"), *words])
    except SystemExit as ended:
        code = ended.code
    assert code == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


def test_the_command_says_what_it_did(tmp_path, capsys):
    words = [
        "--output",
        str(tmp_path / "new"),
        *"--class tree --graphs 2 --forces 3 --technique bfs_tree --workers 1".split(),
    ]
    assert command.main(words) == 0
    assert "18 resolves, 0 of them not converged" in capsys.readouterr().out
