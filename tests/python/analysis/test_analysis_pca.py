# SPDX-License-Identifier: MIT
"""Principal components against closed forms, numpy's eigenvalues and MDAnalysis' PCA."""

import MDAnalysis
import numpy as np
import pytest
from MDAnalysis.analysis.pca import PCA, cosine_content
from pliant.measure import PrincipalComponents, Rmsf, Superposition


def in_memory(positions, masses=None):
    positions = np.asarray(positions, dtype=np.float32)
    universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=True)
    universe.add_TopologyAttr("masses", np.ones(positions.shape[1]) if masses is None else masses)
    universe.add_TopologyAttr("types", ["C"] * positions.shape[1])
    universe.load_new(positions)
    return universe


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
