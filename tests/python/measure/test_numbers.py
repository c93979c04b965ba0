# SPDX-License-Identifier: MIT
"""What the comparison computes, against closed forms and other packages."""

import numpy as np
import pytest
from MDAnalysis.analysis.rms import rmsd
from MDAnalysis.lib.distances import calc_dihedrals
from pliant.measure.compared import numbers
from scipy.spatial.distance import jensenshannon
from scipy.spatial.transform import Rotation

from pliant.measure import agreement


def random_motions(frames, seed):
    rng = np.random.default_rng(seed)
    return Rotation.random(frames, rng=seed).as_matrix(), rng.normal(size=(frames, 1, 3)) * 20


def moved_rigidly(positions, seed=0):
    turns, shifts = random_motions(len(positions), seed)
    return positions @ turns + shifts


def shape(atoms=9, seed=1):
    return np.random.default_rng(seed).normal(size=(atoms, 3)) * 3


ALL = np.arange(9)


def test_fits_are_as_good_as_those_of_mdanalysis():
    rng = np.random.default_rng(4)
    frames = moved_rigidly(shape() + rng.normal(size=(30, 9, 3)) * 0.4)
    fitted = agreement.superposed(frames, shape(), ALL)
    for before, after in zip(frames, fitted, strict=True):
        ours = np.sqrt(np.mean(np.sum((after - shape()) ** 2, axis=1)))
        assert ours == pytest.approx(rmsd(before, shape(), superposition=True), rel=1e-6)


def test_only_the_chosen_atoms_are_fitted():
    frames = np.repeat(shape()[None], 8, axis=0)
    frames[:, 8] += np.random.default_rng(0).normal(size=(8, 3)) * 5
    fitted = agreement.superposed(moved_rigidly(frames), shape(), ALL[:8])
    assert np.ptp(fitted[:, :8], axis=0).max() < 1e-12
    assert np.ptp(fitted[:, 8], axis=0).max() > 1


def test_fluctuation_of_one_moving_atom():
    """An atom that is at +-a along a line fluctuates by a, the others not at all."""
    frames = np.repeat(shape()[None], 10, axis=0)
    frames[::2, 8, 0] += 0.3
    frames[1::2, 8, 0] -= 0.3
    fitted = agreement.superposed_on_mean(moved_rigidly(frames), ALL[:8])
    expected = np.array([0.0] * 8 + [0.3])
    assert agreement.fluctuations(fitted) == pytest.approx(expected, abs=1e-9)


def test_the_average_does_not_depend_on_the_first_frame():
    rng = np.random.default_rng(2)
    frames = moved_rigidly(shape() + rng.normal(size=(40, 9, 3)) * 0.5)
    forwards = agreement.fluctuations(agreement.superposed_on_mean(frames, ALL))
    backwards = agreement.fluctuations(agreement.superposed_on_mean(frames[::-1], ALL))
    assert forwards == pytest.approx(backwards, rel=1e-5)


def test_pearson_is_that_of_numpy():
    rng = np.random.default_rng(8)
    for _ in range(20):
        a, b = rng.normal(size=(2, 30))
        assert agreement.correlation(a, b) == pytest.approx(np.corrcoef(a, b)[0, 1], rel=1e-12)
    assert agreement.correlation(a, 3 * a + 1) == pytest.approx(1.0, rel=1e-14)
    assert agreement.correlation(a, -a) == pytest.approx(-1.0, rel=1e-14)
    assert np.isnan(agreement.correlation(a, np.ones(30)))
    assert np.isnan(agreement.correlation(a[:2], b[:2]))


def subspace(rows):
    return np.eye(12)[rows]


def test_rmsip_of_known_subspaces():
    a = subspace([0, 1, 2, 3])
    assert agreement.rmsip(a, a) == 1.0
    assert agreement.rmsip(a, subspace([3, 1, 0, 2])) == 1.0
    assert agreement.rmsip(a, subspace([4, 5, 6, 7])) == 0.0
    assert agreement.rmsip(a, subspace([0, 5, 6, 7])) == 0.5  # sqrt(1 / 4)
    assert np.isnan(agreement.rmsip(a, subspace([])))


def test_rmsip_does_not_depend_on_the_basis_of_a_subspace():
    turned = Rotation.random(rng=3).as_matrix() @ np.eye(12)[:3]
    assert agreement.rmsip(subspace([0, 1, 2]), turned) == pytest.approx(1.0)


def test_a_tilted_mode_overlaps_by_its_cosine():
    tilted = np.cos(0.3) * np.eye(12)[:1] + np.sin(0.3) * np.eye(12)[5:6]
    assert agreement.rmsip(subspace([0]), tilted) == pytest.approx(np.cos(0.3))
    assert agreement.overlaps(subspace([0, 5]), -tilted) == pytest.approx(
        np.abs([[np.cos(0.3)], [np.sin(0.3)]])
    )


def test_chance_is_what_random_subspaces_have():
    atoms, modes = 12, 5
    rng = np.random.default_rng(6)
    squares = []
    for _ in range(400):
        a, b = (np.linalg.qr(rng.normal(size=(3 * atoms - 6, modes)))[0].T for _ in range(2))
        squares.append(np.sum((a @ b.T) ** 2) / modes)
    assert agreement.chance_rmsip(modes, atoms) == pytest.approx(
        np.sqrt(np.mean(squares)), rel=0.02
    )


def test_modes_of_a_known_motion():
    """Two perpendicular motions of variance 4 and 1 come out as such, in this order."""
    rng = np.random.default_rng(9)
    basis = np.linalg.qr(rng.normal(size=(27, 2)))[0].T
    phase = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    table = np.sqrt([8.0, 2.0]) * np.stack([np.cos(phase), np.sin(phase)], axis=1) @ basis
    modes = agreement.principal_modes(shape() + table.reshape(200, 9, 3), most=10)
    assert modes.variances == pytest.approx(np.array([4.0, 1.0]) * 200 / 199, rel=1e-10)
    assert np.abs(np.sum(modes.vectors * basis, axis=1)) == pytest.approx([1, 1], rel=1e-10)
    assert modes.share == pytest.approx(1.0)


def test_modes_are_eigenvectors_of_the_covariance():
    rng = np.random.default_rng(10)
    frames = rng.normal(size=(50, 4, 3)) * np.arange(1, 13).reshape(4, 3)
    modes = agreement.principal_modes(frames, most=3)
    covariance = np.cov(frames.reshape(50, 12).T)
    assert modes.variances == pytest.approx(np.linalg.eigvalsh(covariance)[::-1][:3], rel=1e-10)
    for vector, variance in zip(modes.vectors, modes.variances, strict=True):
        assert covariance @ vector == pytest.approx(variance * vector, abs=1e-8)


def test_frames_that_do_not_move_have_no_modes():
    modes = agreement.principal_modes(np.repeat(shape()[None], 5, axis=0), most=10)
    assert len(modes.vectors) == 0 and modes.share == 0.0


def test_dihedrals_are_those_of_mdanalysis():
    rng = np.random.default_rng(11)
    frames = rng.normal(size=(25, 9, 3)).astype(np.float32).astype(float)
    quadruples = np.array([rng.choice(9, 4, replace=False) for _ in range(12)])
    angles = numbers.dihedrals(frames, quadruples)
    for frame, row in zip(frames, angles, strict=True):
        theirs = calc_dihedrals(*(frame[quadruples[:, k]] for k in range(4)))
        assert row == pytest.approx(np.degrees(theirs), abs=1e-3)


def test_dihedrals_by_hand():
    a, b, c = [0, 1, 0], [0, 0, 0], [1, 0, 0]
    ends = {0: [1, 1, 0], 180: [1, -1, 0], 90: [1, 0, 1], -90: [1, 0, -1]}
    for angle, end in ends.items():
        frame = np.array([[a, b, c, end]], float)
        found = numbers.dihedrals(frame, np.array([[0, 1, 2, 3]]))[0, 0]
        assert abs(found) == pytest.approx(abs(angle))
        if abs(angle) == 90:
            reference = calc_dihedrals(*(frame[0, [k]] for k in range(4)))
            assert found == pytest.approx(np.degrees(reference[0]))


def test_shares_of_angles():
    angles = np.array([[-180.0, -171.0], [180.0, 179.9], [0.0, -0.1], [9.9, 0.1]])
    shares = numbers.shares(angles, 36)
    assert shares[0, [0, 18]].tolist() == [0.5, 0.5]  # 180 and -180 are the same angle
    assert shares[1, [0, 35, 17, 18]].tolist() == [0.25] * 4
    assert shares.sum(axis=1).tolist() == [1.0, 1.0]


def test_jensen_shannon_is_that_of_scipy():
    rng = np.random.default_rng(12)
    p, q = rng.dirichlet(np.ones(36) * 0.2, size=(2, 15))
    p[0, :5], q[0, 5:] = 0, 0
    p, q = (x / x.sum(axis=1, keepdims=True) for x in (p, q))
    assert numbers.jensen_shannon(p, q) == pytest.approx(jensenshannon(p, q, base=2, axis=1))
    assert numbers.jensen_shannon(p, p).tolist() == [0.0] * 15
    apart = numbers.jensen_shannon(np.array([1.0, 0]), np.array([0, 1.0]))
    assert apart == 1.0


def test_radius_of_gyration_of_a_dumbbell():
    # Masses 1 and 3 at distance 4: centre at 3 from the light one, sqrt((9 + 3 * 1) / 4)
    frames = np.array([[[0.0, 0, 0], [0, 0, 4]], [[0, 5, 0], [0, 5, 0]]])
    assert numbers.gyration_radii(frames, np.array([1.0, 3.0])) == pytest.approx([np.sqrt(3), 0])
