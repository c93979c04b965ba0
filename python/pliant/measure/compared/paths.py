# SPDX-License-Identifier: MIT
"""Two paths, frame by frame: how near each comes to the other (path similarity analysis).

Of D, the RMSD of each frame of ours from each of theirs, superposed pair by pair (Seyler, Kumar,
Thorpe, Beckstein, PLoS Comput. Biol. 11 (2015) e1004568):

- mean nearest: the mean over the frames of one path of the distance to the other's nearest frame;
- Hausdorff: the largest of these, of either path;
- discrete Frechet: the least largest distance when both are walked from begin to end, neither
  backwards (Eiter, Mannila, TR CD-TR 94/64, 1994).
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field

import numpy as np

from pliant._core import InputError
from pliant.base.checked import checked, whole
from pliant.base.extras import need
from pliant.measure.compared.ensembles import read_trace
from pliant.measure.compared.pairing import choose
from pliant.measure.compared.reference import read_reference
from pliant.measure.compared.residues import LEAST_RESIDUES
from pliant.measure.compared.trace_of_atoms import trace_of_atoms
from pliant.trajectory.opened import one_file
from pliant.trajectory.superposition import rmsd_to, superpose_onto
from pliant.trajectory.universe import universe_of

FRAMES = 500


@dataclass(frozen=True)
class PathDistances:
    """How far two paths are apart, Angstrom."""

    nearest_theirs: float  #: mean over frames of the first path
    nearest_ours: float  #: mean over frames of the second
    hausdorff: float
    frechet: float


@dataclass(frozen=True)
class PathComparison:
    """A path of ours and one of theirs, by one atom of each residue that both have."""

    path: str
    theirs: list[str]
    residues: int
    frames: tuple[int, int]  #: compared, of ours and theirs
    ends: tuple[float, float]  #: RMSD of the first and of the last frames of both, Angstrom
    ours: PathDistances  #: of ours and theirs
    line: PathDistances  #: of the straight line between ends of theirs, as many frames, and theirs
    rmsd: np.ndarray = field(repr=False)  #: (F, G) Angstrom, of frames of ours and theirs
    notes: list[str] = field(default_factory=list)


@checked(frames=whole(2, name="all"))
def compare_paths(
    ours: str | os.PathLike[str],
    theirs: str | os.PathLike[str],
    *,
    topology: str | os.PathLike[str] | None = None,
    select: str = "all",
    frames: int | str = FRAMES,
) -> PathComparison:
    """Compares a path with another: which of their frames it comes near, in their order.

    Residues are matched by sequence, and superposed by alpha carbons (P of nucleotides), pair by
    pair. The straight line between the ends of theirs, superposed, is measured beside ours: what is
    no nearer than that tells nothing of the way.

    Parameters
    ----------
    ours : str or path
        H5MD file of ``pliant path`` or ``pliant run``.
    theirs : str or path
        A trajectory, or a PDB or mmCIF file with models in the order of the path.
    topology : str or path, optional
        File with the atom names of `theirs`.
    select : str
        MDAnalysis selection of the atoms to compare, for both.
    frames : int or "all"
        At most so many frames of each, spread evenly.

    Raises
    ------
    ImportError
        MDAnalysis is missing.
    InputError
        A file cannot be read, has fewer than two frames, or no residues that match.
    """
    need("pliant.compare", "MDAnalysis")
    recording = one_file(ours)
    universe = universe_of(recording)
    chosen = choose(universe, select, ours)
    trace = trace_of_atoms(chosen)
    if len(trace) < LEAST_RESIDUES:
        raise InputError(f"{os.fspath(ours)}: expected {LEAST_RESIDUES} residues or more")
    reference = read_reference(trace, [theirs], topology, select, frames, universe)
    if len(reference.frames) < 2:
        raise InputError(f"{os.fspath(theirs)}: expected at least 2 frames, found 1")
    positions, _ = read_trace(recording, chosen.ix[trace.atoms], frames)
    mine = np.asarray(positions[:, reference.residues], dtype=np.float64)
    other = np.asarray(reference.frames, dtype=np.float64)
    table = rmsd_to(mine, other)
    line = rmsd_to(straight_line(other[0], other[-1], len(mine)), other)
    return PathComparison(
        os.fspath(ours),
        [os.fspath(theirs)],
        mine.shape[1],
        table.shape,
        (float(table[0, 0]), float(table[-1, -1])),
        distances_of(table),
        distances_of(line),
        table,
        list(reference.notes),
    )


def distances_of(table: np.ndarray) -> PathDistances:
    """How far two paths are apart, by the RMSDs (F, G) of their frames."""
    nearest = table.min(axis=1), table.min(axis=0)
    return PathDistances(
        float(nearest[0].mean()),
        float(nearest[1].mean()),
        float(max(nearest[0].max(), nearest[1].max())),
        frechet(table),
    )


def frechet(table: np.ndarray) -> float:
    """Discrete Frechet distance of two paths whose frames are table (F, G) apart."""
    reach = np.maximum.accumulate(table[0])
    for row in table[1:]:
        before, reach = reach, np.empty_like(reach)
        reach[0] = max(before[0], row[0])
        easiest = np.minimum(before[1:], before[:-1])
        for k, distance in enumerate(row[1:], start=1):
            reach[k] = max(min(easiest[k - 1], reach[k - 1]), distance)
    return float(reach[-1])


def straight_line(first: np.ndarray, last: np.ndarray, frames: int) -> np.ndarray:
    """(frames, n, 3) from one structure (n, 3) to the other, superposed on it."""
    end = superpose_onto(last[None], slice(None), first)[0]
    line: np.ndarray = first + np.linspace(0.0, 1.0, frames)[:, None, None] * (end - first)
    return line
