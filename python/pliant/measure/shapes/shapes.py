# SPDX-License-Identifier: MIT
"""Shapes among the frames of an ensemble: frames far from the start that stand for the others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant._core import PlausibleShapes
from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.superposition import pairwise_rmsd, rmsd_to

#: what is nearer to the start, or to another shape, than this is no other shape, Angstrom
LEAST_RMSD = 3.0
MOST_SHAPES = 8
#: a frame stands for those that are nearer than this, the more the nearer, Angstrom
REACH = 8.0
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
    compared: np.ndarray  #: (c,) frames beyond the limit that were compared
    representatives: np.ndarray  #: (k,) frames, the most plausible first
    members: tuple[np.ndarray, ...]  #: k times the frames of a shape
    distances: tuple[np.ndarray, ...]  #: of these from the representative, Angstrom
    alone: np.ndarray  #: (a,) frames that were compared and are like no shape


def find_shapes(
    frames: FrameStore, start: np.ndarray, near: np.ndarray, plausible: PlausibleShapes
) -> ShapeGroups:
    """Frames that stand for those further from the start than all around it.

    frames: (F, n, 3); start: (n, 3); near: (F,) bool, drawn around the start: another shape is
    further from it than these all are, and than LEAST_RMSD. RMSDs are of pairs superposed. See
    `stand_for_others`; a frame is of the shape that it is nearest to. `plausible` is of the start.
    """
    rmsd = np.concatenate([rmsd_to(block, start[None])[:, 0] for block in frames.blocks()])
    limit = LEAST_RMSD
    if near.any():
        limit = max(limit, float(rmsd[near].max()))
    far = np.flatnonzero(~near & (rmsd > limit))
    most = min(MOST_COMPARED, max(2, COMPARED_BYTES // (24 * len(start))))
    compared = far[:: max(1, -(-len(far) // most))]
    if len(compared) < LEAST_FRAMES:
        none = np.zeros(0, dtype=np.int64)
        return ShapeGroups(rmsd, limit, compared, none, (), (), compared)
    chosen = frames.take(compared).astype(np.float64)
    distances = pairwise_rmsd(chosen)
    scores = plausible.scores(chosen)
    centres = stand_for_others(distances, scores, MOST_SHAPES)
    nearest = np.argmin(distances[centres], axis=0)
    reached = distances[centres].min(axis=0) < REACH
    groups = [np.flatnonzero(reached & (nearest == k)) for k in range(len(centres))]
    shapes = [k for k, group in enumerate(groups) if len(group) >= LEAST_FRAMES]
    members = [groups[k] for k in shapes]
    return ShapeGroups(
        rmsd,
        limit,
        compared,
        compared[centres[shapes]],
        tuple(compared[own] for own in members),
        tuple(distances[centres[k], own] for k, own in zip(shapes, members, strict=True)),
        compared[np.setdiff1d(np.arange(len(compared)), np.concatenate([*members, []]))],
    )


def stand_for_others(
    distances: np.ndarray, scores: np.ndarray, most: int, apart: float = LEAST_RMSD
) -> np.ndarray:
    """(k,) frames that stand best for all, those that add most first.

    distances: (F, F) Angstrom; scores: (F,) logarithms of how plausible each is. A frame at
    distance d is stood for by 1 - d / REACH, and counts by how plausible it is; each next frame is
    the one that adds most to the sum (G. Nemhauser et al., Math. Program. 14 (1978) 265), and is
    `apart` from those before (Angstrom).
    """
    near = np.maximum(1.0 - distances / REACH, 0.0)
    weights = np.exp(scores - scores.max())
    stood = np.zeros(len(near))
    chosen: list[int] = []
    free = np.ones(len(near), dtype=bool)
    while len(chosen) < most and free.any():
        gains = np.maximum(near - stood, 0.0) @ weights
        chosen.append(int(np.argmax(np.where(free, gains, -1.0))))
        stood = np.maximum(stood, near[chosen[-1]])
        free &= distances[chosen[-1]] >= apart
        free[chosen[-1]] = False
    return np.array(chosen, dtype=np.int64)
