# SPDX-License-Identifier: MIT
"""Where frames are: in memory, or in a file from which each is read when it is asked for."""

from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import InputError, Structure
from pliant.base.extras import needed_by
from pliant.base.input_files import expect_file
from pliant.trajectory.sources import H5MD, kind_of, later, structure_of

Positions = npt.NDArray[np.float64]


class Frames(Protocol):
    """The frames of one molecule."""

    @property
    def structure(self) -> Structure:
        """Atoms and bonds, at the first frame."""

    def __len__(self) -> int: ...

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""

    def step(self, frame: int) -> int:
        """Number of the step or frame where it was made."""

    def time(self, frame: int) -> float:
        """In ps; the number of the frame where no time is known."""


class FramesInMemory:
    """(F, N, 3) Angstrom."""

    def __init__(self, structure: Structure, positions: npt.ArrayLike) -> None:
        values = np.asarray(positions, dtype=np.float64)
        values = values[None] if values.ndim == 2 else values
        if values.ndim != 3 or values.shape[2] != 3:
            raise InputError(
                f"positions: expected shape (N, 3) or (F, N, 3), found {np.shape(positions)}"
            )
        check_atoms(structure, values.shape[1])
        self.structure = structure
        self.values: Positions = values

    def __len__(self) -> int:
        return len(self.values)

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom: a view."""
        found: Positions = self.values[frame]
        return found

    def step(self, frame: int) -> int:
        """The number of the frame."""
        return frame

    def time(self, frame: int) -> float:
        """The number of the frame."""
        return float(frame)


class FramesOfH5md:
    """Those of an H5MD file, or of the shards of an ensemble."""

    def __init__(self, path: str | os.PathLike[str], reader: Any = None) -> None:
        self.path = Path(path)
        self._reader: Any = _core.H5mdReader(path) if reader is None else reader
        if len(self._reader) == 0:
            raise InputError(f"{os.fspath(path)}: holds no frame")

    @cached_property
    def structure(self) -> Structure:
        """The atoms that were recorded; nameless ones of files that have no names."""
        return structure_recorded(self._reader)

    def __len__(self) -> int:
        return len(self._reader)

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        return np.asarray(self._reader.positions(frame))

    def step(self, frame: int) -> int:
        """The step that was recorded."""
        return int(self._reader.step(frame))

    def time(self, frame: int) -> float:
        """In ps; the number of the frame where the file has none."""
        return time_recorded(self._reader, frame)

    def walker(self, frame: int) -> int | None:
        """Of a frame of an ensemble; None where there are no walkers."""
        known = getattr(self._reader, "walker", None)
        return known(frame) if known else None


class FramesOfModels:
    """The models of a structure file, or its one structure."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self.structure = _core.read(path)

    def __len__(self) -> int:
        return self.structure.model_count

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        if frame == 0:
            return np.array(self.structure.positions)
        read = _core.read(self.path, frame + 1, perceive_bonds=False)
        check_atoms(self.structure, len(read), f"model {frame + 1} of {self.path}")
        return np.array(read.positions)

    def step(self, frame: int) -> int:
        """The number of the frame."""
        return frame

    def time(self, frame: int) -> float:
        """The number of the frame."""
        return float(frame)


class FramesOfUniverse:
    """Those of a Universe or AtomGroup of MDAnalysis, whose current frame stays what it was."""

    def __init__(self, atoms: Any) -> None:
        self._atoms = atoms.atoms
        self.structure: Structure = later("pliant.adapters", "from_mdanalysis")(self._atoms)

    def __len__(self) -> int:
        return len(self._atoms.universe.trajectory)

    def _at(self, frame: int) -> Any:
        trajectory = self._atoms.universe.trajectory
        before = trajectory.frame
        shown = trajectory[frame]
        positions = self._atoms.positions.astype(np.float64)[self.structure.source_order]
        found = positions, shown.frame, float(shown.time)
        trajectory[before]
        return found

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        found: Positions = self._at(frame)[0]
        return found

    def step(self, frame: int) -> int:
        """The number of the frame."""
        return int(self._at(frame)[1])

    def time(self, frame: int) -> float:
        """In ps."""
        return float(self._at(frame)[2])


def structure_recorded(reader: Any) -> Structure:
    """The atoms of a reader; nameless ones of files that have no names."""
    try:
        structure: Structure = reader.structure(0)
    except InputError as error:
        if "no atom table" not in str(error):
            raise
        return Structure(reader.positions(0))
    return structure


def time_recorded(reader: Any, frame: int) -> float:
    """In ps; the number of the frame where the file has no time."""
    try:
        return float(reader.time(frame))
    except InputError:
        return float(frame)


def check_atoms(structure: Structure, found: int, what: str = "positions") -> None:
    """Raises InputError where a structure is not the one that frames are of."""
    count = len(structure)
    if found == count:
        return
    raise InputError(
        f"{what}: {found} atoms, but {structure.source or 'the structure'} has {count}: frames are "
        "of the prepared molecule, with hydrogens added and waters left out: "
        'ensemble.to_mdanalysis(), or the file "x-topology.pdb" beside them'
    )


def frames_of(source: Any, topology: Any = None) -> Frames:
    """The frames of anything that has some; a path is opened, and read frame by frame.

    `topology`: a Structure, or what `structure_of` takes, of a file without atoms.
    """
    if isinstance(source, (str, os.PathLike)):
        return _of_path(Path(source), topology)
    if hasattr(source, "universe") and hasattr(source, "atoms"):
        return FramesOfUniverse(source)
    kind = kind_of(source)
    structure = kind.structure(source)
    return FramesInMemory(structure, kind.frames(source, structure))


def _of_path(path: Path, topology: Any) -> Frames:
    from pliant.trajectory.shards.plan import is_ensemble

    if is_ensemble(path):
        from pliant.trajectory.shards.shards_reader import ShardsReader

        return FramesOfH5md(path, ShardsReader(path))
    if path.suffix.lower() in H5MD:
        frames = FramesOfH5md(path)
        if topology is not None:
            check_atoms(structure_of(topology), len(frames.structure), str(path))
        return frames
    if topology is None:
        return FramesOfModels(path)
    with needed_by("pliant.Trajectory"):
        import MDAnalysis
    for file in (topology, path):
        expect_file(file)
    return FramesOfUniverse(MDAnalysis.Universe(os.fspath(topology), str(path)))
