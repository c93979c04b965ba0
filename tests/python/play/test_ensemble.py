# SPDX-License-Identifier: MIT
"""What the page is told of an ensemble: its frames, domains and their turns, shapes."""

import numpy as np
import pytest
from imd_partners import MOLECULES
from pliant.play.ensemble.many_frames import is_many_frames

import pliant

pytest.importorskip("MDAnalysis")
from pliant.play.ensemble.facts import ensemble_for_page
from pliant.play.ensemble.turns import largest_turn


def rotated(positions, angle, about):
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    return (positions - about) @ turn.T + about


@pytest.mark.parametrize("angle", [5, 40, 120])
def test_a_turn_is_found_with_its_axis(angle):
    random = np.random.default_rng(1)
    start = random.normal(scale=8, size=(40, 3))
    domain = np.arange(40) >= 25
    about = np.array([3.0, -2.0, 1.0])
    frames = np.array([start] * 3)
    frames[1, domain] = rotated(start[domain], angle / 2, about)
    frames[2, domain] = rotated(start[domain], angle, about) + np.array([0, 0, 1.5])
    found = largest_turn(frames, ~domain, domain)
    assert (found.before, found.after) == (0, 2)
    assert found.angle == pytest.approx(angle, abs=1e-6)
    assert found.axis == pytest.approx([0, 0, 1], abs=1e-6)
    assert found.shift == pytest.approx(1.5, abs=1e-6)
    assert found.point[:2] == pytest.approx(about[:2], abs=1e-6)


@pytest.fixture(scope="module")
def ensemble(tmp_path_factory):
    path = tmp_path_factory.mktemp("ensemble") / "peptide.h5md"
    pliant.sample(MOLECULES / "peptide_20.pdb", frames=20, seed=1).save(path)
    return path


def test_a_page_gets_the_file_and_the_frames_that_stand_for_it(ensemble):
    given = ensemble_for_page(ensemble)
    assert given.data == ensemble.read_bytes()
    assert given.facts["frames"] == len(given.facts["numbers"]) == 20
    rows = given.facts["shapes"]["rows"]
    assert len({row["frame"] for row in rows}) == len(rows) == 6
    assert "turns" in given.facts or given.facts["noDomains"]


def test_of_a_large_one_some_frames_are_taken_with_the_shapes_among_them(ensemble, tmp_path):
    given = ensemble_for_page(ensemble, most_bytes=24 * 327 * 10)
    numbers = given.facts["numbers"]
    assert len(numbers) < 20 == given.facts["frames"]
    assert {row["frame"] for row in given.facts["shapes"]["rows"]} <= set(numbers)
    thin = tmp_path / "thin.h5md"
    thin.write_bytes(given.data)
    held, all_frames = pliant.Trajectory(thin), pliant.Trajectory(ensemble)
    assert len(held) == len(numbers)
    for k, number in enumerate(numbers):
        assert np.array_equal(held[k], all_frames[number])


def test_what_holds_few_frames_is_no_ensemble(ensemble, tmp_path):
    assert is_many_frames(ensemble)
    assert not is_many_frames(MOLECULES / "peptide_20.pdb")
    (tmp_path / "broken.h5md").write_bytes(ensemble.read_bytes()[:1000])
    assert not is_many_frames(tmp_path / "broken.h5md")
