# SPDX-License-Identifier: MIT
"""Who takes part in a race: every technique with every weighting, and OpenMM's CCMA."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import pliant
from pliant.base.extras import need
from pliant.checks.openmm.angles import why_no_angles
from pliant.checks.openmm.child import Job, run_jobs
from pliant.checks.weightings import WEIGHTINGS
from pliant.lab.bench.target import Target
from pliant.lab.peers.ccma import Ccma, CcmaInDynamics

if TYPE_CHECKING:
    from pliant.checks.openmm.child import Outcome


TOLD_INTACT = ("shake",)  #: techniques to which the structure before the push makes a difference
IN_LANES = ("bfs_cycle", "blocks", "shake", "newton")  #: techniques that race so as well
WALKERS = 16  #: copies that go together then
TRIAL_SECONDS = 120.0  #: for OpenMM in a process of its own


@dataclass
class Repair:
    """One structure repaired."""

    positions: np.ndarray  #: (N, 3) Angstrom
    seconds: float
    stop: str  #: of our summary; of OpenMM, which says nothing, ""
    sweeps: int | None = None
    projections: int | None = None


class Ours:
    """A technique with a weighting; plans are made once for each tolerance and kept."""

    whose = "pliant"
    walkers = 1

    def __init__(
        self,
        target: Target,
        technique: str,
        weighting: float | None,
        mass_weighted: bool = False,
        given_intact: bool = False,
    ) -> None:
        self._target, self._technique, self.weighting = target, technique, weighting
        self.method = f"{technique}_dynamics" if given_intact else technique
        self._mass_weighted = mass_weighted
        self._reference = target.positions if given_intact else None
        self._resolver: pliant.Resolver | None = None

    def prepare(self, tolerance: float) -> None:
        """Makes ready for repairs to a relative tolerance."""
        self._resolver = pliant.Resolver(
            self._target.framework,
            self._technique,
            0.5 if self.weighting is None else self.weighting,
            mass_weighted=self._mass_weighted,
            tolerance=tolerance,
        )

    def repair(self, broken: np.ndarray) -> Repair:
        """A repaired copy."""
        assert self._resolver is not None
        copy = broken.copy()
        start = time.thread_time()
        summary = self._resolver.resolve(copy, reference=self._reference)
        seconds = time.thread_time() - start
        return Repair(copy, seconds, summary.stop.name, summary.sweeps, summary.projections)


class InLanes:
    """A technique on many broken copies at once, in SIMD lanes; times are of one copy.

    The copies are broken alike: to each the pushes of the joints are dealt anew.
    """

    whose = "pliant"
    walkers = WALKERS

    def __init__(self, target: Target, technique: str, weighting: float | None) -> None:
        self._target, self._technique, self.weighting = target, technique, weighting
        self.method = f"{technique}_lanes"
        self._resolver: pliant.WalkerResolver | None = None

    def prepare(self, tolerance: float) -> None:
        """As of Ours."""
        self._resolver = pliant.WalkerResolver(
            self._target.framework,
            self._technique,
            0.5 if self.weighting is None else self.weighting,
            tolerance=tolerance,
        )

    def repair(self, broken: np.ndarray) -> Repair:
        """The first copy; if another one is not whole, that one."""
        assert self._resolver is not None
        copies = self._copies(broken)
        start = time.thread_time()
        summaries = self._resolver.resolve(copies, measured="nothing")
        seconds = (time.thread_time() - start) / len(copies)
        worst = next((k for k, s in enumerate(summaries) if not s.converged), 0)
        summary = summaries[worst]
        return Repair(
            copies[worst], seconds, summary.stop.name, summary.sweeps, summary.projections
        )

    def _copies(self, broken: np.ndarray) -> np.ndarray:
        deal = np.random.default_rng(0)
        pushes = broken - self._target.positions
        others = [self._target.positions + deal.permutation(pushes) for _ in range(WALKERS - 1)]
        return np.stack([broken, *others])


class Theirs:
    """OpenMM in one of its ways."""

    whose = "openmm"
    weighting = None
    walkers = 1

    def __init__(self, context: Ccma) -> None:
        self._context, self.method = context, context.name
        self._tolerance = 1e-6

    def prepare(self, tolerance: float) -> None:
        """As of Ours."""
        self._tolerance = tolerance

    def repair(self, broken: np.ndarray) -> Repair:
        """As of Ours."""
        positions, seconds = self._context.repair(broken, self._tolerance)
        return Repair(positions, seconds, "")


Contender = Ours | InLanes | Theirs


def our_contenders(
    target: Target, wanted: Sequence[str] = (), mass_weighted: bool = False
) -> Iterator[Ours | InLanes]:
    """Every row of the table of techniques that takes this framework; `wanted` names, or all."""
    for name in wanted:  # refuses wrong names
        pliant.Resolver(pliant.Framework([[0, 1]], [1.0]), name)
    for row in pliant.techniques():
        if (wanted and row.name not in wanted) or not _takes(row, target):
            continue
        for weighting in WEIGHTINGS if row.has_weighting else (None,):
            yield Ours(target, row.name, weighting, mass_weighted)
            if row.name in IN_LANES and not mass_weighted:
                yield InLanes(target, row.name, weighting)
        if row.name in TOLD_INTACT:
            yield Ours(target, row.name, None, mass_weighted, given_intact=True)


def _takes(row: pliant.TechniqueEntry, target: Target) -> bool:
    return not row.forests_only or target.framework.graph_facts().is_forest


def their_contenders(target: Target) -> tuple[list[Theirs], str]:
    """OpenMM's ways that leave their process alive, and what is to be said of them."""
    need("a race with OpenMM", "openmm", extra="lab")
    why = why_no_angles(target.bars)
    outcome = _trial(target)
    if not outcome.done:
        return [], f"OpenMM takes no part, in a process of its own it {outcome.brief()}"
    given = not why
    arguments = (target.masses, target.bars, target.rest_lengths, target.positions, given)
    return [Theirs(kind(*arguments)) for kind in (Ccma, CcmaInDynamics)], why


def _trial(target: Target) -> Outcome:
    broken = target.broken(0.01, 0)[None, None] * 0.1
    arrays = {
        "masses": target.masses,
        "bars": target.bars,
        "rest_lengths": target.rest_lengths * 0.1,
        "broken": broken,
    }
    values: dict[str, float | int | str] = {
        "platform": "Reference",
        "tolerance": 1e-2,
        "repeats": 1,
        "budget_seconds": 10.0,
    }
    (outcome,), _ = run_jobs([Job("apply_constraints", values, arrays)], TRIAL_SECONDS)
    return outcome
