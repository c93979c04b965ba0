# SPDX-License-Identifier: MIT
"""Contacts of two structures of one molecule: which both have, and which are there in a frame."""

from __future__ import annotations

from typing import Any

import numpy as np

BROKEN = 0.1  #: a contact so far outside its interval is none, Angstrom


def names_of(atoms: dict[tuple[int, str], int]) -> dict[int, tuple[int, str]]:
    """Names by atom of atoms by name."""
    return {atom: name for name, atom in atoms.items()}


def keys(contacts: np.ndarray, names: dict[int, tuple[int, str]]) -> list[Any]:
    """What each contact joins, in either order; None where it is not between matched residues."""
    found: list[Any] = []
    for row in contacts:
        ends = (names.get(int(row["a"])), names.get(int(row["b"])))
        found.append(None if None in ends else (str(row["kind"]), *sorted(e for e in ends if e)))
    return found


def is_there(positions: np.ndarray, a: int, b: int, least: float, most: float) -> bool:
    """Whether two atoms of positions (N, 3) are as near as a contact wants them, Angstrom."""
    apart = float(np.linalg.norm(positions[a] - positions[b]))
    return least - BROKEN <= apart <= most + BROKEN


def off(positions: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    """(C,) how far the distance of each is outside its interval, Angstrom."""
    apart = np.linalg.norm(positions[contacts["a"]] - positions[contacts["b"]], axis=1)
    outside = np.maximum(apart - contacts["most"], contacts["least"] - apart)
    return np.asarray(np.maximum(0.0, outside))


def furthest_off(positions: np.ndarray, contacts: np.ndarray) -> float:
    """The largest of them; 0 where there are none."""
    return float(off(positions, contacts).max(initial=0.0))


def rms(moves: np.ndarray) -> float:
    """r.m.s. length of moves (n, 3)."""
    return float(np.sqrt(np.mean(np.sum(moves**2, axis=1))))
