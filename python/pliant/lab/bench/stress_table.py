# SPDX-License-Identifier: MIT
"""More cases of ``pliant lab bench stress``: large, redundant, from peers, long runs; and all."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

import pliant
from pliant.lab.bench.stress_cases import (
    Broken,
    Case,
    bent_chain,
    broken,
    coincident,
    complete,
    examples,
    lengths,
    masses,
    not_finite,
    offsets,
    pushes,
    ring,
    shaken,
    straight_chain,
)

FEW_SWEEPS = 20  #: of large frameworks: enough to see that nothing breaks
STEPS = 10_000


def large(shrink: int) -> Iterator[Case]:
    """Families that overrun a recursion, a quadratic loop or a 32-bit counter."""
    sizes = {
        "straight_chain": (1_000_000, straight_chain),
        "bent_chain": (1_000_000, bent_chain),
        "cycle": (100_000, ring),
        "star": (100_000, _star),
    }
    for name, (count, make) in sizes.items():
        size = max(count // shrink, 10)
        yield Case(
            f"{name}_{size}",
            "large",
            "closed form",
            partial(lambda make, size: _bent_once(make(size)), make, size),
            max_sweeps=FEW_SWEEPS,
        )
    count = max(200 // min(shrink, 20), 10)
    what = "3 n - 6 of n (n - 1) / 2 bars are independent"
    start = partial(lambda count: shaken(complete(count), 0.01), count)
    yield Case(f"K_{count}", "large", what, start, max_sweeps=1000)


def _star(leaves: int) -> Broken:
    """Leaves a unit away from joint 0, spread by the golden angle."""
    k = np.arange(leaves) + 0.5
    polar, around = np.arccos(1 - 2 * k / leaves), np.pi * (1 + 5**0.5) * k
    x = np.column_stack(
        [np.cos(around) * np.sin(polar), np.sin(around) * np.sin(polar), np.cos(polar)]
    )
    bars = np.column_stack([np.zeros(leaves, int), np.arange(1, leaves + 1)])
    return broken(np.concatenate([[[0.0, 0, 0]], x]), bars, np.ones(leaves))


def _bent_once(whole: Broken) -> Broken:
    whole.positions[len(whole.positions) // 2] += (0.1, 0.1, 0.1)
    return whole


def redundant() -> Iterator[Case]:
    """Bars that ask twice for the same, agreeing or not."""
    closed = "closed form"
    two = [[0.0, 0.0, 0.0], [1.1, 0.0, 0.0]]
    yield Case(
        "duplicate_bar_same_length",
        "redundant",
        closed,
        lambda: broken(two, [[0, 1], [1, 0]], [1, 1]),
    )
    yield Case(
        "duplicate_bar_conflict_1_2",
        "impossible",
        closed,
        lambda: broken(two, [[0, 1], [1, 0]], [1, 2]),
        feasible=False,
    )
    yield Case("dodecahedron_edges", "redundant", "Schlaefli: 20 vertices, 30 edges", _dodecahedron)
    for n in (6, 8):
        what = "3 n - 6 of n (n - 1) / 2 bars are independent"
        start = partial(lambda n: shaken(complete(n), 1.0), n)
        yield Case(f"K_{n}_far_off", "redundant", what, start, feasible=True)
    yield Case(
        "two_far_atoms_of_a_pinned_square", "impossible", closed, _pinned_square, feasible=False
    )


def _dodecahedron() -> Broken:
    golden = (1 + 5**0.5) / 2
    signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
    pairs = np.array(np.meshgrid([-1, 1], [-1, 1])).reshape(2, -1).T
    rows = [np.column_stack([np.zeros(4), pairs[:, 0] / golden, pairs[:, 1] * golden])]
    rows += [np.roll(rows[0], 1, axis=1), np.roll(rows[0], 2, axis=1)]
    x = np.concatenate([signs, *rows])
    apart = np.linalg.norm(x[:, None] - x[None], axis=2)
    bars = np.argwhere(np.triu(np.isclose(apart, 2 / golden)))
    return shaken(broken(x, bars), 0.1)


def _pinned_square() -> Broken:
    x = [[0, 0, 0], [5, 0, 0], [5, 1, 0], [0, 1, 0]]
    bars = [[0, 1], [1, 2], [2, 3], [3, 0]]
    return broken(x, bars, [1, 1, 1, 1], pinned=np.array([0, 1], np.uint32))


def peers() -> Iterator[Case]:
    """What other programs have met with."""
    for tolerance in (1e-2, 1e-4, 1e-8):
        yield Case(
            f"openmm_3603_diamond_{tolerance:.0e}",
            "peers",
            "OpenMM issue 3603: masses, lengths and coordinates",
            _diamond,
            tolerance=tolerance,
        )
    source = "OpenMM, tests/TestVerletIntegrator.h: unit chain of random directions"
    for count in (10, 1500):
        yield Case(
            f"openmm_chain_{count}",
            "peers",
            source,
            partial(lambda count: shaken(_random_chain(count), 0.1), count),
        )


def _diamond() -> Broken:
    """Four beads of Martini's cholesterol, coordinates from nm to Angstrom, five bars."""
    x = 10 * np.array(
        [[5.566, 7.728, 3.213], [5.494, 7.973, 3.631], [5.354, 7.788, 3.773], [5.295, 7.811, 4.307]]
    )
    bars = [[0, 1], [0, 2], [1, 2], [3, 1], [3, 2]]
    rest = 10 * np.array([0.4904, 0.6019, 0.2719, 0.7237, 0.5376])
    return broken(x, bars, rest, masses=np.full(4, 50.0))


def _random_chain(count: int, seed: int = 0) -> Broken:
    steps = np.random.Generator(np.random.PCG64(seed)).normal(size=(count, 3))
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    joints = np.arange(count)
    return broken(np.cumsum(steps, axis=0), np.column_stack([joints[:-1], joints[1:]]))


def long_runs(steps: int) -> Iterator[Case]:
    """Closed mechanisms, pushed again and again."""
    known = {row.name: row for row in pliant.examples()}
    for name in ("peaucellier_cell_2D", "cyclohexane_boat"):
        row = known[name]
        bars = row.framework.bars, row.framework.rest_lengths
        start, title = partial(broken, row.positions, *bars), f"{name}_{steps}_steps"
        yield Case(title, "steps", row.source, start, max_sweeps=1000, steps=steps)


def all_cases(shrink: int = 1, steps: int = STEPS) -> list[Case]:
    """The whole table; large frameworks are made `shrink` times smaller."""
    tables = [examples(), coincident(), lengths(), offsets(), pushes(), masses(), not_finite()]
    tables += [redundant(), peers(), large(shrink), long_runs(steps)]
    return [case for table in tables for case in table]
