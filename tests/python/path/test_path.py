# SPDX-License-Identifier: MIT
"""Paths between structures of adenylate kinase, open and closed."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

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


def test_what_both_have_is_held(closing):
    contacts = closing.model.contacts
    assert len(contacts) == closing.held > 100
    for positions in closing.positions:
        apart = np.linalg.norm(positions[contacts["a"]] - positions[contacts["b"]], axis=1)
        assert np.all(apart < contacts["most"] + 0.02)
        assert np.all(apart > contacts["least"] - 0.02)


def test_contacts_of_one_end_come_and_go(closing):
    first, last = closing.frames[0], closing.frames[-1]
    assert first.lost == 0
    assert last.lost > 0.3 * closing.only_start
    assert last.made > first.made


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


def test_twice_the_same(closing):
    assert np.array_equal(pliant.path(OPEN, CLOSED).positions, closing.positions)


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


def test_options_have_the_ranges_of_the_command():
    with pytest.raises(pliant.OptionError, match="backtrack = 1001: must be at most 1000"):
        PathOptions(backtrack=1001)
    with pytest.raises(pliant.OptionError, match="seed = -1: must be a whole number from 0"):
        PathOptions(seed=-1)


def test_heavy_atoms_come_near():
    path = pliant.path(OPEN, CLOSED, atoms="heavy")
    assert path.arrived
    assert path.reached < 1.0


def test_other_numbers_are_matched_by_sequence(tmp_path, closing):
    rows = []
    for line in CLOSED.read_text().splitlines(keepends=True):
        is_atom = line.startswith("ATOM")
        rows.append(f"{line[:22]}{int(line[22:26]) + 300:4d}{line[26:]}" if is_atom else line)
    (tmp_path / "renumbered.pdb").write_text("".join(rows))
    path = pliant.path(OPEN, tmp_path / "renumbered.pdb")
    assert path.matched == 214
    assert np.array_equal(path.positions, closing.positions)
    assert any("214 of our 214 residues" in note for note in path.notes)


def test_what_makes_no_sense_is_refused(tmp_path):
    with pytest.raises(pliant.OptionError, match='no atoms named "all"; known: CA, heavy'):
        pliant.path(OPEN, CLOSED, atoms="all")
    with pytest.raises(pliant.OptionError, match="step = 0: must be positive"):
        pliant.path(OPEN, CLOSED, step=0)
    with pytest.raises(pliant.InputError, match="is it the same molecule"):
        pliant.path(OPEN, DATA / "1a28.pdb.gz")


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


def test_atoms_that_are_alike_are_one(tmp_path, closing):
    """The names of both O of ASP and GLU are a matter of chance."""
    swapped = {"OD1": "OD2", "OD2": "OD1", "OE1": "OE2", "OE2": "OE1"}
    rows = []
    for line in CLOSED.read_text().splitlines(keepends=True):
        name = line[12:16].strip()
        if line.startswith("ATOM") and line[17:20] in ("ASP", "GLU") and name in swapped:
            line = f"{line[:12]} {swapped[name]:3s}{line[16:]}"
        rows.append(line)
    (tmp_path / "swapped.pdb").write_text("".join(rows))
    path = pliant.path(OPEN, tmp_path / "swapped.pdb")
    assert path.held == closing.held


def test_the_same_structure_is_no_way():
    path = pliant.path(OPEN, OPEN)
    assert path.arrived
    assert len(path.frames) == 1


def test_small_steps_are_no_reason_to_stop():
    path = pliant.path(OPEN, CLOSED, step=0.02)
    assert path.frames[20].to_end < path.frames[0].to_end - 0.3


PEPTIDE = Path(__file__).parents[3] / "data" / "molecules" / "peptide_20.pdb"


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
