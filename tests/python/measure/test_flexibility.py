# SPDX-License-Identifier: MIT
"""Flexibility with errors, correlations, collective motions: against numpy and laws."""

import numpy as np
import pytest
from pliant.measure.collective import collectivity, moving_stretches, participation
from pliant.measure.domains import correlations, distance_fluctuations
from pliant.measure.flexibility import (
    equal_blocks,
    flexibility,
    numbered_blocks,
    path_blocks,
    statistical_inefficiency,
)
from pliant.trajectory.superposition import superpose_all
from turned_molecule import rotated


def noise(frames, sigma, seed=0):
    """(F, n, 3) independent normal displacements of standard deviation sigma (n,)."""
    random = np.random.default_rng(seed)
    return random.standard_normal((frames, len(sigma), 3)) * np.asarray(sigma)[None, :, None]


def test_rmsf_is_numpys_and_units_are_roots_of_mean_squares():
    positions = noise(300, [0.5, 1.0, 2.0, 0.1])
    found = flexibility(positions, np.array([0, 0, 1, 1]), equal_blocks(300, 3))
    squares = positions.var(axis=0).sum(axis=1)
    np.testing.assert_allclose(found.rmsf**2, [squares[:2].mean(), squares[2:].mean()])
    assert found.blocks == 3
    assert np.all(found.error > 0)


def test_twice_the_error_holds_the_true_value_about_19_times_of_20():
    sigma = np.linspace(0.3, 2.0, 40)
    inside = []
    for seed in range(20):
        found = flexibility(noise(200, sigma, seed), np.arange(40), equal_blocks(200, 4))
        inside.append(np.abs(found.rmsf - np.sqrt(3) * sigma) < 2 * found.error)
    assert 0.90 <= np.mean(inside) <= 0.99


def test_a_drift_is_in_the_error_and_is_not_converged():
    positions = noise(400, np.full(30, 0.1))
    still = flexibility(positions, np.arange(30), equal_blocks(400, 4))
    positions[:, :5] += np.linspace(0, 4, 400)[:, None, None]
    drifting = flexibility(positions, np.arange(30), equal_blocks(400, 4))
    assert np.all(drifting.error[:5] > 0.4 * drifting.rmsf[:5])
    assert not still.converged  # all alike: there is no profile that halves could share
    assert drifting.difference < 1


def test_halves_that_agree_are_converged_and_others_not():
    sigma = np.linspace(0.2, 3.0, 50)
    assert flexibility(noise(2000, sigma), np.arange(50), equal_blocks(2000, 2)).converged
    positions = noise(2000, sigma)
    positions[1000:, :25] *= 3.0
    changed = flexibility(positions, np.arange(50), equal_blocks(2000, 2))
    assert not changed.converged
    whole = np.sqrt(positions[:1000].var(axis=0).sum(axis=1))
    np.testing.assert_allclose(changed.halves[0], whole)


def test_what_does_not_move_has_no_error():
    found = flexibility(np.ones((10, 5, 3)), np.arange(5), equal_blocks(10, 2))
    assert found.rmsf.tolist() == found.error.tolist() == [0.0] * 5
    assert (found.correlation, found.difference) == (1.0, 0.0)


def test_blocks_follow_the_numbers_of_frames():
    sizes = [len(b) for b in numbered_blocks(np.arange(50, 430), 100)]
    assert sizes == [150, 100, 130]  # 50 to 99 join 100 to 199; 400 to 429 join 300 to 399
    assert [len(b) for b in numbered_blocks(np.arange(150), 100)] == [75, 75]
    for numbers in (np.arange(50, 430), np.arange(90)):
        every = np.concatenate(numbered_blocks(numbers, 100))
        assert every.tolist() == list(range(len(numbers)))


def test_a_walk_has_two_blocks_and_white_noise_ten():
    random = np.random.default_rng(3)
    white = random.standard_normal(4000)
    assert statistical_inefficiency(white) == pytest.approx(1.0, abs=0.25)
    assert len(path_blocks(white)) == 10
    assert len(path_blocks(np.cumsum(white))) == 2
    memory = np.zeros(200_000)
    steps = random.standard_normal(len(memory))
    for k in range(1, len(memory)):
        memory[k] = 0.9 * memory[k - 1] + steps[k]
    # of an autoregressive process the sum is (1 + a) / (1 - a)
    assert statistical_inefficiency(memory) == pytest.approx(19, rel=0.15)


def test_superposition_takes_rigid_motion_away():
    random = np.random.default_rng(5)
    shape = random.standard_normal((12, 3)) * 5
    frames = np.array(
        [
            rotated(shape, random.standard_normal(3), np.degrees(a))
            + 10 * random.standard_normal(3)
            for a in random.uniform(0, 3, 20)
        ]
    )
    assert np.ptp(superpose_all(frames), axis=0).max() < 1e-9
    part = superpose_all(frames, np.arange(4))
    assert np.ptp(part, axis=0).max() < 1e-9


def test_correlations_are_those_of_a_loop():
    random = np.random.default_rng(2)
    positions = random.standard_normal((50, 6, 3))
    positions[:, 1] = positions[:, 0] + 0.1
    positions[:, 2] = -positions[:, 0]
    positions[:, 5] = 1.0
    found = correlations(positions)
    moved = positions - positions.mean(axis=0)
    for i in range(5):
        for j in range(5):
            top = np.mean(np.sum(moved[:, i] * moved[:, j], axis=1))
            bottom = np.mean(np.sum(moved[:, i] ** 2, axis=1)) * np.mean(
                np.sum(moved[:, j] ** 2, axis=1)
            )
            assert found[i, j] == pytest.approx(top / np.sqrt(bottom))
    assert found[0, 1] == pytest.approx(1)
    assert found[0, 2] == pytest.approx(-1)
    assert np.all(found[5] == 0)


def test_small_changes_of_distances_are_those_that_numpy_measures():
    random = np.random.default_rng(7)
    positions = 10 * random.standard_normal((8, 3)) + 0.01 * random.standard_normal((200, 8, 3))
    apart = np.linalg.norm(positions[:, :, None] - positions[:, None], axis=3)
    np.testing.assert_allclose(
        distance_fluctuations(positions), apart.std(axis=0), rtol=0.02, atol=1e-6
    )


def test_collectivity_of_all_and_of_one():
    every = np.full((1, 30), 1 / np.sqrt(30))
    alone = np.zeros((1, 30))
    alone[0, 4] = 1.0
    assert collectivity(every)[0] == pytest.approx(1.0)
    assert collectivity(alone)[0] == pytest.approx(0.1)
    np.testing.assert_allclose(participation(every)[0], 0.1)


def test_stretches_that_move_do_not_cross_chains():
    share = np.zeros(40)
    share[5:9] = 0.1
    share[18:22] = 0.15
    chains = np.repeat(["A", "B"], 20)
    assert moving_stretches(share, chains) == [
        (5, 8, pytest.approx(0.4)),
        (18, 19, pytest.approx(0.3)),
        (20, 21, pytest.approx(0.3)),
    ]
