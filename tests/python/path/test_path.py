# SPDX-License-Identifier: MIT
"""Paths between structures of adenylate kinase, open and closed."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from real_files import PEPTIDE

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.jobs.path.command import main
from pliant.jobs.path.walk import PathEnds, PathOptions, PathWalk

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


@pytest.fixture(scope="module")
def closing():
    return pliant.path(OPEN, CLOSED)


def fitted(points, goal):
    """r.m.s. distance after the best rotation and shift (Kabsch)."""
    one, other = points - points.mean(axis=0), goal - goal.mean(axis=0)
    u, values, vt = np.linalg.svd(one.T @ other)
    values[2] *= np.sign(np.linalg.det(u @ vt))
    left = np.sum(one**2) + np.sum(other**2) - 2 * values.sum()
    return np.sqrt(max(left, 0.0) / len(points))


def alpha_carbons(structure, positions):
    return positions[np.flatnonzero((structure.names == "CA") & (structure.elements == 6))]


@pytest.mark.parametrize(("start", "end"), [(OPEN, CLOSED), (CLOSED, OPEN)])
def test_arrives(start, end):
    path = pliant.path(start, end)
    assert path.arrived
    goal = pliant.read(end)
    there = fitted(
        alpha_carbons(path.model.structure, path.positions[-1]), alpha_carbons(goal, goal.positions)
    )
    assert there == pytest.approx(path.reached, abs=1e-6)
    assert there < 0.5
    assert path.frames[0].to_end > 6.5
    assert path.frames[0].from_start == pytest.approx(0, abs=1e-9)


def test_every_frame_is_exact(closing):
    bars, rest = closing.model.framework.bars, closing.model.framework.rest_lengths
    for positions in closing.positions:
        lengths = np.linalg.norm(positions[bars[:, 1]] - positions[bars[:, 0]], axis=1)
        assert np.max(np.abs(lengths - rest) / rest) < 1e-10


def test_atoms_keep_their_distance(closing):
    """Of heavy atoms of residues that are not neighbours, none comes nearer than at the start."""
    from scipy.spatial import cKDTree

    structure = closing.model.structure
    heavy = np.flatnonzero(structure.elements > 1)
    residue = structure.residue_of[heavy]

    def nearest(positions):
        pairs = cKDTree(positions[heavy]).query_pairs(3.0, output_type="ndarray")
        far = np.abs(residue[pairs[:, 0]] - residue[pairs[:, 1]]) > 1
        ends = positions[heavy][pairs[far]]
        return np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).min()

    least = nearest(closing.positions[0])
    assert min(nearest(positions) for positions in closing.positions) > min(least, 2.55) - 0.15


def test_steps_are_small(closing):
    for one, other in zip(closing.positions, closing.positions[1:], strict=False):
        carbons = [alpha_carbons(closing.model.structure, x) for x in (one, other)]
        assert fitted(*carbons) < 0.35


def test_a_walk_grows_step_by_step_into_the_path(closing):
    options = PathOptions()
    walk = PathWalk(PathEnds(pliant.read(OPEN), pliant.read(CLOSED), options), options)
    seen = [len(walk)]
    while walk.advance():
        assert len(walk) == seen[-1] + 1
        seen.append(len(walk))
        assert walk.positions(first=len(walk) - 1).shape == (1, 3341, 3)
    assert walk.is_over
    assert not walk.advance()
    assert np.array_equal(walk.positions(), closing.positions)
    assert walk.left == closing.reached
    assert [frame.lost for frame in walk.table()] == [frame.lost for frame in closing.frames]
    assert repr(closing.frames[0]) == "<pliant.PathFrame 0: 6.91 Angstrom from the end>"


def test_heavy_atoms_come_near():
    path = pliant.path(OPEN, CLOSED, atoms="heavy")
    assert path.arrived
    assert path.reached < 1.0


def test_the_command_writes_and_tells(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = [str(OPEN), str(CLOSED), "-o", "p.h5md", "--csv", "p.csv", "--json"]
    assert main(words) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["arrived"]
    assert report["residues_matched"] == 214
    with open("p.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    reader = pliant.H5mdReader("p.h5md")
    assert len(reader) == len(rows) == len(report["frames"])
    assert reader.positions(0).shape == (3341, 3)
    assert float(rows[-1]["to_end"]) == pytest.approx(report["rmsd_reached"])
    assert main(words) == 2
    assert "--csv p.csv: exists; --overwrite replaces it" in capsys.readouterr().err
    assert main([str(OPEN), str(OPEN), "-o", "q.h5md"]) == 2


def test_a_path_is_written_as_models_of_a_pdb_file(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main([str(OPEN), str(CLOSED), "-o", "p.h5md"]) == 0
    assert main([str(OPEN), str(CLOSED), "-o", "p.pdb"]) == 0
    assert "PliantWarning" not in capsys.readouterr().err
    reader = pliant.H5mdReader("p.h5md")
    models = Path("p.pdb").read_text().count("MODEL ")
    assert models == len(reader)
    last = pliant.read("p.pdb", model=models).positions
    assert last == pytest.approx(reader.positions(models - 1), abs=1e-3)


def dimer(path, shift):
    """Two peptides, chain B turned about x and moved by `shift`."""
    lines = [line for line in PEPTIDE.read_text().splitlines() if line.startswith("ATOM")]
    moved = []
    for line in lines:
        x, y, z = (float(line[k : k + 8]) for k in (30, 38, 46))
        place = (x + shift[0], shift[1] - y, shift[2] - z)
        moved.append(f"{line[:21]}B{line[22:30]}{''.join(f'{v:8.3f}' for v in place)}{line[54:]}")
    path.write_text("\n".join([*lines, "TER", *moved, "TER", "END", ""]))
    return path


def test_chains_that_are_arranged_differently_are_told_and_one_can_be_chosen(
    tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    start, end = dimer(tmp_path / "a.pdb", (30, 0, 0)), dimer(tmp_path / "b.pdb", (0, 40, 0))
    (note,) = [
        note
        for note in PathEnds(pliant.read(start), pliant.read(end), PathOptions()).notes
        if "are arranged differently" in note
    ]
    carbons = [alpha_carbons(s, s.positions) for s in (pliant.read(start), pliant.read(end))]
    assert note == (
        "chains A, B are arranged differently in the two structures: superposed all together they "
        f"are {round(fitted(*carbons), 2):g} Angstrom apart, one by one 0; "
        '--select "chainID A" follows one'
    )
    assert main(["a.pdb", "b.pdb", "-o", "p.h5md", "--select", "chainID A"]) == 0
    assert "are arranged differently" not in capsys.readouterr().out


def test_chains_that_move_together_are_not_said_to_be_arranged_differently(tmp_path):
    start, end = dimer(tmp_path / "a.pdb", (30, 0, 0)), dimer(tmp_path / "b.pdb", (30.5, 0, 1))
    notes = PathEnds(pliant.read(start), pliant.read(end), PathOptions()).notes
    assert not any("are arranged differently" in note for note in notes)
