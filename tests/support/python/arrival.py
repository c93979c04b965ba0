# SPDX-License-Identifier: MIT
"""Whether `auto` arrives on real files: steps that are not whole, and steps that cost much.

``python tests/support/python/arrival.py [--seconds S] [FILE...]`` prints what goes wrong on each
file of the installed packages; S cuts a run off.
"""

from __future__ import annotations

import argparse
import time
import warnings
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from real_files import real_files, structure_of

import pliant

STEPS = 100
#: Name, and arguments of Motion.
PUSHES: dict[str, dict[str, str | float]] = {
    "force": {"push": "force"},
    "force_all": {"push": "force_all"},
    "displacement 0.1": {"push": "displacement", "displacement": 0.1},
    "displacement 0.5": {"push": "displacement", "displacement": 0.5},
}
BARS = ("bonds", "angles")
OTHERS = ("shake", "newton")
#: A step may look at so many times as many bars as the median step of its run; a push of one joint
#: that mostly reaches few bars, at so many times as many as there are.
MOST_OVER_MEDIAN = 50.0


@dataclass
class Run:
    """What each step of a run came to."""

    bars: int
    unconverged: list[int] = field(default_factory=list)  # numbers of steps
    looked: list[int] = field(default_factory=list)  # bars, a step
    seconds: float = 0.0  # of the processor

    @property
    def over_median(self) -> float:
        """Bars that the dearest step looked at, over those of the median step or of all."""
        if not self.looked:
            return 0.0
        return float(max(self.looked) / max(np.median(self.looked), self.bars))


def walk(
    framework: pliant.Framework,
    positions: np.ndarray,
    push: str,
    technique: str,
    seconds: float = np.inf,
    steps: int = STEPS,
) -> Run:
    """Steps one walker, for at most so many seconds of the processor."""
    motion = pliant.Motion(framework, positions, technique=technique, seed=1, **PUSHES[push])
    motion.start()
    run = Run(framework.bar_count)
    begin = time.process_time()
    for step in range(1, steps + 1):
        frame = motion.step()
        run.looked.append(frame.projections)
        if not frame.converged:
            run.unconverged.append(step)
        run.seconds = time.process_time() - begin
        if run.seconds > seconds:
            break
    return run


def who_arrives(
    framework: pliant.Framework, positions: np.ndarray, push: str, seconds: float, steps: int
) -> list[str]:
    """The techniques without a step that is not whole."""
    return [
        name
        for name in OTHERS
        if not walk(framework, positions, push, name, seconds, steps).unconverged
    ]


def failures(
    structure: pliant.Structure, bars: str, push: str, seconds: float = np.inf, steps: int = STEPS
) -> tuple[list[str], Run]:
    """What does not hold, in words, and the run of `auto`."""
    framework = structure.framework(bars=bars)
    found = []
    run = walk(framework, structure.positions, push, "auto", seconds, steps)
    if run.unconverged:
        others = who_arrives(framework, structure.positions, push, seconds, steps)
        if others:
            found.append(f"{len(run.unconverged)} of {len(run.looked)} steps, but not {others}")
    if run.over_median > MOST_OVER_MEDIAN:
        found.append(f"a step looks at {run.over_median:.0f} times the bars of the median")
    return found, run


def print_all(paths: Iterable[Path], seconds: float) -> None:
    """A line for each run."""
    for path in paths:
        structure = structure_of(path)
        if structure is None:
            print(path.name, "-", flush=True)
            continue
        for bars in BARS:
            for push in PUSHES:
                try:
                    found, run = failures(structure, bars, push, seconds)
                except pliant.InputError as error:
                    print(f"{path.name} {bars} {push}: {error}", flush=True)
                    continue
                said = "; ".join(found) or "ok"
                print(
                    f"{path.name} {len(structure.positions)} {bars} {push}: "
                    f"{len(run.looked)} steps {run.seconds:.1f} s, "
                    f"{run.over_median:.1f} x median {np.median(run.looked):.0f}: {said}",
                    flush=True,
                )


def main() -> None:
    """Prints what goes wrong."""
    asked = argparse.ArgumentParser()
    asked.add_argument("--seconds", type=float, default=np.inf)
    asked.add_argument("files", nargs="*", type=Path)
    given = asked.parse_args()
    warnings.simplefilter("ignore", pliant.PliantWarning)
    print_all(given.files or real_files(), given.seconds)


if __name__ == "__main__":
    main()
