# SPDX-License-Identifier: MIT
"""From one structure to another: which pieces turned as wholes, by how much, about which hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant.analysis.domains import LEAST_STRETCH, LOOSE, find_domains, without_short_stretches
from pliant.analysis.superposition import Superposition

#: sites of a chain on either side that go with a site to one piece
NEIGHBOURS = 2
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

    The pieces are at first those of `find_domains` for the two structures: sites whose distances
    change least are put together. Then each site goes to the piece whose motion brings it and its
    neighbours along the chain nearest to their places, until nothing changes. The angle is that of
    the rotation that superposes a piece once the largest is superposed: cos(angle) = (trace(R) - 1)
    / 2.
    """
    moved = Superposition(start, np.ones(len(start))).apply(end)
    piece = _best_pieces(
        start, moved, find_domains(np.stack([start, moved]), chains).domain, chains
    )
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
            off.append(_over_neighbours(np.sum((moved - end) ** 2, axis=1), chains))
        better = names[np.argmin(off, axis=0)]
        better = _whole_ends(without_short_stretches(better, chains), chains)
        if np.array_equal(better, piece):
            break
        piece = better
    _, number, sizes = np.unique(piece, return_inverse=True, return_counts=True)
    return np.argsort(np.argsort(-sizes, kind="stable"), kind="stable")[number]


def _over_neighbours(values: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Mean over the sites of the chain that are at most NEIGHBOURS away."""
    sums, counts = values.copy(), np.ones(len(values))
    for apart in range(1, NEIGHBOURS + 1):
        same = chains[apart:] == chains[:-apart]
        sums[apart:] += np.where(same, values[:-apart], 0.0)
        sums[:-apart] += np.where(same, values[apart:], 0.0)
        counts[apart:] += same
        counts[:-apart] += same
    return np.asarray(sums / counts)


def _whole_ends(piece: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Short stretches at the ends of chains join the piece that follows them in the chain."""
    piece = piece.copy()
    edges = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    for chain in np.split(np.arange(len(piece)), edges):
        for sites in (chain, chain[::-1]):
            unlike = np.flatnonzero(piece[sites] != piece[sites[0]])
            if len(unlike) and unlike[0] < LEAST_STRETCH:
                piece[sites[: unlike[0]]] = piece[sites[unlike[0]]]
    return piece
