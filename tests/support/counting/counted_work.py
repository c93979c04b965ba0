# SPDX-License-Identifier: MIT
"""Small fixed workloads that stand for pliant lab bench work-precision, throughput and step."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pliant

MOLECULES = Path(__file__).resolve().parents[3] / "data/molecules"
BARS = ("bonds", "angles")
WEIGHTINGS = (0.5, 0.75, 1.0)
# Of what valgrind 3.19 runs: it knows neither AVX-512 nor all of AVX2.
LEVELS = ("v2", "portable")
IN_LANES = ("bfs_cycle", "blocks", "shake", "newton")
WALKERS = 8  # one group of lanes
RACE = {"molecules": ("caffeine.sdf", "peptide_20.pdb"), "tolerances": (1e-4, 1e-8, 1e-12)}
RACE_SWEEPS = 50  # who needs more is measured by so many
STEPS, RESIDUES = 400, 800
AUTO_TOLERANCES, COPIES, ROUNDS = (1e-6, 1e-10), 4, 3

Work = Callable[[], int]  # returns how many bars it looked at


class Row(NamedTuple):
    """What is counted: the instructions of `work`, less those of `less` if there is one."""

    name: str
    work: Work
    less: Work | None = None


def rows() -> Iterator[Row]:
    """All workloads; each is to be run before the next is made."""
    for bars in BARS:
        yield from work_precision(bars)
    yield from throughput()
    yield from steps()
    for path in sorted(MOLECULES.iterdir()):
        for bars in BARS:
            yield auto(path, bars)


def read(name: str, bars: str) -> tuple[pliant.Framework, np.ndarray]:
    """The framework of a molecule, and positions in which it is whole."""
    structure = pliant.read(MOLECULES / name)
    return structure.framework(bars), np.array(structure.positions, dtype=float)


def broken(positions: np.ndarray, count: int) -> np.ndarray:
    """Copies, each coordinate off by a normal deviate of 0.1 Angstrom."""
    # RandomState draws the same numbers in every version of numpy.
    draw = np.random.RandomState(0)
    return positions + 0.1 * draw.standard_normal((count, *positions.shape))


def weightings(row: pliant.TechniqueEntry) -> tuple[float, ...]:
    """Those that are measured; one if they mean nothing."""
    return WEIGHTINGS if row.has_weighting else (0.5,)


def repairs(resolver: pliant.Resolver, copies: np.ndarray) -> Work:
    """One after the other; its first run has made the plans."""

    def work() -> int:
        return sum(resolver.resolve(x.copy()).projections for x in copies)

    work()
    return work


def repairs_in_lanes(resolver: pliant.WalkerResolver, copies: np.ndarray) -> Work:
    """All at once."""

    def work() -> int:
        done = resolver.resolve(copies.copy(), measured="nothing")
        return sum(summary.projections for summary in done)

    work()
    return work


def one_by_one(works: list[Work]) -> Work:
    """All of them as one."""
    return lambda: sum(work() for work in works)


def work_precision(bars: str) -> Iterator[Row]:
    """Every technique; its weightings, and molecules and tolerances, are one row."""
    targets = [read(name, bars) for name in RACE["molecules"]]
    for row in pliant.techniques():
        if row.forests_only:  # none of the molecules is one
            continue
        asked = [
            (
                framework,
                positions,
                {"technique": row.name, "weighting": w, "tolerance": t, "max_sweeps": RACE_SWEEPS},
            )
            for framework, positions in targets
            for w in weightings(row)
            for t in RACE["tolerances"]
        ]
        alone = [repairs(pliant.Resolver(f, **o), broken(x, 1)) for f, x, o in asked]
        yield Row(f"work-precision {bars} {row.name}", one_by_one(alone))
        if row.name in IN_LANES:
            lanes = [
                repairs_in_lanes(pliant.WalkerResolver(f, **o, level=LEVELS[0]), broken(x, WALKERS))
                for f, x, o in asked
            ]
            yield Row(f"work-precision {bars} {row.name}_lanes", one_by_one(lanes))


def throughput() -> Iterator[Row]:
    """A peptide's conformers, in lanes and without."""
    framework, positions = read("peptide_20.pdb", "bonds")
    conformers = broken(positions, 4 * WALKERS)
    for technique in IN_LANES:
        alone = pliant.WalkerResolver(framework, technique, 1.0, lanes=False)
        yield Row(f"throughput {technique}", repairs_in_lanes(alone, conformers))
        for level in LEVELS:
            lanes = pliant.WalkerResolver(framework, technique, 1.0, level=level)
            yield Row(f"throughput {technique} {level}", repairs_in_lanes(lanes, conformers))


def steps() -> Iterator[Row]:
    """Steps of a run after the first ones, so that plans do not count."""
    large, small = peptide(RESIDUES), read("peptide_20.pdb", "bonds")
    for technique in ("blocks", "auto"):
        yield step_row(f"step {technique}", *large, technique=technique)
    for perturb in ("force_all", "displacement"):
        yield step_row(f"step auto {perturb}", *small, perturb=perturb)


def step_row(name: str, framework: pliant.Framework, positions: np.ndarray, **options) -> Row:
    """A run, less one with a third of its steps."""

    def work(count: int) -> int:
        done = pliant.run(framework, positions, steps=count, every=count, seed=1, **options)
        return done.projections

    return Row(name, lambda: work(3 * STEPS), lambda: work(STEPS))


def peptide(residues: int) -> tuple[pliant.Framework, np.ndarray]:
    """A long zigzag of residues: six atoms in the chain and its branches, a ring in every fifth."""
    chain = [(0, 0, 0), (1.4, 0.5, 0), (2.5, -0.4, 0), (2.5, -1.6, 0.1), (1.4, 1.4, 1.2)]
    shape = np.array([*chain, (0.4, 2.2, 1.6), (1.2, 3.3, 2.2), (2.5, 2.4, 1.9)])
    own = [(0, 1), (1, 2), (2, 3), (1, 4), (4, 5), (5, 6), (6, 7)]
    positions, bars = [], []
    for k in range(residues):
        first = len(shape) * k
        positions.append(shape * (1, 1 if k % 2 else -1, 1) + (3.8 * k, 0, 0))
        bars += [(first + a, first + b) for a, b in own]
        bars += [(first + 7, first + 4)] if k % 5 == 0 else []
        bars += [(first - len(shape) + 2, first)] if k else []
    placed = np.concatenate(positions)
    return pliant.Framework(np.array(bars, dtype=np.uint32), positions=placed), placed


def auto(path: Path, bars: str) -> Row:
    """What auto takes for a molecule, at both tolerances."""
    framework, positions = read(path.name, bars)
    copies = np.concatenate([broken(positions, COPIES)] * ROUNDS)
    resolvers = [pliant.Resolver(framework, tolerance=t) for t in AUTO_TOLERANCES]
    work = one_by_one([repairs(resolver, copies) for resolver in resolvers])
    return Row(f"auto {path.stem} {bars}", work)
