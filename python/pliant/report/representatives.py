# SPDX-License-Identifier: MIT
"""A few frames that stand for all, as the models of a PDB file: for docking, or to look at."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import InputError, OptionError
from pliant.base.checked import checked, whole
from pliant.base.display import Displayed, Facts
from pliant.measure.shapes.medoids import k_medoids
from pliant.measure.shapes.other_shapes import REMARK_OF_SHAPES, shape_groups
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.measure.stages.opened import opened
from pliant.measure.stages.reference import reference_of
from pliant.report.multi_model import write_chosen
from pliant.trajectory.files import file_of
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.shards.frames import folder_of
from pliant.trajectory.shards.plan import PLAN, is_ensemble
from pliant.trajectory.sources import Molecule
from pliant.trajectory.superposition import pairwise_rmsd
from pliant.trajectory.trajectory import HasFrames

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

REMARK = "chosen by k-medoids; populations are not claimed"
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
    notes: tuple[str, ...]
    output: str = ""  #: the file written

    def facts(self) -> Facts:
        """Which frames, and how well they stand for all."""
        chosen = ", ".join(map(str, self.frames.tolist()))
        far = f"{self.mean_distance:.2f} Å on average, {self.largest_distance:.2f} Å at most"
        compared = f"{self.compared} frames, superposed on {self.superposed_on}"
        files = [("file", self.output)] if self.output else []
        return [("frames", chosen), ("a frame is off", far), ("compared", compared), *files]

    def as_json(self) -> dict[str, Any]:
        """The same as one JSON object."""
        return dict(vars(self))


@checked(count=whole(1))
def representatives(
    path: HasFrames | Molecule,
    count: int | None = None,
    output: str | os.PathLike[str] | None = None,
    *,
    topology: str | os.PathLike[str] | None = None,
    select: str = "all",
    superpose: str | None = None,
    shapes: bool = False,
    overwrite: bool = False,
) -> Representatives:
    """Chooses `count` frames by k-medoids on the RMSD of frames superposed pair by pair.

    With `shapes`, one frame for each other shape that `analyse` finds in an ensemble of sampler
    ``reach``, those furthest from the start first.

    Nothing is random: the same file gives the same frames. How many frames are nearest to each is
    no population: how often a shape occurs is not claimed.

    Parameters
    ----------
    path : str or path, SampledEnsemble, RunResult, MolecularPath, Trajectory, Universe, ...
        H5MD file, the folder of an ensemble, or any trajectory that MDAnalysis reads; or what has
        frames.
    count : int, optional
        Frames to choose.
    output : str or path, optional
        PDB file with one model for each, superposed.
    topology : str or path, optional
        File with atoms, where `path` holds none.
    select : str
        MDAnalysis selection: which atoms are written.
    superpose : str, optional
        Atoms that are superposed and compared. Default: CA and P atoms if they form chains, else
        all but hydrogens.
    shapes : bool
        Instead of `count` and `superpose`: one frame per shape.
    overwrite : bool
        Replace an existing output.

    Raises
    ------
    InputError, FileError
        The file cannot be used; the output exists, or cannot be written.
    OptionError
        There are fewer frames than asked for, no other shapes, or a selection is wrong.
    """
    if shapes == (count is not None):
        raise OptionError("-k, --shapes: expected one of the two")
    if shapes and superpose is not None:
        raise OptionError("--superpose: goes with -k, not with --shapes")
    if output is not None and Path(output).exists() and not overwrite:
        raise InputError(f"{os.fspath(output)}: exists; --overwrite replaces it")
    file, _folder = file_of(path, "representatives")
    if is_ensemble(file):
        file = str(folder_of(Path(file)) / PLAN)
    named = None if topology is None else os.fspath(topology)
    analysis = opened(AnalysisOptions(file, named, select, superpose))
    analysis = analysis.having(reference_of(analysis)) if shapes else analysis
    found, chosen = _one_per_shape(analysis) if count is None else _medoids(analysis, count)
    if output is not None:
        remark = REMARK_OF_SHAPES if shapes else REMARK
        write_chosen(analysis, chosen, Path(output), remark, overwrite=overwrite)
        found = replace(found, output=os.fspath(output))
    return found


def _medoids(analysis: Analysis, count: int) -> tuple[Representatives, np.ndarray]:
    """What stands for all frames, and its places among those analysed."""
    notes = analysis.notes
    stride = -(-len(analysis.frames) // MOST_FRAMES)
    offered = len(analysis.frames[::stride])
    if stride > 1:
        notes.append(f"every {stride}th frame was compared")
    if count > offered:
        raise OptionError(f"-k: expected up to {offered} frames, found {count}")
    if analysis.kind != ENSEMBLE:
        notes.append("these frames are no independent draws: see pliant sample")
    compared = np.concatenate(list(analysis.some_positions(analysis.fitted.ix)))[::stride]
    found = k_medoids(pairwise_rmsd(compared.astype(np.float64)), count)
    chosen = found.frames * stride
    representatives = Representatives(
        analysis.frames[chosen],
        np.bincount(found.owner, minlength=count),
        float(found.distance.mean()),
        float(found.distance.max()),
        len(compared),
        analysis.fitted_name,
        tuple(notes),
    )
    return representatives, chosen


def _one_per_shape(analysis: Analysis) -> tuple[Representatives, np.ndarray]:
    """The same of each other shape."""
    found = shape_groups(analysis)
    if found is None or len(found[1].representatives) == 0:
        raise OptionError("--shapes: there are no other shapes; see pliant sample --sampler reach")
    groups = found[1]
    distances = np.concatenate(groups.distances)
    representatives = Representatives(
        analysis.frames[groups.representatives],
        np.array([len(members) for members in groups.members]),
        float(distances.mean()),
        float(distances.max()),
        len(groups.compared),
        "CA and P atoms",
        tuple(analysis.notes),
    )
    return representatives, groups.representatives
