# SPDX-License-Identifier: MIT
"""Whether a file holds many frames: asked before what looks at them is imported."""

from __future__ import annotations

from pathlib import Path

from pliant._core import Error
from pliant.trajectory.opened import is_recorded, recorded

LEAST_FRAMES = 4  #: fewer are no ensemble


def is_many_frames(path: Path) -> bool:
    """Whether a file or folder holds enough frames to look for domains and shapes in."""
    if not is_recorded(path):
        return False
    try:
        return len(recorded(path)) >= LEAST_FRAMES
    except Error:  # which the page tells of
        return False
