# SPDX-License-Identifier: MIT
"""Fits a structure to measured distances, to a density map, or to both."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from typing import Any

from pliant._core import DensityMap, FileError, OptionError, PathOptions
from pliant.base.checked import SEED, checked, whole
from pliant.jobs.fit.fitted import FittedStructure
from pliant.jobs.fit.molecule import FRAMES
from pliant.jobs.fit.saxs.curve import read_curve
from pliant.jobs.fit.saxs.explained import FittedCurve, fit_curve
from pliant.jobs.fit.task import FitTask

__all__ = ["FittedCurve", "FittedStructure", "fit"]

LEAST_FRAMES = 50


@checked(keep=whole(1), seed=SEED)
def fit(
    start: Any,
    distances: str | os.PathLike[str] | Sequence[Mapping[str, Any]] | None = None,
    *,
    map: str | os.PathLike[str] | DensityMap | None = None,
    resolution: float | None = None,
    half: str | os.PathLike[str] | DensityMap | None = None,
    place: bool = False,
    saxs: str | os.PathLike[str] | None = None,
    ensemble: bool = False,
    background: bool = False,
    frames: int | str | os.PathLike[str] = FRAMES,
    keep: int = 1,
    seed: int = 0,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    **options: Any,
) -> FittedStructure | FittedCurve:
    """Fits a structure to measured distances, a density map, or both, or chooses shapes by a SAXS
    curve: all atoms, bonds and angles exact.

    Parameters
    ----------
    start : Structure, path, Universe, AtomGroup, ...
        A protein or nucleic acid, as ``sample`` takes it.
    distances : str, path or sequence of dicts, optional
        CSV with a header, or the same fields: site1, site2 (residues: "A:45", "45" or a selection),
        and distance with error, or low and high, in Angstrom between alpha carbons; kind: CA (the
        default), the reagent of a cross-link, DSS, BS3, DSSO, DSBU (up to 30), SDA (25) or EDC
        (20), MTSL, between spin labels, FRET, between mean positions of dyes, or atom or NOE,
        whose sites are selections of one atom or of hydrogens.
    map : str, path or DensityMap, optional
        MRC or CCP4, into which `start` has been put, as by ChimeraX' fitmap. The result is there,
        too.
    resolution : float, optional
        Of the map, Angstrom. Needed with a map.
    half : str, path or DensityMap, optional
        The other half of the data as a map, to judge by.
    place : bool
        Put `start` into the map first, wherever it is.
    saxs : str or path
        In place of distances: a text of columns q (1/Angstrom), I and sigma. The result is a
        ``pliant.jobs.fit.saxs.explained.FittedCurve``: the frame that explains the curve.
    ensemble : bool
        Of `saxs`: the least number of frames that explain it, and their weights.
    background : bool
        Of `saxs`: a constant is fitted, too.
    frames : int or path
        Of the ensemble from which starts are taken: how many (50 or more) to make, or a file of
        them, as ``sample`` writes it.
    keep : int
        How many structures fitted to distances are made of all atoms, the best first.
    seed : int
        Of the ensemble.
    output : str or path, optional
        File of the structures: .pdb, .cif, .h5md, ...
    overwrite : bool
        Replace it.
    **options
        What ``path`` takes of the molecule and its model: `select`, `contacts`, ...

    Raises
    ------
    OptionError
        An option out of range, or of the other kind of data.
    InputError
        A file that cannot be read, or a row of the table that is wrong.
    FileError
        The output exists or cannot be written.
    """
    begun = time.perf_counter()
    if output is not None and not overwrite and os.path.exists(output):
        raise FileError(f"{os.fspath(output)}: exists; overwrite=True replaces it")
    if isinstance(frames, int) and frames < LEAST_FRAMES:
        raise OptionError(f"frames = {frames}: must be {LEAST_FRAMES} or more, or a file")
    _check_kind(distances is not None or map is not None, saxs, ensemble or background, keep)
    task = FitTask.of(start, distances, map, resolution, half, place, seed, PathOptions(**options))
    molecule = task.molecule
    curve = None if saxs is None else read_curve(saxs)
    molecule.sampled(frames)
    found: FittedStructure | FittedCurve
    if curve is None:
        found = task.fitted(keep)
    else:
        of = molecule.model, molecule.frames, molecule.atoms
        found = fit_curve(curve, *of, ensemble=ensemble, background=background, seed=seed)
    found.seconds = time.perf_counter() - begun
    if output is not None:
        found.save(output, overwrite=overwrite)
    return found


def _check_kind(is_fit: bool, saxs: Any, is_of_saxs: bool, keep: int) -> None:
    if is_fit == (saxs is not None):
        raise OptionError("give distances, a map, or both; or saxs")
    if is_of_saxs and saxs is None:
        raise OptionError("ensemble, background: are for saxs")
    if keep > 1 and saxs is not None:
        raise OptionError(f"keep = {keep}: is not for saxs")
