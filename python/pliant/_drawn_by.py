# SPDX-License-Identifier: MIT
"""How frames of an ensemble were drawn: the values of /observables/sampler."""

from __future__ import annotations

import numpy as np

from pliant import _core

#: Names by value; "other" are those of samplers that draw in one way.
DRAWN_BY = tuple(name.replace("_", " ") for name in _core.drawn_by_names())
#: Frames up to this value are around the start; others go further.
DRAWN_ALONG_MODES = DRAWN_BY.index("modes")


def around_start(drawn_by: np.ndarray | None) -> np.ndarray | None:
    """(F,) bool: frames by which flexibility is computed; None: all.

    An ensemble may have others besides, which show where else it could be.
    """
    if drawn_by is None:
        return None
    near: np.ndarray = drawn_by <= DRAWN_ALONG_MODES
    return None if near.all() or np.count_nonzero(near) < 2 else near
