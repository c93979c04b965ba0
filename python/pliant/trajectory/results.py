# SPDX-License-Identifier: MIT
"""What `sample` and `run` return: their numbers, and their frames."""

from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path

import numpy as np

from pliant import _core
from pliant._core import InputError, Structure
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.trajectory import HasFrames, Trajectory

#: Frames of a run that has no output are kept in memory up to this.
MOST_KEPT = 256 * 1024**2


class SampledEnsemble(HasFrames, _core.SampledFrames):
    """Frames of a molecule, and how exact they are.

    ``len``, an index, iteration and slices give frames, (N, 3) arrays in Angstrom, as of a
    `Trajectory`.
    """

    output: Path | None = None  #: the H5MD file, if one was written

    def __repr__(self) -> str:
        return f"<pliant.SampledEnsemble: {len(self)} frames of {len(self.structure)} atoms>"

    @property
    def structure(self) -> Structure:
        """The molecule that was sampled: prepared, which may have added or left out atoms."""
        return self.model.structure

    @property
    def trajectory(self) -> Trajectory:
        """The frames, in memory."""
        return Trajectory._of(FramesInMemory(self.structure, self.positions))


class SampleResult(HasFrames, _core.SampleSummary):
    """What `continue_sample` added, and all frames of the file, as of a `Trajectory`."""

    output: Path  #: the H5MD file

    @property
    def trajectory(self) -> Trajectory:
        """The frames, read when they are asked for."""
        return Trajectory(self.output)

    @property
    def positions(self) -> np.ndarray:
        """(F, N, 3) float64, Angstrom."""
        return self.trajectory.positions


class RunResult(HasFrames, _core.RunSummary):
    """What a run did, and its frames: in the H5MD file that it wrote, else in memory.

    ``len``, an index, iteration and slices give frames, (N, 3) arrays in Angstrom, as of a
    `Trajectory`. In memory frames of up to 256 MB in all are kept.
    """

    def __init__(
        self,
        summary: _core.RunSummary,
        structure: Structure | None,
        output: str | os.PathLike[str] | None = None,
    ) -> None:
        super().__init__(summary)
        self._structure = structure
        self.output = None if output is None else Path(output)  #: the file, if one was written

    def __bool__(self) -> bool:
        return True  # also where no frames were kept

    @cached_property
    def trajectory(self) -> Trajectory:
        """The frames. Raises InputError where they were not kept, with what keeps them."""
        if len(self.kept) > 0:
            kept = self.kept.reshape(-1, len(self.state.positions), 3)
            return Trajectory._of(FramesInMemory(self.structure, kept))
        if self.output is None:
            raise InputError(
                f"run: {self.frames} frames take more than {MOST_KEPT >> 20} MB and were not kept: "
                'pliant.run(..., output="run.h5md") writes them into a file'
            )
        return Trajectory(self.output)

    @property
    def structure(self) -> Structure:
        """The molecule; of a framework nameless atoms at its joints."""
        if self._structure is not None:
            return self._structure
        if self.output is not None:
            return self.trajectory.structure
        return Structure(self.state.positions)

    @property
    def positions(self) -> np.ndarray:
        """(F, N, 3) float64, Angstrom."""
        return self.trajectory.positions
