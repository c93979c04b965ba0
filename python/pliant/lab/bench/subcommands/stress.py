# SPDX-License-Identifier: MIT
"""``pliant lab bench stress``."""

from __future__ import annotations

from typing import Any

from pliant._core import OptionError
from pliant.lab.bench import stress_cases
from pliant.lab.bench.stress import Stress, stress
from pliant.lab.options import TECHNIQUES, numbers, whole, word

DESCRIPTION = """\
Tries every technique on frameworks chosen to break it, each in a child process. Prints
how each ended, and the worst bar measured again. It is a violation if a process dies, a
position is not a number, a pinned joint has moved, or a technique says 'converged' beyond
the tolerance. Violations are named, and the exit code is then 1."""
EPILOG = """\
examples:
  pliant lab bench stress --only offset
  pliant lab bench stress --technique blocks,bfs_cycle --json > stress.json
"""
OPTIONS = {
    "--only": word("WORD", "only cases with this word in their name or group", ""),
    "--technique": TECHNIQUES,
    "--weighting": numbers("0.5", "weightings of these techniques", "W,W,...", dest="weightings"),
    "--steps": whole(1, stress_cases.STEPS, "steps of the runs of closed mechanisms"),
    "--shrink": whole(1, 1, "make the large frameworks N times smaller"),
}


def measure(only: str, steps: int, shrink: int, **options: Any) -> Stress:
    """The cases that are asked for."""
    cases = stress_cases.all_cases(shrink, steps)
    asked = [case for case in cases if only in case.name or only in case.group]
    if not asked:
        raise OptionError(f"--only: no case has '{only}' in its name or group")
    return stress(asked, **options)
