# SPDX-License-Identifier: MIT
"""A few frames that stand for all, as the models of a PDB file: for docking, or to look at."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from pliant._core import InputError, OptionError
from pliant.base.checked import checked, whole
from pliant.measure.shapes.other_shapes import REMARK_OF_SHAPES
from pliant.measure.shapes.representatives import Representatives, medoids, one_per_shape
from pliant.measure.stages.analysis import AnalysisOptions
from pliant.measure.stages.opened import opened
from pliant.measure.stages.reference import reference_of
from pliant.report.multi_model import write_chosen
from pliant.trajectory.files import file_of
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import HasFrames

REMARK = "frames that stand for all; populations are not claimed"


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

    Of an ensemble of sampler ``reach``, half of them are of the frames around the start, half of
    the others, where plausible ones count more. With `shapes`, one frame for each other shape that
    `analyse` finds in it, the most plausible first.

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
        raise OptionError("count, shapes: expected one of the two")
    if shapes and superpose is not None:
        raise OptionError("superpose: goes with count, not with shapes")
    if output is not None and Path(output).exists() and not overwrite:
        raise InputError(f"{os.fspath(output)}: exists; overwrite=True replaces it")
    file, _folder = file_of(path, "representatives")
    named = None if topology is None else os.fspath(topology)
    analysis = opened(AnalysisOptions(file, named, select, superpose))
    analysis = analysis.having(reference_of(analysis)) if shapes else analysis
    found, chosen = one_per_shape(analysis) if count is None else medoids(analysis, count)
    if output is not None:
        remark = REMARK_OF_SHAPES if shapes else REMARK
        write_chosen(analysis, chosen, Path(output), remark, overwrite=overwrite)
        found = replace(found, output=os.fspath(output))
    return found
