# SPDX-License-Identifier: MIT
"""Fits a structure to measured distances."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pliant._core import (
    FileError,
    InputError,
    MolecularModel,
    OptionError,
    PathEnds,
    PathOptions,
    PathWalk,
    PliantWarning,
    Structure,
    nodes_to_fit,
    sample,
)
from pliant.base.checked import SEED, checked, whole
from pliant.jobs.fit import nodes as at_nodes
from pliant.jobs.fit.data import Datum, Sites, in_nanometres, read_distances
from pliant.jobs.fit.fitted import ARRIVED, FittedStructure, Whole, agreement_of
from pliant.jobs.fit.saxs.curve import read_curve
from pliant.jobs.fit.saxs.explained import FittedCurve, fit_curve
from pliant.trajectory.superposition import superpose_onto

__all__ = ["FittedCurve", "FittedStructure", "fit"]

FRAMES = 400  #: of the ensemble that starts are taken from
LEAST_NODES = 10


class Molecule:
    """The molecule of a fit: its model, its nodes, and shapes in its reach."""

    def __init__(self, start: Any, frames: int, seed: int, options: PathOptions) -> None:
        self.options = options
        self.start: Structure = options.start_of(start)
        self.model: MolecularModel = PathEnds.model_of(self.start, options)
        self.atoms, self.chains = nodes_to_fit(self.model.structure)
        if len(self.atoms) < LEAST_NODES:
            raise InputError(
                f"{self.start.source}: expected a protein or nucleic acid of {LEAST_NODES} "
                f"residues or more, found {len(self.atoms)}"
            )
        self.sites = Sites(self.model.structure, self.atoms)
        self._frames, self._seed = frames, seed

    def sampled(self) -> None:
        """Makes the ensemble; the start is its first frame."""
        made = sample(self.model, self._frames, seed=self._seed, sampler="reach").positions
        self.frames = np.concatenate([np.asarray(self.model.positions)[None], np.asarray(made)])

    @property
    def ensemble(self) -> at_nodes.Ensemble:
        """At the nodes."""
        nodes = np.ascontiguousarray(self.frames[:, self.atoms], dtype=np.float64)
        return at_nodes.Ensemble(nodes[0], nodes, self.chains)

    def brought(self, fits: at_nodes.NodeFits, k: int) -> Whole:
        """All atoms, walked to the places of the residues of a fit, exactly: from its frame, which
        is near; from the start, too, where something is in the way."""
        found = self._walked(fits.positions[k], self.frames[fits.frames[k]])
        if found.short_of_fit <= ARRIVED:
            return found
        other = self._walked(fits.positions[k], self.frames[0])
        return min(found, other, key=lambda one: one.short_of_fit)

    def _walked(self, goal: np.ndarray, begun: np.ndarray) -> Whole:
        begun = np.asarray(begun, dtype=np.float64)
        ends = PathEnds.at(self.start, self.atoms, goal, self.options, begun)
        walk = PathWalk(ends, self.options)
        while walk.advance():
            pass
        last, positions = walk.table()[-1], np.asarray(walk.positions()[-1])
        return Whole(
            positions, walk.left, ends.only_start, last.max_residual, last.overlap, last.tightest
        )


@checked(frames=whole(50), keep=whole(1), seed=SEED)
def fit(
    start: Any,
    distances: str | os.PathLike[str] | Sequence[Mapping[str, Any]] | None = None,
    *,
    saxs: str | os.PathLike[str] | None = None,
    ensemble: bool = False,
    background: bool = False,
    frames: int = FRAMES,
    keep: int = 1,
    seed: int = 0,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    **options: Any,
) -> FittedStructure | FittedCurve:
    """Fits a structure to measured distances, or chooses shapes by a SAXS curve: all atoms, bonds
    and angles exact.

    Parameters
    ----------
    start : Structure, path, Universe, AtomGroup, ...
        A protein or nucleic acid, as ``sample`` takes it.
    distances : str, path or sequence of dicts
        CSV with a header, or the same fields: site1, site2 (residues: "A:45", "45" or a selection),
        and distance with error, or low and high, in Angstrom between alpha carbons; kind: CA (the
        default) or the reagent of a cross-link, DSS, BS3, DSSO (up to 30) or EDC (20).
    saxs : str or path
        In place of distances: a text of columns q (1/Angstrom), I and sigma. The result is a
        ``pliant.jobs.fit.saxs.explained.FittedCurve``: the frame that explains the curve.
    ensemble : bool
        Of `saxs`: the least number of frames that explain it, and their weights.
    background : bool
        Of `saxs`: a constant is fitted, too.
    frames : int
        Of the ensemble from which starts are taken.
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
    _check_kind(distances, saxs, ensemble or background, keep)
    molecule = Molecule(start, frames, seed, PathOptions(**options))
    found: FittedStructure | FittedCurve
    if saxs is not None:
        curve = read_curve(saxs)
        molecule.sampled()
        of = molecule.model, molecule.frames, molecule.atoms
        found = fit_curve(curve, *of, ensemble=ensemble, background=background, seed=seed)
    else:
        found = _fitted(molecule, _read(distances, molecule), keep)
    found.seconds = time.perf_counter() - begun
    if output is not None:
        found.save(output, overwrite=overwrite)
    return found


def _check_kind(distances: Any, saxs: Any, is_of_saxs: bool, keep: int) -> None:
    if (distances is None) == (saxs is None):
        raise OptionError("give one of distances, saxs")
    if is_of_saxs and saxs is None:
        raise OptionError("ensemble, background: are for saxs")
    if keep > 1 and saxs is not None:
        raise OptionError(f"keep = {keep}: is for distances")


def _read(distances: Any, molecule: Molecule) -> list[Datum]:
    data = read_distances(distances, molecule.sites)
    if in_nanometres(data, np.asarray(molecule.model.positions)[molecule.atoms]):
        warnings.warn("distances look as if they were in nm: Angstrom are asked for", PliantWarning,
                      stacklevel=3)  # fmt: skip
    molecule.sampled()
    return data


def _fitted(molecule: Molecule, data: list[Datum], keep: int) -> FittedStructure:
    ensemble = molecule.ensemble
    known = at_nodes.consistent(ensemble, data)
    fits = known.fits
    wholes = [molecule.brought(fits, k) for k in range(min(keep, len(fits.frames)))]
    best, start = wholes[0].positions[molecule.atoms], ensemble.start
    used = [data[k] for k in known.kept]
    missed = [known.left_out[k].off for k in known.kept if k in known.left_out]
    return FittedStructure(
        model=molecule.model,
        kept=wholes,
        data=agreement_of(data, start, best, known.contradicting, known.left_out),
        labels=molecule.sites.labels,
        spread=fits.spread,
        rmsd_from_start=_rms(superpose_onto(best[None], slice(None), start)[0] - start),
        agreeing=len(fits.agreeing),
        fits=len(fits.frames),
        off_at_start=_rms(at_nodes.violations(start, used)[:, None]),
        off_left_out=_rms(np.array(missed)[:, None]) if missed else None,
    )


def _rms(moves: np.ndarray) -> float:
    return float(np.sqrt((moves**2).sum(axis=1).mean()))
