# SPDX-License-Identifier: MIT
"""From one structure to another: which pieces turned as wholes, by how much, about which hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pliant.measure.domains import LOOSE, distance_fluctuations
from pliant.measure.domains.stretches import (
    LEAST_STRETCH,
    over_neighbours,
    whole_ends,
    without_short_stretches,
)
from pliant.trajectory.superposition import Superposition, superpose_all

#: at most so many pieces are looked for
MOST_PIECES = 6
#: one more piece must explain this share of all motion beyond those before
LEAST_GAIN = 0.08
#: what explains less than this is no cut into pieces
LEAST_EXPLAINED = 0.3
#: a piece has at least so many sites, and this share of all
LEAST_SITES = 10
LEAST_SHARE = 0.05

MOST_ROUNDS = 20


@dataclass(frozen=True)
class RigidTurns:
    """Pieces that are rigid from one structure to the other, and their turns."""

    piece: np.ndarray  #: (n,) of each site, from 0 by size
    angles: np.ndarray  #: (k,) degrees, of each against the largest, which has 0
    axes: np.ndarray  #: (k, 3) unit vectors along the axes of these turns
    hinges: np.ndarray  #: (h, 2) neighbours along a chain in different pieces
    within: float  #: RMSD that is left when each piece is superposed by itself, Angstrom
    end: np.ndarray  #: (n, 3) the other structure, its largest piece superposed on the first's


def rigid_turns(start: np.ndarray, end: np.ndarray, chains: np.ndarray) -> RigidTurns:
    """Pieces of sites (n, 3), one a residue in the order of their chains, from start to end.

    At first sites whose distances change least are put together (average linkage); pieces are added
    while each explains at least LEAST_GAIN of the motion. Then each site goes to the piece whose
    motion brings it and its neighbours along the chain nearest to their places, until nothing
    changes. The angle is that of the rotation that superposes a piece once the largest is
    superposed: cos(angle) = (trace(R) - 1) / 2.
    """
    moved = Superposition(start, np.ones(len(start))).apply(end)
    piece = _best_pieces(start, moved, _first_pieces(np.stack([start, moved]), chains), chains)
    core = piece == 0
    moved = Superposition(start[core], np.ones(int(core.sum()))).apply(end, end[core])
    angles, axes, left = [], [], 0.0
    for own in (piece == k for k in range(piece.max() + 1)):
        fit = Superposition(start[own], np.ones(int(own.sum())))
        rotation = fit.motion(moved[own])[0]
        cosine = (np.trace(rotation) - 1.0) / 2.0
        angles.append(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
        axes.append(np.linalg.svd(rotation.T - np.eye(3))[2][2])  # which the rotation leaves as is
        left += float(np.sum((fit.apply(moved[own]) - start[own]) ** 2))
    angles[0] = 0.0
    first = np.flatnonzero((chains[1:] == chains[:-1]) & (piece[1:] != piece[:-1]))
    hinges = np.stack([first, first + 1], axis=1)
    within = float(np.sqrt(left / len(piece)))
    return RigidTurns(piece, np.array(angles), np.array(axes), hinges, within, moved)


def _best_pieces(
    start: np.ndarray, end: np.ndarray, piece: np.ndarray, chains: np.ndarray
) -> np.ndarray:
    """(n,) the piece of each site, from 0 by size."""
    for _ in range(MOST_ROUNDS):
        names, sizes = np.unique(piece[piece != LOOSE], return_counts=True)
        names = names[sizes >= LEAST_STRETCH]
        off = []
        for own in (piece == name for name in names):
            moved = Superposition(end[own], np.ones(int(own.sum()))).apply(start, start[own])
            off.append(over_neighbours(np.sum((moved - end) ** 2, axis=1), chains))
        better = names[np.argmin(off, axis=0)]
        better = whole_ends(without_short_stretches(better, chains), chains)
        if np.array_equal(better, piece):
            break
        piece = better
    _, number, sizes = np.unique(piece, return_inverse=True, return_counts=True)
    return np.argsort(np.argsort(-sizes, kind="stable"), kind="stable")[number]


def _first_pieces(positions: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """(n,) the piece of each site in structures (F, n, 3) that are superposed; LOOSE: none yet."""
    sites = positions.shape[1]
    best = np.zeros(sites, dtype=np.int64)
    total = float(positions.var(axis=0).sum())
    if sites < 2 * _least(sites) or total <= 0:
        return best
    tree = linkage(squareform(distance_fluctuations(positions), checks=False), "average")
    explained = 0.0
    for count in range(2, MOST_PIECES + 1):
        cut = _cut(tree, sites, count, chains)
        if cut is None:
            break
        share = 1.0 - _left_over(positions, cut) / total
        if share < explained + LEAST_GAIN:
            break
        best, explained = cut, share
    if explained < LEAST_EXPLAINED:
        best = np.zeros(sites, dtype=np.int64)
    return best


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


def _left_over(positions: np.ndarray, domain: np.ndarray) -> float:
    """Fluctuation that is left within pieces, each superposed by itself; all of loose sites."""
    rest = float(positions[:, domain == LOOSE].var(axis=0).sum())
    for k in range(int(domain.max()) + 1):
        own = superpose_all(positions[:, domain == k], iterations=3)
        rest += float(own.var(axis=0).sum())
    return rest
