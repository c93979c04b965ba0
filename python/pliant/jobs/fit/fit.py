# SPDX-License-Identifier: MIT
"""Fits a structure to measured distances, to a density map, or to both."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pliant._core import DensityMap, FileError, OptionError, PathOptions, PliantWarning
from pliant.base.checked import SEED, checked, whole
from pliant.jobs.fit import in_map
from pliant.jobs.fit import nodes as at_nodes
from pliant.jobs.fit.data import Datum, in_nanometres, read_distances
from pliant.jobs.fit.fitted import FittedStructure, agreement_of
from pliant.jobs.fit.molecule import FRAMES, Molecule
from pliant.jobs.fit.saxs.curve import read_curve
from pliant.jobs.fit.saxs.explained import FittedCurve, fit_curve
from pliant.trajectory.superposition import superpose_onto

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
        default), the reagent of a cross-link, DSS, BS3, DSSO (up to 30) or EDC (20), or MTSL,
        between spin labels.
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
    if map is None and (resolution is not None or half is not None or place):
        raise OptionError("resolution, half, place: of a map, and none is given")
    _check_kind(distances is not None or map is not None, saxs, ensemble or background, keep)
    density = None if map is None else in_map.read_map(map, resolution, half)
    molecule = Molecule(start, frames, seed, PathOptions(**options))
    found: FittedStructure | FittedCurve
    if saxs is not None:
        curve = read_curve(saxs)
        molecule.sampled()
        of = molecule.model, molecule.frames, molecule.atoms
        found = fit_curve(curve, *of, ensemble=ensemble, background=background, seed=seed)
    else:
        data = [] if distances is None else _distances(molecule, distances)
        molecule.sampled()
        if density is not None and place:
            molecule.place_into(density)
        found = _fitted(molecule, data, density, keep)
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


def _distances(molecule: Molecule, given: Any) -> list[Datum]:
    data = read_distances(given, molecule.sites)
    if in_nanometres(data, np.asarray(molecule.model.positions)[molecule.atoms]):
        warnings.warn("distances look as if they were in nm: Angstrom are asked for", PliantWarning,
                      stacklevel=4)  # fmt: skip
    return data


def _fitted(
    molecule: Molecule, data: list[Datum], density: in_map.MapData | None, keep: int
) -> FittedStructure:
    of, structure = molecule.ensemble, molecule.structure
    known = at_nodes.Known(data)
    if density is not None:
        known = at_nodes.Known(data, density.at_nodes(structure, of.frames))
    found = at_nodes.consistent(of, known)
    fits = found.fits
    wholes = [molecule.brought(fits, k) for k in range(min(keep, len(fits.frames)))]
    best, start = wholes[0].positions[molecule.atoms], of.start
    used = [data[k] for k in found.kept]
    missed = [found.left_out[k].off for k in found.kept if k in found.left_out]
    return FittedStructure(
        model=molecule.model,
        kept=wholes,
        data=agreement_of(data, start, best, found.contradicting, found.left_out),
        density=None
        if density is None
        else in_map.agreement_with(
            density,
            in_map.at(structure, molecule.placed),
            in_map.at(structure, wholes[0].positions),
            molecule.atoms,
            molecule.sites.labels,
            in_map.freedom_of(density, of, known.only(found.kept), structure, fits.frames[0]),
        ),
        labels=molecule.sites.labels,
        spread=fits.spread if density is None else density.spread(fits.spread),
        rmsd_from_start=_rms(superpose_onto(best[None], slice(None), start)[0] - start),
        agreeing=len(fits.agreeing),
        fits=len(fits.frames),
        off_at_start=_rms(at_nodes.violations(start, used)[:, None]),
        off_left_out=_rms(np.array(missed)[:, None]) if missed else None,
    )


def _rms(moves: np.ndarray) -> float:
    return float(np.sqrt((moves**2).sum(axis=1).mean())) if len(moves) else 0.0
