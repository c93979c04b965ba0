# SPDX-License-Identifier: MIT
"""Goes back on a way that is stuck, and tries again by a detour."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pliant.path.march import LEAST_GAIN, PATIENCE, Way, march
from pliant.path.walker import Walker, ways

DETOUR = 6  #: steps
FURTHEST = 2.0  #: Angstrom a step that the residue furthest from its goal is sent
SMOOTH = 4.0  #: residues along which a detour changes its direction


def go(
    walker: Walker,
    way: Way,
    goals: Sequence[np.ndarray],
    step: float,
    attempts: int,
    seed: int,
    near_enough: float,
) -> tuple[Way, int]:
    """Marches, and where that is stuck further than `near_enough` (Angstrom) from the last goal
    goes back and tries again, at most `attempts` times. The best way, and how often it went back.
    """  # fmt: skip
    march(walker, way, goals, step)
    best, tried = way, 0
    while best.left[-1] > near_enough and tried < attempts:
        tried += 1
        other = _again(walker, best, goals, step, tried, seed)
        if other.left[-1] < best.left[-1] - LEAST_GAIN:
            best = other
    walker.put(best.frames[-1])
    return best, tried


def _again(
    walker: Walker, stuck: Way, goals: Sequence[np.ndarray], step: float, attempt: int, seed: int
) -> Way:
    """From some frames before the last: further back, and further aside, the more attempts."""
    back = PATIENCE * 2 ** (attempt % 4)
    way = stuck.until(max(0, len(stuck.frames) - 1 - back))
    walker.put(stuck.frames[-1])
    aside = _aside(walker, goals[-1], attempt, seed)
    walker.put(way.frames[-1])
    for _ in range(DETOUR):
        if not walker.step(walker.asked, 0.0, aside):
            aside = 0.5 * aside
            continue
        way.add(walker.now, walker.apart(goals[-1]))
    nearest = int(np.argmin([walker.apart(goal) for goal in goals]))
    march(walker, way, goals[nearest:], step)
    return way


def _aside(walker: Walker, goal: np.ndarray, attempt: int, seed: int) -> np.ndarray:
    """(R, 3) where residues that are far from their goal are sent in each step of a detour."""
    leaders = walker.side.leader[walker.side.asked]
    left = np.linalg.norm(ways(walker.asked, goal), axis=1)
    furthest = np.zeros(walker.side.leader.max() + 1)
    np.maximum.at(furthest, leaders, left)
    share = furthest / max(furthest.max(), 1e-9)
    field = _smooth_field(len(share), attempt, seed)
    return np.asarray(FURTHEST * share[:, None] * field)


def _smooth_field(residues: int, attempt: int, seed: int) -> np.ndarray:
    """(R, 3) random directions that change slowly along the residues, the longest of length 1.

    Bits of Philox alone, so that they are the same with every version of NumPy.
    """
    bits = np.random.Philox(key=[seed, attempt]).random_raw(3 * residues) >> np.uint64(11)
    noise = (bits.astype(np.float64) * 2.0**-52 - 1.0).reshape(-1, 3)
    apart = np.arange(residues)[:, None] - np.arange(residues)[None]
    field = np.exp(-0.5 * (apart / SMOOTH) ** 2) @ noise
    return np.asarray(field / np.linalg.norm(field, axis=1).max())
