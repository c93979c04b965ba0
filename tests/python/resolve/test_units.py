# SPDX-License-Identifier: MIT
"""Technique units beside scipy: best rotation of the first unit, best torsion of the next."""

import expected_warnings
import numpy as np
import pytest
from MDAnalysisTests import datafiles
from real_files import MOLECULES
from scipy.optimize import minimize, minimize_scalar
from scipy.spatial.transform import Rotation

import pliant


def angles_of(name):
    structure = pliant.read(str(MOLECULES / name))
    structure.perceive_bonds()
    return structure, structure.framework(bars="angles")


def broken(structure, size, seed):
    random = np.random.default_rng(seed)
    moves = random.normal(size=structure.positions.shape)
    moves *= size / np.linalg.norm(moves, axis=1)[:, None]
    return structure.positions + moves


def superposed(shape, target, weights):
    """`shape` moved rigidly onto `target` by scipy, reflections excluded."""
    middle = np.average(shape, axis=0, weights=weights)
    goal = np.average(target, axis=0, weights=weights)
    rotation, _ = Rotation.align_vectors(target - goal, shape - middle, weights=weights)
    return rotation.apply(shape - middle) + goal


@pytest.mark.parametrize("name", ["c60.xyz", "cubane.xyz", "cyclohexane_chair.xyz", "benzene.sdf"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_rigid_molecule_goes_where_align_vectors_puts_it(name, seed):
    structure, framework = angles_of(name)
    for size in (0.1, 0.5):
        positions = broken(structure, size, seed)
        expected = superposed(structure.positions, positions, np.ones(len(positions)))
        pliant.resolve(framework, positions, technique="units", tolerance=1e-12)
        assert np.abs(positions - expected).max() < 1e-12


def test_the_fit_is_weighted_by_mass():
    structure, framework = angles_of("benzene.sdf")
    positions = broken(structure, 0.3, 4)
    masses = 1.0 / framework.inverse_masses
    expected = superposed(structure.positions, positions, masses)
    pliant.resolve(framework, positions, technique="units", mass_weighted=True)
    assert np.abs(positions - expected).max() < 1e-12


def dihedral(points):
    """Of four points, in radians."""
    first, middle, last = np.diff(points, axis=0)
    left, right = np.cross(first, middle), np.cross(middle, last)
    return np.arctan2(np.linalg.norm(middle) * first @ right, left @ right)


def turned(points, origin, axis, angle):
    return Rotation.from_rotvec(angle * axis / np.linalg.norm(axis)).apply(points - origin) + origin


@pytest.mark.parametrize("seed", range(8))
def test_the_second_methyl_group_turns_as_far_as_a_minimiser_turns_it(seed):
    structure, framework = angles_of("ethane.xyz")
    start = broken(structure, 0.3, seed)
    positions = start.copy()
    pliant.resolve(framework, positions, technique="units", tolerance=1e-12)
    first, second = [0, 1, 2, 3, 4], [5, 6, 7]
    expected = superposed(structure.positions[first], start[first], np.ones(5))
    assert np.abs(positions[first] - expected).max() < 1e-12
    origin, axis = positions[0], positions[1] - positions[0]

    def badness(angle):
        return ((turned(positions[second], origin, axis, angle) - start[second]) ** 2).sum()

    best = minimize_scalar(badness, bounds=(-0.5, 0.5), method="bounded", options={"xatol": 1e-10})
    assert abs(best.x) < 1e-6
    assert badness(0.0) <= min(badness(angle) for angle in np.linspace(-np.pi, np.pi, 721)) + 1e-12


def test_torsions_are_all_that_changes():
    structure, framework = angles_of("butane.sdf")
    positions = broken(structure, 0.3, 1)
    pliant.resolve(framework, positions, technique="units", tolerance=1e-12)
    assert abs(dihedral(positions[:4]) - dihedral(structure.positions[:4])) > 1e-3
    assert np.abs(pliant.residuals(framework, positions)).max() < 1e-13


@pytest.mark.parametrize("seed", range(4))
def test_froda_without_a_reference_ends_near_where_a_minimiser_of_all_torsions_ends(seed):
    structure, framework = angles_of("butane.sdf")
    start = broken(structure, 0.3, seed)
    positions = start.copy()
    summary = pliant.resolve(framework, positions, technique="froda", tolerance=1e-12)
    assert summary.converged
    beyond = {(0, 1): [4, 5, 6], (1, 2): [0, 4, 5, 6, 7, 8], (2, 3): [11, 12, 13]}
    ends = {(0, 1): (1, 0), (1, 2): (2, 1), (2, 3): (2, 3)}

    def moved(turns):
        points = positions.copy()
        for (hinge, joints), angle in zip(beyond.items(), turns[:3], strict=True):
            near, far = (points[joint] for joint in ends[hinge])
            points[joints] = turned(points[joints], near, far - near, angle)
        return superposed(points, start, np.ones(len(points)))

    def badness(turns):
        return ((moved(turns) - start) ** 2).sum()

    here = ((positions - start) ** 2).sum()
    best = minimize(badness, np.zeros(3), method="Nelder-Mead", options={"xatol": 1e-8})
    assert here <= best.fun * 1.03
    assert np.abs(pliant.residuals(framework, moved(best.x))).max() < 1e-12


def many_of(framework, positions, copies):
    """Copies 100 Angstrom apart as one framework that does not know where its joints were drawn."""
    bars = [framework.bars + len(positions) * k for k in range(copies)]
    lengths = np.tile(framework.rest_lengths, copies)
    placed = [positions + np.array([100.0 * k, 0.0, 0.0]) for k in range(copies)]
    return pliant.Framework(np.concatenate(bars), lengths), np.concatenate(placed)


@pytest.mark.parametrize("technique", ["units", "auto"])
@pytest.mark.parametrize("copies", [3, 30, pytest.param(300, marks=pytest.mark.long)])
def test_angles_that_were_never_drawn_cost_as_much_a_bar_at_any_size(technique, copies):
    """A protein's angles, up to 10^6 atoms: once 447 s, to no end."""
    structure = expected_warnings.read_without_elements(datafiles.PDB_small)
    kinase = structure.framework(bars="angles")
    framework, positions = many_of(kinase, structure.positions, copies)
    positions += np.random.default_rng(3).normal(0.0, 0.3, positions.shape)
    summary = pliant.resolve(framework, positions, technique)
    assert summary.converged
    assert summary.projections <= 3 * len(framework.bars)
