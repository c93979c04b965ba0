# SPDX-License-Identifier: MIT
"""Both ends go towards each other, until they meet or neither gains.

Each of the two has its own bars, so that frames of one cannot be frames of the other: where they
have met, the molecule of the start goes on along the frames that the other has made, backwards, as
its goals.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant.path.contacts import rms
from pliant.path.ends import Ends
from pliant.path.march import MOST_STEPS, NEAR, Patience, Way, whole_step
from pliant.path.walker import Walker, ways


@dataclass
class Meeting:
    """Where both were when they stopped."""

    apart: float  #: r.m.s. distance between them, Angstrom
    steps: tuple[int, int]  #: of the molecule of the start, and of that of the end
    goals: list[np.ndarray]  #: (K, 3) each: places of the other's frames, the last one first

    @property
    def has_met(self) -> bool:
        """Whether they came near each other."""
        return self.apart <= NEAR

    def told(self) -> str:
        """In words."""
        ours, theirs = self.steps
        met = "met" if self.has_met else "did not meet"
        return (
            f"the two ends {met}, {self.apart:.2f} A apart, after {ours} steps of the start and "
            f"{theirs} of the end"
        )


class _Traveller:
    """One of the two."""

    def __init__(self, walker: Walker, step: float, apart: float) -> None:
        self.walker, self.step = walker, step
        self.frames = [walker.now]
        self.waits = False
        self._left = apart  #: Angstrom, if the other stood still
        self._patience = Patience(step, apart)

    def go(self, other: np.ndarray) -> None:
        """A step towards places (K, 3); waits for good where steps gain no more."""
        before = self.walker.apart(other)
        if not whole_step(self.walker, other, self.step):
            self.waits = True
            return
        self._left -= before - self.walker.apart(other)
        self.frames.append(self.walker.now)
        self.waits = self._patience.is_over(self._left)


def meet(ends: Ends, walker: Walker, step: float) -> tuple[Way, Meeting]:
    """Steps of both in turn: the frames of `walker`, of the start, and where they met."""
    asked, apart = ends.end.asked, walker.apart(ends.goal)
    pair = _Traveller(walker, step, apart), _Traveller(Walker(ends.end), step, apart)
    steps = 0
    while steps < MOST_STEPS and not all(one.waits for one in pair):
        here, there = pair if steps % 2 == 0 else pair[::-1]
        steps += 1
        if here.walker.apart(there.walker.asked) <= NEAR:
            break
        if not here.waits:
            here.go(there.walker.asked)
    ours, theirs = pair
    way = Way(
        ours.frames, [rms(ways(f.positions[ends.start.asked], ends.goal)) for f in ours.frames]
    )
    goals = [frame.positions[asked] for frame in theirs.frames[::-1]]
    apart = walker.apart(theirs.walker.asked)
    return way, Meeting(apart, (len(ours.frames) - 1, len(theirs.frames) - 1), goals)
