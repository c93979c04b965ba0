# SPDX-License-Identifier: MIT
"""Paths that stick: going back and trying again, and both ends moved towards each other."""

import json
from pathlib import Path

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.jobs.path.command import main

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def turned(structure, positions, residue, degrees):
    """Positions with what follows a residue turned about its bond N-CA (phi)."""
    positions = np.array(positions)
    names, residues = structure.names, structure.residue_of.astype(int)
    n, ca = (np.flatnonzero((residues == residue) & (names == x))[0] for x in ("N", "CA"))
    beyond = ~np.isin(names, ["N", "HN", "H", "CA", "HA"])
    moved = (residues > residue) | ((residues == residue) & beyond)
    axis = (positions[ca] - positions[n]) / np.linalg.norm(positions[ca] - positions[n])
    angle, arms = np.radians(degrees), positions[moved] - positions[n]
    along = np.outer(arms @ axis, axis)
    across = np.cross(axis, arms)
    positions[moved] = (
        positions[n] + along + np.cos(angle) * (arms - along) + np.sin(angle) * across
    )
    return positions


@pytest.fixture(scope="module")
def hairpin(tmp_path_factory):
    """Residues 1 to 30 of adenylate kinase, and the same with two torsions turned by half.

    On the straight way from the second to the first the helix would pass through the strand.
    """
    folder = tmp_path_factory.mktemp("hairpin")
    lines = [
        line
        for line in OPEN.read_text().splitlines(keepends=True)
        if line.startswith("ATOM") and int(line[22:26]) <= 30
    ]
    straight, bent = folder / "straight.pdb", folder / "bent.pdb"
    straight.write_text("".join(lines) + "END\n")
    structure = pliant.read(straight)
    positions = turned(structure, turned(structure, structure.positions, 6, 180), 9, 180)
    text = "".join(
        line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:]
        for line, place in zip(lines, positions, strict=True)
    )
    bent.write_text(text + "END\n")
    return bent, straight


def assert_exact(path):
    bars, rest = path.model.framework.bars, path.model.framework.rest_lengths
    ends = path.positions[:, bars]
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    assert np.max(np.abs(lengths - rest) / rest) < 1e-10


def test_the_straight_way_sticks(hairpin):
    path = pliant.path(*hairpin)
    assert not path.arrived
    assert path.reached > 1.0
    assert path.attempts == 0


# Of the seeds from 0 to 15, 12 arrive within ten attempts.
@pytest.mark.parametrize("seed", [0, 1, 4])
def test_going_back_finds_a_way_round(hairpin, seed):
    path = pliant.path(*hairpin, backtrack=10, seed=seed)
    assert path.arrived
    assert 1 <= path.attempts <= 10
    assert len(path.frames) == len(path.positions)
    assert [frame.step for frame in path.frames] == list(range(len(path.frames)))
    assert_exact(path)


def test_a_way_round_is_one_way(hairpin):
    """What led nowhere is not part of it: each frame is near the one before."""
    path = pliant.path(*hairpin, backtrack=10)
    moves = np.linalg.norm(np.diff(path.positions, axis=0), axis=2)
    assert np.sqrt(np.mean(moves**2, axis=1)).max() < 2.5


def test_what_arrives_makes_no_detour():
    plain, ready = pliant.path(OPEN, CLOSED), pliant.path(OPEN, CLOSED, backtrack=10)
    assert ready.attempts == 0
    assert np.array_equal(plain.positions, ready.positions)


def test_the_tightest_places_are_named():
    """By an oracle of its own: least distances of the framework's sterics by their kinds."""
    path = pliant.path(OPEN, CLOSED)
    structure = path.model.structure
    frame = max(path.frames, key=lambda one: one.overlap)
    place = path.tight_places()[0]
    assert (place.atoms, place.overlap, place.step) == (frame.tightest, frame.overlap, frame.step)
    ends = []
    for label in frame.tightest.split(" - "):
        residue, name = label.split()
        number = int("".join(x for x in residue.partition(":")[2] or residue if x.isdigit()))
        found = np.flatnonzero((structure.residue_ids == number) & (structure.names == name))
        assert len(found) == 1
        ends.append(found[0])
    sterics = path.model.framework.sterics
    kinds = np.asarray(sterics.kinds)[ends]
    least = sterics.least[kinds[0], kinds[1]]
    apart = np.linalg.norm(np.diff(path.positions[frame.step][ends], axis=0))
    assert 0 < frame.overlap <= least - apart + 1e-9


def test_the_command_goes_back(hairpin, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = [str(hairpin[0]), str(hairpin[1]), "-o", "p.h5md"]
    assert main(words) == 3
    assert "--both and --backtrack try other ways round" in capsys.readouterr().out
    assert main([*words, "--overwrite", "--json", "--backtrack"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["attempts"] >= 1
    assert len(pliant.H5mdReader("p.h5md")) == len(report["frames"])
    assert set(report["frames"][0]) >= {"to_end", "lost", "made", "overlap", "tightest"}
    assert main([*words, "--overwrite", "--both"]) in (0, 3)
    assert "the two ends " in capsys.readouterr().err


def test_an_analysis_knows_a_path(hairpin, tmp_path):
    from pliant.trajectory.kind import TRANSITION
    from pliant.trajectory.opened import one_file

    seed = 2**64 - 1
    pliant.path(*hairpin, output=tmp_path / "p.h5md", both=True, backtrack=2, seed=seed)
    frames = one_file(tmp_path / "p.h5md")
    kept = {name: value for name, value in frames.parameters.items() if name.startswith("path/")}
    assert kept["path/end"] == "straight.pdb"
    assert (kept["path/both"], kept["path/backtrack"], kept["path/seed"]) == (True, 2, str(seed))
    assert frames.kind == TRANSITION


def test_a_page_of_a_path_claims_no_errors(hairpin, tmp_path):
    pliant.path(*hairpin, output=tmp_path / "p.h5md", backtrack=2)
    pliant.analyse(tmp_path / "p.h5md", tmp_path / "out", dpi=50)
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8").split("<script")[0]
    assert "A path from one structure to another" in page
    assert "move most on the way" in page
    assert "standard errors" not in page
