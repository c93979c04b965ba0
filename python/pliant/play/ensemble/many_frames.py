# SPDX-License-Identifier: MIT
"""Whether a file holds many frames: asked before what looks at them is imported."""

from __future__ import annotations

from pathlib import Path

import h5py

from pliant.trajectory.shards.plan import is_ensemble

LEAST_FRAMES = 4  #: fewer are no ensemble


def is_many_frames(path: Path) -> bool:
    """Whether a file or folder holds enough frames to look for domains and shapes in."""
    if is_ensemble(str(path)):
        return True
    try:
        with h5py.File(path) as file:
            groups = file["particles"].values()
            return any(
                len(one["position/value"]) >= LEAST_FRAMES for one in groups if "position" in one
            )
    except (OSError, KeyError, TypeError):  # which the page tells of
        return False
