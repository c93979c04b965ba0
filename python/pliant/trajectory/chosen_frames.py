# SPDX-License-Identifier: MIT
"""Some frames of many: spread evenly, and what is read of them at once."""

from __future__ import annotations

import numpy as np


def choose_frames(count: int, wanted: int | str, always: int | None = None) -> np.ndarray:
    """Frame numbers spread evenly from the first to the last, `always` among them."""
    if isinstance(wanted, str) or wanted >= count:  # "all"
        return np.arange(count)
    chosen = np.unique(np.linspace(0, count - 1, wanted).round().astype(int))
    if always is not None and always not in chosen:
        # In place of its nearest neighbour, so that the number stays what was asked for.
        chosen[np.argmin(np.abs(chosen - always))] = always
    return np.unique(chosen)


def runs_of(frames: np.ndarray) -> list[np.ndarray]:
    """Numbers of frames, divided where one does not follow the one before."""
    if len(frames) < 2:
        return [frames] if len(frames) else []
    return np.split(frames, np.flatnonzero(np.diff(frames) != 1) + 1)
