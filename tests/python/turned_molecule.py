# SPDX-License-Identifier: MIT
"""A molecule whose parts turn about its bonds, and a shell of atoms."""

import numpy as np

SYMBOLS = {1: "H", 6: "C", 7: "N", 8: "O", 16: "S"}


class Molecule:
    """A molecule as the tests need it: atoms, bonds and frames whose bonds keep their lengths."""

    def __init__(self, elements, bonds, positions, names=None, residues=None):
        self.elements = np.asarray(elements)
        self.bonds = np.asarray(bonds)
        self.positions = np.asarray(positions, dtype=float)
        counts = np.arange(1, len(self.elements) + 1)
        self.names = names or [
            f"{SYMBOLS[e]}{k}" for e, k in zip(self.elements, counts, strict=True)
        ]
        self.residues = residues or [("UNK", 1, "", range(len(self.elements)))]

    @property
    def rest_lengths(self):
        ends = self.positions[self.bonds]
        return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)

    def side(self, j, k):
        """The atoms on k's side of the bond j-k, which is in no ring."""
        found, waiting = {k}, [k]
        while waiting:
            atom = waiting.pop()
            for a, b in self.bonds:
                for one, other in ((a, b), (b, a)):
                    if one == atom and other not in found and (one, other) != (k, j):
                        found.add(int(other))
                        waiting.append(int(other))
        return sorted(found)

    def turned(self, positions, j, k, degrees):
        """Positions after k's side of the bond j-k was turned about it."""
        axis = positions[k] - positions[j]
        moved = positions.copy()
        side = self.side(j, k)
        moved[side] = rotated(positions[side] - positions[k], axis, degrees) + positions[k]
        return moved


def rotated(vectors, axis, degrees):
    """Rodrigues' formula: vectors (n, 3) turned about an axis through the origin."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return vectors * c + np.cross(axis, vectors) * s + np.outer(vectors @ axis, axis) * (1 - c)


def shell(radius, count):
    """Points spread evenly over a sphere (a spiral in steps of the golden angle)."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    flat = np.sin(polar)
    return radius * np.stack([np.cos(turn) * flat, np.sin(turn) * flat, np.cos(polar)], axis=1)
