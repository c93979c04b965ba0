# SPDX-License-Identifier: MIT
"""How frames of an ensemble were drawn: the values of /observables/sampler."""

from __future__ import annotations

import numpy as np

from pliant import _core

#: Names by value; "other" are those of samplers that draw in one way.
DRAWN_BY = tuple(name.replace("_", " ") for name, _ in _core.drawn_by_table())
_NEAR = [value for value, (_, near) in enumerate(_core.drawn_by_table()) if near]


def is_near(drawn_by: np.ndarray) -> np.ndarray:
    """(F,) bool: frames around the start; others go further."""
    return np.isin(drawn_by, _NEAR)


def around_start(drawn_by: np.ndarray | None) -> np.ndarray | None:
    """(F,) bool: frames by which flexibility is computed; None: all.

    An ensemble may have others besides, which show where else it could be.
    """
    if drawn_by is None:
        return None
    near = is_near(drawn_by)
    return None if near.all() or np.count_nonzero(near) < 2 else near
