# SPDX-License-Identifier: MIT
"""Which parts of a molecule move together: correlations, domains that move as rigid, hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pliant.analysis.superposition import superpose_all

#: at most so many domains are looked for
MOST_DOMAINS = 6
#: one more domain must explain this share of all fluctuation beyond those before
LEAST_GAIN = 0.08
#: what explains less than this is no cut into domains
LEAST_EXPLAINED = 0.3
#: a domain has at least so many sites, and this share of all
LEAST_SITES = 10
LEAST_SHARE = 0.05
#: a stretch of a chain shorter than this between two of one domain belongs to that domain
LEAST_STRETCH = 5

#: sites whose directions to all others are in memory at once
_ROWS = 64

LOOSE = -1  #: the domain of sites that belong to none


@dataclass(frozen=True)
class Domains:
    """Parts that move as rigid bodies."""

    domain: np.ndarray  #: (n,) of each site, from 0 by size; LOOSE where it belongs to none
    explained: float  #: share of the fluctuation that the domains explain by moving rigidly
    hinges: np.ndarray  #: (h, 2) neighbours along a chain in different domains

    @property
    def count(self) -> int:
        """How many domains there are; 1 means that the molecule moves as one."""
        return int(self.domain.max(initial=-1)) + 1


def correlations(positions: np.ndarray) -> np.ndarray:
    """Correlation matrix (n, n) of displacements: <d_i . d_j> / sqrt(<d_i^2> <d_j^2>).

    positions: (F, n, 3) superposed. 1: along with each other, -1: against each other, 0: neither
    (or at right angles, which this measure cannot tell apart; T. Ichiye, M. Karplus, Proteins 11
    (1991) 205). What does not move correlates with nothing.
    """
    table = positions - positions.mean(axis=0)
    flat = table.transpose(1, 0, 2).reshape(table.shape[1], -1)
    matrix: np.ndarray = flat @ flat.T
    spread = np.sqrt(np.diag(matrix))
    for row, own in zip(matrix, spread, strict=True):  # in place: there may be a million pairs
        scale = own * spread
        row[:] = np.divide(row, scale, out=np.zeros_like(row), where=scale > 0)
    return np.clip(matrix, -1.0, 1.0, out=matrix)


def distance_fluctuations(positions: np.ndarray) -> np.ndarray:
    """(n, n) r.m.s. change of the distance of each two sites, to first order, Angstrom.

    sigma_ij^2 = n_ij . <(d_i - d_j)(d_i - d_j)^T> n_ij with n_ij along the mean distance.
    """
    average = positions.mean(axis=0)
    frames = len(positions)
    table = (positions - average).reshape(frames, -1)
    sites = positions.shape[1]
    shifts = table.reshape(frames, sites, 3)
    own = np.einsum("fia,fib->iab", shifts, shifts) / frames
    ends, cross = np.empty((sites, sites)), np.empty((sites, sites))
    for rows in np.array_split(np.arange(sites), -(-sites // _ROWS)):
        some = slice(rows[0], rows[-1] + 1)
        apart = average[some, None] - average[None]
        length = np.linalg.norm(apart, axis=2)
        along = apart / np.where(length > 0, length, 1.0)[:, :, None]
        ends[some] = np.einsum("ija,iab,ijb->ij", along, own[some], along, optimize=True)
        rows3 = slice(3 * some.start, 3 * some.stop)  # the whole covariance has 9 numbers a pair
        covariance = (table[:, rows3].T @ table / frames).reshape(len(rows), 3, sites, 3)
        cross[some] = np.einsum("ija,iajb,ijb->ij", along, covariance, along, optimize=True)
    return np.asarray(np.sqrt(np.maximum(ends + ends.T - cross - cross.T, 0.0)))


def find_domains(positions: np.ndarray, chains: np.ndarray) -> Domains:
    """Domains and hinges of sites, one a residue, in the order of their chains.

    positions: (F, n, 3) superposed; chains: (n,), equal where sites are of one chain. Sites whose
    distances fluctuate least are put together (average linkage); domains are added while each
    explains at least LEAST_GAIN of the fluctuation. Where they explain less than LEAST_EXPLAINED
    in all, the molecule counts as one piece.
    """
    sites = positions.shape[1]
    best = np.zeros(sites, dtype=np.int64)
    total = float(positions.var(axis=0).sum())
    if sites < 2 * _least(sites) or total <= 0:
        return Domains(best, 0.0, np.zeros((0, 2), dtype=np.int64))
    tree = linkage(squareform(distance_fluctuations(positions), checks=False), "average")
    explained = 0.0
    for count in range(2, MOST_DOMAINS + 1):
        cut = _cut(tree, sites, count, chains)
        if cut is None:
            break
        share = 1.0 - _left_over(positions, cut) / total
        if share < explained + LEAST_GAIN:
            break
        best, explained = cut, share
    if explained < LEAST_EXPLAINED:
        best, explained = np.zeros(sites, dtype=np.int64), 0.0
    return Domains(best, explained, _hinges(best, chains))


def _least(sites: int) -> int:
    return max(LEAST_SITES, int(LEAST_SHARE * sites))


def _cut(tree: np.ndarray, sites: int, count: int, chains: np.ndarray) -> np.ndarray | None:
    """The first cut of the tree with `count` parts that are large enough; None without one."""
    for parts in range(count, min(sites, 8 * count) + 1):
        labels = without_short_stretches(fcluster(tree, parts, "maxclust"), chains)
        names, sizes = np.unique(labels, return_counts=True)
        large = names[np.argsort(-sizes, kind="stable")][: np.count_nonzero(sizes >= _least(sites))]
        if len(large) >= count:
            domain = np.full(sites, LOOSE)
            for k, name in enumerate(large[:count]):
                domain[labels == name] = k
            return domain
    return None


def without_short_stretches(labels: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Short stretches between two of one part join it."""
    labels = labels.copy()
    edges = np.flatnonzero((labels[1:] != labels[:-1]) | (chains[1:] != chains[:-1])) + 1
    starts = [0, *edges.tolist(), len(labels)]
    for k in range(1, len(starts) - 2):
        first, last = starts[k], starts[k + 1]
        flanks = labels[first - 1], labels[last]
        one_chain = chains[first - 1] == chains[first] == chains[last]
        if last - first < LEAST_STRETCH and flanks[0] == flanks[1] and one_chain:
            labels[first:last] = flanks[0]
    return labels


def _left_over(positions: np.ndarray, domain: np.ndarray) -> float:
    """Fluctuation that is left within domains, each superposed by itself; all of loose sites."""
    rest = float(positions[:, domain == LOOSE].var(axis=0).sum())
    for k in range(int(domain.max()) + 1):
        own = superpose_all(positions[:, domain == k], iterations=3)
        rest += float(own.var(axis=0).sum())
    return rest


def _hinges(domain: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Neighbours of one chain in different domains; across loose sites the two that flank them."""
    held = np.flatnonzero(domain != LOOSE)
    pairs = np.stack([held[:-1], held[1:]], axis=1)
    one_chain = chains[pairs[:, 0]] == chains[pairs[:, 1]]
    near = pairs[:, 1] - pairs[:, 0] <= LEAST_SITES
    return np.asarray(pairs[one_chain & near & (domain[pairs[:, 0]] != domain[pairs[:, 1]])])
