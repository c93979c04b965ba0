# SPDX-License-Identifier: MIT
"""Fits at the nodes, a residue each: from the frames that violate the data least, and which of the
fitted shapes is taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant._core import PlausibleShapes, fit_nodes
from pliant.jobs.fit.data import Datum
from pliant.trajectory.superposition import rmsd_to, superpose_onto

STARTS = 40  #: frames that are fitted
MOST_LEFT_OUT = 20  #: data that are left out, one at a time
FEWER_STARTS = 12  #: of each fit without one datum
LETS_GO = 8.0  #: Angstrom: in the choice of starts, a datum so far off counts half
ENERGY = 5.0  #: that a shape e times less plausible may have less
AGREES = 1.0  #: Angstrom: so much more violation (r.m.s.) is about as good

#: a datum contradicts the others if the energy falls so much without it, and they put it so far off
LEAST_DROP, LEAST_OFF = 9.0, 5.0


@dataclass(frozen=True)
class Ensemble:
    """The nodes of a molecule and of frames of it."""

    start: np.ndarray  #: (M, 3) Angstrom
    frames: np.ndarray  #: (F, M, 3); the start first
    chains: np.ndarray  #: (M,)


@dataclass(frozen=True)
class NodeFits:
    """Fitted shapes, the one to take first, then by how well they explain the data."""

    positions: np.ndarray  #: (n, M, 3) Angstrom, each superposed on the first
    frames: np.ndarray  #: (n,) the frame that each came from
    weights: np.ndarray  #: (n,) sum 1
    violations: np.ndarray  #: (n, K) Angstrom: above 0 where too long
    energy: float  #: the least, of shape, misfit and plausibility

    @property
    def agreeing(self) -> np.ndarray:
        """Which of them agree with the data about as well as the best."""
        off = np.sqrt((self.violations**2).mean(axis=1))
        return np.asarray(np.flatnonzero(off <= off.min() + AGREES))

    @property
    def spread(self) -> np.ndarray:
        """(M,) r.m.s. distance of each residue from the first, over those that agree; Angstrom."""
        others = self.positions[self.agreeing] - self.positions[0]
        return np.asarray(np.sqrt((others**2).sum(axis=2).mean(axis=0)))


def violations(nodes: np.ndarray, data: Sequence[Datum]) -> np.ndarray:
    """(..., K) how far distances of nodes (..., M, 3) are outside of their intervals, Angstrom."""
    found = distances(nodes, data)
    low, high = np.array([d.low for d in data]), np.array([d.high for d in data])
    return np.asarray(np.where(found > high, found - high, np.minimum(0.0, found - low)))


def distances(nodes: np.ndarray, data: Sequence[Datum]) -> np.ndarray:
    """(..., K) Angstrom."""
    pairs = np.array([d.pair for d in data])
    return np.asarray(
        np.linalg.norm(nodes[..., pairs[:, 0], :] - nodes[..., pairs[:, 1], :], axis=-1)
    )


def fitted(of: Ensemble, data: Sequence[Datum], starts: int = STARTS) -> NodeFits:
    """Fits the frames that violate the data least.

    The shape that is taken is the one nearest to all others, by how plausible they are and how
    little energy they need: the mean of what is known, but a shape that is possible.
    """
    square = violations(of.frames, data) ** 2
    ranks = np.argsort((square / (1 + square / LETS_GO**2)).sum(axis=1), kind="stable")
    frames = ranks[:starts]
    pairs = [datum.pair for datum in data]
    low, high = [datum.low for datum in data], [datum.high for datum in data]
    begun = np.ascontiguousarray(of.frames[frames])
    shapes, strain, misfit = fit_nodes(begun, of.chains, pairs, low, high)
    evidence = PlausibleShapes(of.start).scores(shapes) - (strain + misfit) / ENERGY
    weights = np.exp(evidence - evidence.max())
    weights /= weights.sum()
    first = int(np.argmin(rmsd_to(shapes, shapes) ** 2 @ weights))
    order = np.argsort(-weights, kind="stable")
    order = np.concatenate([[first], order[order != first]])
    shapes = superpose_onto(shapes[order], slice(None), shapes[first])
    off = violations(shapes, data)
    return NodeFits(shapes, frames[order], weights[order], off, float(-ENERGY * evidence.max()))


@dataclass(frozen=True)
class LeftOut:
    """What the other data say of one."""

    predicted: float  #: Angstrom, of fits without it
    spread: float
    off: float  #: Angstrom outside of its interval: above 0 where too long
    drop: float  #: by which the energy falls without it


def left_out(of: Ensemble, data: Sequence[Datum], fits: NodeFits) -> dict[int, LeftOut]:
    """Data as the others predict them: all, or the MOST_LEFT_OUT that are violated most in `fits`
    to all."""
    pulls = fits.weights @ np.abs(fits.violations)
    some = np.argsort(-pulls, kind="stable")[:MOST_LEFT_OUT]
    return {int(k): _without(of, data, int(k), fits.energy) for k in sorted(some)}


def _without(of: Ensemble, data: Sequence[Datum], k: int, energy: float) -> LeftOut:
    one, others = [data[k]], [*data[:k], *data[k + 1 :]]
    fits = fitted(of, others, FEWER_STARTS)
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


def consistent(of: Ensemble, data: Sequence[Datum]) -> Consistent:
    """Fits `data`; one after the other those that cannot hold with the rest are let go, at most a
    third."""
    kept, contradicting = list(range(len(data))), list[int]()
    known: dict[int, LeftOut] = {}
    while True:
        some = [data[k] for k in kept]
        fits = fitted(of, some)
        if len(some) < 2:
            return Consistent(fits, kept, contradicting, known)
        tried = {kept[k]: one for k, one in left_out(of, some, fits).items()}
        known |= tried
        worst = max(tried, key=lambda k: tried[k].drop)
        may_go = 3 * (len(contradicting) + 1) <= len(data)
        if not (may_go and _contradicts(known[worst])):
            return Consistent(fits, kept, contradicting, known)
        kept.remove(worst)
        contradicting.append(worst)


def _contradicts(one: LeftOut) -> bool:
    return one.drop >= LEAST_DROP and abs(one.off) >= LEAST_OFF
