# SPDX-License-Identifier: MIT
"""Moves one molecule towards given places of its asked atoms, step by step, every step whole."""

from __future__ import annotations

import numpy as np

from pliant._core import Frame, Motion
from pliant._superposition import Superposition
from pliant.path.contacts import rms
from pliant.path.ends import Side

TOLERANCE = 1e-10  #: of bars, share of their length
MOST_SWEEPS = 300  #: a step that takes more is not whole
TIMESTEP = 0.01  #: ps a step, as files of Motion have it; a path has no time


class Walker:
    """Stands at the positions of a side, to be moved."""

    def __init__(self, side: Side) -> None:
        self.side = side
        self._count = np.bincount(side.leader[side.asked], minlength=side.leader.max() + 1)
        self._goal, self._length = np.empty((0, 3)), 0.0
        self._drift: np.ndarray | None = None
        self._motion = Motion(
            side.model.framework, side.positions, technique="froda", push=[],
            tolerance=TOLERANCE, max_sweeps=MOST_SWEEPS,
        )  # fmt: skip
        self._motion.add(self._push)
        self.now = kept(self._motion.start())

    @property
    def asked(self) -> np.ndarray:
        """(K, 3) where the asked atoms are, Angstrom."""
        places: np.ndarray = self.now.positions[self.side.asked]
        return places

    def apart(self, goal: np.ndarray) -> float:
        """r.m.s. distance of the asked atoms from places (K, 3), superposed, Angstrom."""
        return rms(ways(self.asked, goal))

    def step(self, goal: np.ndarray, length: float, drift: np.ndarray | None = None) -> bool:
        """Asks for a step of r.m.s. `length` (Angstrom) towards (K, 3), or all the way if nearer.

        drift: (R, 3) Angstrom, by which each matched residue is asked to go besides.
        False where it cannot be made whole; nothing has then moved.
        """
        self._goal, self._length, self._drift = goal, length, drift
        frame = self._motion.step()
        if not frame.converged:
            self.put(self.now)
            return False
        self.now = kept(frame)
        return True

    def put(self, frame: Frame) -> None:
        """Goes on from a frame that was made before."""
        self._motion.state.positions = frame.positions
        self._motion.state.previous = frame.positions
        self.now = frame

    def _push(self, _step: int, positions: np.ndarray, _previous: np.ndarray) -> None:
        side = self.side
        moves = ways(positions[side.asked], self._goal)
        apart = rms(moves)
        moves *= min(1.0, self._length / apart) if apart > 0.0 else 0.0
        leaders = side.leader[side.asked]
        common = self._means(leaders, moves)
        positions[side.asked] += moves - common[leaders]
        if self._drift is not None:
            common += self._drift
        positions += common[side.leader]

    def _means(self, leaders: np.ndarray, moves: np.ndarray) -> np.ndarray:
        """(R, 3) mean move of the asked atoms of each residue."""
        sums = [np.bincount(leaders, moves[:, k], minlength=len(self._count)) for k in range(3)]
        means: np.ndarray = np.stack(sums, axis=1) / np.maximum(self._count, 1)[:, None]
        return means


def ways(here: np.ndarray, goal: np.ndarray) -> np.ndarray:
    """(K, 3) from each of (K, 3) to its goal, which is superposed first."""
    moves: np.ndarray = Superposition(here, np.ones(len(here))).apply(goal) - here
    return moves


def kept(frame: Frame, step: int | None = None) -> Frame:
    """A copy that the next step does not change, with another number of its step."""
    number = frame.step if step is None else step
    return Frame(
        number, number * TIMESTEP, frame.positions, sweeps=frame.sweeps,
        projections=frame.projections, max_residual=frame.max_residual,
        rms_residual=frame.rms_residual,
    )  # fmt: skip
