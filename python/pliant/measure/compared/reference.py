# SPDX-License-Identifier: MIT
"""Reading what ours is compared with: models of a file, several structures, or a trajectory."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant import _core
from pliant._core import InputError, PliantWarning, Trace, match_residues, trace_of
from pliant.measure.compared.pairing import choose, open_theirs
from pliant.measure.compared.trace_of_atoms import trace_of_atoms
from pliant.measure.joined_chains import joined_along
from pliant.trajectory.chosen_frames import choose_frames

if TYPE_CHECKING:
    from MDAnalysis import Universe

#: kinds of reference
TRAJECTORY, MODELS, STRUCTURES, STRUCTURE = "trajectory", "models", "structures", "structure"
#: what the library itself reads, model by model
EXTENSIONS = (".pdb", ".ent", ".cif", ".mmcif", ".pdb1")
PACKED = (".gz", ".bz2", ".xz")
TORN = 8.0  #: Angstrom; neighbours in a chain that are further apart were cut by a periodic box


@dataclass(frozen=True)
class ReferenceFrames:
    """Their frames, on residues of ours that all of them have."""

    kind: str  #: TRAJECTORY, MODELS, STRUCTURES or STRUCTURE
    residues: np.ndarray  #: (K,) of ours, rising
    frames: np.ndarray  #: (G, K, 3) Angstrom
    notes: list[str]


def is_structure_file(path: str | os.PathLike[str]) -> bool:
    """Whether the name is that of a PDB or mmCIF file, packed or not."""
    name = Path(path)
    suffix = Path(name.stem).suffix if name.suffix.lower() in PACKED else name.suffix
    return suffix.lower() in EXTENSIONS


def read_reference(
    ours: Trace,
    paths: Sequence[str | os.PathLike[str]],
    topology: str | os.PathLike[str] | None,
    select: str,
    frames: int | str,
    universe: Universe,
) -> ReferenceFrames:
    """Reads theirs; `universe` is ours, whose names a trajectory without names gets.

    Raises InputError where a file cannot be read, or holds another molecule.
    """
    if len(paths) == 1 and (topology is not None or not is_structure_file(paths[0])):
        return _trajectory(ours, paths[0], topology, select, frames, universe)
    for path in paths:
        if not is_structure_file(path):
            raise InputError(
                f"{os.fspath(path)}: several files are compared as a set of structures (PDB, "
                "mmCIF); expected one trajectory alone"
            )
    read = [_models(ours, path, select, frames) for path in paths]
    shared = read[0].residues
    for one in read[1:]:
        shared = np.intersect1d(shared, one.residues)
    found = [one.frames[:, np.isin(one.residues, shared)] for one in read]
    notes = [note for one in read for note in one.notes]
    if len(shared) < 3:
        raise InputError("fewer than 3 residues of ours are in all files")
    together = np.concatenate(found)
    kind = MODELS if len(paths) == 1 else STRUCTURES
    return ReferenceFrames(STRUCTURE if len(together) == 1 else kind, shared, together, notes)


def _models(
    ours: Trace, path: str | os.PathLike[str], select: str, frames: int | str
) -> ReferenceFrames:
    """All models of a file, on the residues that every one of them has."""
    name = os.fspath(path)
    first = _read(path, 1)
    chosen = choose_frames(first.model_count, frames)
    found = []
    notes: list[str] = []
    for model in chosen:
        structure = first if model == 0 else _read(path, int(model) + 1)
        part = structure if select == "all" else structure.select(select)
        trace = trace_of(part)
        matched = match_residues(ours, trace, name)
        notes = notes or matched.notes
        atoms = trace.atoms[matched.theirs]
        found.append((matched.ours, np.asarray(part.positions)[atoms]))
    shared = found[0][0]
    for residues, _ in found[1:]:
        shared = np.intersect1d(shared, residues)
    positions = np.array([place[np.isin(residues, shared)] for residues, place in found])
    return ReferenceFrames(MODELS, shared, positions, list(notes))


def _read(path: str | os.PathLike[str], model: int) -> _core.Structure:
    """A model, without warnings of its columns, alternates and links."""
    if not os.path.exists(path):
        raise InputError(f"{os.fspath(path)}: no such file")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PliantWarning)
        return _core.read(path, model, perceive_bonds=False)


def _trajectory(
    ours: Trace,
    path: str | os.PathLike[str],
    topology: str | os.PathLike[str] | None,
    select: str,
    frames: int | str,
    universe: Universe,
) -> ReferenceFrames:
    theirs, _ = open_theirs(path, topology, universe)
    atoms = choose(theirs, select, path)
    trace = trace_of_atoms(atoms)
    matched = match_residues(ours, trace, os.fspath(path))
    used = atoms[trace.atoms[matched.theirs]]
    steps = choose_frames(len(theirs.trajectory), frames).tolist()
    positions = np.array(
        [joined_along(used.positions, step.dimensions) for step in theirs.trajectory[steps]]
    )
    _refuse_torn(positions, ours, matched.ours, os.fspath(path))
    kind = STRUCTURE if len(positions) == 1 else TRAJECTORY
    return ReferenceFrames(kind, matched.ours, positions, list(matched.notes))


def _refuse_torn(positions: np.ndarray, ours: Trace, residues: np.ndarray, source: str) -> None:
    """Neighbours in a chain of amino acids stay neighbours."""
    if not np.isfinite(positions).all():
        raise InputError(f"{source}: has coordinates that are no numbers")
    next_to = (np.diff(ours.numbers[residues]) == 1) & (np.diff(residues) == 1)
    next_to &= ours.chains[residues[1:]] == ours.chains[residues[:-1]]
    apart = np.linalg.norm(np.diff(positions, axis=1), axis=2) * next_to
    if apart.size and apart.max() > TORN:
        frame, place = np.unravel_index(np.argmax(apart), apart.shape)
        raise InputError(
            f"{source}: {ours.label(residues[place])} and its neighbour are "
            f"{apart[frame, place]:.1f} A apart in frame {frame + 1} of those read: the edge of "
            "the periodic box cuts the molecule; make it whole (unwrap it) first"
        )
