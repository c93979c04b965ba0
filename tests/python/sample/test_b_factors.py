# SPDX-License-Identifier: MIT
"""Estimated B factors: the formula, by NumPy; which residues they are of; what is refused."""

import numpy as np
import pytest
from real_files import MOLECULES

import pliant


def springs(x):
    """Those of network ``shared`` of one unbroken chain, written again from the page."""
    r = np.linalg.norm(x[:, None] - x[None], axis=2)
    near = (r < 18.0) & (r > 0.0)
    shared = near.astype(float) @ near.T
    own = near.sum(axis=1)
    share = shared / np.maximum(np.sqrt(np.outer(own, own)), 1.0)
    upper = np.triu(r < 8.0, 1)
    share = share / share[upper].mean() if share[upper].any() else np.ones_like(share)
    np.fill_diagonal(r, 1.0)
    k = ((6.0 / np.maximum(r, 2.8)) ** 6 + 0.1 * (r < 15.0)) * share**2
    apart = np.abs(np.subtract.outer(np.arange(len(x)), np.arange(len(x))))
    k += 3.0 * ((apart <= 3) & (r < 4.3 * np.maximum(apart, 1)))
    np.fill_diagonal(k, 0.0)
    return np.where(k < 1e-6, 0.0, k)


@pytest.mark.parametrize("count", [2, 7, 8, 9, 60])
def test_they_are_the_pseudoinverse_of_kirchhoffs_matrix(count):
    steps = np.random.default_rng(count).normal(size=(count, 3))
    x = np.cumsum(3.8 * steps / np.linalg.norm(steps, axis=1)[:, None], axis=0)
    k = springs(x)
    expected = np.diag(np.linalg.pinv(np.diag(k.sum(axis=1)) - k, hermitian=True))
    found = pliant.node_b_factors(x)
    np.testing.assert_allclose(found, expected / expected.mean(), rtol=1e-9)


def test_residues_of_a_structure_by_their_alpha_carbons():
    structure = pliant.read(MOLECULES / "peptide_20.pdb")
    values, atoms = pliant.estimate_b_factors(structure)
    assert structure.names[atoms].tolist() == ["CA"] * 20
    assert values.mean() == pytest.approx(1.0)
    np.testing.assert_array_equal(values, pliant.node_b_factors(structure.positions[atoms]))
    assert values[0] > values[10] < values[19]


def test_chains_are_reported_apart_by_equal_numbers_that_follow():
    x = np.array([[0.0, 0, 0], [3.8, 0, 0], [7.6, 0, 0], [7.6, 3.8, 0]])
    one, two = pliant.node_b_factors(x), pliant.node_b_factors(x, [5, 5, 2, 2])
    assert not np.array_equal(one, two)
    np.testing.assert_array_equal(one, pliant.node_b_factors(x, [7] * 4))


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        (([[0.0, 0, 0]],), pliant.OptionError, "network: 1 node; it needs 2 or more"),
        (([[0.0, 0, 0]] * 2, [1]), pliant.InputError,
         "chains: expected 2, one for each position, found 1"),
        (([[0.0, 0, 0], [np.nan, 0, 0]],), pliant.InputError,
         "network: the position of node 1 is not finite"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_is_wrong_is_said(arguments, error, said):
    with pytest.raises(error) as raised:
        pliant.node_b_factors(*arguments)
    assert str(raised.value) == said


def test_a_molecule_without_residues_has_none():
    with pytest.raises(pliant.OptionError, match="0 nodes"):
        pliant.estimate_b_factors(pliant.read(MOLECULES / "caffeine.sdf"))
