# SPDX-License-Identifier: MIT
"""From one structure to another: which pieces turned as wholes, by how much, about which hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant.analysis.domains import LEAST_STRETCH, LOOSE, find_domains
from pliant.analysis.superposition import Superposition


@dataclass(frozen=True)
class RigidTurns:
    """Pieces that are rigid from one structure to the other, and their turns."""

    piece: np.ndarray  #: (n,) of each site, from 0 by size; LOOSE where it belongs to none
    angles: np.ndarray  #: (k,) degrees, of each against the largest, which has 0
    axes: np.ndarray  #: (k, 3) unit vectors along the axes of these turns
    hinges: np.ndarray  #: (h, 2) neighbours along a chain in different pieces
    within: float  #: RMSD that is left when each piece is superposed by itself, Angstrom
    end: np.ndarray  #: (n, 3) the other structure, its largest piece superposed on the first's


def rigid_turns(start: np.ndarray, end: np.ndarray, chains: np.ndarray) -> RigidTurns:
    """Pieces of sites (n, 3), one a residue in the order of their chains, from start to end.

    The pieces are those of `find_domains` for the two structures: sites whose distances change
    least are put together. Of a pair, the change is exact: rigid pieces have none, however far
    they turn. The angle is that of the rotation that superposes a piece once the largest is
    superposed: cos(angle) = (trace(R) - 1) / 2.
    """
    moved = Superposition(start, np.ones(len(start))).apply(end)
    piece = _whole_ends(find_domains(np.stack([start, moved]), chains).domain, chains)
    core = piece == 0
    moved = Superposition(start[core], np.ones(int(core.sum()))).apply(end, end[core])
    angles, axes, left = [], [], []
    for k in range(piece.max() + 1):
        own = piece == k
        fit = Superposition(start[own], np.ones(int(own.sum())))
        rotation = fit.motion(moved[own])[0]
        cosine = (np.trace(rotation) - 1.0) / 2.0
        angles.append(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))) if k else 0.0)
        axes.append(np.linalg.svd(rotation.T - np.eye(3))[2][2])  # which the rotation leaves as is
        left.append(np.sum((fit.apply(moved[own]) - start[own]) ** 2))
    within = float(np.sqrt(sum(left) / max(1, np.count_nonzero(piece != LOOSE))))
    joined = (chains[1:] == chains[:-1]) & (piece[1:] != piece[:-1])
    first = np.flatnonzero(joined)
    hinges = np.stack([first, first + 1], axis=1)
    return RigidTurns(piece, np.array(angles), np.array(axes), hinges, within, moved)


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
