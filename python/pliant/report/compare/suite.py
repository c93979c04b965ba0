# SPDX-License-Identifier: MIT
"""The comparison of two ensembles: what is measured, and the report that holds it."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError
from pliant.base.checked import checked, whole
from pliant.base.extras import need
from pliant.base.progress import Stages
from pliant.measure import agreement
from pliant.measure.agreement import turned_as_one
from pliant.measure.bars import lengths
from pliant.measure.compared import numbers
from pliant.measure.compared.ensembles import (
    Ensembles,
    SingleFrameError,
    alpha_carbons,
    fit_atoms,
    read_ensembles,
    read_trace,
)
from pliant.measure.compared.pairing import choose, open_theirs, pair
from pliant.measure.compared.reference import read_reference
from pliant.measure.compared.residue_report import ResidueComparison
from pliant.measure.compared.residues import LEAST_RESIDUES, compare_residues
from pliant.measure.compared.trace_of_atoms import trace_of_atoms
from pliant.measure.rotatable import rotatable_torsions
from pliant.report.compare.comparison_report import (
    AtomComparison,
    BarLengths,
    ComparisonReport,
    Fluctuations,
    ModeComparison,
    TorsionComparison,
)
from pliant.report.compare.conclusions import conclude
from pliant.trajectory.frames import Frames
from pliant.trajectory.opened import one_file
from pliant.trajectory.universe import universe_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe

FRAMES = 2000
MODES = 10
BINS = 36  #: of torsion angles: 10 degrees each


@checked(frames=whole(2, name="all"))
def compare(
    ours: str | os.PathLike[str],
    theirs: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    topology: str | os.PathLike[str] | None = None,
    select: str = "all",
    frames: int | str = FRAMES,
    pictures: str | os.PathLike[str] | None = None,
) -> ComparisonReport:
    """Compares an ensemble of Pliant with others: NMR models, crystals, molecular dynamics.

    Residues are matched by sequence, chain by chain, and superposed by their alpha carbons (P of
    nucleotides) but for free ends. Compared are which residues move (r of RMSF, with its error),
    in what directions (RMSIP, overlaps of modes), and what one has and the other lacks. The
    ceiling is how well random halves of `theirs` agree.

    Where theirs are of the same atoms, those are compared too: fluctuations (RMSF), principal
    modes (RMSIP and overlaps), torsions (Jensen-Shannon distances), lengths of bars and radii of
    gyration. To tell differences from noise, the first half of `theirs` is compared with its second
    half.

    Parameters
    ----------
    ours : str or path
        H5MD file of ``pliant sample`` or ``pliant run``.
    theirs : str or path, or several
        PDB or mmCIF file with models; several such files, a set of crystal structures, say; or any
        trajectory that MDAnalysis reads.
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
        A file cannot be read, or neither residues nor atoms of both can be matched.
    """
    need("pliant.compare", "MDAnalysis")
    if pictures is not None:
        need("a picture of pliant.compare", "matplotlib")
    paths = [theirs] if isinstance(theirs, (str, os.PathLike)) else list(theirs)
    if not paths:
        raise InputError("theirs: expected at least one file")
    recording = one_file(ours)
    universe = universe_of(recording)
    asked = (paths, topology, select, frames)
    with Stages("compare", 2 + (pictures is not None)) as on_stage:
        on_stage("residues")
        residues = _residues(recording, universe, *asked)
        on_stage("atoms")
        atoms, notes = _atoms(recording, universe, *asked, residues is None)
        notes += _frames_left_out(recording)
        report = ComparisonReport(
            recording.name, [os.fspath(path) for path in paths], residues, atoms, notes
        )
        if pictures is not None:
            from pliant.report.compare.pictures import draw

            on_stage("pictures")
            report.pictures = draw(report, pathlib.Path(pictures))
    return report


def _frames_left_out(recording: Frames) -> list[str]:
    near, count = len(recording.around_start), len(recording)
    if near == count:
        return []
    return [
        f"ours: the {near} of {count} frames that are around the start, not those that go further"
    ]


def _residues(
    recording: Frames,
    universe: Universe,
    paths: Sequence[str | os.PathLike[str]],
    topology: str | os.PathLike[str] | None,
    select: str,
    frames: int | str,
) -> ResidueComparison | None:
    """None where ours has too few residues to match."""
    chosen = choose(universe, select, recording.name)
    trace = trace_of_atoms(chosen)
    if len(trace) < LEAST_RESIDUES:
        return None
    reference = read_reference(trace, paths, topology, select, frames, universe)
    positions, independent = read_trace(recording, chosen.ix[trace.atoms], frames)
    found = compare_residues(trace, positions, independent, reference)
    conclude(found)
    return found


def _atoms(
    recording: Frames,
    universe: Universe,
    paths: Sequence[str | os.PathLike[str]],
    topology: str | os.PathLike[str] | None,
    select: str,
    frames: int | str,
    is_all: bool,
) -> tuple[AtomComparison | None, list[str]]:
    """All atoms of both, and how they were matched; where residues were compared, nothing and why
    not."""
    try:
        if len(paths) > 1:
            raise InputError("several files are compared by residues, of which ours has too few")
        theirs, named = open_theirs(paths[0], topology, universe)
        pairing = pair(
            choose(universe, select, recording.name), choose(theirs, select, paths[0]), named
        )
        if len(pairing.ours) < 3:
            raise InputError(f"--select '{select}': expected at least 3 atoms")
        ensembles = read_ensembles(recording, pairing, frames, paths[0])
    except InputError as error:
        if is_all:
            raise
        is_plain = len(paths) > 1 or isinstance(error, SingleFrameError)
        return None, [] if is_plain else [f"atoms are not compared, residues only: {error}"]
    return _compare_atoms(ensembles), [f"atoms are matched {pairing.how}"]


def _compare_atoms(ensembles: Ensembles) -> AtomComparison:
    fit = fit_atoms(ensembles.atoms)
    ours = agreement.superposed_on_mean(ensembles.ours, fit)
    theirs = agreement.superposed_on_mean(ensembles.theirs, fit)
    # Turned as one body onto our average, so that directions of motion can be compared.
    theirs = turned_as_one(theirs, ours.mean(axis=0), fit)
    atoms, residues = _fluctuations(ensembles, ours, theirs)
    masses = ensembles.recording.masses[ensembles.atoms.ix]
    return AtomComparison(
        ensembles,
        atoms,
        residues,
        _compare_modes(ours[:, fit], theirs[:, fit]),
        _compare_torsions(ensembles),
        _compare_bars(ensembles),
        (
            numbers.gyration_radii(ensembles.ours, masses),
            numbers.gyration_radii(ensembles.theirs, masses),
        ),
    )


def _names(atoms: AtomGroup) -> list[str]:
    return [str(name) for name in getattr(atoms, "names", atoms.ix)]


def _atom_labels(atoms: AtomGroup) -> list[str]:
    if len(atoms.residues) < 2 or not hasattr(atoms, "resnames"):
        return _names(atoms)
    pairs = zip(_residue_labels(atoms), _names(atoms), strict=True)
    return [f"{residue}:{name}" for residue, name in pairs]


def _residue_labels(atoms: AtomGroup) -> list[str]:
    """The residue of each atom; the atom's name where residues have none."""
    if not hasattr(atoms, "resnames"):
        return _names(atoms)
    return [f"{name}{number}" for name, number in zip(atoms.resnames, atoms.resids, strict=True)]


def _fluctuations(
    ensembles: Ensembles, ours: np.ndarray, theirs: np.ndarray
) -> tuple[Fluctuations, Fluctuations | None]:
    labels = _atom_labels(ensembles.atoms)
    pair_of = agreement.fluctuations(ours), agreement.fluctuations(theirs)
    atoms = Fluctuations("atom", labels, *pair_of)
    alpha = alpha_carbons(ensembles.atoms)
    if len(alpha) < 3:
        return atoms, None
    names = _residue_labels(ensembles.atoms[alpha])
    return atoms, Fluctuations("residue", names, *(values[alpha] for values in pair_of))


def _compare_modes(ours: np.ndarray, theirs: np.ndarray) -> ModeComparison:
    mine, other = (agreement.principal_modes(x, MODES) for x in (ours, theirs))
    count = min(len(mine.vectors), len(other.vectors))
    return ModeComparison(
        ours.shape[1],
        agreement.overlaps(mine.vectors, other.vectors),
        agreement.rmsip(mine.vectors, other.vectors),
        agreement.chance_rmsip(count, ours.shape[1]),
        _halves(ours),
        _halves(theirs),
        mine.share,
        other.share,
    )


def _halves(fitted: np.ndarray) -> float:
    middle = len(fitted) // 2
    first, second = (
        agreement.principal_modes(x, MODES) for x in (fitted[:middle], fitted[middle:])
    )
    return agreement.rmsip(first.vectors, second.vectors)


def _compare_torsions(ensembles: Ensembles) -> list[TorsionComparison]:
    """phi and psi of a protein, else all rotatable bonds."""
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
    names, bars, rest = _atom_labels(ensembles.atoms), ensembles.bars, ensembles.rest_lengths
    spreads, residuals = [], []
    for positions in (ensembles.ours, ensembles.theirs):
        length = np.array([lengths(frame, bars) for frame in positions])
        spreads.append(length.std(axis=0))
        residuals.append(float(np.max(np.abs(length - rest) / rest, initial=0.0)))
    labels = [f"{names[a]} - {names[b]}" for a, b in bars.tolist()]
    return BarLengths(labels, *spreads, *residuals)
