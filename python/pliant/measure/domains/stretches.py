# SPDX-License-Identifier: MIT
"""Stretches of chains: values smoothed along them, and labels without short ones."""

from __future__ import annotations

import numpy as np

#: a stretch of a chain shorter than this between two of one domain belongs to that domain
LEAST_STRETCH = 5
#: sites of a chain on either side that go with a site to one body
NEIGHBOURS = 2


def over_neighbours(values: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Mean over the sites of the chain that are at most NEIGHBOURS away."""
    sums, counts = values.copy(), np.ones(len(values))
    for apart in range(1, NEIGHBOURS + 1):
        same = chains[apart:] == chains[:-apart]
        sums[apart:] += np.where(same, values[:-apart], 0.0)
        sums[:-apart] += np.where(same, values[apart:], 0.0)
        counts[apart:] += same
        counts[:-apart] += same
    return np.asarray(sums / counts)


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


def whole_ends(piece: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """Short stretches at the ends of chains join the piece that follows them in the chain."""
    piece = piece.copy()
    edges = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    for chain in np.split(np.arange(len(piece)), edges):
        for sites in (chain, chain[::-1]):
            unlike = np.flatnonzero(piece[sites] != piece[sites[0]])
            if len(unlike) and unlike[0] < LEAST_STRETCH:
                piece[sites[: unlike[0]]] = piece[sites[unlike[0]]]
    return piece
