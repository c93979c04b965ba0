# SPDX-License-Identifier: MIT
"""shake ends where OpenMM's CCMA does; newton where scipy finds the nearest whole positions."""

import numpy as np
import pytest
import scipy.optimize
from pliant.checks.openmm.child import Job, run_jobs
from real_files import MOLECULES

import pliant
from pliant.measure import bars as _bars

NM = 0.1


def molecule(name):
    structure = pliant.read(MOLECULES / name)
    return structure.framework(), np.array(structure.positions)


def displaced(positions, size, seed=1):
    return positions + np.random.default_rng(seed).normal(scale=size, size=positions.shape)


def constrain_step(framework, whole, broken, tolerance):
    """OpenMM's answer in a step of dynamics from `whole` to `broken`, in Angstrom."""
    triples = _bars.bar_pairs(framework.bars, len(whole))
    job = Job(
        "constrain_step",
        {"tolerance": tolerance, "platform": "Reference", "repeats": 1, "budget_seconds": 60.0},
        {
            "masses": 1 / framework.inverse_masses,
            "bars": framework.bars,
            "rest_lengths": framework.rest_lengths * NM,
            "intact": whole[None] * NM,
            "broken": broken[None, None] * NM,
            "triples": triples,
            "angles": _bars.angles_between(whole, triples)[None],
        },
    )
    (outcome,), _ = run_jobs([job])
    assert outcome.done, outcome.brief()
    return outcome.arrays["positions"][0, 0] / NM


@pytest.mark.parametrize("name", ["peptide_20.pdb", "caffeine.sdf", "cholesterol.cif"])
@pytest.mark.parametrize("size", [0.01, 0.05])
def test_shake_ends_where_ccma_does(name, size):
    framework, whole = molecule(name)
    broken = displaced(whole, size)
    theirs = constrain_step(framework, whole, broken, 1e-12)
    assert np.abs(pliant.residuals(framework, theirs)).max() < 1e-11, "CCMA got there"
    ours = broken.copy()
    summary = pliant.resolve(framework, ours, "shake", tolerance=1e-13, reference=whole)
    assert summary.converged
    assert summary.finishing_sweeps == 0
    apart = np.linalg.norm(ours - theirs, axis=1).max()
    assert apart < 1e-10 * framework.rest_lengths.min()
    assert np.linalg.norm(theirs - broken, axis=1).max() > size, "there was something to mend"


def test_shake_without_the_reference_ends_elsewhere():
    framework, whole = molecule("caffeine.sdf")
    broken = displaced(whole, 0.05)
    with_reference, without = broken.copy(), broken.copy()
    pliant.resolve(framework, with_reference, "shake", tolerance=1e-12, reference=whole)
    pliant.resolve(framework, without, "shake", tolerance=1e-12)
    assert np.linalg.norm(with_reference - without, axis=1).max() > 1e-3


def rigidity_rows(framework, positions):
    i, j = framework.bars.T
    delta = positions[j] - positions[i]
    rows = np.zeros((len(i), *positions.shape))
    rows[np.arange(len(i)), i] = -delta
    rows[np.arange(len(i)), j] = delta
    return rows.reshape(len(i), -1)


def off_stationary(framework, positions, broken):
    """The part of M (x - broken) that is no combination of the rows of the rigidity matrix."""
    masses = np.repeat(1 / framework.inverse_masses, 3)
    rows = rigidity_rows(framework, positions) / np.sqrt(masses)
    moved = np.sqrt(masses) * (positions - broken).ravel()
    multipliers = np.linalg.lstsq(rows.T, moved, rcond=None)[0]
    return np.abs(moved - rows.T @ multipliers).max() / np.abs(moved).max()


@pytest.mark.parametrize("size", [0.03, 0.1, 0.3])
@pytest.mark.parametrize("name", ["caffeine.sdf", "cholesterol.cif", "crown_18_6.cif", "c60.xyz"])
def test_newton_is_stationary(name, size):
    framework, whole = molecule(name)
    broken = displaced(whole, size)
    x = broken.copy()
    summary = pliant.resolve(framework, x, "newton", tolerance=1e-12)
    assert summary.converged
    assert summary.finishing_sweeps == 0
    assert off_stationary(framework, x, broken) < 1e-11


def test_newton_is_as_near_as_scipy_finds():
    framework, whole = molecule("caffeine.sdf")
    broken = displaced(whole, 0.1)
    masses = np.repeat(1 / framework.inverse_masses, 3)
    i, j = framework.bars.T

    def stretch(flat):
        delta = flat.reshape(-1, 3)[j] - flat.reshape(-1, 3)[i]
        return ((delta**2).sum(axis=1) - framework.rest_lengths**2) / 2

    found = scipy.optimize.minimize(
        lambda flat: 0.5 * masses @ (flat - broken.ravel()) ** 2,
        whole.ravel(),
        jac=lambda flat: masses * (flat - broken.ravel()),
        constraints={
            "type": "eq",
            "fun": stretch,
            "jac": lambda flat: rigidity_rows(framework, flat.reshape(-1, 3)),
        },
        method="SLSQP",
        options={"ftol": 1e-14, "maxiter": 500},
    )
    assert found.success, found.message
    x = broken.copy()
    assert pliant.resolve(framework, x, "newton", tolerance=1e-12).converged
    np.testing.assert_allclose(x, found.x.reshape(-1, 3), rtol=0, atol=1e-5)
    assert 0.5 * masses @ (x - broken).ravel() ** 2 <= found.fun * (1 + 1e-9)


@pytest.mark.parametrize("technique", ["blocks", "newton", "shake"])
@pytest.mark.parametrize("name", ["benzene.sdf", "caffeine.sdf", "peptide_20.pdb"])
def test_redundant_bars_of_angles_are_made_whole_without_sweeps(name, technique):
    """Flat groups are rigid to second order only: sweeps crawl, and OpenMM gives NaN."""
    structure = pliant.read(MOLECULES / name)
    framework, whole = structure.framework(bars="angles"), np.array(structure.positions)
    for seed in range(5):
        x = displaced(whole, 0.06, seed)
        summary = pliant.resolve(framework, x, technique, tolerance=1e-6)
        assert summary.converged, summary.brief(framework)
        assert summary.finishing_sweeps == 0
        off = np.abs(pliant.residuals(framework, x)) / framework.rest_lengths
        assert off.max() <= 1e-6
