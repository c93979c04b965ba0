# SPDX-License-Identifier: MIT
"""What the writers of frames are given."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Moment:
    """A frame on its way: positions (n, 3) Angstrom, step, time in ps."""

    positions: np.ndarray
    step: int
    time: float
    walker: int | None = None  #: of a frame of an ensemble
