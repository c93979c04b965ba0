# SPDX-License-Identifier: MIT
"""A few frames that stand for all, near and far from the start, or one for each other shape."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import OptionError
from pliant.base.display import Displayed, Facts
from pliant.measure.shapes.medoids import k_medoids, owned_by
from pliant.measure.shapes.other_shapes import Compared, has_shapes, shape_groups
from pliant.measure.shapes.shapes import stand_for_others
from pliant.measure.stages.reference import reference_of
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.superposition import pairwise_rmsd

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

#: of more frames than these so many are taken, evenly
MOST_FRAMES = 3000


@dataclass(frozen=True)
class Representatives(Displayed):
    """k frames, and how well they stand for all."""

    frames: np.ndarray  #: (k,) numbers in the file, those nearest to most frames first
    nearest: np.ndarray  #: (k,) how many of the frames compared are nearest to each
    mean_distance: float  #: of a frame from the one that stands for it, Angstrom
    largest_distance: float  #: Angstrom
    compared: int  #: frames that were compared
    superposed_on: str  #: atoms
    around: int  #: of the k, frames around the start; others were drawn to reach further
    notes: tuple[str, ...]
    output: str = ""  #: the file written

    def facts(self) -> Facts:
        """Which frames, and how well they stand for all."""
        chosen = ", ".join(map(str, self.frames.tolist()))
        far = f"{self.mean_distance:.2f} Å on average, {self.largest_distance:.2f} Å at most"
        compared = f"{self.compared} frames, superposed on {self.superposed_on}"
        files = [("file", self.output)] if self.output else []
        if 0 < self.around < len(self.frames):
            chosen += f" ({self.around} around the start, {len(self.frames) - self.around} beyond)"
        return [("frames", chosen), ("a frame is off", far), ("compared", compared), *files]

    def as_json(self) -> dict[str, Any]:
        """The same as one JSON object."""
        return dict(vars(self))


def medoids(analysis: Analysis, count: int) -> tuple[Representatives, np.ndarray]:
    """What stands for all frames, and its places among those analysed."""
    notes = analysis.notes
    stride = -(-len(analysis.frames) // MOST_FRAMES)
    offered = len(analysis.frames[::stride])
    if stride > 1:
        notes.append(f"every {stride}th frame was compared")
    if count > offered:
        raise OptionError(f"representatives: expected up to {offered} frames, found {count}")
    if analysis.kind != ENSEMBLE:
        notes.append("these frames are no independent draws: see pliant sample")
    compared = np.concatenate(list(analysis.some_positions(analysis.fitted.ix)))[::stride]
    distances = pairwise_rmsd(compared.astype(np.float64))
    beyond = np.zeros(len(compared), dtype=bool)
    if analysis.reaches is not None:
        beyond = analysis.reaches[::stride]
    others = _of_others(analysis, distances, beyond, stride, count)
    around = _medoids_among(distances, np.flatnonzero(~beyond), count - len(others))
    found = owned_by(distances, np.concatenate([around, others]))
    representatives = Representatives(
        analysis.frames[found.frames * stride],
        np.bincount(found.owner, minlength=count),
        float(found.distance.mean()),
        float(found.distance.max()),
        len(compared),
        analysis.fitted_name,
        len(around),
        tuple(notes),
    )
    return representatives, found.frames * stride


def _of_others(
    analysis: Analysis, distances: np.ndarray, beyond: np.ndarray, stride: int, count: int
) -> np.ndarray:
    """Half of the frames asked for, of those drawn to reach further: as shapes are chosen. Every
    `stride`th frame is compared."""
    others = np.flatnonzero(beyond)
    wanted = min(len(others), max(count // 2, count - np.count_nonzero(~beyond)))
    if not wanted:
        return others[:0]
    scores = np.zeros(len(others))
    if has_shapes(analysis):
        by = Compared.of(analysis, reference_of(analysis))
        chosen = np.isin(np.arange(len(analysis.frames)), others * stride)
        frames = analysis.stored_positions(by.sites, chosen).take(np.arange(len(others)))
        scores = by.plausible.scores(frames.astype(np.float64))
    among = distances[np.ix_(others, others)]
    return np.asarray(others[stand_for_others(among, scores, wanted, apart=0.0)])


def _medoids_among(distances: np.ndarray, frames: np.ndarray, count: int) -> np.ndarray:
    if not count:
        return frames[:0]
    return np.asarray(frames[k_medoids(distances[np.ix_(frames, frames)], count).frames])


def one_per_shape(analysis: Analysis) -> tuple[Representatives, np.ndarray]:
    """The same of each other shape."""
    found = shape_groups(analysis)
    if found is None or len(found[1].representatives) == 0:
        raise OptionError("shapes: there are no other shapes; see pliant sample --sampler reach")
    groups = found[1]
    distances = np.concatenate(groups.distances)
    representatives = Representatives(
        analysis.frames[groups.representatives],
        np.array([len(members) for members in groups.members]),
        float(distances.mean()),
        float(distances.max()),
        len(groups.compared),
        "CA and P atoms",
        0,
        tuple(analysis.notes),
    )
    return representatives, groups.representatives
