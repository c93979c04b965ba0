# SPDX-License-Identifier: MIT
"""The coordinates that are compared: frames of both, the same atoms, in the same sequence."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError
from pliant.measure.bars import lengths
from pliant.measure.compared.pairing import Pairing
from pliant.measure.rotatable import is_hydrogen
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.frames import Frames
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.universe import source_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

MOST_BYTES = 2 << 30
TORN = 3.0  #: a bar longer than so many rest lengths was cut by the edge of a periodic box
FEW_ALPHA_CARBONS = 5  #: with fewer a molecule is fitted on all heavy atoms


class SingleFrameError(InputError):
    """A trajectory has one frame alone."""


@dataclass
class Ensembles:
    """Both trajectories as arrays, and what of ours is needed to interpret them."""

    recording: Frames
    pairing: Pairing
    ours: np.ndarray  #: (F, n, 3) Angstrom
    theirs: np.ndarray  #: (G, n, 3) Angstrom
    bars: np.ndarray  #: (B, 2) of ours, among the chosen atoms and numbered as they are
    rest_lengths: np.ndarray  #: (B,) Angstrom

    @property
    def atoms(self) -> AtomGroup:
        """The chosen atoms of ours."""
        return self.pairing.ours


def read_ensembles(
    recording: Frames, pairing: Pairing, frames: int | str, path: str | os.PathLike[str]
) -> Ensembles:
    """Reads at most `frames` frames of each, spread evenly.

    Raises InputError when they take too much memory, there are fewer than two, or theirs is cut by
    a periodic box.
    """
    bars, rest_lengths = _bars_among(recording, pairing.ours)
    ours = _read_ours(recording, pairing.ours, frames)
    theirs = _read_theirs(pairing.theirs, frames, path)
    for name, positions in ((recording.name, ours), (os.fspath(path), theirs)):
        if len(positions) < 2:
            kind = SingleFrameError if len(positions) == 1 else InputError
            raise kind(f"{name}: expected at least 2 frames, found {len(positions)}")
        if not np.isfinite(positions).all():
            raise InputError(f"{name}: has coordinates that are no numbers")
    _refuse_torn(theirs, bars, rest_lengths, pairing.theirs, path)
    return Ensembles(recording, pairing, ours, theirs, bars, rest_lengths)


def _bars_among(recording: Frames, atoms: AtomGroup) -> tuple[np.ndarray, np.ndarray]:
    place = np.full(recording.atom_count, -1)
    place[atoms.ix] = np.arange(len(atoms))
    bars = place[recording.bars]
    inside = (bars >= 0).all(axis=1)
    return bars[inside], recording.rest_lengths[inside]


def _chosen(count: int, frames: int | str, atoms: int, path: str | os.PathLike[str]) -> np.ndarray:
    chosen = choose_frames(count, frames)
    size = 24 * len(chosen) * atoms
    if size > MOST_BYTES:
        raise InputError(
            f"{os.fspath(path)}: {len(chosen)} frames of {atoms} atoms take {size / 2**30:.1f} GiB "
            "of memory: choose fewer with --frames or --select"
        )
    return chosen


def _chosen_of_ours(
    recording: Frames, atoms: AtomGroup | np.ndarray, frames: int | str
) -> np.ndarray:
    """Among those around the start: others show what else it could be, not how flexible it is."""
    near = recording.around_start
    chosen: np.ndarray = near[_chosen(len(near), frames, len(atoms), recording.name)]
    return chosen


def _read_ours(recording: Frames, atoms: AtomGroup, frames: int | str) -> np.ndarray:
    return _read(recording, _chosen_of_ours(recording, atoms, frames), atoms.ix)


def _read(source: Frames, chosen: np.ndarray, atoms: np.ndarray) -> np.ndarray:
    """(f, n, 3) in the precision in which they are stored, which MDAnalysis rounds."""
    pieces = np.array_split(chosen, max(1, len(chosen) // 100))
    return np.concatenate([source.read(piece)[:, atoms] for piece in pieces])


def read_trace(
    recording: Frames, atoms: np.ndarray, frames: int | str
) -> tuple[np.ndarray, np.ndarray | None]:
    """Frames (F, k, 3) of some of our atoms, and their numbers (F,) where they are independent.

    Frames of `pliant sample` are. Raises InputError where there are fewer than two frames.
    """
    chosen = _chosen_of_ours(recording, atoms, frames)
    if len(chosen) < 2:
        raise InputError(f"{recording.name}: expected at least 2 frames, found {len(chosen)}")
    positions = _read(recording, chosen, atoms)
    if recording.kind != ENSEMBLE:
        return positions, None
    return positions, np.array([recording.step(int(frame)) for frame in chosen])


def _read_theirs(atoms: AtomGroup, frames: int | str, path: str | os.PathLike[str]) -> np.ndarray:
    trajectory = atoms.universe.trajectory
    chosen = _chosen(len(trajectory), frames, len(atoms), path)
    source = source_of(trajectory)
    if source is not None:
        return _read(source, chosen, atoms.ix)
    found = [atoms.positions.astype(np.float64) for _ in trajectory[chosen.tolist()]]
    return np.array(found)


def _refuse_torn(
    theirs: np.ndarray,
    bars: np.ndarray,
    rest_lengths: np.ndarray,
    atoms: AtomGroup,
    path: str | os.PathLike[str],
) -> None:
    if len(bars) == 0:
        return
    stretch = np.array([lengths(frame, bars) / rest_lengths for frame in theirs])
    frame, bar = np.unravel_index(np.argmax(stretch), stretch.shape)
    if stretch[frame, bar] > TORN:
        a, b = (atoms[int(k)] for k in bars[bar])
        length = stretch[frame, bar] * rest_lengths[bar]
        raise InputError(
            f"{os.fspath(path)}: {getattr(a, 'name', a.index)} - {getattr(b, 'name', b.index)} is "
            f"{length:.1f} A long in frame {frame + 1} of those read: the edge of the "
            "periodic box cuts the molecule; make it whole (unwrap it) first"
        )


def fit_atoms(atoms: AtomGroup) -> np.ndarray:
    """Atoms by which frames are superposed: alpha carbons, else heavy atoms, else all.

    Of these the modes are those compared, too.
    """
    alpha = alpha_carbons(atoms)
    if len(alpha) >= FEW_ALPHA_CARBONS:
        return alpha
    heavy = np.flatnonzero(~is_hydrogen(atoms))
    return heavy if len(heavy) >= 3 else np.arange(len(atoms))


def alpha_carbons(atoms: AtomGroup) -> np.ndarray:
    """Places of the alpha carbons among the atoms: CA of residues that have N and C too."""
    if not hasattr(atoms, "names"):
        return np.empty(0, int)
    names, residues = atoms.names.astype(str), atoms.resindices
    complete = set(residues[names == "N"]) & set(residues[names == "C"])
    return np.flatnonzero((names == "CA") & np.isin(residues, list(complete)))
