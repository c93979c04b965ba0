# SPDX-License-Identifier: MIT
"""The frames of an H5MD file, ours or another program's, and what it tells of them."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from pliant import _core
from pliant._core import Framework, Structure
from pliant.trajectory.chosen_frames import runs_of
from pliant.trajectory.frames import Frames, Positions
from pliant.trajectory.recorded_contacts import RecordedContacts, contacts_of


class FramesOfH5md(Frames):
    """Read when they are asked for, in double precision.

    Can be copied to another process, where the file is opened anew. Raises FileError where it
    cannot be read or is being written, InputError where it is no H5MD file or damaged: the message
    names the path within it. So does whatever reads it.
    """

    path: Path

    def __init__(self, path: Path) -> None:
        self.path = path
        self.is_single = self._reader.bytes_per_coordinate < 8
        self.rounded_to = self._reader.rounded_to
        self.joints_of_whole = self._reader.joints_of_whole
        self.frames_left_out = self._reader.frames_left_out

    @cached_property
    def _reader(self) -> Any:
        return _core.H5mdReader(self.path)

    def __getstate__(self) -> dict[str, object]:
        return {name: value for name, value in self.__dict__.items() if name != "_reader"}

    def close(self) -> None:
        """Closes the file, which reading opens again."""
        vars(self).pop("_reader", None)

    @cached_property
    def structure(self) -> Structure:
        """The atoms that were recorded; nameless ones of files that have no names."""
        structure: Structure = self._reader.structure(0)
        return structure

    def __len__(self) -> int:
        return len(self._reader)

    @property
    def atom_count(self) -> int:
        """Those of each frame."""
        return int(self._reader.joint_count)

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        return np.asarray(self._reader.positions(frame))

    def read(self, frames: np.ndarray) -> Positions:
        """(f, N, 3) Angstrom, of ascending frames; those of a damaged one may not be finite."""
        blocks = [self._reader.block(int(run[0]), len(run)) for run in runs_of(frames)]
        if len(blocks) == 1:
            return np.asarray(blocks[0])
        return np.concatenate([np.empty((0, self.atom_count, 3)), *blocks])

    @property
    def has_steps(self) -> bool:
        """Also where they are the numbers of the frames."""
        return True

    @cached_property
    def steps(self) -> np.ndarray:
        """(F,) as they were recorded."""
        return np.asarray(self._reader.steps())

    @cached_property
    def times(self) -> np.ndarray:
        """(F,) ps; the numbers of the frames where the file has none."""
        times = np.asarray(self._reader.times())
        return times if len(times) else np.arange(float(len(self)))

    def step(self, frame: int) -> int:
        """The step that was recorded."""
        return int(self.steps[frame])

    def time(self, frame: int) -> float:
        """In ps."""
        return float(self.times[frame])

    def walker(self, frame: int) -> int | None:
        """Of a shard of runs; None where there are no walkers."""
        walkers = self.observables.get("walker")
        return None if walkers is None else int(walkers[frame])

    @cached_property
    def observables(self) -> Mapping[str, np.ndarray]:
        """One number a frame, (F,), of each name; what has fewer is left out."""
        found = {name: self._reader.observable(name) for name in self._reader.observables}
        return {name: values for name, values in found.items() if len(values) == len(self)}

    def numbers(self, frame: int) -> dict[str, float | int]:
        """Step, time and observables of a frame."""
        found = {"step": self.step(frame), "time": self.time(frame)}
        return found | {name: one[frame].item() for name, one in self.observables.items()}

    @property
    def time_between(self) -> float:
        """Between the first two frames, ps."""
        return float(self.times[1] - self.times[0]) if len(self) > 1 else 0.0

    @cached_property
    def parameters(self) -> Mapping[str, Any]:
        """Options of the job that made the frames, and what it noted."""
        parameters: dict[str, Any] = self._reader.parameters()
        return parameters

    @cached_property
    def bars(self) -> np.ndarray:
        """(B, 2) joints, from 0."""
        return np.asarray(self._reader.bars()).astype(np.int64)

    @cached_property
    def rest_lengths(self) -> np.ndarray:
        """(B,) Angstrom."""
        return np.asarray(self._reader.rest_lengths())

    def with_bars(self, chosen: np.ndarray) -> FramesOfH5md:
        """The same with these of the bars alone, (B,) bool."""
        other = copy.copy(self)
        other.__dict__ |= {"bars": self.bars[chosen], "rest_lengths": self.rest_lengths[chosen]}
        return other

    @cached_property
    def framework(self) -> Framework:
        """All that was held. Raises InputError where the file has no bars, or impossible ones."""
        framework: Framework = self._reader.framework()
        return framework

    @property
    def pinned(self) -> np.ndarray:
        """(N,) bool. Raises as `framework`."""
        return np.isin(np.arange(self.atom_count), self.framework.pinned)

    @property
    def angle_bars(self) -> bool:
        """Whether bars were made of angles too."""
        model = self.parameters.get("model/kind", "bonds")
        return self.parameters.get("input/bars") == "angles" or model != "bonds"

    @cached_property
    def masses(self) -> np.ndarray:
        """(N,) u, as they were recorded."""
        masses = np.asarray(self._reader.masses())
        return masses if len(masses) else super().masses

    @cached_property
    def contacts(self) -> RecordedContacts | None:
        """Which a model held, and in which frames."""
        return contacts_of(self._reader, str(self.path))

    @property
    def has_names(self) -> bool:
        """Of its atoms."""
        return bool(self._reader.has_atoms)
