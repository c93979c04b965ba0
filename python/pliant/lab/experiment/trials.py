# SPDX-License-Identifier: MIT
"""Pushed frameworks, and what techniques take to make them whole: sweeps and projections."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

import pliant
from pliant.lab.experiment.statistics import resampling

PUSH = 0.5  #: Angstrom: what 50 kJ/(mol Angstrom) do to 1 u in one step of 0.01 ps
TOLERANCE = 0.01  #: Angstrom
LIMIT = 2000  #: sweeps
REPLICATES = 1000


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
    graphs: np.ndarray

    @property
    def failures(self) -> int:
        """Trials that met the limit of sweeps."""
        return int(np.sum(~self.converged))


def work_of(
    trials: Sequence[Trial], technique: str, weighting: float = 0.5, length: float = TOLERANCE
) -> Work:
    """Resolves each trial to a tolerance in Angstrom."""
    rows, resolver, owner = [], None, None
    for step, trial in enumerate(trials):
        if owner is not trial.framework:
            owner = trial.framework
            resolver = pliant.Resolver(
                owner, technique, weighting, tolerance_length=length, max_sweeps=LIMIT
            )
        assert resolver is not None
        done = resolver.resolve(trial.pushed(), trial.root, step=step, reference=trial.positions)
        rows.append((done.sweeps, done.projections, done.converged, trial.graph))
    columns = [np.array(column) for column in zip(*rows, strict=True)]
    return Work(*columns)


def mean_interval(work: Work, seed: int) -> tuple[float, float, float]:
    """Mean projections with the 95 % interval of their replicates."""
    weights = _replicates(work.graphs, seed)
    low, high = np.percentile(weights @ work.projections / weights.sum(axis=1), (2.5, 97.5))
    return float(work.projections.mean()), float(low), float(high)


def ratio_interval(above: Work, below: Work, seed: int) -> tuple[float, float, float]:
    """Ratio of the mean projections of two, on the same trials, with its 95 % interval."""
    weights = _replicates(below.graphs, seed)
    a, b = above.projections, below.projections
    low, high = np.percentile((weights @ a) / (weights @ b), (2.5, 97.5))
    return float(a.sum() / b.sum()), float(low), float(high)


def _replicates(graphs: np.ndarray, seed: int) -> np.ndarray:
    """(REPLICATES, n) weights of n trials: whole graphs drawn with replacement.

    The same seed gives the same draws, so that differences between techniques are paired.
    """
    names, place = np.unique(graphs, return_inverse=True)
    return resampling(len(names), REPLICATES, seed)[1:, place]
