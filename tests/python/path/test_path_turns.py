# SPDX-License-Identifier: MIT
"""Paths between ends whose parts differ by large turns: pieces turn as wholes, along arcs."""

import json

import numpy as np
import pytest
from pliant.jobs.path.command import main
from pliant.jobs.path.walk import PathEnds, PathOptions, PathWalk
from real_files import PEPTIDE

import pliant

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def turned(structure, residue, degrees):
    """Positions with what follows a residue (from 0) turned about its bond CA-C (psi)."""
    positions, names = np.array(structure.positions), structure.names
    residues = structure.residue_of.astype(int)
    a, b = (positions[(residues == residue) & (names == name)][0] for name in ("CA", "C"))
    moved = (residues > residue) | ((residues == residue) & (names == "O"))
    axis, angle, arms = (b - a) / np.linalg.norm(b - a), np.radians(degrees), positions[moved] - a
    along = np.outer(arms @ axis, axis)
    across = np.cross(axis, arms)
    positions[moved] = a + along + np.cos(angle) * (arms - along) + np.sin(angle) * across
    return positions


@pytest.fixture(scope="module")
def helices(tmp_path_factory):
    """A helix, and the same with its second half turned by 150 degrees."""
    lines = [line for line in PEPTIDE.read_text().splitlines() if line.startswith("ATOM")]
    places = turned(pliant.read(PEPTIDE), 10, 150)
    bent = tmp_path_factory.mktemp("turned") / "bent.pdb"
    rows = [
        line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:]
        for line, place in zip(lines, places, strict=True)
    ]
    bent.write_text("\n".join([*rows, "END\n"]))
    return PEPTIDE, bent


@pytest.mark.parametrize("back", [False, True])
def test_a_turn_of_150_degrees_is_reached(helices, back):
    path = pliant.path(*(helices[::-1] if back else helices))
    assert path.arrived
    assert 135 < path.turned < 225
    bars, rest = path.model.framework.bars, path.model.framework.rest_lengths
    ends = path.positions[:, bars]
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    assert np.max(np.abs(lengths - rest) / rest) < 1e-10
    assert max(frame.overlap for frame in path.frames) < 0.11
    moves = np.linalg.norm(np.diff(path.positions, axis=0), axis=2)
    assert np.sqrt(np.mean(moves**2, axis=1)).max() < 1.0


@pytest.mark.long
def test_a_walk_shows_one_way_at_a_time(helices):
    """Until the way with turns has come nearer, the straight one is the best there is."""
    options = PathOptions()
    ends = PathEnds(*map(pliant.read, map(str, helices)), options)
    walk = PathWalk(ends, options)
    left = [walk.left]
    while walk.advance():
        left.append(walk.left)
        assert (walk.turned > 0) == (walk.left < 0.5)
    assert walk.turned > 0
    assert walk.left < 0.5 < left[-2]
    assert np.array_equal(walk.positions(), pliant.path(*helices).positions)


@pytest.mark.long
def test_the_command_says_that_a_piece_turned(helices, tmp_path, capsys):
    words = [*map(str, helices), "-o", str(tmp_path / "p.h5md")]
    assert main(words) == 0
    assert ", turning a piece by " in capsys.readouterr().out
    assert main([*words, "--overwrite", "--json"]) == 0
    assert 135 < json.loads(capsys.readouterr().out)["turned"] < 225
