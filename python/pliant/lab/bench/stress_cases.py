# SPDX-License-Identifier: MIT
"""What repairing is tried on where it is hard: the cases of ``pliant lab bench stress``."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial

import numpy as np
import numpy.typing as npt

import pliant
from pliant.measure import bars as _bars


@dataclass
class Broken:
    """Bars and the positions from which they are to be made whole."""

    positions: np.ndarray  #: (N, 3) Angstrom
    bars: np.ndarray  #: (B, 2)
    rest_lengths: np.ndarray  #: (B,) Angstrom
    masses: np.ndarray  #: (N,) u
    pinned: np.ndarray = field(default_factory=lambda: np.empty(0, np.uint32))


@dataclass(frozen=True)
class Case:
    """A row of the table."""

    name: str
    group: str
    source: str
    make: Callable[[], Broken]
    feasible: bool | None = True  #: None: not known
    tolerance: float = 1e-6
    max_sweeps: int = 10_000
    steps: int = 0  #: of a run, in place of one repair
    mass_weighted: bool = False


def broken(
    positions: npt.ArrayLike,
    bars: npt.ArrayLike,
    rest_lengths: npt.ArrayLike | None = None,
    masses: np.ndarray | None = None,
    pinned: np.ndarray | None = None,
) -> Broken:
    """From lists; masses default to 1, rest lengths to the distances there are."""
    x = np.asarray(positions, dtype=float).reshape(-1, 3)
    pairs = np.asarray(bars, dtype=np.int64).reshape(-1, 2)
    rest = _bars.lengths(x, pairs) if rest_lengths is None else np.array(rest_lengths, float)
    made = Broken(x, pairs, rest, np.ones(len(x)) if masses is None else masses)
    return made if pinned is None else dataclasses.replace(made, pinned=pinned)


def shaken(whole: Broken, size: float, seed: int = 0) -> Broken:
    """The same with every coordinate of joints that are not pinned off by `size` Angstrom."""
    moved = _bars.displaced(whole.positions, size, seed)
    moved[whole.pinned] = whole.positions[whole.pinned]
    return Broken(moved, whole.bars, whole.rest_lengths, whole.masses, whole.pinned)


def _example(example: pliant.Example) -> Broken:
    framework = example.framework
    inverse = np.array(framework.inverse_masses)
    masses = np.divide(1.0, inverse, out=np.ones_like(inverse), where=inverse > 0)
    pinned, lengths = np.array(framework.pinned), framework.rest_lengths
    made = broken(example.positions, framework.bars, lengths, masses=masses, pinned=pinned)
    if not example.facts.whole or framework.bar_count == 0:
        return made
    return shaken(made, 0.1 * float(made.rest_lengths.min()))


def examples() -> Iterator[Case]:
    """Every example of the library; whole ones shaken by a tenth of their shortest bar."""
    for row in pliant.examples():
        yield Case(
            row.name, "examples", row.source, partial(_example, row), feasible=row.facts.feasible
        )


def bent_chain(count: int, length: float = 1.0) -> Broken:
    """A staircase of `count` joints in space."""
    steps = np.eye(3)[np.arange(count) % 3] * length
    joints = np.arange(count)
    return broken(np.cumsum(steps, axis=0), np.column_stack([joints[:-1], joints[1:]]))


def straight_chain(count: int) -> Broken:
    """A chain of unit bars along x."""
    joints = np.arange(count)
    x = np.column_stack([joints, np.zeros((count, 2))])
    return broken(x, np.column_stack([joints[:-1], joints[1:]]))


def ring(count: int) -> Broken:
    """A regular polygon of unit sides."""
    angle = 2 * np.pi * np.arange(count) / count
    radius = 0.5 / np.sin(np.pi / count)
    x = radius * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    joints = np.arange(count)
    return broken(x, np.column_stack([joints, (joints + 1) % count]), np.ones(count))


def complete(count: int, seed: int = 0) -> Broken:
    """Joints at random places in a cube, each joined to each."""
    x = np.random.Generator(np.random.PCG64(seed)).random((count, 3)) * count ** (1 / 3)
    return broken(x, np.column_stack(np.triu_indices(count, 1)))


def _at_one_place(whole: Broken) -> Broken:
    return Broken(np.zeros_like(whole.positions), whole.bars, whole.rest_lengths, whole.masses)


def coincident() -> Iterator[Case]:
    """All joints at one place, where no bar has a direction."""
    for name, make in {
        "chain_10": lambda: bent_chain(10),
        "ring_6": lambda: ring(6),
        "K4": lambda: complete(4),
        "K5": lambda: complete(5),
    }.items():
        yield Case(
            f"coincident_{name}",
            "coincident",
            "closed form",
            partial(lambda make: _at_one_place(make()), make),
        )


def lengths() -> Iterator[Case]:
    """Bars of zero length, next to zero, and of twelve decades in one framework."""
    for length in (0.0, 1e-310, 1e200):
        yield Case(
            f"bar_of_{length:g}",
            "lengths",
            "squares of lengths underflow or overflow",
            partial(broken, [[0, 0, 0], [1, 0, 0]], [[0, 1]], [length]),
            feasible=None,
        )
    for length in (1e-150, 1e-100, 1e-12, 1e-6, 1e6, 1e100, 1e150):
        yield Case(
            f"chain_with_a_bar_of_{length:g}",
            "lengths",
            "closed form",
            partial(_with_one_length, length),
            feasible=None if length < 1e-12 else True,
        )
    yield Case("lengths_1e-6_to_1e6_chain", "lengths", "closed form", _thirteen_decades)
    yield Case("lengths_1e-6_to_1e6_ring", "lengths", "closed form", _thirteen_decades_closed)


def _with_one_length(length: float) -> Broken:
    made = shaken(bent_chain(5), 0.1)
    made.rest_lengths[2] = length
    return made


def _thirteen_decades(push: float = 0.1) -> Broken:
    size = 10.0 ** np.arange(-6, 7)
    steps = np.eye(3)[np.arange(13) % 2] * size[:, None]
    x = np.concatenate([[[0.0, 0, 0]], np.cumsum(steps, axis=0)])
    joints = np.arange(14)
    made = broken(x, np.column_stack([joints[:-1], joints[1:]]), size)
    made.positions[1:] += push * steps
    return made


def _thirteen_decades_closed() -> Broken:
    chain = _thirteen_decades(0.0)
    bars = np.concatenate([chain.bars, [[0, 13]]])
    made = broken(chain.positions, bars)
    made.positions[1:] *= 1.1
    return made


def offsets() -> Iterator[Case]:
    """Far from the origin, where doubles lie far apart."""
    for exponent in range(0, 13, 2):
        for name, make in (("chain_10", lambda: bent_chain(10)), ("ring_17", lambda: ring(17))):
            yield Case(
                f"{name}_at_1e{exponent}",
                "offset",
                "doubles are 2.2e-16 of a coordinate apart",
                partial(lambda make, by: _moved(shaken(make(), 0.1), by), make, 10.0**exponent),
                feasible=True if exponent <= 8 else None,
            )


def _moved(whole: Broken, by: float) -> Broken:
    return Broken(whole.positions + by, whole.bars, whole.rest_lengths, whole.masses)


def pushes() -> Iterator[Case]:
    """One joint pushed from 1e-8 to 1e6 Angstrom away."""
    for exponent in range(-8, 7, 2):
        for name, make in (
            ("chain_10", lambda: bent_chain(10)),
            ("ring_17", lambda: ring(17)),
            ("K5", lambda: complete(5)),
        ):
            yield Case(
                f"{name}_pushed_1e{exponent}",
                "push",
                "closed form",
                partial(lambda make, by: _pushed(make(), by), make, 10.0**exponent),
            )


def _pushed(whole: Broken, by: float) -> Broken:
    whole.positions[len(whole.positions) // 2] += by * np.array([0.36, 0.48, 0.8])
    return whole


def masses() -> Iterator[Case]:
    """Neighbours a million million times as heavy as each other, corrections shared by mass."""
    for name, make in (("chain_10", lambda: bent_chain(10)), ("ring_17", lambda: ring(17))):
        start = partial(lambda make: _unequal(shaken(make(), 0.1)), make)
        title = f"{name}_of_masses_1e-6_to_1e6"
        yield Case(title, "masses", "closed form", start, mass_weighted=True, feasible=True)


def _unequal(whole: Broken) -> Broken:
    whole.masses = 10.0 ** np.where(np.arange(len(whole.masses)) % 2, 6, -6)
    return whole


def not_finite() -> Iterator[Case]:
    """Positions that are no numbers, or whose squares overflow: they come back as they were."""
    for value in (np.nan, np.inf, 1e200):
        yield Case(
            f"start_at_{value:g}",
            "not_finite",
            "IEEE 754",
            partial(lambda value: _moved_joint(ring(6), value), value),
            feasible=False,
        )


def _moved_joint(whole: Broken, to: float) -> Broken:
    whole.positions[2, 1] = to
    return whole
