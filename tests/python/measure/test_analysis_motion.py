# SPDX-License-Identifier: MIT
"""RMSD, RMSF, size, superposition and principal components: closed forms and MDAnalysis."""

import MDAnalysis
import numpy as np
import pytest
from MDAnalysis.analysis import align, rms
from MDAnalysis.analysis.pca import PCA, cosine_content
from MDAnalysisTests.datafiles import DCD, PSF
from pliant.measure.frames import weights_of

from pliant.measure import PrincipalComponents, RadiusOfGyration, RmsdToStart, Rmsf, Superposition


@pytest.fixture(scope="module")
def adk():
    """CA atoms of adenylate kinase, 33 frames of real dynamics, in memory."""
    whole = MDAnalysis.Universe(PSF, DCD)
    trace = whole.select_atoms("name CA")
    universe = MDAnalysis.Merge(trace)
    positions = [trace.positions.copy() for _ in whole.trajectory[::3]]
    universe.load_new(np.array(positions))
    return universe


def in_memory(positions, masses=None):
    positions = np.asarray(positions, dtype=np.float32)
    count = positions.shape[1]
    universe = MDAnalysis.Universe.empty(count, trajectory=True)
    universe.add_TopologyAttr("masses", np.ones(count) if masses is None else masses)
    universe.add_TopologyAttr("types", ["C"] * count)
    universe.load_new(positions)
    return universe


def rotation(seed):
    q, r = np.linalg.qr(np.random.default_rng(seed).standard_normal((3, 3)))
    q = q * np.sign(np.diag(r))
    return q * np.sign(np.linalg.det(q))


def test_superposition_undoes_a_rigid_motion():
    points = np.random.default_rng(1).standard_normal((20, 3))
    moved = points @ rotation(2) + [5.0, -3.0, 2.0]
    fit = Superposition(points, np.ones(20))
    np.testing.assert_allclose(fit.apply(moved), points, atol=1e-13)


@pytest.mark.parametrize("dimension", [0, 1, 2])
def test_superposition_of_points_in_a_plane_on_a_line_in_a_point(dimension):
    points = np.zeros((6, 3))
    points[:, :dimension] = np.random.default_rng(3).standard_normal((6, dimension))
    moved = points @ rotation(4) + 1.0
    np.testing.assert_allclose(Superposition(points, np.ones(6)).apply(moved), points, atol=1e-13)


def test_superposition_never_mirrors():
    points = np.random.default_rng(5).standard_normal((10, 3))
    rotated, _ = Superposition(points, np.ones(10)).motion(points * [1, 1, -1])
    assert np.linalg.det(rotated) == pytest.approx(1.0)


def test_mass_weighted_rmsd(adk):
    masses = np.linspace(1, 30, len(adk.atoms))
    found = RmsdToStart(adk.atoms, weights=masses).run().results.rmsd
    theirs = rms.RMSD(adk.atoms, weights=masses).run().results.rmsd[:, 2]
    np.testing.assert_allclose(found, theirs, atol=1e-5)


def test_rmsf_of_a_swinging_atom_in_closed_form():
    """x = a cos(phase) over whole turns has variance a^2 / 2; without superposition."""
    frames = 64
    positions = np.zeros((frames, 3, 3))
    positions[:, 1, 0] = 2.0 * np.cos(2 * np.pi * np.arange(frames) / frames)
    positions[:, 2] = [7.0, 8.0, 9.0]
    found = Rmsf(in_memory(positions).atoms, superpose=False).run().results
    np.testing.assert_allclose(found.rmsf, [0, np.sqrt(2), 0], atol=1e-6)
    assert found.iterations == 1


def test_rmsf_of_a_rigid_molecule_that_tumbles_is_zero():
    points = 5 * np.random.default_rng(6).standard_normal((12, 3))
    positions = [points @ rotation(seed) + seed for seed in range(30)]
    found = Rmsf(in_memory(positions).atoms).run().results
    assert found.rmsf.max() < 1e-5
    assert found.average_converged


def test_rmsf_is_that_of_mdanalysis_on_the_same_superposition(adk):
    ours = Rmsf(adk.atoms).run().results
    aligned = adk.copy()
    reference = MDAnalysis.Merge(aligned.atoms)
    reference.atoms.positions = ours.average
    align.AlignTraj(aligned, reference, in_memory=True).run()
    theirs = rms.RMSF(aligned.atoms).run().results.rmsf
    np.testing.assert_allclose(ours.rmsf, theirs, atol=2e-5)


def test_the_average_is_iterated_not_that_of_the_first_frame(adk):
    once = Rmsf(adk.atoms, max_iterations=1).run().results
    rested = Rmsf(adk.atoms).run().results
    assert not once.average_converged
    assert rested.average_converged
    assert rested.iterations > 1
    assert np.sum(rested.rmsf**2) < np.sum(once.rmsf**2)  # the fit on the average is the tighter


def test_residue_rmsf_is_the_root_of_the_mean_of_squares():
    whole = MDAnalysis.Universe(PSF, DCD)
    atoms = whole.select_atoms("resid 10:12 and not name H*")
    found = Rmsf(atoms, superpose_on=whole.select_atoms("name CA")).run(step=10).results
    assert list(found.residues) == [9, 10, 11]
    for residue, value in zip(found.residues, found.residue_rmsf, strict=True):
        own = found.rmsf[atoms.resindices == residue]
        assert value == pytest.approx(np.sqrt(np.mean(own**2)), rel=1e-12)


def test_rmsf_over_chosen_frames_starts_at_the_first_of_them(adk):
    by_slice = Rmsf(adk.atoms).run(start=5, stop=20, step=3).results
    by_list = Rmsf(adk.atoms).run(frames=[5, 8, 11, 14, 17]).results
    mask = np.isin(np.arange(len(adk.trajectory)), [5, 8, 11, 14, 17])
    by_mask = Rmsf(adk.atoms).run(frames=mask).results
    np.testing.assert_array_equal(by_slice.rmsf, by_list.rmsf)
    np.testing.assert_array_equal(by_slice.rmsf, by_mask.rmsf)


def test_no_frames_to_average(adk):
    with pytest.raises(ValueError, match="no frames to average"):
        Rmsf(adk.atoms).run(start=3, stop=3)


def test_radius_of_gyration_in_closed_form():
    """Masses 1 and 2 at distance 3: sqrt(1 * 2) / 3 * 3 = sqrt(2)."""
    universe = in_memory([[[0, 0, 0], [3, 0, 0]]], masses=[1.0, 2.0])
    assert RadiusOfGyration(universe.atoms).run().results.radius[0] == pytest.approx(np.sqrt(2))
    equal = RadiusOfGyration(universe.atoms, weights=None).run().results.radius[0]
    assert equal == pytest.approx(1.5)


@pytest.mark.parametrize(
    ("weights", "message"),
    [
        ("charge", "expected None, 'mass' or an array, got 'charge'"),
        ([1.0], r"expected shape \(214,\), got \(1,\)"),
        (np.zeros(214), "expected finite numbers >= 0 that are not all 0"),
        (np.full(214, -1.0), "expected finite numbers >= 0"),
        (np.full(214, np.nan), "expected finite numbers >= 0"),
    ],
)
def test_weights_that_make_no_sense_are_refused(adk, weights, message):
    with pytest.raises(ValueError, match=message):
        weights_of(adk.atoms, weights)


def test_the_trajectory_stays_where_it_was(adk):
    adk.trajectory[4]
    RmsdToStart(adk.atoms)
    assert adk.trajectory.ts.frame == 4


@pytest.fixture
def random_walk():
    random = np.random.default_rng(1)
    start = 4 * random.standard_normal((7, 3))
    steps = 0.1 * random.standard_normal((60, 7, 3)) * np.linspace(0.2, 2, 7)[:, None]
    return start + np.cumsum(steps, axis=0)


def test_one_mode_in_closed_form():
    """Atoms that swing along one vector v with amplitudes c(t): one eigenvalue, var(c) |v|^2."""
    v = np.array([[1.0, 0, 0], [0, 2, 0], [0, 0, -2]])
    c = np.linspace(-1, 1, 9)
    base = 10 * np.eye(3)
    found = PrincipalComponents(in_memory(base + c[:, None, None] * v).atoms, superpose=False)
    found = found.run().results
    assert found.eigenvalues[0] == pytest.approx(np.var(c, ddof=1) * 9, rel=1e-6)
    assert found.explained[0] == pytest.approx(1.0, abs=1e-9)
    direction = v.ravel() / 3
    sign = np.sign(direction[np.argmax(np.abs(direction))])
    np.testing.assert_allclose(found.components[0], sign * direction, atol=1e-6)
    np.testing.assert_allclose(found.projections[:, 0], sign * 3 * c, atol=1e-5)


def test_without_superposition_it_is_the_pca_of_mdanalysis(random_walk):
    universe = in_memory(random_walk)
    ours = PrincipalComponents(universe.atoms, superpose=False).run().results
    theirs = PCA(universe, align=False).run()
    count = len(ours.eigenvalues)
    assert count == 21
    np.testing.assert_allclose(ours.eigenvalues, theirs.results.variance[:count], rtol=1e-4)
    cumulated = theirs.results.cumulated_variance[:count]
    np.testing.assert_allclose(np.cumsum(ours.explained), cumulated, rtol=1e-5)
    projected = theirs.transform(universe.atoms, n_components=3)
    for k in range(3):
        overlap = ours.components[k] @ theirs.results.p_components[:, k]
        assert abs(overlap) == pytest.approx(1.0, abs=1e-5)
        np.testing.assert_allclose(
            ours.projections[:, k], np.sign(overlap) * projected[:, k], atol=1e-3
        )
        assert ours.cosine_content[k] == pytest.approx(cosine_content(projected, k), abs=1e-3)


def test_mass_weighted_components_diagonalise_the_weighted_covariance(random_walk):
    masses = np.array([1.0, 12, 14, 16, 1, 32, 12])
    universe = in_memory(random_walk, masses)
    found = PrincipalComponents(universe.atoms, mass_weighted=True).run().results
    average = Rmsf(universe.atoms, weights=masses).run().results.average
    fit = Superposition(average, masses)
    moved = np.array([fit.apply(ts.positions.astype(float)).ravel() for ts in universe.trajectory])
    covariance = np.cov((moved * np.repeat(np.sqrt(masses), 3)).T)
    np.testing.assert_allclose(
        found.eigenvalues[:10], np.linalg.eigvalsh(covariance)[::-1][:10], rtol=1e-5
    )
    identity = found.components @ covariance @ found.components.T
    np.testing.assert_allclose(identity, np.diag(found.eigenvalues), atol=1e-4)


def test_projections_have_the_variances_and_no_correlation(random_walk):
    found = PrincipalComponents(in_memory(random_walk).atoms).run().results
    np.testing.assert_allclose(np.cov(found.projections.T), np.diag(found.eigenvalues), atol=1e-9)
    gram = found.components @ found.components.T
    np.testing.assert_allclose(gram, np.eye(len(gram)), atol=1e-9)
    largest = np.abs(found.components).argmax(axis=1)
    assert (found.components[np.arange(len(gram)), largest] > 0).all()


def test_superposition_takes_six_motions_away(random_walk):
    found = PrincipalComponents(in_memory(random_walk).atoms).run().results
    free = PrincipalComponents(in_memory(random_walk).atoms, superpose=False).run().results
    assert np.count_nonzero(found.eigenvalues > 1e-5) < np.count_nonzero(free.eigenvalues > 1e-5)
    assert found.eigenvalues.sum() < free.eigenvalues.sum()


def test_shares_count_the_components_that_are_not_kept(random_walk):
    every = PrincipalComponents(in_memory(random_walk).atoms).run().results
    two = PrincipalComponents(in_memory(random_walk).atoms, n_components=2).run().results
    assert two.projections.shape == (60, 2)
    np.testing.assert_array_equal(two.explained, every.explained[:2])
    assert two.explained.sum() < 1


def test_atoms_that_rest_have_no_components():
    still = np.broadcast_to(np.random.default_rng(2).standard_normal((4, 3)), (5, 4, 3))
    found = PrincipalComponents(in_memory(still).atoms, superpose=False).run().results
    assert found.eigenvalues.shape == (0,)
    assert found.projections.shape == (5, 0)
