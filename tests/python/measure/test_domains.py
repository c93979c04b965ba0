# SPDX-License-Identifier: MIT
"""Domains and hinges of bodies that are known to be rigid, and how well they repeat."""

import itertools
import warnings

import numpy as np
import pytest
from pliant.measure.domains import find_domains
from pliant.measure.domains.find import APART, TOGETHER
from pliant.measure.domains.splits import Frames, left_over
from pliant.trajectory.superposition import superpose_all
from scipy.spatial.transform import Rotation

import pliant

BODY = 40  #: sites of each body


def bodies(angles, trembling=0.05, seed=1):
    """Bodies of BODY sites in a row, each turned about its first site by angles (F, k) of its own,
    at right angles to the row; the first by nothing."""
    random = np.random.default_rng(seed)
    along = np.arange(BODY)
    body = np.stack([1.5 * along, 3 * np.sin(along), 3 * np.cos(along)], axis=1)
    frames = []
    for turns in angles:
        parts, end, turn = [body], body[-1] + [1.5, 0, 0], Rotation.identity()
        for k, angle in enumerate(turns):
            axis = [[0, 0, 1], [0, 1, 0]][k % 2]
            turn = turn * Rotation.from_rotvec(angle * np.array(axis))
            parts.append(turn.apply(body - body[0]) + end)
            end = parts[-1][-1] + turn.apply([1.5, 0, 0])
        frames.append(np.concatenate(parts))
    made = np.array(frames)
    return superpose_all(made + trembling * random.standard_normal(made.shape))


def drawn(frames, count, seed):
    return np.random.default_rng(seed).normal(0, 0.2, (frames, count))


def one_chain(positions):
    return np.zeros(positions.shape[1], dtype=int)


@pytest.mark.parametrize("count", [2, 3])
def test_rigid_bodies_are_domains_with_hinges_between_them(count):
    positions = bodies(drawn(200, count - 1, 3))
    found = find_domains(positions, one_chain(positions))
    assert found.count == count
    assert found.counts == {count: 1.0} and np.all(found.found == 1.0)
    assert found.explained > 0.9
    for k in range(count):
        inner = found.domain[k * BODY + 4 : (k + 1) * BODY - 4]
        assert len(set(inner.tolist())) == 1 and inner[0] >= 0
    assert [round(hinge.site / BODY) for hinge in found.hinges] == list(range(1, count))
    assert all(abs(hinge.site % BODY - BODY) <= 3 or hinge.site % BODY <= 3
               for hinge in found.hinges)  # fmt: skip
    assert all(hinge.share > 0.5 for hinge in found.hinges)
    assert found.hinge_share[BODY // 2] == 0.0


def test_a_body_that_moves_little_beside_one_that_moves_much_is_found():
    angles = drawn(200, 2, 5) * [0.1, 1.0]
    found = find_domains(positions := bodies(angles, 0.02), one_chain(positions))
    assert found.count in (2, 3) and found.domain[BODY // 2] != found.domain[-BODY // 2]


def test_noise_still_frames_and_one_rigid_body_are_one_piece():
    random = np.random.default_rng(4)
    shape = 10 * random.standard_normal((60, 3))
    trembling = superpose_all(shape + 0.3 * random.standard_normal((200, 60, 3)))
    rigid = superpose_all([Rotation.random(random_state=k).apply(shape) for k in range(20)])
    for positions in (trembling, np.array([shape] * 5), rigid):
        found = find_domains(positions, one_chain(positions))
        assert (found.count, found.explained, len(found.hinges)) == (1, 0.0, 0)
        assert set(found.domain.tolist()) == {0}


def test_what_does_not_repeat_is_not_shown():
    """Eight frames in two hundred bend: many a resample has few of them."""
    angles = np.zeros((200, 1))
    angles[17:25] = 0.35
    found = find_domains(positions := bodies(angles, 0.35), one_chain(positions))
    assert APART < found.counts[1] < TOGETHER and found.counts[2] > APART
    assert found.count == 0 and found.hinges == [] and np.all(found.domain == -1)


@pytest.mark.long
def test_cores_of_bodies_that_change_are_not_shown():
    """A chain of eight bends as a whole: where it is cut differs from resample to resample."""
    positions = bodies(0.5 * drawn(200, 7, 1))
    found = find_domains(positions, one_chain(positions))
    assert len(found.counts) > 2 and found.count == 0 and len(found.undecided) > 0


def test_it_is_the_same_each_time_and_wherever_the_frames_lie():
    positions = bodies(drawn(60, 1, 8), 0.3)
    first, again = (find_domains(positions, one_chain(positions)) for _ in range(2))
    turn = Rotation.from_euler("xyz", [30, 40, 50], degrees=True)
    moved = turn.apply(positions.reshape(-1, 3)).reshape(positions.shape) + 20.0
    elsewhere = find_domains(moved, one_chain(positions))
    for other in (again, elsewhere):
        np.testing.assert_array_equal(first.domain, other.domain)
        assert first.counts == other.counts and first.hinges == other.hinges


def test_blocks_of_a_path_are_taken_whole():
    """Only the second half bends: of two blocks a quarter of the resamples lack it."""
    angles = np.concatenate([np.zeros((100, 1)), drawn(100, 1, 2)])
    positions = bodies(angles, 0.2)
    halves = [np.arange(100), np.arange(100, 200)]
    found = find_domains(positions, one_chain(positions), halves)
    assert found.count == 0 and found.counts[1] == pytest.approx(0.25, abs=0.15)


def test_many_frames_are_thinned_and_samples_hold_what_they_drew():
    positions = bodies(drawn(600, 1, 6))
    assert find_domains(positions, one_chain(positions)).count == 2
    frames = Frames(positions, one_chain(positions), [np.arange(100), np.arange(100, 300)])
    assert np.count_nonzero(frames.sample(np.array([1, 0])).weights) == 100


def test_what_is_left_beside_a_rigid_motion_is_what_least_squares_leaves():
    positions = bodies(drawn(30, 1, 9), 0.3)
    sample = Frames(positions, one_chain(positions), [np.arange(30)]).sample(np.ones(1))
    body = np.arange(10, 60)
    arms = sample.mean - sample.mean[body].mean(axis=0)
    basis = np.zeros((len(arms), 3, 6))
    for k, axis in enumerate(np.eye(3)):
        basis[:, :, k] = axis
        basis[:, :, 3 + k] = np.cross(axis, arms)
    left = np.zeros(len(arms))
    for move in sample.moves.T.reshape(30, -1, 3).astype(float):
        amounts = np.linalg.lstsq(basis[body].reshape(-1, 6), move[body].ravel(), rcond=None)[0]
        left += np.sum((move - basis @ amounts) ** 2, axis=1) / 30
    np.testing.assert_allclose(left_over(sample, body), left, rtol=1e-3, atol=1e-4)


def test_seeds_of_adenylate_kinase_agree_on_core_lid_and_nmp():
    data = pytest.importorskip("MDAnalysisTests.datafiles")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)  # elements are taken from names
        model = pliant.build_model(pliant.read(data.PDB_small))
    alphas = np.flatnonzero(np.asarray(model.structure.names) == "CA")
    assigned = []
    for seed in range(2):
        frames = pliant.sample(model, 100, sampler="modes", seed=seed).positions[:, alphas]
        found = find_domains(superpose_all(np.asarray(frames)), np.zeros(214, dtype=int))
        assert found.count == 3 and found.counts[3] >= TOGETHER
        lid, nmp, core = (set(found.domain[a:b].tolist()) for a, b in
                          ((121, 157), (36, 58), (0, 25)))  # fmt: skip
        assert all(len(one) == 1 for one in (lid, nmp, core)) and len(lid | nmp | core) == 3
        assert len(found.hinges) == 4
        assigned.append(found.domain)
    for one, other in itertools.combinations(assigned, 2):
        both = (one >= 0) & (other >= 0)
        assert both.mean() > 0.9
        np.testing.assert_array_equal(one[both], other[both])
