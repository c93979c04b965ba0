# SPDX-License-Identifier: MIT
"""A molecule split into rigid bodies by how it moves and where it hangs together little: once, for
one weighting of the frames.

With V the mean square fluctuation that is left within a set of sites when its best rigid motion is
taken out, and C its contacts, A is split into the B and C (any stretches of its chains) for which

    (V_A - V_B - V_C) / V_A  -  CONTACTS C_between / C_A

is largest. The first term alone is the criterion of DynDom (S. Hayward, H. Berendsen, Proteins 30
(1998) 144), there between two structures; but an elastic body can bend nearly as well at other
places as at its hinge, and a hinge is where few contacts hold. Both look at A alone: a domain that
moves little beside one that moves much is found as well. Rigid motions are to first order, turns
and shifts of the mean structure.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from pliant._core import followed_rigidly

#: what a share of contacts weighs against the same share of the fluctuation
CONTACTS = 2.0
#: a molecule is split where the difference is so large, ...
LEAST_SCORE = 1 / 3
#: ... and a part of it where it is so large: pieces of pieces are seldom domains
LEAST_SCORE_OF_PART = 0.5
#: a split must explain so much of the fluctuation of all sites, near the start and farther off
LEAST_GAIN = 0.06
#: a domain has at least so many sites; smaller are loops
LEAST_SITES = 30
#: one more stretch goes to the other side where the score becomes so much larger
LEAST_RISE = 0.03
#: sites (Angstrom) that touch, and those of a chain so much apart in it
CONTACT = 8.0
APART_IN_CHAIN = 3

#: motions that a set of frames is reduced to
_MOTIONS = 20
#: stretches end at about so many places at first
_PLACES = 48
_LEAST_STRETCH = 5
_MOST_ROUNDS = 6

_NONE = np.zeros((1, 2), dtype=np.int64)  # a stretch without sites


@dataclass(frozen=True)
class Sample:
    """Frames of n sites with weights, as a split needs them."""

    mean: np.ndarray  #: (n, 3) Angstrom
    moves: np.ndarray  #: (n, 3, m) along independent motions; their squares are mean squares
    contacts: np.ndarray  #: (c, 2) sites that touch
    chains: np.ndarray  #: (n,) equal where sites are of one chain

    def of(self, sites: np.ndarray) -> Sample:
        """The same of some sites, in their order."""
        place = np.full(len(self.mean), -1)
        place[sites] = np.arange(len(sites))
        contacts = place[self.contacts]
        contacts = contacts[(contacts >= 0).all(axis=1)]
        return Sample(self.mean[sites], self.moves[sites], contacts, self.chains[sites])

    def followed(self, body: np.ndarray, stretches: np.ndarray = _NONE) -> np.ndarray:
        """(s, 2) of the squares of the moves: what the sites of a body (n, bool) follow as one
        rigid body, and all others as another, once those of a stretch have changed sides."""
        return followed_rigidly(self.mean, self.moves, body, stretches)

    def left(self) -> float:
        """Sum of the mean square fluctuations of the sites when all follow one rigid motion."""
        none = np.zeros(len(self.mean), dtype=bool)
        return float(np.sum(self.moves**2) - self.followed(none).sum())

    def gain(self, body: np.ndarray) -> float:
        """How much less is left if a body and the others follow each their own."""
        return self.left() - float(np.sum(self.moves**2) - self.followed(body).sum())


class Frames:
    """Frames in blocks, prepared so that a sample of blocks takes little.

    positions: (F, n, 3) superposed, Angstrom; chains: (n,); blocks: arrays of frame numbers.
    """

    def __init__(self, positions: np.ndarray, chains: np.ndarray, blocks: list[np.ndarray]) -> None:
        sizes = [len(block) for block in blocks]
        chosen = positions[np.concatenate(blocks)]
        self._mean = chosen.mean(axis=0)
        self._chains, self._sizes = chains, np.array(sizes)
        self._block = np.repeat(np.arange(len(blocks)), sizes)
        flat = (chosen - self._mean).reshape(len(chosen), -1)
        squares, vectors = np.linalg.eigh(flat @ flat.T)
        kept = (squares > 1e-9 * max(squares[-1], 1e-9)) & (np.arange(len(flat))[::-1] < _MOTIONS)
        self._along = vectors[:, kept] * np.sqrt(squares[kept])  # (F, m) places along the motions
        self._motions = flat.T @ (vectors[:, kept] / np.sqrt(squares[kept]))  # (3n, m)
        self._contacts = _contacts(self._mean, chains)

    def sample(self, times: np.ndarray) -> Sample:
        """Each block as many times as `times` (B,) says."""
        weights = (times / (times @ self._sizes))[self._block]
        around = (self._along - weights @ self._along) * np.sqrt(weights)[:, None]
        _, spread, turned = np.linalg.svd(around, full_matrices=False)
        moves = self._motions @ (turned.T * spread)
        return Sample(
            self._mean, moves.reshape(len(self._mean), 3, -1), self._contacts, self._chains
        )


def _contacts(mean: np.ndarray, chains: np.ndarray) -> np.ndarray:
    pairs = cKDTree(mean).query_pairs(CONTACT, output_type="ndarray").astype(np.int64)
    first, second = pairs.T
    apart = (chains[first] != chains[second]) | (second - first >= APART_IN_CHAIN)
    return np.asarray(pairs[apart])


def rigid_bodies(sample: Sample, far: Sample | None = None) -> np.ndarray:
    """(n,) the body of each site, from 0 by size; far: of frames that reach further."""
    sites = len(sample.mean)
    to_split, bodies = [np.arange(sites)], []
    seen = [one for one in (sample, far) if one is not None]
    least_gains = [LEAST_GAIN * one.left() for one in seen]
    while to_split:
        whole = to_split.pop()
        parts = [one.of(whole) for one in seen]
        halves = _halves(parts[0], least_gains[0], len(whole) == sites)
        if halves is None or any(
            part.gain(halves) < least for part, least in zip(parts, least_gains, strict=True)
        ):
            bodies.append(whole)
        else:
            to_split += [whole[halves], whole[~halves]]
    _settle(sample, bodies)
    body = np.empty(sites, dtype=np.int64)
    for k, one in enumerate(sorted(bodies, key=lambda one: (-len(one), one[0]))):
        body[one] = k
    return body


def _settle(sample: Sample, bodies: list[np.ndarray]) -> None:
    """Moves the boundaries of each two bodies of three or more: of three in a row, the first split
    goes through the one between."""
    pairs = list(itertools.combinations(range(len(bodies)), 2)) if len(bodies) > 2 else []
    for _ in range(_MOST_ROUNDS):
        settled = True
        for one, other in pairs:
            whole = np.sort(np.concatenate([bodies[one], bodies[other]]))
            halves = _Halves(sample.of(whole), np.isin(whole, bodies[one]))
            if halves.move_boundaries():
                bodies[one], bodies[other] = whole[halves.is_one], whole[~halves.is_one]
                settled = False
        if settled:
            break


def _halves(part: Sample, least_gain: float, is_whole: bool) -> np.ndarray | None:
    """(n, bool) the best split of a set of sites; None if it is not good enough."""
    sites = len(part.mean)
    if sites < 2 * LEAST_SITES or part.left() <= least_gain:
        return None
    halves = _Halves(part, np.zeros(sites, dtype=bool))
    stretches = _stretches(part.chains)
    while halves.change(stretches, LEAST_RISE):
        halves.move_boundaries()
    least = LEAST_SCORE if is_whole else LEAST_SCORE_OF_PART
    return halves.is_one if halves.score >= least else None


def _stretches(chains: np.ndarray) -> np.ndarray:
    """(s, 2) stretches between places along the chains."""
    ends = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    even = np.linspace(0, len(chains), min(_PLACES, len(chains)) + 1).astype(np.int64)
    places = np.union1d(even, ends)
    pairs = places[np.stack(np.triu_indices(len(places), 1), axis=1)]
    lengths = pairs[:, 1] - pairs[:, 0]
    return pairs[(lengths >= _LEAST_STRETCH) & (lengths < len(chains))]


def _beside(is_one: np.ndarray) -> np.ndarray:
    """(s, 2) stretches beside each boundary."""
    edges = np.flatnonzero(is_one[1:] != is_one[:-1])[:, None] + 1
    lengths = np.arange(1, LEAST_SITES // 2 + 1)
    before = np.stack(np.broadcast_arrays(edges - lengths, edges), axis=-1)
    after = np.stack(np.broadcast_arrays(edges, edges + lengths), axis=-1)
    both = np.concatenate([before, after]).reshape(-1, 2)
    return both[(both >= 0).all(axis=1) & (both <= len(is_one)).all(axis=1)]


class _Halves:
    """Two halves of a set of sites, which stretches of the chains are moved between."""

    def __init__(self, part: Sample, is_one: np.ndarray) -> None:
        self._part, self.is_one = part, is_one
        self._left, self._squares = part.left(), float(np.sum(part.moves**2))
        self.score = float(self._scores(_NONE)[0]) if is_one.any() else -np.inf

    def change(self, stretches: np.ndarray, least_rise: float) -> bool:
        """Moves the stretch that makes the score largest; False where none raises it so much."""
        stretches = stretches[self._leaves_enough(stretches)]
        if len(stretches) == 0:
            return False
        scores = self._scores(stretches)
        best = int(np.argmax(scores))
        if scores[best] <= self.score + least_rise:
            return False
        first, end = stretches[best]
        self.is_one[first:end] = ~self.is_one[first:end]
        self.score = float(scores[best])
        return True

    def move_boundaries(self) -> bool:
        """By some sites at a time, while that raises the score; False where it does not."""
        moved = False
        while self.change(_beside(self.is_one), 1e-9):
            moved = True
        return moved

    def _scores(self, stretches: np.ndarray) -> np.ndarray:
        """(s,) of the halves once a stretch has changed sides."""
        left = self._squares - self._part.followed(self.is_one, stretches).sum(axis=1)
        cut = self._cut(stretches) / max(len(self._part.contacts), 1)
        return np.asarray(1.0 - left / self._left - CONTACTS * cut)

    def _leaves_enough(self, stretches: np.ndarray) -> np.ndarray:
        """(s, bool) whether both halves have enough sites then."""
        before = np.append(0, np.cumsum(np.where(self.is_one, -1, 1)))
        size = np.count_nonzero(self.is_one) + before[stretches[:, 1]] - before[stretches[:, 0]]
        return np.asarray((size >= LEAST_SITES) & (len(self.is_one) - size >= LEAST_SITES))

    def _cut(self, stretches: np.ndarray) -> np.ndarray:
        """(s,) contacts between the halves then.

        Of the contacts with one end in a stretch, those that were between no longer are, and those
        that were not are: sums over squares of a table of them by the stretches' ends.
        """
        first, second = self._part.contacts.T
        sign = np.where(self.is_one[first] == self.is_one[second], 1.0, -1.0)
        ends = np.unique(stretches)
        count = len(ends) + 1
        rows, columns = (np.searchsorted(ends, one, "right") for one in (first, second))
        table = np.bincount(rows * count + columns, sign, count * count).reshape(count, count)
        sums = np.zeros((count + 1, count + 1))
        sums[1:, 1:] = (table + table.T).cumsum(axis=0).cumsum(axis=1)
        low, high = np.searchsorted(ends, stretches).T + 1
        within = sums[high, high] - sums[low, high] - sums[high, low] + sums[low, low]
        crossing = sums[high, -1] - sums[low, -1] - within
        return np.asarray(np.count_nonzero(sign < 0) + crossing)
