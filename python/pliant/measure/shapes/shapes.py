# SPDX-License-Identifier: MIT
"""Shapes among the frames of an ensemble: groups of frames that are alike, far from the start."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.superposition import pairwise_rmsd, rmsd_to

#: what is nearer to the start than this is no other shape, Angstrom
LEAST_RMSD = 3.0
#: more shapes than these are put together, the most alike first
MOST_SHAPES = 8
#: a frame that is like no other is no shape
LEAST_FRAMES = 2
#: of more frames than fit, evenly taken ones are compared; so are those beyond MOST_COMPARED
COMPARED_BYTES = 1 << 24
MOST_COMPARED = 3000


@dataclass(frozen=True)
class ShapeGroups:
    """Which frames are around the start, which are of which other shape, which are like none."""

    rmsd: np.ndarray  #: (F,) from the start, Angstrom
    limit: float  #: frames up to here count as around the start, Angstrom
    cutoff: float  #: groups of frames that are less apart on average are one shape, Angstrom
    compared: np.ndarray  #: (c,) frames beyond the limit that were compared
    representatives: np.ndarray  #: (k,) frames, furthest from the start first
    members: tuple[np.ndarray, ...]  #: k times the frames of a shape
    distances: tuple[np.ndarray, ...]  #: of these from the representative, Angstrom
    alone: np.ndarray  #: (a,) frames that were compared and are like no other


def find_shapes(frames: FrameStore, start: np.ndarray, near: np.ndarray) -> ShapeGroups:
    """Groups of the frames that are further from the start than those around it.

    frames: (F, n, 3); start: (n, 3); near: (F,) bool, drawn around the start: another shape is
    further from it than these all are, and than LEAST_RMSD. RMSDs are of pairs superposed. Of two
    frames that each scatter by the limit about one shape the RMSD is sqrt(2) times the limit, so
    groups that are less apart on average are put together (average linkage), and more of them until
    there are at most MOST_SHAPES.
    """
    rmsd = np.concatenate([rmsd_to(block, start[None])[:, 0] for block in frames.blocks()])
    limit = LEAST_RMSD
    if near.any():
        limit = max(limit, float(rmsd[near].max()))
    far = np.flatnonzero(~near & (rmsd > limit))
    most = min(MOST_COMPARED, max(2, COMPARED_BYTES // (24 * len(start))))
    compared = far[:: max(1, -(-len(far) // most))]
    cutoff = float(np.sqrt(2.0) * limit)
    if len(compared) < LEAST_FRAMES:
        none = np.zeros(0, dtype=np.int64)
        return ShapeGroups(rmsd, limit, cutoff, compared, none, (), (), compared)
    distances = pairwise_rmsd(frames.take(compared).astype(np.float64))
    labels, cutoff = _cut(linkage(squareform(distances, checks=False), "average"), cutoff)
    groups = [np.flatnonzero(labels == k) for k in range(1, labels.max() + 1)]
    shapes = [group for group in groups if len(group) >= LEAST_FRAMES]
    centres = [group[np.argmin(distances[np.ix_(group, group)].sum(axis=0))] for group in shapes]
    order = np.argsort([-rmsd[compared[c]] for c in centres], kind="stable")
    return ShapeGroups(
        rmsd,
        limit,
        cutoff,
        compared,
        np.array([compared[centres[k]] for k in order], dtype=np.int64),
        tuple(compared[shapes[k]] for k in order),
        tuple(distances[centres[k], shapes[k]] for k in order),
        compared[np.isin(np.arange(len(compared)), [g[0] for g in groups if len(g) == 1])],
    )


def _cut(tree: np.ndarray, cutoff: float) -> tuple[np.ndarray, float]:
    """The group of each frame, from 1, at the lowest cut from `cutoff` on that has few shapes."""
    heights = tree[:, 2]
    for height in (cutoff, *heights[heights > cutoff]):
        labels = fcluster(tree, height, "distance")
        if np.count_nonzero(np.bincount(labels) >= LEAST_FRAMES) <= MOST_SHAPES:
            break
    return labels, float(height)
