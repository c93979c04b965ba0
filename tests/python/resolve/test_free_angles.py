# SPDX-License-Identifier: MIT
"""Angles that are free in a count of freedoms, against the rank of joints and bars."""

from __future__ import annotations

from itertools import combinations, permutations, product
from typing import Any

import numpy as np
import pytest

import pliant

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")

Pairs = list[tuple[int, int]]


def sodalite_cage() -> tuple[Any, Pairs]:
    """24 Si at the corners of a truncated octahedron, 36 O between them, in general position; the
    pair of Si of each O."""
    signs = product((1, -1), repeat=2)
    corners = {p for one, two in signs for p in permutations((0, one, 2 * two))}
    silicon = np.array(sorted(corners), dtype=float)
    pairs = [
        (a, b)
        for a, b in combinations(range(24), 2)
        if np.isclose(np.sum((silicon[a] - silicon[b]) ** 2), 2)
    ]
    oxygen = np.array([(silicon[a] + silicon[b]) / 2 * 1.05 for a, b in pairs])
    positions = np.concatenate([silicon, oxygen]) * 3.1 / np.sqrt(2)
    positions += np.random.default_rng(3).normal(0, 0.05, positions.shape)
    bonds = [(k, 24 + o) for o, pair in enumerate(pairs) for k in pair]
    made = pliant.Structure(positions, elements=[14] * 24 + [8] * 36, bonds=bonds)
    return made, pairs


def freedoms_of_bars(structure: Any, centres: range) -> int:
    """3 N - 6 - the rank of bars along bonds, and across the angles at these atoms."""
    bars = {tuple(pair) for pair in structure.bonds.tolist()}
    for centre in centres:
        around = [sum(pair) - centre for pair in structure.bonds.tolist() if centre in pair]
        bars |= set(combinations(sorted(around), 2))
    x = structure.positions
    matrix = np.zeros((len(bars), x.size))
    for row, (a, b) in zip(matrix, bars, strict=True):
        row[3 * a : 3 * a + 3] = x[a] - x[b]
        row[3 * b : 3 * b + 3] = x[b] - x[a]
    return x.size - 6 - int(np.linalg.matrix_rank(matrix))


def test_a_sodalite_cage_moves_once_its_oxygens_are_free() -> None:
    cage, pairs = sodalite_cage()
    assert (len(cage), len(pairs)) == (60, 36)
    held = pliant.rigidity(cage)
    assert (held.rigid_clusters, held.degrees_of_freedom) == (1, 0)
    free = pliant.rigidity(cage, free_angles="element O")
    assert free.rigid_clusters > 1
    assert free.degrees_of_freedom == freedoms_of_bars(cage, range(24)) == 30


def random_tree(count: int, seed: int) -> Any:
    """Atoms of at most four bonds in general position."""
    chance = np.random.default_rng(seed)
    bonds: Pairs = []
    degree = [0] * count
    for atom in range(1, count):
        to = int(chance.choice([k for k in range(atom) if degree[k] < 4]))
        bonds.append((to, atom))
        degree[to] += 1
        degree[atom] += 1
    positions = chance.normal(0, 1, (count, 3))
    return pliant.Structure(positions, elements=[6] * count, bonds=bonds), degree


@pytest.mark.parametrize("seed", range(20))
def test_free_angles_of_branched_molecules_count_as_joints_and_bars(seed: int) -> None:
    """Each freed atom has a neighbour whose angles are held; ends hang on any of them."""
    made, degree = random_tree(20, seed)
    pairs = made.bonds.tolist()
    around = [[sum(pair) - k for pair in pairs if k in pair] for k in range(20)]
    freed: list[int] = []
    for k in range(20):
        inner = [j for j in around[k] if degree[j] > 1 and j not in freed]
        keeps = all(
            any(degree[j] > 1 and j not in freed and j != k for j in around[f]) for f in freed
        )
        if degree[k] > 1 and inner and keeps and k % 2 == seed % 2:
            freed.append(k)
    assert freed
    held = [k for k in range(20) if k not in freed]
    names = " ".join(str(k) for k in freed)
    found = pliant.rigidity(made, free_angles=f"index {names}")
    assert found.degrees_of_freedom == freedoms_of_bars(made, held)


def test_an_atom_beside_none_whose_angles_are_held_is_refused() -> None:
    cage, _ = sodalite_cage()
    with pytest.raises(pliant.OptionError) as caught:
        pliant.rigidity(cage, free_angles="all")
    assert str(caught.value) == (
        f"free angles: {cage.label(0)} has no neighbour with several bonds whose own angles are "
        "held"
    )
    with pytest.raises(pliant.OptionError, match="free angles: selection"):
        pliant.rigidity(cage, free_angles="element Au")
