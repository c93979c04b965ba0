# SPDX-License-Identifier: MIT
"""The one place where frames are opened, whatever they are in."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from pliant._core import InputError, Structure
from pliant.base.extras import late, needed_by
from pliant.base.input_files import expect_file
from pliant.trajectory.frames import (
    Frames,
    FramesInMemory,
    FramesOfModels,
    Moment,
    Positions,
    check_atoms,
)
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.shards.plan import SHARDS, folder_of, is_ensemble
from pliant.trajectory.sources import H5MD, kind_of, structure_of

ensemble, universe = late("pliant.trajectory.shards.ensemble"), late("pliant.trajectory.universe")


class FramesOfUniverse(Frames):
    """Those of a Universe or AtomGroup of MDAnalysis, whose positions are 32-bit floats.

    structure: has its atoms in an order of its own; None: nobody asks for it, and the universe is
    ours, so that it may stay at the frame that was read last.
    """

    is_single = True

    def __init__(self, atoms: Any, structure: Structure | None = None) -> None:
        self.universe, self._atoms, self._structure = atoms.universe, atoms.atoms, structure
        self._order = slice(None) if structure is None else structure.source_order

    @property
    def structure(self) -> Structure:
        """Atoms and bonds."""
        assert self._structure is not None
        return self._structure

    @property
    def atom_count(self) -> int:
        """Those of the group."""
        return len(self._atoms)

    def __len__(self) -> int:
        return len(self.universe.trajectory)

    @property
    def has_steps(self) -> bool:
        """Of XTC and TRR, say."""
        return "step" in self.universe.trajectory.ts.data

    def moment(self, frame: int) -> Moment:
        """All of a frame."""
        trajectory = self.universe.trajectory
        before = trajectory.frame
        shown = trajectory[frame]
        positions = self._atoms.positions.astype(np.float64)[self._order]
        step = int(shown.data.get("step", shown.frame))
        box = None if shown.dimensions is None else np.array(shown.dimensions)
        found = Moment(positions, step, float(shown.time), None, box)
        if self._structure is not None:
            trajectory[before]
        return found

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        return self.moment(frame).positions

    def step(self, frame: int) -> int:
        """The step, where the format has any, or the number of the frame."""
        return self.moment(frame).step

    def time(self, frame: int) -> float:
        """In ps."""
        return self.moment(frame).time


def frames_of(source: Any, topology: Any = None) -> Frames:
    """The frames of anything that has some; a path is opened, and read frame by frame.

    `topology`: a Structure, or what `structure_of` takes, of a file without atoms.
    """
    if isinstance(source, (str, os.PathLike)):
        return _of_path(Path(source), topology)
    structure = structure_of(source)
    if hasattr(source, "universe") and hasattr(source, "atoms"):
        return FramesOfUniverse(source, structure)
    return FramesInMemory(structure, kind_of(source).frames(source, structure))


def _of_path(path: Path, topology: Any) -> Frames:
    if is_recorded(path):
        frames = recorded(path)
        if topology is not None:
            check_atoms(structure_of(topology), frames.atom_count, str(path))
        return frames
    if topology is None:
        return FramesOfModels(path)
    with needed_by("pliant.Trajectory"):
        atoms = universe.open_universe(path, topology)
    return FramesOfUniverse(atoms, structure_of(atoms))


def is_recorded(path: str | os.PathLike[str]) -> bool:
    """Whether a path is that of an H5MD file or an ensemble, by its name."""
    return is_ensemble(path) or Path(path).suffix.lower() in H5MD


def recorded(path: str | os.PathLike[str]) -> Frames:
    """The frames of an H5MD file or an ensemble."""
    if is_ensemble(path):
        shards: Frames = ensemble.EnsembleFrames(folder_of(path))
        return shards
    return one_file(path)


def one_file(path: str | os.PathLike[str]) -> FramesOfH5md:
    """The frames of an H5MD file. Raises InputError that says what to give for an ensemble."""
    if is_ensemble(path):
        shards = folder_of(Path(path)) / SHARDS
        raise InputError(
            f"{os.fspath(path)}: is an ensemble: give one of its shards ({shards}/...), or open it "
            "with MDAnalysis"
        )
    expect_trajectory(Path(path))
    frames = FramesOfH5md(Path(path))
    if len(frames) == 0:
        raise InputError(f"{path}: holds no frame")
    return frames


def expect_trajectory(path: Path) -> None:
    """Raises InputError or FileError, in one line, for what is no file with something in it."""
    if not path.exists():
        raise InputError(f"{path}: no such file")
    if path.is_dir():
        raise InputError(f"{path}: is a folder, expected a trajectory file")
    expect_file(path)
    if path.stat().st_size == 0:
        raise InputError(f"{path}: is empty")
