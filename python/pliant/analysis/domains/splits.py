# SPDX-License-Identifier: MIT
"""A molecule split into rigid bodies by how it moves: once, for one weighting of the frames.

A set of sites is split in two where the halves move against each other about as far as they deform
themselves: with V the mean square fluctuation that is left within a set when its best rigid motion
is taken out, the split of A into B and C counts if

    (V_A - V_B - V_C) / (V_B + V_C) >= LEAST_RATIO^2,

which is the criterion of DynDom (S. Hayward, H. Berendsen, Proteins 30 (1998) 144), there between
two structures and with 1. It looks at A alone: a domain that moves little beside one that moves
much is found as well. Rigid motions are to first order, turns and shifts of the mean structure.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.cluster.hierarchy import linkage
from scipy.spatial.distance import pdist, squareform

from pliant.analysis.domains.stretches import (
    over_neighbours,
    whole_ends,
    without_short_stretches,
)

#: the halves of a split must move against each other by so much of what they deform (r.m.s.)
LEAST_RATIO = 0.9
#: a split must explain so much of the fluctuation of all sites: pieces of pieces are no domains
LEAST_GAIN = 0.04
#: a domain has at least so many sites, and this share of all
LEAST_SITES = 20
LEAST_SHARE = 0.05

_MOST_ROUNDS = 6


def least_sites(sites: int) -> int:
    """Sites of the smallest domain of a molecule of so many."""
    return max(LEAST_SITES, int(LEAST_SHARE * sites))


@dataclass(frozen=True)
class Sample:
    """Frames of n sites with weights, as a split needs them."""

    mean: np.ndarray  #: (n, 3) Angstrom
    moves: np.ndarray  #: (F, 3n) from there
    weights: np.ndarray  #: (F,) of the frames; they sum to 1
    changes: np.ndarray  #: (n (n - 1) / 2,) standard deviation of the distance of each two sites
    chains: np.ndarray  #: (n,) equal where sites are of one chain

    def of(self, sites: np.ndarray) -> Sample:
        """The same of some sites, in their order; a gap between them ends a chain."""
        if len(sites) == len(self.mean):
            return self
        moves = self.moves.reshape(len(self.moves), -1, 3)[:, sites].reshape(len(self.moves), -1)
        changes = squareform(squareform(self.changes)[np.ix_(sites, sites)], checks=False)
        chains = self.chains[sites]
        ends = (np.diff(sites) > 1) | (chains[1:] != chains[:-1])
        stretches = np.cumsum(np.append(False, ends))
        return Sample(self.mean[sites], moves, self.weights, changes, stretches)

    @cached_property
    def squares(self) -> np.ndarray:
        """(3n,) mean square fluctuation of each coordinate."""
        return np.asarray(self.weights @ (self.moves * self.moves))


class Frames:
    """Frames in blocks, prepared so that a sample of blocks takes little.

    positions: (F, n, 3) superposed, Angstrom; chains: (n,); blocks: arrays of frame numbers.
    """

    def __init__(
        self, positions: np.ndarray, chains: np.ndarray, blocks: list[np.ndarray]
    ) -> None:
        mean = positions.mean(axis=0)
        self._mean = mean
        self._flat = (positions - mean).reshape(len(positions), -1).astype(np.float32)
        self._chains = chains
        self._block = np.full(len(positions), -1)
        at_mean = pdist(mean)
        first = np.zeros((len(blocks), len(at_mean)), dtype=np.float32)
        second = np.zeros_like(first)
        for k, block in enumerate(blocks):
            self._block[block] = k
            for frame in block:
                change = pdist(positions[frame]) - at_mean
                first[k] += change
                second[k] += change * change
        self._sums = first, second
        self._sizes = np.array([len(block) for block in blocks])

    def sample(self, times: np.ndarray) -> Sample:
        """Each block as many times as `times` (B,) says."""
        part = (times / (times @ self._sizes)).astype(np.float32)
        used = part[self._block] > 0
        flat, weights = self._flat[used], part[self._block[used]]
        shift = weights @ flat
        first, second = (part @ sums for sums in self._sums)
        changes = np.sqrt(np.maximum(second - first * first, 0.0))
        mean = self._mean + shift.reshape(-1, 3)
        return Sample(mean, flat - shift, weights, changes, self._chains)


def rigid_bodies(sample: Sample) -> np.ndarray:
    """(n,) the body of each site, from 0 by size."""
    sites = len(sample.mean)
    to_split, bodies = [np.arange(sites)], []
    least_gain = LEAST_GAIN * left_within(sample, to_split[0])
    while to_split:
        whole = to_split.pop()
        halves = _split(sample, whole, least_gain)
        to_split += halves
        if not halves:
            bodies.append(whole)
    body = np.empty(sites, dtype=np.int64)
    for k, one in enumerate(sorted(bodies, key=lambda one: (-len(one), one[0]))):
        body[one] = k
    return body


def _split(sample: Sample, whole: np.ndarray, least_gain: float) -> list[np.ndarray]:
    """Two bodies of a set of sites, or none if they move too little against each other."""
    least = least_sites(len(sample.mean))
    if len(whole) < 2 * least:
        return []
    part = sample.of(whole)
    within = left_within(part, np.arange(len(whole)))
    if within < least_gain or within <= 0:
        return []
    halves = _halves(part, least)
    left = sum(left_within(part, half) for half in halves)
    if not halves or within - left < max(LEAST_RATIO**2 * left, least_gain):
        return []
    return [whole[half] for half in halves]


def _halves(sample: Sample, least: int) -> list[np.ndarray]:
    """Two bodies of all sites: those of the tree of changes of distances, then each site to the
    body whose motion it follows better, it and its neighbours along the chain; or none."""
    body = _first_halves(sample, least)
    for _ in range(_MOST_ROUNDS if body.any() else 0):
        off = [
            over_neighbours(left_over(sample, np.flatnonzero(body == k)), sample.chains)
            for k in range(2)
        ]
        better = without_short_stretches((off[1] < off[0]).astype(np.int64), sample.chains)
        better = whole_ends(better, sample.chains)
        if min(np.count_nonzero(better == k) for k in range(2)) < least:
            return []
        if np.array_equal(better, body):
            break
        body = better
    return [np.flatnonzero(body == k) for k in range(2)] if body.any() else []


def _first_halves(sample: Sample, least: int) -> np.ndarray:
    """(n,) 1 for one of the two parts that average linkage of the changes of distances makes, once
    branches of fewer than `least` sites are set aside; 0 for all where there are no two."""
    tree = linkage(sample.changes, "average")
    count = len(sample.mean)
    sizes = np.concatenate([np.ones(count), tree[:, 3]])
    body = np.zeros(count, dtype=np.int64)
    node = 2 * count - 2
    while node >= count:
        node, smaller = sorted(tree[node - count, :2].astype(int), key=lambda k: -sizes[k])
        if sizes[smaller] >= least:
            body[_leaves(tree, smaller)] = 1
            break
    return body


def _leaves(tree: np.ndarray, node: int) -> list[int]:
    found, below, count = [], [node], len(tree) + 1
    while below:
        one = below.pop()
        if one < count:
            found.append(one)
        else:
            below += tree[one - count, :2].astype(int).tolist()
    return found


def left_within(sample: Sample, body: np.ndarray) -> float:
    return float(left_over(sample, body)[body].sum())


def left_over(sample: Sample, body: np.ndarray) -> np.ndarray:
    """(n,) mean square fluctuation of every site that is left when all follow the rigid motion
    that fits a body best (least squares)."""
    sites = len(sample.mean)
    motions = np.zeros((6, sites, 3))  # three shifts, and turns about three axes
    arms = sample.mean - sample.mean[body].mean(axis=0)
    for k in range(3):
        after, last = (k + 1) % 3, (k + 2) % 3
        motions[k, :, k] = 1.0
        motions[3 + k, :, last] = arms[:, after]
        motions[3 + k, :, after] = -arms[:, last]
    own = np.zeros_like(motions)
    own[:, body] = motions[:, body]
    flat, own = (one.reshape(6, -1).astype(np.float32) for one in (motions, own))
    amounts = (sample.moves @ own.T) @ np.linalg.pinv(own @ own.T)  # (F, 6)
    weighted = amounts * sample.weights[:, None]
    along = weighted.T @ sample.moves  # (6, 3n)
    left = sample.squares + np.sum(((weighted.T @ amounts) @ flat - 2.0 * along) * flat, axis=0)
    return np.asarray(left.reshape(sites, 3).sum(axis=1))
