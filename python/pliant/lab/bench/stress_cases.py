# SPDX-License-Identifier: MIT
"""What repairing is tried on where it is hard: the cases of ``pliant lab bench stress``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np
import numpy.typing as npt

import pliant
from pliant.lab.bench.stress_frameworks import (
    Broken,
    along,
    bent_chain,
    broken,
    complete,
    diamond,
    dodecahedron,
    random_chain,
    ring,
    shaken,
    star,
    straight_chain,
)

FEW_SWEEPS = 20  #: of large frameworks: enough to see that nothing breaks
STEPS = 10_000


Make = Callable[[], Broken]


@dataclass(frozen=True)
class Case:
    """A row of the table."""

    name: str
    group: str
    make: Make
    feasible: bool | None = True  #: None: not known
    tolerance: float = 1e-6
    max_sweeps: int = 10_000
    steps: int = 0  #: of a run, in place of one repair
    mass_weighted: bool = False


#: Small frameworks of which most groups have a case each.
SMALL: dict[str, Make] = {"chain_10": partial(bent_chain, 10), "ring_17": partial(ring, 17)}
K5 = partial(complete, 5)


def changed(make: Make, *changes: Callable[[Broken], object]) -> Make:
    """What makes a framework and then changes it."""

    def start() -> Broken:
        made = make()
        for change in changes:
            change(made)
        return made

    return start


def examples() -> Iterator[Case]:
    """Every example of the library; whole ones shaken by a tenth of their shortest bar."""
    for row in pliant.examples():
        yield Case(row.name, "examples", partial(_example, row), row.facts.feasible)


def _example(example: pliant.Example) -> Broken:
    framework = example.framework
    inverse = np.array(framework.inverse_masses)
    masses = np.divide(1.0, inverse, out=np.ones_like(inverse), where=inverse > 0)
    lengths, pinned = framework.rest_lengths, np.array(framework.pinned)
    made = broken(example.positions, framework.bars, lengths, masses, pinned)
    if not example.facts.whole or framework.bar_count == 0:
        return made
    return shaken(made, 0.1 * float(made.rest_lengths.min()))


def coincident() -> Iterator[Case]:
    """All joints at one place, where no bar has a direction."""

    def gather(whole: Broken) -> None:
        whole.positions[:] = 0.0

    chosen: dict[str, Make] = {"chain_10": SMALL["chain_10"], "ring_6": partial(ring, 6)}
    for name, make in (chosen | {"K4": partial(complete, 4), "K5": K5}).items():
        yield Case(f"coincident_{name}", "coincident", changed(make, gather))


def lengths() -> Iterator[Case]:
    """Bars of zero length, next to zero, whose squares overflow; twelve decades together."""
    for length in (0.0, 1e-310, 1e200):
        make = partial(broken, [[0, 0, 0], [1, 0, 0]], [[0, 1]], [length])
        yield Case(f"bar_of_{length:g}", "lengths", make, feasible=None)

    def set_length(whole: Broken, to: float) -> None:
        whole.rest_lengths[2] = to

    for length in (1e-150, 1e-100, 1e-12, 1e-6, 1e6, 1e100, 1e150):
        chain, change = partial(bent_chain, 5), partial(set_length, to=length)
        start = changed(chain, partial(shaken, size=0.1), change)
        known = None if length < 1e-12 else True
        yield Case(f"chain_with_a_bar_of_{length:g}", "lengths", start, known)
    yield Case("lengths_1e-6_to_1e6_chain", "lengths", _thirteen_decades)
    yield Case("lengths_1e-6_to_1e6_ring", "lengths", _thirteen_decades_closed)


def _thirteen_decades(push: float = 0.1) -> Broken:
    size = 10.0 ** np.arange(-6, 7)
    steps = np.eye(3)[np.arange(13) % 2] * size[:, None]
    places = np.concatenate([[[0.0, 0, 0]], np.cumsum(steps, axis=0)])
    made = broken(places, along(14), size)
    made.positions[1:] += push * steps
    return made


def _thirteen_decades_closed() -> Broken:
    chain = _thirteen_decades(0.0)
    made = broken(chain.positions, np.concatenate([chain.bars, [[0, 13]]]))
    made.positions[1:] *= 1.1
    return made


def offsets() -> Iterator[Case]:
    """Far from the origin, where doubles lie 2.2e-16 of a coordinate apart."""

    def move(whole: Broken, by: float) -> None:
        whole.positions += by

    for exponent in range(0, 13, 2):
        for name, make in SMALL.items():
            start = changed(make, partial(shaken, size=0.1), partial(move, by=10.0**exponent))
            yield Case(f"{name}_at_1e{exponent}", "offset", start, True if exponent <= 8 else None)


def pushes() -> Iterator[Case]:
    """One joint pushed from 1e-8 to 1e6 Angstrom away."""
    for exponent in range(-8, 7, 2):
        for name, make in (SMALL | {"K5": K5}).items():
            by = 10.0**exponent * np.array([0.36, 0.48, 0.8])
            start = changed(make, partial(_push, by=by))
            yield Case(f"{name}_pushed_1e{exponent}", "push", start)


def _push(whole: Broken, by: npt.ArrayLike) -> None:
    whole.positions[len(whole.positions) // 2] += by


def masses() -> Iterator[Case]:
    """Neighbours a million million times as heavy as each other, corrections shared by mass."""

    def weigh(whole: Broken) -> None:
        whole.masses = 10.0 ** np.where(np.arange(len(whole.masses)) % 2, 6, -6)

    for name, make in SMALL.items():
        start = changed(make, partial(shaken, size=0.1), weigh)
        yield Case(f"{name}_of_masses_1e-6_to_1e6", "masses", start, mass_weighted=True)


def not_finite() -> Iterator[Case]:
    """Positions that are no numbers, or whose squares overflow: they come back as they were."""

    def place(whole: Broken, at: float) -> None:
        whole.positions[2, 1] = at

    for value in (np.nan, np.inf, 1e200):
        start = changed(partial(ring, 6), partial(place, at=value))
        yield Case(f"start_at_{value:g}", "not_finite", start, feasible=False)


def redundant() -> Iterator[Case]:
    """Bars that ask twice for the same, agreeing or not; what cannot be."""
    two, twice = [[0.0, 0.0, 0.0], [1.1, 0.0, 0.0]], [[0, 1], [1, 0]]
    square = [[0, 0, 0], [5, 0, 0], [5, 1, 0], [0, 1, 0]]
    sides = [[0, 1], [1, 2], [2, 3], [3, 0]]
    yield Case("duplicate_bar_same_length", "redundant", partial(broken, two, twice, [1, 1]))
    conflict = partial(broken, two, twice, [1, 2])
    yield Case("duplicate_bar_conflict_1_2", "impossible", conflict, feasible=False)
    start = changed(dodecahedron, partial(shaken, size=0.1))
    yield Case("dodecahedron_edges", "redundant", start)
    for n in (6, 8):
        start = changed(partial(complete, n), partial(shaken, size=1.0))
        yield Case(f"K_{n}_far_off", "redundant", start)
    far = partial(broken, square, sides, np.ones(4), pinned=[0, 1])
    yield Case("two_far_atoms_of_a_pinned_square", "impossible", far, feasible=False)


def peers() -> Iterator[Case]:
    """What other programs have met with."""
    for tolerance in (1e-2, 1e-4, 1e-8):
        yield Case(f"openmm_3603_diamond_{tolerance:.0e}", "peers", diamond, tolerance=tolerance)
    for count in (10, 1500):
        start = changed(partial(random_chain, count), partial(shaken, size=0.1))
        yield Case(f"openmm_chain_{count}", "peers", start)


def large(shrink: int) -> Iterator[Case]:
    """Families that overrun a recursion, a quadratic loop or a 32-bit counter."""
    sizes: dict[str, tuple[int, Callable[[int], Broken]]] = {
        "straight_chain": (1_000_000, straight_chain),
        "bent_chain": (1_000_000, bent_chain),
        "cycle": (100_000, ring),
        "star": (100_000, star),
    }
    for name, (most, make) in sizes.items():
        size = max(most // shrink, 10)
        start = changed(partial(make, size), partial(_push, by=(0.1, 0.1, 0.1)))
        yield Case(f"{name}_{size}", "large", start, max_sweeps=FEW_SWEEPS)
    count = max(200 // min(shrink, 20), 10)
    start = changed(partial(complete, count), partial(shaken, size=0.01))
    yield Case(f"K_{count}", "large", start, max_sweeps=1000)


def long_runs(steps: int) -> Iterator[Case]:
    """Closed mechanisms, pushed again and again."""
    for row in pliant.examples():
        if row.name in ("peaucellier_cell_2D", "cyclohexane_boat"):
            start = partial(broken, row.positions, row.framework.bars, row.framework.rest_lengths)
            yield Case(f"{row.name}_{steps}_steps", "steps", start, max_sweeps=1000, steps=steps)


def all_cases(shrink: int = 1, steps: int = STEPS) -> list[Case]:
    """The whole table; large frameworks are made `shrink` times smaller."""
    tables = [examples(), coincident(), lengths(), offsets(), pushes(), masses(), not_finite()]
    tables += [redundant(), peers(), large(shrink), long_runs(steps)]
    return [case for table in tables for case in table]
