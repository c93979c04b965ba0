# SPDX-License-Identifier: MIT
"""What force files say of how they were made, and what `pliant run --forces` makes of it."""

import json

import numpy as np
import pytest
from h5md_contents import positions_in
from real_files import PEPTIDE

SESSION = "set technique froda\nforce 4 900 40 -70\nstep 3\nforce 7 100 0 0\nstep\n"


@pytest.fixture
def forces(pliant, tmp_path):
    """Random pushes for a model that is not the one that a run takes by itself."""
    made = pliant("lab", "forcegen", PEPTIDE, "--model", "protein", "--steps", 4, "-o", "f.txt")
    assert made.code == 0, made.err
    return tmp_path / "f.txt"


@pytest.fixture
def session(forces, tmp_path):
    """What a page would write: the same header, and events."""
    head = "".join(forces.read_text().partition("set ")[0])
    (tmp_path / "s.txt").write_text(head + SESSION)
    return tmp_path / "s.txt"


@pytest.mark.parametrize("name", ["f.txt", "s.txt"])
def test_the_model_comes_from_the_file(pliant, session, tmp_path, name):
    ended = pliant("run", PEPTIDE, "--forces", name, "-o", "a.h5md", "--json")
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    assert report["bars"] == 950
    assert report["forces"]["taken"]["model"] == "protein"
    assert pliant("run", PEPTIDE, "--model", "protein", "--forces", name, "-o", "b.h5md").code == 0
    np.testing.assert_array_equal(
        positions_in(tmp_path / "a.h5md"), positions_in(tmp_path / "b.h5md")
    )


CONTRADICTIONS = [
    (["--model", "bonds"], "--model bonds: f.txt was made with --model protein"),
    (["--bars", "angles"], "--bars angles: f.txt was made with --model protein"),
    (["--pin", "name CA"], "--pin name CA: f.txt was made without --pin"),
    (["--all-hydrogens"], "--all-hydrogens: f.txt was made without --all-hydrogens"),
    (["--tolerance", "0.001"], "--tolerance 0.001: f.txt was made with --tolerance 1e-06"),
    (
        ["--tolerance-length", "0.1"],
        "--tolerance-length 0.1: f.txt was made with --tolerance 1e-06",
    ),
    (["--timestep", "0.02"], "--timestep 0.02: f.txt was made with --timestep 0.01"),
]


@pytest.mark.parametrize(("options", "message"), CONTRADICTIONS)
def test_what_contradicts_the_file_is_refused(pliant, forces, tmp_path, options, message):
    run = ("run", PEPTIDE, "--forces", "f.txt", *options)
    ended = pliant(*run)
    assert ended.code == 2
    assert ended.err.splitlines()[-1] == (f"pliant: error: {message}; leave the option out")
    assert not list(tmp_path.glob("*.h5md"))


def test_any_technique_may_resolve_random_pushes(pliant, forces):
    run = ("run", PEPTIDE, "--forces", "f.txt", "--dry-run", "--technique")
    assert [pliant(*run, name).code for name in ("froda", "bfs_cycle", "newton")] == [0, 0, 0]


def test_another_structure_is_refused(pliant, forces, tmp_path):
    text = PEPTIDE.read_text()
    (tmp_path / "moved.pdb").write_text(text)  # the name does not count
    assert pliant("run", "moved.pdb", "--forces", "f.txt", "--dry-run").code == 0
    atom = next(line for line in text.splitlines() if line.startswith("ATOM"))
    moved = atom[:30] + f"{float(atom[30:38]) + 0.001:8.3f}" + atom[38:]
    (tmp_path / "moved.pdb").write_text(text.replace(atom, moved, 1))
    run = ("run", "moved.pdb", "--forces", "f.txt", "--dry-run")
    ended = pliant(*run)
    assert ended.code == 1
    assert "f.txt: was made for another structure: with fingerprint " in ended.err
    assert ended.err.endswith("as of moved.pdb\n")


def test_a_file_without_a_model_is_a_guess(pliant, tmp_path):
    (tmp_path / "s.txt").write_text("pliant-forces 3\nset technique froda\nstep\n")
    run = ("run", PEPTIDE, "--forces", "s.txt", "--dry-run")
    assert (
        "warning: s.txt: does not say for which structure, model and hydrogens it was made: 327 "
        "joints and --bars bonds are a guess; give its --model or --bars\n" in pliant(*run).err
    )
    assert "warning" not in pliant(*run, "--model", "protein").err


def test_a_dry_run_says_what_was_taken(pliant, forces):
    run = ("run", PEPTIDE, "--forces", "f.txt", "--dry-run")
    assert pliant(*run).out == (
        "force file      f.txt: model protein, timestep 0.01, tolerance 1e-06, max_sweeps 10000\n"
    )
    assert json.loads(pliant(*run, "--json").out)["forces"]["taken"]["timestep"] == "0.01"


def test_a_replay_goes_on(pliant, forces, tmp_path):
    run = ("run", PEPTIDE, "--forces", "f.txt")
    assert pliant(*run, "-o", "whole.h5md").code == 0
    assert pliant(*run, "-o", "part.h5md", "--steps", 2).code == 0
    forces.unlink()
    assert pliant("run", "--continue", "part.h5md", "--steps", 4).code == 0
    np.testing.assert_array_equal(
        positions_in(tmp_path / "whole.h5md"), positions_in(tmp_path / "part.h5md")
    )


def test_a_recorded_run_is_repeated_by_its_technique(pliant, tmp_path):
    run = ("run", PEPTIDE, "--model", "angles", "--technique", "newton", "--damping", 0.25)
    assert pliant(*run, "--steps", 4, "--record-forces", "f.txt", "-o", "a.h5md").code == 0
    report = json.loads(pliant("run", PEPTIDE, "--forces", "f.txt", "-o", "b.h5md", "--json").out)
    assert report["technique"] == "newton"
    assert report["forces"]["taken"]["damping"] == "0.25"
    np.testing.assert_array_equal(
        positions_in(tmp_path / "a.h5md"), positions_in(tmp_path / "b.h5md")
    )
