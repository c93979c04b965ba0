# SPDX-License-Identifier: MIT
"""Domains that repeat: what resamples of the frames agree on, and how well they do."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pliant.measure.domains.splits import LEAST_SITES, Frames, Sample, rigid_bodies

#: sites are of one domain if they are in one in this share of the resamples ...
TOGETHER = 0.9
#: ... and of two if they are in one in at most this share
APART = 0.1
RESAMPLES = 50
#: blocks of frames, where each frame is independent
BLOCKS = 20
#: more frames than this are thinned
MOST_FRAMES = 500
#: a domain is found in a resample where one of that resample shares so much of both with it
SAME = 0.75
#: a domain is found in this share of the resamples; else it is the core of others that change
LEAST_FOUND = 0.8
#: between two domains that a hinge joins there are at most so many sites
MOST_BETWEEN = 20

LOOSE = -1  #: the domain of sites that belong to none


@dataclass(frozen=True)
class Hinge:
    """Where a chain goes from one domain to another. Sites by their numbers."""

    before: int  #: last site of the one domain
    after: int  #: first site of the other
    site: int  #: the one that is beside the boundary most often
    share: float  #: of the resamples in which it is


@dataclass(frozen=True)
class Domains:
    """Parts that move as rigid bodies, as far as they repeat. Of n sites."""

    domain: np.ndarray  #: (n,) of each site, from 0 by size; LOOSE where it belongs to none
    explained: float  #: share of the fluctuation that the domains explain by moving rigidly
    found: np.ndarray  #: (k,) share of the resamples that have the domain
    counts: dict[int, float]  #: share of the resamples by their number of domains
    hinges: list[Hinge]
    hinge_share: np.ndarray  #: (n,) share of the resamples in which a site is a hinge
    #: sites (two or more stretches) that are a domain in some resamples, with the share of these
    undecided: list[tuple[np.ndarray, float]]

    @property
    def count(self) -> int:
        """How many domains there are; 1: the molecule moves as one; 0: nothing repeats."""
        return int(self.domain.max(initial=-1)) + 1


def find_domains(
    positions: np.ndarray,
    chains: np.ndarray,
    blocks: list[np.ndarray] | None = None,
    far: np.ndarray | None = None,
) -> Domains:
    """Domains and hinges of sites, one a residue, in the order of their chains.

    positions: (F, n, 3) superposed, Angstrom; chains: (n,), equal where sites are of one chain;
    blocks: arrays of frame numbers that are independent of each other, by default BLOCKS equal
    ones; far: (F', n, 3) superposed frames of the same sites that reach further, which no split may
    contradict. RESAMPLES times as many blocks as there are, drawn with replacement, are split into
    rigid bodies (`rigid_bodies`); always the same draws. A domain is a set of sites of which each
    two are in one body in TOGETHER of the resamples, and which is a body in LEAST_FOUND of them;
    two domains are in one body in at most APART. What is neither is `undecided`, and no domain.
    """
    if blocks is None:
        blocks = np.array_split(np.arange(len(positions)), min(BLOCKS, len(positions)))
    frames = _thinned(positions, chains, blocks)
    reached = None
    if far is not None and len(far):
        reached = _thinned(far, chains, [np.arange(len(far))]).sample(np.ones(1))
    random = np.random.default_rng(0)
    times = random.multinomial(len(blocks), np.full(len(blocks), 1 / len(blocks)), RESAMPLES)
    bodies = np.array([rigid_bodies(frames.sample(row), reached) for row in times])
    together = _together(bodies)
    domain, undecided = _agreed(bodies, together)
    hinge_share = _hinge_share(bodies, chains)
    numbers, counts = np.unique(bodies.max(axis=1) + 1, return_counts=True)
    return Domains(
        domain,
        _explained(frames.sample(np.ones(len(blocks))), domain),
        np.array([_found(bodies, domain == k) for k in range(domain.max() + 1)]),
        dict(zip(numbers.tolist(), (counts / len(bodies)).tolist(), strict=True)),
        _hinges(domain, chains, hinge_share),
        hinge_share,
        undecided,
    )


def _thinned(positions: np.ndarray, chains: np.ndarray, blocks: list[np.ndarray]) -> Frames:
    step = -(-len(positions) // MOST_FRAMES)
    return Frames(positions, chains, [block[:: max(1, min(step, len(block)))] for block in blocks])


def _together(bodies: np.ndarray) -> np.ndarray:
    """(n, n) share of the resamples in which two sites are in one body."""
    together = np.zeros((bodies.shape[1], bodies.shape[1]), dtype=np.float32)
    for body in bodies:
        together += body[:, None] == body
    return together / len(bodies)


def _agreed(
    bodies: np.ndarray, together: np.ndarray
) -> tuple[np.ndarray, list[tuple[np.ndarray, float]]]:
    """(n,) the domain of each site, and what is none because it is a domain too seldom."""
    sites = len(together)
    tree = linkage(squareform(1.0 - together, checks=False), "complete")
    names = fcluster(tree, 1.0 - TOGETHER + 1e-6, "distance")
    groups = [np.flatnonzero(names == name) for name in np.unique(names)]
    least = SAME * min(LEAST_SITES, sites)  # resamples agree on less than each of them has
    groups = [group for group in groups if len(group) >= least]
    groups.sort(key=lambda group: (-len(group), group[0]))
    kept: list[np.ndarray] = []
    undecided = []
    for group in groups:
        share = _found(bodies, np.isin(np.arange(sites), group))
        is_apart = all(together[np.ix_(group, one)].mean() <= APART for one in kept)
        if is_apart and share >= LEAST_FOUND:
            kept.append(group)
        else:
            undecided.append((group, share))
    domain = np.full(sites, LOOSE)
    if len(kept) > 1 or (len(kept) == 1 and _is_whole(bodies)):
        for k, group in enumerate(kept):
            domain[group] = k
    return domain, undecided


def _is_whole(bodies: np.ndarray) -> bool:
    return bool(np.mean(bodies.max(axis=1) == 0) >= TOGETHER)


def _found(bodies: np.ndarray, domain: np.ndarray) -> float:
    """Share of the resamples in which a body is this one (n, bool), but for 1 - SAME of both."""
    own = 0
    for body in bodies:
        sizes = np.bincount(body)
        shared = np.bincount(body[domain], minlength=len(sizes))
        own += np.max(shared / (sizes + domain.sum() - shared)) >= SAME
    return float(own / len(bodies))


def _explained(sample: Sample, domain: np.ndarray) -> float:
    """Share of the fluctuation that domains explain; of loose sites nothing is."""
    if domain.max() < 1:
        return 0.0
    followed = sum(sample.followed(domain == k)[0, 0] for k in range(domain.max() + 1))
    return float(1.0 - (np.sum(sample.moves**2) - followed) / sample.left())


def _hinge_share(bodies: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """(n,) share of the resamples in which the boundary of two bodies is beside a site."""
    ends = np.zeros((len(bodies), bodies.shape[1] + 1), dtype=bool)
    ends[:, 1:-1] = (bodies[:, 1:] != bodies[:, :-1]) & (chains[1:] == chains[:-1])
    return np.asarray((ends[:, 1:] | ends[:, :-1]).mean(axis=0))


def _hinges(domain: np.ndarray, chains: np.ndarray, share: np.ndarray) -> list[Hinge]:
    """Between sites of one chain that are of different domains, with none of a third between."""
    held = np.flatnonzero(domain != LOOSE)
    made = []
    for before, after in itertools.pairwise(held):
        one_chain = chains[before] == chains[after]
        if one_chain and domain[before] != domain[after] and after - before <= MOST_BETWEEN:
            site = int(before) + int(np.argmax(share[before : after + 1]))
            made.append(Hinge(int(before), int(after), site, float(share[site])))
    return made
