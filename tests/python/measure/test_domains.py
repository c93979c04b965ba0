# SPDX-License-Identifier: MIT
"""Domains and hinges of bodies that are known to be rigid, and how well they repeat."""

import itertools
import warnings

import numpy as np
import pytest
from pliant.measure.domains import find_domains
from pliant.measure.domains.find import APART, TOGETHER
from pliant.measure.domains.splits import Frames, rigid_bodies
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
    for positions in (trembling, trembling[:, :25], np.array([shape] * 5), rigid):
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
    moves = frames.sample(np.array([1, 0])).moves
    assert np.sum(moves**2) == pytest.approx(positions[:100].var(axis=0).sum(), rel=0.02)


def sample_of(positions):
    every = [np.arange(len(positions))]
    return Frames(positions, one_chain(positions), every).sample(np.ones(1))


def test_what_two_bodies_follow_is_what_least_squares_fit():
    sample = sample_of(bodies(drawn(30, 1, 9), 0.3))
    body = np.zeros(2 * BODY, dtype=bool)
    body[10:30] = True
    found = sample.followed(body, np.array([[0, 0], [25, 60], [10, 30]]))
    body[25:60] = ~body[25:60]

    def squares(some):
        basis = np.zeros((some.sum(), 3, 6))
        for k, axis in enumerate(np.eye(3)):
            basis[:, :, k] = axis
            basis[:, :, 3 + k] = np.cross(axis, sample.mean[some])
        moves = sample.moves[some].reshape(3 * some.sum(), -1)
        amounts = np.linalg.lstsq(basis.reshape(-1, 6), moves, rcond=None)[0]
        return np.sum((basis.reshape(-1, 6) @ amounts) ** 2)

    np.testing.assert_allclose(found[1], [squares(body), squares(~body)], rtol=1e-6)
    np.testing.assert_allclose(found[2], [0.0, found.sum(axis=1)[2]], atol=1e-9)


def test_motions_hold_all_that_the_frames_do():
    positions = bodies(drawn(15, 1, 9), 0.3)
    sample = sample_of(positions)
    spread = np.sum(positions.var(axis=0))
    assert np.sum(sample.moves**2) == pytest.approx(spread, rel=1e-9)


def test_a_split_is_where_few_contacts_are_among_those_that_move_alike():
    """A rod of discs of nine sites bends evenly: motion alone would cut it near its middle, after
    site 44. Its seventh disc is a single site, where fewer contacts are cut."""
    disc = 4.0 * np.stack(np.meshgrid([0], range(3), range(3), indexing="ij"), -1).reshape(-1, 3)
    discs = [(disc if k != 6 else disc[4:5]) + [6.0 * k, 0.0, 0.0] for k in range(10)]
    rod = np.concatenate(discs) - [27.0, 4.0, 4.0]
    angle = 0.01 * drawn(60, 1, 4) * rod[:, 0]
    frames = rod + np.stack([-angle * rod[:, 1], 0.5 * angle * rod[:, 0], 0 * angle], axis=-1)
    body = rigid_bodies(sample_of(frames))
    (cut,) = np.flatnonzero(np.diff(body))
    assert abs(cut - 54) <= 3


def test_what_frames_that_reach_further_do_not_show_is_no_domain():
    near = bodies(drawn(200, 2, 3) * [1.0, 0.6])
    far = bodies(drawn(200, 2, 4) * [1.0, 0.0])
    chain = one_chain(near)
    assert find_domains(near, chain).count == 3
    assert find_domains(near, chain, far=far).count == 2
    assert find_domains(near, chain, far=bodies(drawn(200, 2, 4))).count == 3


def test_a_path_of_adenylate_kinase_shows_core_lid_and_nmp():
    """Resamples differ in where the NMP-binding domain ends, and agree on less than 30 sites."""
    data = pytest.importorskip("MDAnalysisTests.datafiles")
    import MDAnalysis

    universe = MDAnalysis.Universe(data.PSF, data.DCD)
    alphas = universe.select_atoms("name CA")
    frames = superpose_all(np.array([alphas.positions.astype(float) for _ in universe.trajectory]))
    found = find_domains(frames, np.zeros(214, dtype=int))
    assert found.count == 3
    core, lid, nmp = (set(found.domain[a:b].tolist()) for a, b in ((0, 25), (121, 157), (36, 58)))
    assert (core, lid, nmp) == ({0}, {1}, {2})


def test_seeds_of_adenylate_kinase_agree_on_core_lid_and_nmp():
    data = pytest.importorskip("MDAnalysisTests.datafiles")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)  # elements are taken from names
        model = pliant.build_model(pliant.read(data.PDB_small))
    alphas = np.flatnonzero(np.asarray(model.structure.names) == "CA")
    assigned = []
    for seed in range(2):
        frames = pliant.sample(model, 200, sampler="reach", seed=seed).positions[:, alphas]
        near, far = (superpose_all(some) for some in np.split(np.asarray(frames), 2))
        found = find_domains(near, np.zeros(214, dtype=int), far=far)
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
