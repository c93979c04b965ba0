# SPDX-License-Identifier: MIT
"""How far a domain turns against another over many frames, and about which axis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant.trajectory.superposition import Superposition, superpose_onto


@dataclass(frozen=True)
class Turn:
    """The largest turn of a domain: a rotation about an axis, and a shift along it."""

    angle: float  #: degrees, from 0 to 180
    shift: float  #: Angstrom along the axis
    point: np.ndarray  #: (3,) of the axis, nearest to the domain; Angstrom, as `before` lies
    axis: np.ndarray  #: (3,) unit vector; the turn is right-handed about it
    before: int  #: frame that it begins with
    after: int  #: frame that it ends with


def largest_turn(
    positions: np.ndarray, core: np.ndarray, domain: np.ndarray, ends: tuple[int, int] | None = None
) -> Turn:
    """The turn of a domain between the two frames that are furthest apart in it.

    positions: (F, n, 3) Angstrom; core, domain: which of the n sites stand still and which turn;
    ends: the two frames, where these are known. The core of each frame is superposed. The axis is
    that of the screw motion (Chasles), as DynDom has it (S. Hayward, H. J. C. Berendsen, Proteins
    30 (1998) 144).
    """
    before, after = _furthest(positions, core, domain) if ends is None else ends
    one = positions[before]
    fit = Superposition(one[core], np.ones(int(core.sum())))
    other = fit.apply(positions[after], positions[after][core])
    return _screw(one[domain], other[domain], before, after)


def _furthest(positions: np.ndarray, core: np.ndarray, domain: np.ndarray) -> tuple[int, int]:
    """The frames at both ends of the direction in which the domain turns most, the lower first."""
    moved = superpose_onto(positions, core, positions[0][core])[:, domain]
    mean = moved.mean(axis=0)
    vectors = np.array([_vector(_rotation(mean, one)) for one in moved])
    vectors -= vectors.mean(axis=0)
    along = vectors @ np.linalg.svd(vectors, full_matrices=False)[2][0]
    first, last = sorted((int(np.argmin(along)), int(np.argmax(along))))
    return first, last


def _screw(one: np.ndarray, other: np.ndarray, before: int, after: int) -> Turn:
    """Of the motion that brings positions (n, 3) to other ones."""
    rotation = _rotation(one, other)
    vector = _vector(rotation)
    angle = float(np.linalg.norm(vector))
    centre = one.mean(axis=0)
    way = other.mean(axis=0) - centre
    if angle < 1e-6:
        return Turn(0.0, float(np.linalg.norm(way)), centre, np.eye(3)[2], before, after)
    axis = vector / angle
    across = way - (way @ axis) * axis
    # The centre goes round the axis by the angle, from a point at half its chord over tan(angle/2).
    point = centre + 0.5 * (across + np.cross(axis, across) / np.tan(0.5 * angle))
    return Turn(float(np.degrees(angle)), float(way @ axis), point, axis, before, after)


def _rotation(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """(3, 3) that turns (n, 3) onto other positions: column vectors."""
    rotation: np.ndarray = Superposition(other, np.ones(len(other))).motion(one)[0].T
    return rotation


def _vector(rotation: np.ndarray) -> np.ndarray:
    """(3,) along the axis of a rotation, as long as its angle in radians."""
    cosine = float(np.clip((np.trace(rotation) - 1.0) / 2.0, -1.0, 1.0))
    angle = float(np.arccos(cosine))
    odd = rotation - rotation.T
    along = np.array([odd[2, 1], odd[0, 2], odd[1, 0]])
    length = float(np.linalg.norm(along))
    if length < 1e-9:  # none, or half a turn
        along = np.linalg.svd(rotation - np.eye(3))[2][2]
        length = 1.0
    return np.asarray(along * (angle / length))
