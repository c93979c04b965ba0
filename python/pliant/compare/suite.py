# SPDX-License-Identifier: MIT
"""The comparison of two trajectories: what is measured, and the report that holds it."""

from __future__ import annotations

import os
import pathlib

import numpy as np

from pliant._core import InputError
from pliant._extras import need
from pliant.check.recording import read_recording
from pliant.compare import numbers
from pliant.compare.comparison_report import (
    BarLengths,
    ComparisonReport,
    Fluctuations,
    ModeComparison,
    TorsionComparison,
)
from pliant.compare.ensembles import Ensembles, alpha_carbons, fit_atoms, read_ensembles
from pliant.compare.pairing import choose, open_theirs, open_universe, pair
from pliant.lab.peers.measure import lengths

FRAMES = 2000
MODES = 10
BINS = 36  #: of torsion angles: 10 degrees each


def compare(
    ours: str | os.PathLike[str],
    theirs: str | os.PathLike[str],
    *,
    topology: str | os.PathLike[str] | None = None,
    select: str = "all",
    frames: int | str = FRAMES,
    pictures: str | os.PathLike[str] | None = None,
) -> ComparisonReport:
    """Compares a trajectory of Pliant with one of molecular dynamics, or any other.

    Frames of each are superposed on their average. Then fluctuations (RMSF), principal modes (RMSIP
    and overlaps), torsions (Jensen-Shannon distances), lengths of bars and radii of gyration are
    compared. To tell differences from noise, the first half of `theirs` is compared with its
    second half.

    Parameters
    ----------
    ours : str or path
        H5MD file of ``pliant run``.
    theirs : str or path
        Any trajectory that MDAnalysis reads.
    topology : str or path, optional
        File with the atom names of `theirs`. Without it, formats without names (DCD, XTC) are
        assumed to have the atoms of `ours` in the same order.
    select : str
        MDAnalysis selection of the atoms to compare, for both.
    frames : int or "all"
        At most so many frames of each, spread evenly.
    pictures : str or path, optional
        Folder for the PNG files.

    Raises
    ------
    ImportError
        MDAnalysis, or matplotlib for pictures, is missing; the message says how to install it.
    InputError
        A file cannot be read, or the chosen atoms of both are not the same.
    """
    need("pliant.compare", "MDAnalysis")
    if pictures is not None:
        need("a picture of pliant.compare", "matplotlib")
    recording = read_recording(ours)
    our_universe = open_universe(ours)
    their_universe, named = open_theirs(theirs, topology, our_universe)
    pairing = pair(
        choose(our_universe, select, ours), choose(their_universe, select, theirs), named
    )
    if len(pairing.ours) < 3:
        raise InputError(f"--select '{select}': expected at least 3 atoms")
    report = _compare(read_ensembles(recording, pairing, frames, theirs), os.fspath(theirs))
    if pictures is not None:
        from pliant.compare.picture import draw

        report.pictures = draw(report, pathlib.Path(pictures))
    return report


def _compare(ensembles: Ensembles, theirs_path: str) -> ComparisonReport:
    fit = fit_atoms(ensembles.atoms)
    ours = numbers.superposed_on_mean(ensembles.ours, fit)
    theirs = numbers.superposed_on_mean(ensembles.theirs, fit)
    # Turned as one body onto our average, so that directions of motion can be compared.
    theirs = _turned(theirs, ours.mean(axis=0), fit)
    atoms, residues = _fluctuations(ensembles, ours, theirs)
    masses = ensembles.recording.masses[ensembles.atoms.ix]
    return ComparisonReport(
        ensembles,
        theirs_path,
        atoms,
        residues,
        _compare_modes(ours[:, fit], theirs[:, fit]),
        _compare_torsions(ensembles),
        _compare_bars(ensembles),
        (
            numbers.gyration_radii(ensembles.ours, masses),
            numbers.gyration_radii(ensembles.theirs, masses),
        ),
        [f"atoms are matched {ensembles.pairing.how}"],
    )


def _turned(positions: np.ndarray, reference: np.ndarray, fit: np.ndarray) -> np.ndarray:
    mean = positions.mean(axis=0)
    corners = np.concatenate([np.zeros((1, 3)), np.eye(3)])
    # Where the average goes, its axes go: they are carried along as four more points.
    carried = np.concatenate([mean, mean[fit].mean(axis=0) + corners])[None]
    moved = numbers.superposed(carried, reference, fit)[0, len(mean) :]
    rotation = moved[1:] - moved[0]
    turned: np.ndarray = (positions - mean[fit].mean(axis=0)) @ rotation
    return turned


def _labels(ensembles: Ensembles) -> list[str]:
    atoms = ensembles.atoms
    names = [str(name) for name in getattr(atoms, "names", atoms.ix)]
    if len(atoms.residues) < 2 or not hasattr(atoms, "resnames"):
        return names
    residues = zip(atoms.resnames, atoms.resids, names, strict=True)
    return [f"{resname}{resid}:{name}" for resname, resid, name in residues]


def _fluctuations(
    ensembles: Ensembles, ours: np.ndarray, theirs: np.ndarray
) -> tuple[Fluctuations, Fluctuations | None]:
    labels = _labels(ensembles)
    pair_of = numbers.fluctuations(ours), numbers.fluctuations(theirs)
    atoms = Fluctuations("atom", labels, *pair_of)
    alpha = alpha_carbons(ensembles.atoms)
    if len(alpha) < 3:
        return atoms, None
    names = [labels[k].split(":")[0] for k in alpha]
    return atoms, Fluctuations("residue", names, *(values[alpha] for values in pair_of))


def _compare_modes(ours: np.ndarray, theirs: np.ndarray) -> ModeComparison:
    mine, other = (numbers.principal_modes(x, MODES) for x in (ours, theirs))
    count = min(len(mine.vectors), len(other.vectors))
    return ModeComparison(
        ours.shape[1],
        numbers.overlaps(mine, other),
        numbers.rmsip(mine, other),
        numbers.chance_rmsip(count, ours.shape[1]),
        _halves(ours),
        _halves(theirs),
        mine.share,
        other.share,
    )


def _halves(fitted: np.ndarray) -> float:
    middle = len(fitted) // 2
    first, second = (numbers.principal_modes(x, MODES) for x in (fitted[:middle], fitted[middle:]))
    return numbers.rmsip(first, second)


def _compare_torsions(ensembles: Ensembles) -> list[TorsionComparison]:
    """phi and psi of a protein, else all rotatable bonds."""
    from pliant.analysis.rotatable import rotatable_torsions

    atoms = ensembles.atoms
    if not hasattr(atoms, "bonds"):
        return []
    torsions = rotatable_torsions(atoms)
    backbone = [torsion for torsion in torsions if torsion.kind in ("phi", "psi")]
    chosen = backbone or torsions
    if not chosen:
        return []
    place = {int(index): k for k, index in enumerate(atoms.ix)}
    quadruples = np.array([[place[atom] for atom in torsion.atoms] for torsion in chosen])
    ours, theirs = (numbers.dihedrals(x, quadruples) for x in (ensembles.ours, ensembles.theirs))
    middle = len(theirs) // 2
    mine, other, first, second = (
        numbers.shares(x, BINS) for x in (ours, theirs, theirs[:middle], theirs[middle:])
    )
    distances = numbers.jensen_shannon(mine, other), numbers.jensen_shannon(first, second)
    rows = zip(chosen, mine, other, *distances, strict=True)
    return [TorsionComparison(t.label, p, q, float(d), float(h)) for t, p, q, d, h in rows]


def _compare_bars(ensembles: Ensembles) -> BarLengths:
    names, bars, rest = _labels(ensembles), ensembles.bars, ensembles.rest_lengths
    spreads, residuals = [], []
    for positions in (ensembles.ours, ensembles.theirs):
        length = np.array([lengths(frame, bars) for frame in positions])
        spreads.append(length.std(axis=0))
        residuals.append(float(np.max(np.abs(length - rest) / rest, initial=0.0)))
    labels = [f"{names[a]} - {names[b]}" for a, b in bars.tolist()]
    return BarLengths(labels, *spreads, *residuals)
