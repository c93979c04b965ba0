# SPDX-License-Identifier: MIT
"""What each figure must reach, and what it aims at."""

from __future__ import annotations

from typing import Any

#: (system, figure) or figure: must, aim, whether these are the least, whether it must be exact.
_GOALS: dict[tuple[str, str] | str, tuple[float, float, bool, bool]] = {
    ("ubiquitin", "r of RMSF, residues 1-70"): (0.90, 0.94, True, False),
    ("ubiquitin", "RMSIP of 10"): (0.75, 0.80, True, False),
    ("HIV-PR", "r of RMSF"): (0.93, 0.97, True, False),
    ("HIV-PR", "RMSIP of 10"): (0.77, 0.79, True, False),
    ("AdK, closed to open", "cumulative overlap of 10"): (0.88, 0.92, True, False),
    ("AdK, open to closed", "cumulative overlap of 10"): (0.96, 0.975, True, False),
    ("domain motions, held out", "cumulative overlap of 10, mean"): (0.868, 0.89, True, False),
    ("domain motions, held out", "cumulative overlap of 10, median"): (0.92, 0.95, True, False),
    "two seeds, r of RMSF, the worst": (0.995, 0.999, True, False),
    "two seeds, RMSIP of 10, the worst": (0.95, 0.98, True, False),
    "Ramachandran outliers above the start's, %": (1.0, 0.5, False, False),
    "worst bar, relative": (1e-10, 1e-13, False, True),
    "new overlaps > 0.1 Angstrom": (0, 0, False, True),
    "flipped chirality": (0, 0, False, True),
    "omega off > 5 degrees": (0, 0, False, True),
    "redrawn at 1.4 Angstrom, %": (1.0, 0.2, False, False),
    "redrawn at 2.8 Angstrom, %": (5.0, 1.0, False, False),
    "nearest frame of reach, Angstrom": (3.0, 2.0, False, False),
    "a frame of turns for one of modes, times of a core": (3.0, 1.5, False, False),
    ("AdK, open to closed", "ms of a core a frame"): (5.0, 2.0, False, False),
    ("AdK, open to closed", "ms of a core a frame, polar hydrogens"): (5.0, 2.0, False, False),
    ("ubiquitin", "s, whole command, 200 frames"): (2.5, 0.8, False, False),
    ("AdK, open to closed", "MB, whole command"): (100.0, 100.0, False, False),
}


def goal_of(system: str, figure: str) -> dict[str, Any]:
    """Fields of a Row: must, aim, least, exact; none where nothing is asked for."""
    found = _GOALS.get((system, figure)) or _GOALS.get(figure)
    return dict(zip(("must", "aim", "least", "exact"), found, strict=True)) if found else {}
