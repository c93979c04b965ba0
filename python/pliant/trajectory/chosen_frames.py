# SPDX-License-Identifier: MIT
"""Some frames of many, spread evenly."""

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
