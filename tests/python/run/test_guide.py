# SPDX-License-Identifier: MIT
"""Guided runs: modes rocked along, groups pulled, pair distances reached; every frame whole."""

import itertools

import numpy as np
import pytest
from real_files import MOLECULES

import pliant


@pytest.fixture(scope="module")
def model():
    """Without contacts, which would hold the helix."""
    return pliant.build_model(pliant.read(MOLECULES / "peptide_20.pdb"), model="molecule")


@pytest.fixture
def start(model):
    return np.array(model.positions)


def run(model, guide, steps=300, **options):
    seen = []
    state = pliant.State(np.array(model.positions))
    summary = pliant.run(
        model.framework,
        state,
        structure=model.structure,
        guide=guide,
        steps=steps,
        observers=[lambda frame: seen.append((np.array(frame.positions), frame.max_residual))],
        **options,
    )
    return summary, seen


def residue(model, number):
    return np.flatnonzero(model.structure.residue_ids == number)


def place(start, group, away):
    """So far along each axis from the centre of a group."""
    return tuple(start[group].mean(axis=0) + away)


def assert_whole(summary, seen):
    assert summary.unconverged_steps == 0
    assert max(one[1] for one in seen) < 1e-6


def test_a_group_arrives_where_it_is_pulled(model, start):
    ends = residue(model, 20)
    to = start[ends].mean(axis=0) + np.array([0.0, 2.0, 1.0])
    guide = pliant.Guide(pulls=[(ends, tuple(to))])
    assert guide.pulls_away(start)[0] == pytest.approx(np.sqrt(5.0))
    summary, seen = run(model, guide)
    assert_whole(summary, seen)
    assert guide.has_arrived(seen[-1][0])
    assert guide.pulls_away(seen[-1][0])[0] <= 0.05
    assert summary.steps < 300  # it ends once there is nothing to follow


@pytest.mark.parametrize("asked", [12.0, (10.0, 14.0)])
def test_a_pair_comes_to_its_distance(model, start, asked):
    guide = pliant.Guide(pairs=[(residue(model, 3), residue(model, 18), asked)])
    before = guide.pair_distances(start)[0]
    least, most = asked if isinstance(asked, tuple) else (asked, asked)
    assert not least <= before <= most
    summary, seen = run(model, guide, steps=2000)
    assert_whole(summary, seen)
    assert least - 0.05 <= guide.pair_distances(seen[-1][0])[0] <= most + 0.05


def test_a_mode_is_rocked_along_and_frames_are_near(model, start):
    field = pliant.mode_field(model.structure, 1, 1.5)
    nodes = np.flatnonzero(model.structure.names == "CA")
    assert np.sqrt(np.mean(np.sum(field[nodes] ** 2, axis=1))) == pytest.approx(1.5, rel=0.05)
    summary, seen = run(model, pliant.Guide(rock=field, period=40), steps=40)
    assert_whole(summary, seen)
    assert summary.steps == 40  # rocking never arrives
    moves = [np.linalg.norm(b[0] - a[0], axis=1).max() for a, b in itertools.pairwise(seen)]
    pushed = np.linalg.norm(field, axis=1).max() * 4 / 40
    assert max(moves) < 20 * pushed
    along = [np.sum((x - start) * field) / np.sum(field**2) for x, *_ in seen]
    assert max(along) > 0.4 and min(along) < -0.4


def test_several_guides_act_together(model, start):
    guide = pliant.Guide(
        pulls=[(residue(model, 20), place(start, residue(model, 20), 0.5))],
        pairs=[(residue(model, 3), residue(model, 9), (8.0, 9.0))],
    )
    summary, seen = run(model, guide, steps=2000)
    assert_whole(summary, seen)
    assert guide.has_arrived(seen[-1][0])


def test_motion_follows_a_guide_as_run_does(model, start):
    guide = pliant.Guide(pulls=[(residue(model, 20), place(start, residue(model, 20), 1.0))])
    _, seen = run(model, guide, steps=5)
    motion = pliant.Motion(model.framework, start, push="pull", guide=guide)
    motion.start()
    for _ in range(5):
        frame = motion.step()
    np.testing.assert_array_equal(frame.positions, seen[-1][0])


def test_what_has_arrived_is_not_gone_on_with(model, start, tmp_path):
    guide = pliant.Guide(pulls=[(residue(model, 20), place(start, residue(model, 20), 0.3))])
    path = tmp_path / "arrived.h5md"
    first, _ = run(model, guide, steps=100, output=path)
    assert first.steps < 100
    assert pliant.continue_run(path).steps == 0


def test_there_is_no_such_mode(model):
    with pytest.raises(pliant.OptionError, match="mode = 61: must be from 1 to "):
        pliant.mode_field(model.structure, 61)
    with pytest.raises(pliant.OptionError, match="mode = 0: must be from 1"):
        pliant.mode_field(model.structure, 0)


def test_forces_are_not_recorded_of_a_guide(model, tmp_path):
    with pytest.raises(pliant.OptionError, match="a guide pushes by no force"):
        run(model, pliant.Guide(pulls=[([0], (0, 0, 0))]), record_forces=tmp_path / "f.txt")
