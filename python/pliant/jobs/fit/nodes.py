# SPDX-License-Identifier: MIT
"""Fits at the nodes, a residue each: from the frames that violate the data least, and which of the
fitted shapes is taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant._core import DensityData, PlausibleShapes, fit_nodes
from pliant.jobs.fit.data import Datum
from pliant.jobs.fit.labels import places
from pliant.trajectory.superposition import rmsd_to, superpose_onto

STARTS = 40  #: frames that are fitted
STARTS_IN_MAP = 8  #: and the start: a map leads from further away, and takes longer
MOST_LEFT_OUT = 20  #: data that are left out, one at a time
FEWER = 0.3  #: share of the starts for each fit without one datum
LETS_GO = 8.0  #: Angstrom: in the choice of starts, a datum so far off counts half
ENERGY = 5.0  #: that a shape e times less plausible may have less
AGREES = 1.0  #: Angstrom: so much more violation (r.m.s.) is about as good
CORRELATES = 0.01  #: so much less correlation with a map, too
STRAIN_IN_MAP = 3.0  #: in the choice among fits: where density is missing, much can be explained
STAGES = 4  #: of a fit: data count more in each

#: a datum contradicts the others if the energy falls so much without it, and they put it so far off
LEAST_DROP, LEAST_OFF = 9.0, 5.0


@dataclass(frozen=True)
class Ensemble:
    """The nodes of a molecule and of frames of it."""

    start: np.ndarray  #: (M, 3) Angstrom
    frames: np.ndarray  #: (F, M, 3); the start first
    chains: np.ndarray  #: (M,)


@dataclass(frozen=True)
class Known:
    """What fits are to explain: distances, a map, or both."""

    distances: Sequence[Datum] = ()
    density: DensityData | None = None

    @property
    def starts(self) -> int:
        """How many frames are fitted."""
        return STARTS if self.density is None else STARTS_IN_MAP

    def only(self, some: Sequence[int]) -> Known:
        """With those distances alone."""
        return Known([self.distances[k] for k in some], self.density)

    def nearest(self, frames: np.ndarray, count: int) -> np.ndarray:
        """The frames (F, M, 3) that agree best, and the first one if there is a map: it was put
        there."""
        square = violations(frames, self.distances) ** 2
        order = np.argsort((square / (1 + square / LETS_GO**2)).sum(axis=1), kind="stable")
        if self.density is None:
            return np.asarray(order[:count])
        ranks = np.argsort(order, kind="stable") if len(self.distances) else np.zeros(len(order))
        by_map = np.argsort(-self.density.correlations(frames, False), kind="stable")
        ranks = ranks + np.argsort(by_map, kind="stable")
        return np.unique([0, *np.argsort(ranks, kind="stable")[:count]])


@dataclass(frozen=True)
class NodeFits:
    """Fitted shapes, the one to take first, then by how well they explain the data."""

    positions: np.ndarray  #: (n, M, 3) Angstrom, in the map, or each superposed on the first
    frames: np.ndarray  #: (n,) the frame that each came from
    weights: np.ndarray  #: (n,) sum 1
    violations: np.ndarray  #: (n, K) Angstrom: above 0 where too long
    energy: float  #: the least, of shape, misfit and plausibility
    strain: np.ndarray  #: (n,) energy of the shape alone
    correlations: np.ndarray  #: (n,) with the map; without one 0

    @property
    def agreeing(self) -> np.ndarray:
        """Which of them agree with the data about as well as the best."""
        off = np.sqrt((self.violations**2).sum(axis=1) / max(1, self.violations.shape[1]))
        low = self.correlations < self.correlations.max() - CORRELATES
        return np.asarray(np.flatnonzero((off <= off[~low].min() + AGREES) & ~low))

    @property
    def spread(self) -> np.ndarray:
        """(M,) r.m.s. distance of each residue from the first, over those that agree; Angstrom."""
        others = self.positions[self.agreeing] - self.positions[0]
        return np.asarray(np.sqrt((others**2).sum(axis=2).mean(axis=0)))


def violations(nodes: np.ndarray, data: Sequence[Datum]) -> np.ndarray:
    """(..., K) how far distances of nodes (..., M, 3) are outside of their intervals, Angstrom."""
    return outside(distances(nodes, data), [datum.loosely for datum in data])


def outside(found: np.ndarray, intervals: Sequence[tuple[float, float]]) -> np.ndarray:
    """(..., K) how far distances (..., K) are outside of intervals, above 0 where too long."""
    low, high = np.array(intervals).reshape(-1, 2).T
    return np.asarray(np.where(found > high, found - high, np.minimum(0.0, found - low)))


def distances(nodes: np.ndarray, data: Sequence[Datum]) -> np.ndarray:
    """(..., K) Angstrom, of nodes or labels; (sum of r^-6)^(-1/6) of all that it may be of."""
    pairs, local, more = _places(data)
    ends = [places(nodes, pairs[:, k], local[:, k]) for k in (0, 1)]
    found = np.asarray(np.linalg.norm(ends[0] - ends[1], axis=-1))
    if not more.any():
        return found
    firsts = np.concatenate([[0], np.cumsum([1 + len(one.others) for one in data])[:-1]])
    summed = np.add.reduceat(found**-6.0, firsts, axis=-1) ** (-1 / 6)
    return np.where(more[firsts] > 0, summed, found[..., firsts])


def _places(data: Sequence[Datum]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(P, 2) nodes, (P, 2, 3) places beside them, and (P) how many after each are of the same
    datum."""
    every = [part for one in data for part in ((one.pair, one.local), *one.others)]
    more = [count for one in data for count in range(len(one.others), -1, -1)]
    pairs = np.array([pair for pair, _ in every], dtype=np.int64).reshape(-1, 2)
    local = np.array([place for _, place in every]).reshape(-1, 2, 3)
    return pairs, local, np.array(more, dtype=np.int64)


def fitted(of: Ensemble, known: Known, share: float = 1.0, stages: int = STAGES) -> NodeFits:
    """Fits the frames that agree best with what is known.

    The shape that is taken is the one nearest to all others, by how plausible they are and how
    little energy they need: the mean of what is known, but a shape that is possible.
    """
    data = known.distances
    frames = known.nearest(of.frames, max(1, int(share * known.starts)))
    low, high = (
        [one.loosely[k] for one in data for _ in range(1 + len(one.others))] for k in (0, 1)
    )
    pairs, local, more = _places(data)
    begun = np.ascontiguousarray(of.frames[frames])
    of_data = pairs, low, high, local, more
    shapes, strain, misfit = fit_nodes(begun, of.chains, *of_data, known.density, stages)
    strained = strain if known.density is None else STRAIN_IN_MAP * strain
    evidence = PlausibleShapes(of.start).scores(shapes) - (strained + misfit) / ENERGY
    weights = np.exp(evidence - evidence.max())
    weights /= weights.sum()
    first = int(np.argmin(rmsd_to(shapes, shapes) ** 2 @ weights))
    order = np.argsort(-weights, kind="stable")
    order = np.concatenate([[first], order[order != first]])
    shapes = np.ascontiguousarray(shapes[order])
    if known.density is None:
        shapes, found = superpose_onto(shapes, slice(None), shapes[0]), np.zeros(len(order))
    else:
        found = known.density.correlations(shapes, True)
    off = violations(shapes, data)
    energy = float(-ENERGY * evidence.max())
    return NodeFits(shapes, frames[order], weights[order], off, energy, strain[order], found)


@dataclass(frozen=True)
class LeftOut:
    """What the other data say of one."""

    predicted: float  #: Angstrom, of fits without it
    spread: float
    off: float  #: Angstrom outside of its interval: above 0 where too long
    drop: float  #: by which the energy falls without it


def left_out(of: Ensemble, known: Known, fits: NodeFits) -> dict[int, LeftOut]:
    """Distances as the other data predict them: all, or the MOST_LEFT_OUT that are violated most in
    `fits` to all."""
    pulls = fits.weights @ np.abs(fits.violations)
    some = np.argsort(-pulls, kind="stable")[:MOST_LEFT_OUT]
    return {int(k): _without(of, known, int(k), fits.energy) for k in sorted(some)}


def _without(of: Ensemble, known: Known, k: int, energy: float) -> LeftOut:
    one = [known.distances[k]]
    others = [other for other in range(len(known.distances)) if other != k]
    fits = fitted(of, known.only(others), FEWER)
    found = distances(fits.positions, one)[:, 0]
    mean = float(fits.weights @ found)
    spread = float(np.sqrt(fits.weights @ (found - mean) ** 2))
    off = float(fits.weights @ violations(fits.positions, one)[:, 0])
    return LeftOut(mean, spread, off, energy - fits.energy)


@dataclass(frozen=True)
class Consistent:
    """Fits to the data that can hold together."""

    fits: NodeFits
    kept: list[int]  #: indices of data
    contradicting: list[int]
    left_out: dict[int, LeftOut]  #: of data, by the others; none where one datum is all


def consistent(of: Ensemble, known: Known) -> Consistent:
    """Fits what is known; one after the other distances that cannot hold with the rest are let go,
    at most a third."""
    kept, contradicting = list(range(len(known.distances))), list[int]()
    tried: dict[int, LeftOut] = {}
    while True:
        some = known.only(kept)
        fits = fitted(of, some)
        if len(kept) < (2 if known.density is None else 1):
            return Consistent(fits, kept, contradicting, tried)
        now = {kept[k]: one for k, one in left_out(of, some, fits).items()}
        tried |= now
        worst = max(now, key=lambda k: now[k].drop)
        may_go = 3 * (len(contradicting) + 1) <= len(known.distances)
        if not (may_go and _contradicts(tried[worst])):
            return Consistent(fits, kept, contradicting, tried)
        kept.remove(worst)
        contradicting.append(worst)


def _contradicts(one: LeftOut) -> bool:
    return one.drop >= LEAST_DROP and abs(one.off) >= LEAST_OFF
