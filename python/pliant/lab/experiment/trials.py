# SPDX-License-Identifier: MIT
"""Pushed frameworks, and what techniques take to make them whole: sweeps and projections."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

import pliant
from pliant.checks.weightings import WEIGHTINGS
from pliant.lab.experiment.answer import Table

THESIS = tuple("random bfs_cycle dfs_cycle bfs_reverse dfs_reverse bfs_adapt bfs_random".split())
PUSH = 0.5  #: Angstrom: what 50 kJ/(mol Angstrom) do to 1 u in one step of 0.01 ps
TOLERANCE = 0.01  #: Angstrom
LIMIT = 2000  #: sweeps
REPLICATES = 1000

Combination = tuple[str, float]


@dataclass(frozen=True)
class Trial:
    """One joint of one framework pushed; all bars were whole before."""

    framework: pliant.Framework
    positions: np.ndarray  #: (N, 3) Angstrom, before the push
    root: int
    push: np.ndarray  #: (3,) Angstrom
    graph: int  #: pushes of one framework have the same number

    def pushed(self) -> np.ndarray:
        """Positions after the push, to be changed by whoever asks."""
        moved: np.ndarray = self.positions.copy()
        moved[self.root] += self.push
        return moved


def pushes_of(
    framework: pliant.Framework,
    positions: np.ndarray,
    count: int,
    key: tuple[int, int],
    length: float = PUSH,
) -> list[Trial]:
    """Random joints pushed into random directions; `key` = (seed, number of the framework)."""
    draws = np.random.Generator(np.random.Philox(key=np.array(key, dtype=np.uint64)))
    trials = []
    for _ in range(count):
        root = int(draws.integers(framework.joint_count))
        vector = draws.standard_normal(3)
        push = length * vector / np.linalg.norm(vector)
        trials.append(Trial(framework, positions, root, push, key[1]))
    return trials


def pushed_graphs(
    kind: str, graphs: int, pushes: int, seed: int, length: float = PUSH, **sizes: Any
) -> list[Trial]:
    """`pushes` trials on each of `graphs` random graphs of a class; sizes as pliant.generate."""
    trials = []
    for number in range(graphs):
        graph = pliant.generate(kind, seed, number, **sizes)
        trials += pushes_of(graph.framework, graph.positions, pushes, (seed, number), length)
    return trials


@dataclass(frozen=True)
class Work:
    """What a technique took, one entry a trial."""

    sweeps: np.ndarray
    projections: np.ndarray
    converged: np.ndarray
    seconds: np.ndarray
    graphs: np.ndarray

    @property
    def failures(self) -> int:
        """Trials that met the limit of sweeps."""
        return int(np.sum(~self.converged))


def work_of(
    trials: Sequence[Trial],
    technique: str,
    weighting: float = 0.5,
    *,
    length: float | None = TOLERANCE,
    relative: float = 1e-6,
    limit: int = LIMIT,
) -> Work:
    """Resolves each trial; the tolerance is `length` (Angstrom), or `relative` if that is None."""
    rows, resolver, owner = [], None, None
    for step, trial in enumerate(trials):
        if owner is not trial.framework:
            owner = trial.framework
            resolver = pliant.Resolver(
                owner,
                technique,
                weighting,
                tolerance=relative,
                tolerance_length=length,
                max_sweeps=limit,
            )
        assert resolver is not None
        done = resolver.resolve(trial.pushed(), trial.root, step=step, reference=trial.positions)
        rows.append((done.sweeps, done.projections, done.converged, done.seconds, trial.graph))
    columns = [np.array(column) for column in zip(*rows, strict=True)]
    return Work(*columns)


def combinations(techniques: Sequence[str]) -> list[Combination]:
    """Each technique with the thesis' weightings, or with 0.5 alone where it has none."""
    weighted = {row.name: row.has_weighting for row in pliant.techniques()}
    return [(t, w) for t in techniques for w in (WEIGHTINGS if weighted[t] else (0.5,))]


def label(combination: Combination) -> str:
    """ "bfs_cycle 0.5", or the bare name of a technique without weighting."""
    name, weighting = combination
    rows = {row.name: row.has_weighting for row in pliant.techniques()}
    return f"{name} {weighting:g}" if rows[name] else name


def replicates(graphs: np.ndarray, seed: int, count: int = REPLICATES) -> np.ndarray:
    """(count, n) weights of n trials: whole graphs drawn with replacement (cluster bootstrap).

    Davison and Hinkley, "Bootstrap methods and their application" (1997), section 3.8. The same
    seed gives the same draws, so that differences between techniques are paired.
    """
    names, place = np.unique(graphs, return_inverse=True)
    draws = np.random.Generator(np.random.Philox(key=seed))
    drawn = draws.integers(len(names), size=(count, len(names)))
    counts = np.stack([np.bincount(row, minlength=len(names)) for row in drawn])
    return counts[:, place]


def mean_interval(values: npt.ArrayLike, weights: np.ndarray) -> tuple[float, float, float]:
    """Mean of a sample with the 95 % interval of its replicates."""
    values = np.asarray(values, dtype=float)
    means = weights @ values / weights.sum(axis=1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(values.mean()), float(low), float(high)


def ratio_interval(
    above: npt.ArrayLike, below: npt.ArrayLike, weights: np.ndarray
) -> tuple[float, float, float]:
    """Ratio of the means of two paired samples with its 95 % interval."""
    above, below = np.asarray(above, dtype=float), np.asarray(below, dtype=float)
    ratios = (weights @ above) / (weights @ below)
    low, high = np.percentile(ratios, (2.5, 97.5))
    return float(above.sum() / below.sum()), float(low), float(high)


def between(counts: Collection[int]) -> str:
    """The smallest and the largest: "2 to 20", or "10" where all are alike."""
    low, high = min(counts), max(counts)
    return str(low) if low == high else f"{low} to {high}"


def digits(value: float) -> str:
    """Three digits, or the whole number if it has more."""
    size = abs(value)
    if value == int(value) and size < 1e7:
        return f"{int(value)}"
    return f"{value:.0f}" if size >= 100 else f"{value:.1f}" if size >= 10 else f"{value:.3g}"


def with_interval(found: tuple[float, float, float]) -> str:
    """ "3.14 [2.90, 3.40]"."""
    return f"{digits(found[0])} [{digits(found[1])}, {digits(found[2])}]"


def as_text(tables: list[Table]) -> list[Table]:
    """Every cell as words, so that columns of figures and of intervals stand alike."""
    for table in tables:
        table.rows = [[str(cell) for cell in row] for row in table.rows]
    return tables
