# SPDX-License-Identifier: MIT
"""The frames of one molecule, wherever they are, and what is known of how they were made."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import InputError, Structure
from pliant.trajectory.drawn_by import around_start
from pliant.trajectory.kind import kind_of_frames

if TYPE_CHECKING:
    from pliant.trajectory.recorded_contacts import RecordedContacts

Positions = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Moment:
    """A frame, and when it was."""

    positions: Positions  #: (N, 3) Angstrom
    step: int
    time: float  #: ps
    walker: int | None = None  #: of an ensemble
    box: npt.NDArray[np.float32] | None = None


@dataclass(frozen=True)
class Tolerance:
    """When a bar is whole."""

    relative: float = 1e-6  #: largest |length - rest| / rest; used if `length` is 0
    length: float = 0.0  #: largest |length - rest|, Angstrom

    def of(self, rest_lengths: np.ndarray) -> np.ndarray:
        """Largest |length - rest| / rest accepted of each bar."""
        if self.length > 0:
            return self.length / rest_lengths
        return np.full(len(rest_lengths), self.relative)


class Frames:
    """F frames of N atoms. What files of ours alone tell is empty of all others."""

    path: Path | None = None  #: of the file or folder
    is_single = False  #: positions are known as 32-bit floats
    rounded_to = 0.0  #: coordinates are multiples of this, Angstrom; 0: as they were
    joints_of_whole = 0  #: atoms of the molecule, of which these are some; 0: all
    frames_left_out = 0  #: frames at the end that lack positions, step or time

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Options of the job that made them, and what it noted: "run/technique" -> its value."""
        return MappingProxyType({})

    @property
    def bars(self) -> np.ndarray:
        """(B, 2) joints, from 0."""
        return np.empty((0, 2), np.int64)

    @property
    def rest_lengths(self) -> np.ndarray:
        """(B,) Angstrom."""
        return np.empty(0)

    @property
    def contacts(self) -> RecordedContacts | None:
        """Which a model held, and in which frames."""
        return None

    @property
    def has_names(self) -> bool:
        """Whether its atoms have any."""
        return True

    @property
    def structure(self) -> Structure:
        """Atoms and bonds, at the first frame."""
        raise NotImplementedError

    def __len__(self) -> int:
        raise NotImplementedError

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom. Raises InputError where a file has no finite ones."""
        raise NotImplementedError

    @property
    def name(self) -> str:
        """What messages call it."""
        return str(self.path or self.structure.source or "frames")

    @property
    def atom_count(self) -> int:
        """N."""
        return len(self.structure)

    @property
    def masses(self) -> np.ndarray:
        """(N,) u."""
        return np.asarray(self.structure.masses)

    def read(self, frames: np.ndarray) -> Positions:
        """(f, N, 3) Angstrom, of ascending frames; those of a damaged one may not be finite."""
        found = [self.positions(int(frame)) for frame in frames]
        return np.array(found, dtype=np.float64).reshape(-1, self.atom_count, 3)

    def step(self, frame: int) -> int:
        """The step or number of a frame where it was made."""
        return frame

    def time(self, frame: int) -> float:
        """In ps; the number of the frame where no time is known."""
        return float(frame)

    def walker(self, frame: int) -> int | None:
        """Of a frame of an ensemble; None where there are no walkers."""
        return None

    @property
    def has_steps(self) -> bool:
        """Whether a step is more than the number of a frame."""
        return False

    def box(self, frame: int) -> npt.NDArray[np.float32] | None:
        """(6,) edges and angles, as MDAnalysis has them; None where there is none."""
        return None

    def numbers(self, frame: int) -> dict[str, float | int]:
        """Step, time and observables of a frame, as far as a file tells them."""
        return {}

    def close(self) -> None:
        """Closes files that reading opens again."""

    @property
    def time_between(self) -> float:
        """Between frames, ps."""
        return 1.0

    def moment(self, frame: int) -> Moment:
        """All of a frame; its positions may not be finite."""
        when = self.step(frame), self.time(frame), self.walker(frame)
        return Moment(self.read(np.array([frame]))[0], *when, self.box(frame))

    @property
    def observables(self) -> Mapping[str, np.ndarray]:
        """One number a frame, (F,), of each name."""
        return MappingProxyType({})

    @property
    def converged(self) -> np.ndarray:
        """(F,) bool: what the file says of each frame; true where it does not say."""
        flags = self.observables.get("converged")
        return np.ones(len(self), bool) if flags is None else flags.astype(bool)

    @property
    def kind(self) -> str:
        """What the frames are: a row of `pliant.trajectory.kind`."""
        return kind_of_frames(self.parameters)

    @property
    def around_start(self) -> np.ndarray:
        """Numbers of the frames by which flexibility is computed, ascending.

        All, but for an ensemble of sampler ``reach``: those drawn along the modes.
        """
        near = around_start(self.observables.get("sampler"))
        return np.arange(len(self)) if near is None else np.flatnonzero(near)

    @property
    def tolerance(self) -> Tolerance:
        """That of the run; 1e-6 where none is known. Raises InputError if it is no number."""
        usual = Tolerance()
        return Tolerance(
            self._positive("run/tolerance", usual.relative, math.ulp(0.0)),
            self._positive("run/tolerance_length", usual.length, 0.0),
        )

    def _positive(self, option: str, usual: float, least: float) -> float:
        value = self.parameters.get(option, usual)
        if isinstance(value, (int, float)) and math.isfinite(value) and value >= least:
            return float(value)
        wanted = "a number above 0" if least > 0 else "a number from 0"
        raise InputError(f"{self.name}: /parameters/{option}: expected {wanted}, found {value}")

    def bar_label(self, bar: int) -> str:
        """ "C1(0) - C2(1)": names and numbers (from 0) of both joints."""
        names = self.structure.names
        a, b = (f"{names[j]}({j})" if self.has_names else f"joint {j}" for j in self.bars[bar])
        return f"{a} - {b}"

    def rounding(self, positions: np.ndarray) -> float:
        """How much the storing of coordinates may change a length, Angstrom.

        Each coordinate is off by half a unit in the last place, at both ends, along three axes.
        """
        half_unit = 2.0**-24 if self.is_single else 2.0**-53
        off = max(half_unit * float(np.abs(positions).max(initial=0.0)), self.rounded_to / 2)
        return 2.0 * math.sqrt(3.0) * off


class FramesInMemory(Frames):
    """(F, N, 3) Angstrom."""

    def __init__(self, structure: Structure, positions: npt.ArrayLike) -> None:
        values = np.asarray(positions, dtype=np.float64)
        values = values[None] if values.ndim == 2 else values
        if values.ndim != 3 or values.shape[2] != 3:
            raise InputError(
                f"positions: expected shape (N, 3) or (F, N, 3), found {np.shape(positions)}"
            )
        check_atoms(structure, values.shape[1])
        self._structure = structure
        self.values: Positions = values

    @property
    def structure(self) -> Structure:
        """Atoms and bonds."""
        return self._structure

    def __len__(self) -> int:
        return len(self.values)

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom: a view."""
        found: Positions = self.values[frame]
        return found


class FramesOfModels(Frames):
    """The models of a structure file, or its one structure."""

    def __init__(self, path: Path) -> None:
        self.path: Path = path
        self._structure = _core.read(path)

    @property
    def structure(self) -> Structure:
        """The first model."""
        return self._structure

    def __len__(self) -> int:
        return self._structure.model_count

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        if frame == 0:
            return np.array(self._structure.positions)
        read = _core.read(self.path, frame + 1, perceive_bonds=False)
        check_atoms(self._structure, len(read), f"model {frame + 1} of {self.path}")
        return np.array(read.positions)


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
