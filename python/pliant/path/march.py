# SPDX-License-Identifier: MIT
"""Steps on a way: towards one goal after another, until nothing is gained."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from pliant._core import Frame
from pliant.path.walker import Walker

#: a way ends where so many steps together gain less than LEAST_GAIN, Angstrom
PATIENCE, LEAST_GAIN = 8, 0.02
LEAST_SHARE = 0.05  #: of the way that those steps were asked to go, if that is less
ROUNDING = 1e-6  #: nearer to a goal than this there is no way to go, Angstrom
NEAR = 0.5  #: a goal that is not the last is reached, Angstrom
HALVED = 3  #: times that a step which cannot be made whole is halved
LEAST_GUIDED = 0.1  #: share of a step that is to be gained towards a goal that is not the last
MOST_STEPS = 2000


@dataclass
class Way:
    """Frames of one walker, and how far each is from the last goal (Angstrom)."""

    frames: list[Frame]
    left: list[float]
    notes: list[str] = field(default_factory=list)  #: why it ended, if not for want of gain

    def add(self, frame: Frame, left: float) -> None:
        """One more."""
        self.frames.append(frame)
        self.left.append(left)

    def until(self, frame: int) -> Way:
        """Its frames up to one of them, that one as well."""
        return Way(self.frames[: frame + 1], self.left[: frame + 1])


def begin(walker: Walker, goal: np.ndarray) -> Way:
    """A way of the frame where the walker stands."""
    return Way([walker.now], [walker.apart(goal)])


class Patience:
    """Whether steps still gain."""

    def __init__(self, step: float, begun: float) -> None:
        self._least = min(LEAST_GAIN, LEAST_SHARE * PATIENCE * step)
        self._seen = [begun]

    def is_over(self, left: float) -> bool:
        """Notes how far the goal is (Angstrom); whether the last steps gained too little."""
        self._seen.append(left)
        if len(self._seen) <= PATIENCE:
            return left < ROUNDING
        return self._seen[-1 - PATIENCE] - left < self._least


def march(walker: Walker, way: Way, goals: Sequence[np.ndarray], step: float) -> None:
    """Goes on from the last frame of a way, towards each of the goals (K, 3) in turn.

    Those before the last only show the way: one is left for the next where it is near, or where a
    step gains little.
    """
    for goal in goals[:-1]:
        apart = walker.apart(goal)
        while apart > NEAR and len(way.frames) <= MOST_STEPS and whole_step(walker, goal, step):
            before, apart = apart, walker.apart(goal)
            way.add(walker.now, walker.apart(goals[-1]))
            if before - apart < LEAST_GUIDED * step:
                break
    _arrive(walker, way, goals[-1], step)


def _arrive(walker: Walker, way: Way, goal: np.ndarray, step: float) -> None:
    """Towards one goal until nothing is gained."""
    apart = walker.apart(goal)
    patience = Patience(step, apart)
    while apart > ROUNDING:
        if len(way.frames) > MOST_STEPS:
            way.notes.append(f"ended after {MOST_STEPS} steps")
            return
        if not whole_step(walker, goal, step):
            way.notes.append("the last step could not be made whole, and is left out")
            return
        apart = walker.apart(goal)
        way.add(walker.now, apart)
        if patience.is_over(apart):
            return


def whole_step(walker: Walker, goal: np.ndarray, step: float) -> bool:
    """A step that cannot be made whole is asked for anew, half as long, and again."""
    return any(walker.step(goal, step / 2**halved) for halved in range(HALVED + 1))
