# SPDX-License-Identifier: MIT
"""The parts of a molecule whose shape chemistry fixes, and how far positions leave that shape."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: a centre is planar where it lies nearer than this to the plane of its three neighbours, Angstrom
PLANAR = 0.12
#: of a corner: |volume of its unit vectors| above which it has a hand
HANDED = 0.3


@dataclass(frozen=True)
class Corners:
    """Angles, handed centres and planar centres of a molecule, as atom indices."""

    angles: np.ndarray  #: (A, 3) end, middle, end
    handed: np.ndarray  #: (H, 4) centre and three neighbours, not in one plane
    planar: np.ndarray  #: (P, 4) centre with exactly three neighbours, in their plane


def corners_of(bonds: np.ndarray, elements: np.ndarray, positions: np.ndarray) -> Corners:
    """The corners of a molecule, by the bonds (B, 2) and the reference positions (N, 3).

    Handed are carbons with four neighbours, or three that are not in one plane with them (the
    fourth, a hydrogen, is absent). Nitrogens turn over and count for nothing.
    """
    neighbours: list[list[int]] = [[] for _ in range(len(positions))]
    for a, b in np.asarray(bonds).tolist():
        neighbours[a].append(b)
        neighbours[b].append(a)
    angles = [
        (first, atom, second)
        for atom, own in enumerate(neighbours)
        for k, first in enumerate(own)
        for second in own[k + 1 :]
    ]
    threes = [(atom, *own[:3]) for atom, own in enumerate(neighbours) if len(own) in (3, 4)]
    corners = np.array(threes, dtype=np.int64).reshape(-1, 4)
    number = np.array([len(neighbours[atom]) for atom in corners[:, 0]], dtype=np.int64)
    planar = (number == 3) & (np.abs(out_of_plane(positions, corners)) < PLANAR)
    carbon = np.asarray(elements)[corners[:, 0]] == "C"
    handed = carbon & ~planar & (np.abs(volumes(positions, corners)) > HANDED)
    shape = np.array(angles, dtype=np.int64).reshape(-1, 3)
    return Corners(shape, corners[handed], corners[planar])


def angles_of(positions: np.ndarray, triples: np.ndarray) -> np.ndarray:
    """(A,) angles of triples end, middle, end; degrees."""
    one = positions[triples[:, 0]] - positions[triples[:, 1]]
    two = positions[triples[:, 2]] - positions[triples[:, 1]]
    cosine = np.einsum("ij,ij->i", one, two) / np.maximum(
        np.linalg.norm(one, axis=1) * np.linalg.norm(two, axis=1), 1e-300
    )
    return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))


def volumes(positions: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(H,) signed volume of the unit vectors from a centre to three neighbours, -1 to 1."""
    arms = positions[corners[:, 1:]] - positions[corners[:, :1]]
    arms = arms / np.maximum(np.linalg.norm(arms, axis=2, keepdims=True), 1e-300)
    return np.asarray(np.einsum("ij,ij->i", arms[:, 0], np.cross(arms[:, 1], arms[:, 2])))


def out_of_plane(positions: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(P,) distance of a centre from the plane of its three neighbours, Angstrom, with a sign."""
    centre, one, two, three = (positions[corners[:, k]] for k in range(4))
    normal = np.cross(two - one, three - one)
    length = np.linalg.norm(normal, axis=1)
    height = np.einsum("ij,ij->i", centre - one, normal)
    return np.asarray(np.divide(height, length, out=np.zeros_like(height), where=length > 0))


def torsions_of(positions: np.ndarray, quadruples: np.ndarray) -> np.ndarray:
    """(T,) torsion angles of four atoms each, degrees in [-180, 180]; 0 is cis."""
    a, b, c, d = (positions[quadruples[:, k]] for k in range(4))
    axis = c - b
    axis = axis / np.maximum(np.linalg.norm(axis, axis=1, keepdims=True), 1e-300)
    before = np.cross(b - a, axis)
    after = np.cross(axis, d - c)
    x = np.einsum("ij,ij->i", before, after)
    y = np.einsum("ij,ij->i", np.cross(before, axis), after)
    return np.asarray(np.degrees(np.arctan2(-y, x)))
