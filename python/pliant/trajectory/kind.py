# SPDX-License-Identifier: MIT
"""What the frames of a file are: independent draws, a path of pushes or between structures, or
something of others."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

ENSEMBLE = "ensemble"  #: `pliant sample`: frames are independent
PATH = "path"  #: `pliant run`: each frame is the one before, pushed
TRANSITION = "transition"  #: `pliant path`: each frame is nearer to another structure
TRAJECTORY = "trajectory"  #: another program's: frames may be anything

#: kind -> what its frames are, and what follows from that
MEANING = {
    ENSEMBLE: (
        "An ensemble",
        "Frames are independent and show what can move. How often a shape occurs is not known, and "
        "how far frames go overall was an input.",
    ),
    PATH: (
        "A path of pushes, not an ensemble",
        "Each frame is the one before, pushed and resolved. How far atoms got depends on the "
        "pushes and on how many there were, so these fluctuations are not a property of the "
        "molecule. For those, see pliant sample.",
    ),
    TRANSITION: (
        "A path from one structure to another, not an ensemble",
        "The frames are in order, and show that there is a way. They say nothing about time, "
        "rates, or how often a shape occurs; the fluctuations are those of the path, not a "
        "property of the molecule. The 3-D view plays it.",
    ),
    TRAJECTORY: (
        "A trajectory of another program",
        "Its fluctuations are taken as they are; errors come from blocks of frames that are longer "
        "than the correlation time of the slowest motion.",
    ),
}


def kind_of_frames(parameters: Mapping[str, Any]) -> str:
    """ENSEMBLE, PATH, TRANSITION or TRAJECTORY, by the parameters that the file holds."""
    if "path/end" in parameters:
        return TRANSITION
    if "sample/sampler" in parameters:
        return ENSEMBLE
    return PATH if any(name.startswith("run/") for name in parameters) else TRAJECTORY
