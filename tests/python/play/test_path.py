# SPDX-License-Identifier: MIT
"""Paths that the page finds have the bits of the library."""

import numpy as np
import pytest
from pliant.jobs.path.walk import PathEnds, PathOptions, PathWalk
from real_files import PEPTIDE
from wasm_solver import Solver, sha1

import pliant

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


@pytest.fixture(scope="module")
def bent(tmp_path_factory):
    """The helix with what follows residue 10 turned by 60 degrees about its bond N-CA."""
    structure = pliant.read(PEPTIDE)
    positions, names = np.array(structure.positions), structure.names
    residues = structure.residue_ids
    n, ca = (positions[(residues == 10) & (names == name)][0] for name in ("N", "CA"))
    stays = (residues < 10) | ((residues == 10) & np.isin(names, ["N", "H", "CA", "HA"]))
    axis = (ca - n) / np.linalg.norm(ca - n)
    arms = positions[~stays] - n
    along = np.outer(arms @ axis, axis)
    turned = along + 0.5 * (arms - along) + np.sqrt(0.75) * np.cross(axis, arms)
    positions[~stays] = n + turned
    path = tmp_path_factory.mktemp("bent") / "bent.pdb"
    lines = [line for line in PEPTIDE.read_text().splitlines() if line.startswith("ATOM")]
    rows = zip(lines, positions, strict=True)
    text = (line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:] for line, place in rows)
    path.write_text("\n".join(text) + "\nEND\n")
    return path


def found_by_page(solver, end, **options):
    """Digests of the frames that are there when the path has ended, and the last reply."""
    solver.open(PEPTIDE, "auto")
    began = solver.ask("path", name=end.name, file=str(end), **options)
    frames = [began["positions"]["sha1"]]
    while True:
        reply = solver.ask("path_steps", milliseconds=1)
        frames[reply["kept"] :] = [frame["positions"]["sha1"] for frame in reply["frames"]]
        if reply["over"]:
            return frames, reply


@pytest.mark.parametrize("options", [{}, {"both": True}, {"atoms": "heavy"}], ids=str)
def test_the_path_of_the_page_is_that_of_the_library(solver, bent, options):
    frames, reply = found_by_page(solver, bent, **options)
    asked = PathOptions(**options)
    walk = PathWalk(PathEnds(pliant.read(PEPTIDE), pliant.read(bent), asked), asked)
    while walk.advance():
        pass
    assert reply["arrived"]
    assert len(frames) == len(walk) > 5
    assert frames == [sha1(positions) for positions in walk.positions()]
    assert reply["notes"][1:] == walk.notes[1:]  # the first names the file, by its path or not
    assert reply["left"] == walk.left


def test_a_detour_takes_the_place_of_frames(solver, tmp_path):
    """The mirror image is never reached: every attempt is made."""
    mirror = tmp_path / "mirror.pdb"
    mirror.write_text(
        "\n".join(
            line[:30] + f"{-float(line[30:38]):8.3f}" + line[38:]
            for line in PEPTIDE.read_text().splitlines()
            if line.startswith("ATOM")
        )
    )
    frames, reply = found_by_page(solver, mirror, backtrack=3, seed=1)
    path = pliant.path(PEPTIDE, mirror, backtrack=3, seed=1)
    assert reply["attempts"] == path.attempts == 3
    assert not reply["arrived"]
    assert frames == [sha1(positions) for positions in path.positions]


def test_what_cannot_be_is_refused(solver, bent):
    solver.open(PEPTIDE, "auto")
    stands = solver.ask("state")
    with pytest.raises(ValueError, match="path: none has been begun"):
        solver.ask("path_steps")
    with pytest.raises(ValueError, match="step = 9: must be at most 2 Angstrom"):
        solver.ask("path", name="bent.pdb", file=str(bent), step=9)
    with pytest.raises(ValueError, match="is it the same molecule"):
        dipeptide = PEPTIDE.with_name("caffeine.sdf")
        solver.ask("path", name=dipeptide.name, file=str(dipeptide))
    assert solver.ask("state") == stands
    with Solver() as fresh, pytest.raises(ValueError, match=r"^nothing is open$"):
        fresh.ask("path", name="bent.pdb", file=str(bent))
