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

import numpy as np
from scipy.cluster.hierarchy import linkage
from scipy.spatial.distance import pdist, squareform

from pliant._core import left_by_rigid_motion
from pliant.measure.domains.stretches import over_neighbours, whole_ends, without_short_stretches

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
    moves: np.ndarray  #: (3n, F) from there
    weights: np.ndarray  #: (F,) of the frames; they sum to 1
    changes: np.ndarray  #: (n, n) standard deviation of the distance of each two sites
    chains: np.ndarray  #: (n,) equal where sites are of one chain

    def of(self, sites: np.ndarray) -> Sample:
        """The same of some sites, in their order; a gap between them ends a chain."""
        if len(sites) == len(self.mean):
            return self
        moves = self.moves.reshape(len(self.mean), 3, -1)[sites].reshape(3 * len(sites), -1)
        changes = self.changes[np.ix_(sites, sites)]
        chains = self.chains[sites]
        ends = (np.diff(sites) > 1) | (chains[1:] != chains[:-1])
        stretches = np.cumsum(np.append(False, ends))
        return Sample(self.mean[sites], moves, self.weights, changes, stretches)


class Frames:
    """Frames in blocks, prepared so that a sample of blocks takes little.

    positions: (F, n, 3) superposed, Angstrom; chains: (n,); blocks: arrays of frame numbers.
    """

    def __init__(self, positions: np.ndarray, chains: np.ndarray, blocks: list[np.ndarray]) -> None:
        sizes = [len(block) for block in blocks]
        chosen = positions[np.concatenate(blocks)]
        self._mean = chosen.mean(axis=0)
        flat = (chosen - self._mean).reshape(len(chosen), -1).astype(np.float32)
        self._flat = np.ascontiguousarray(flat.T)
        self._chains, self._sizes = chains, np.array(sizes)
        self._block = np.repeat(np.arange(len(blocks)), sizes)
        at_mean = pdist(self._mean)
        first = np.zeros((len(blocks), len(at_mean)), dtype=np.float32)
        second = np.zeros_like(first)
        for k, frame in zip(self._block, chosen, strict=True):
            change = pdist(frame) - at_mean
            first[k] += change
            second[k] += change * change
        self._sums = first, second

    def sample(self, times: np.ndarray) -> Sample:
        """Each block as many times as `times` (B,) says."""
        part = (times / (times @ self._sizes)).astype(np.float32)
        used = np.flatnonzero(part[self._block])
        flat, weights = np.take(self._flat, used, axis=1), part[self._block[used]]
        shift = flat @ weights
        first, second = (part @ sums for sums in self._sums)
        changes = squareform(np.sqrt(np.maximum(second - first * first, 0.0)))
        mean = self._mean + shift.reshape(-1, 3)
        return Sample(mean, flat - shift[:, None], weights, changes, self._chains)


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
    """Two bodies of a set of sites, or three; none if they move too little against each other."""
    least = least_sites(len(sample.mean))
    if len(whole) < 2 * least:
        return []
    part = sample.of(whole)
    within = left_within(part, np.arange(len(whole)))
    if within < least_gain or within <= 0:
        return []
    tree = linkage(squareform(part.changes, checks=False), "average")
    best: list[np.ndarray] = []
    for count in (2, 3):  # of three in a row, two halves would share out the one between
        first = _first_parts(tree, count, least)
        if best and not _explained(part, first, within, least_gain):
            break
        bodies = _bodies(part, first, least)
        if not _explained(part, bodies, within, least_gain):
            break
        best = bodies
        within = sum(left_within(part, one) for one in best)
    return [whole[one] for one in best]


def _explained(sample: Sample, bodies: list[np.ndarray], within: float, least_gain: float) -> bool:
    """Whether bodies explain enough of the fluctuation that was left without them."""
    left = sum(left_within(sample, one) for one in bodies)
    return len(bodies) > 1 and within - left >= max(LEAST_RATIO**2 * left, least_gain)


def _bodies(sample: Sample, first: list[np.ndarray], least: int) -> list[np.ndarray]:
    """Bodies of all sites, from a first guess: each site to the body whose motion it follows best,
    it and its neighbours along the chain; none where one of them dwindles."""
    body = np.full(len(sample.mean), -1)
    for k, one in enumerate(first):
        body[one] = k
    for _ in range(_MOST_ROUNDS if len(first) > 1 else 0):
        off = [
            over_neighbours(left_over(sample, np.flatnonzero(body == k)), sample.chains)
            for k in range(len(first))
        ]
        better = without_short_stretches(np.argmin(off, axis=0), sample.chains)
        better = whole_ends(better, sample.chains)
        if np.bincount(better, minlength=len(first)).min() < least:
            return []
        if np.array_equal(better, body):
            break
        body = better
    return [np.flatnonzero(body == k) for k in range(len(first))]


def _first_parts(tree: np.ndarray, count: int, least: int) -> list[np.ndarray]:
    """The highest parts of the tree with `least` sites and more, so many; none if there are fewer.
    Smaller branches are set aside."""
    sites = len(tree) + 1
    sizes = np.concatenate([np.ones(sites), tree[:, 3]])
    branches = tree[:, :2].astype(int).tolist()
    nodes: list[int] = [2 * sites - 2]
    kept: list[int] = []  # no part of theirs is large enough
    while nodes and len(nodes) + len(kept) < count:
        node = nodes.pop(nodes.index(max(nodes)))  # the highest of the tree
        below = [k for k in branches[node - sites] if sizes[k] >= least]
        nodes += below
        if not below:
            kept.append(node)
    parts = [np.sort(_leaves(branches, node)) for node in (*nodes, *kept)]
    return parts if len(parts) == count else []


def _leaves(branches: list[list[int]], node: int) -> list[int]:
    found, below, count = [], [node], len(branches) + 1
    while below:
        one = below.pop()
        if one < count:
            found.append(one)
        else:
            below += branches[one - count]
    return found


def left_within(sample: Sample, body: np.ndarray) -> float:
    """Sum of the mean square fluctuations of the sites of a body within it."""
    return float(left_over(sample, body)[body].sum())


def left_over(sample: Sample, body: np.ndarray) -> np.ndarray:
    """(n,) mean square fluctuation of every site that is left when all follow the rigid motion
    that fits a body best (least squares)."""
    return left_by_rigid_motion(sample.mean, sample.moves, sample.weights, body)
