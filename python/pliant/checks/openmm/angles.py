# SPDX-License-Identifier: MIT
"""Whether OpenMM's CCMA is given the angles between bars, which cost time to get ready.

CCMA: Eastman and Pande, J. Chem. Theory Comput. 6 (2010) 434.
"""

from __future__ import annotations

import numpy as np

MOST_ANGLES_PER_BAR = 20  #: with more, as of a star of bars, angles are left out
MOST_BARS_WITH_ANGLES = 30_000  #: CCMA needs time that grows as the square of the bars to get ready


def why_no_angles(bars: np.ndarray) -> str:
    """Why CCMA is better not given the angles between these bars; empty if it is."""
    degree = np.bincount(bars.ravel())
    if len(bars) > MOST_BARS_WITH_ANGLES:
        return (
            f"OpenMM is given no angles: making a Context for more than {MOST_BARS_WITH_ANGLES} "
            "bars takes minutes, and each frame with angles needs one of its own"
        )
    if np.sum(degree * (degree - 1) // 2) > MOST_ANGLES_PER_BAR * len(bars):
        return "OpenMM is given no angles: too many bars share a joint"
    return ""
