# SPDX-License-Identifier: MIT
"""Files of frames, for what reads files only."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any

from pliant._core import InputError
from pliant.trajectory.trajectory import HasFrames, Trajectory


def file_of(given: Any, function: str) -> tuple[str, tempfile.TemporaryDirectory[str] | None]:
    """The file of a trajectory; frames in memory get one, in a folder that goes with the object."""
    if isinstance(given, (str, os.PathLike)):
        return os.fspath(given), None
    frames = Trajectory(given)
    if frames.path is not None:
        return os.fspath(frames.path), None
    if len(frames) < 2:
        found = type(given).__name__
        raise InputError(
            f"{function}: expected frames, or a file of them, found one {found}: "
            f"pliant.{function}(pliant.sample(structure))"
        )
    folder = tempfile.TemporaryDirectory(prefix="pliant-")
    source = given if isinstance(given, HasFrames) else frames
    return os.fspath(source.save(Path(folder.name) / "frames.h5md")), folder
