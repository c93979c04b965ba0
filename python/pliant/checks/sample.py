# SPDX-License-Identifier: MIT
"""The frames that OpenMM is asked about, and the framework as OpenMM is given it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pliant._core import InputError
from pliant.checks.openmm.child import Job
from pliant.measure import bars as _bars
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.h5md import FramesOfH5md

NM = 0.1  #: nanometres in an Angstrom
MOST_BYTES = 2 << 30  #: of sampled positions


@dataclass
class Sample:
    """Some frames of a recording, in double precision."""

    recording: FramesOfH5md
    frames: np.ndarray  #: (S,) frame numbers, ascending
    positions: np.ndarray  #: (S, N, 3) Angstrom

    @property
    def converged(self) -> np.ndarray:
        """(S,) bool: what the file says."""
        flags: np.ndarray = self.recording.converged[self.frames]
        return flags

    def openmm_tolerance(self, positions: np.ndarray) -> float:
        """The relative tolerance at which OpenMM accepts whatever the file may call whole.

        The largest over the bars (they differ if the run's tolerance is a length), what storing
        the coordinates changes included.
        """
        recording = self.recording
        if len(recording.bars) == 0:
            return recording.tolerance.relative
        rounding = recording.rounding(positions) / recording.rest_lengths
        accepted = recording.tolerance.of(recording.rest_lengths) + rounding
        return float(accepted.max()) * (1 + 1e-9)

    def residuals(self, positions: np.ndarray) -> np.ndarray:
        """(S,) largest relative residual of each structure (S, N, 3)."""
        recording = self.recording
        return np.array(
            [_bars.worst_residual(x, recording.bars, recording.rest_lengths) for x in positions]
        )


def take_sample(recording: FramesOfH5md, wanted: int | str, worst: int | None = None) -> Sample:
    """Reads `wanted` frames (or "all"), frame number `worst` among them.

    Raises InputError when they would take more memory than they should, or none has finite
    coordinates.
    """
    frames = choose_frames(len(recording), wanted, worst)
    size = 24 * len(frames) * recording.atom_count
    if size > MOST_BYTES:
        raise InputError(
            f"--frames: {len(frames)} frames of {recording.atom_count} atoms take "
            f"{size / 2**30:.1f} GiB of memory; choose fewer"
        )
    positions = recording.read(frames)
    finite = np.isfinite(positions).all(axis=(1, 2))
    if not finite.any():
        raise InputError(f"{recording.name}: no frame has finite coordinates")
    return Sample(recording, frames[finite], positions[finite])


def constraint_job(recording: FramesOfH5md, kind: str, tolerance: float, **more: Any) -> Job:
    """A job on the framework of the file: every joint free, with its mass.

    Pinned joints are free here: OpenMM refuses a constraint between a joint of mass 0 and another.
    Arrays are passed on, what is no array becomes a value of the job.
    """
    arrays = {
        "masses": recording.masses,
        "bars": recording.bars,
        "rest_lengths": recording.rest_lengths * NM,
    }
    values: dict[str, Any] = {
        "tolerance": tolerance,
        "platform": "Reference",
        "repeats": 1,
        "budget_seconds": 60.0,
    }
    for name, value in more.items():
        (arrays if isinstance(value, np.ndarray) else values)[name] = value
    return Job(kind, values, arrays)
