# SPDX-License-Identifier: MIT
"""Pairs of known structures of one protein, each as two directions, and how a frame is judged.

The metric is that of BioEmu's multi-conformation benchmark (S. Lewis et al., Science 389 (2025)
eadv9817): domain motions by the r.m.s. distance of backbones, below 3 Angstrom; pockets by the mean
distance of the residues of the pocket once those that hold still are superposed, below 1.5.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant._core import InputError
from pliant.lab.structures import read_quietly
from pliant.measure import agreement

BACKBONE = ("N", "CA", "C", "O")
SUFFIXES = (".pdb", ".cif")
DOMAIN, POCKET = "domain motions", "pockets"
COVERED = {DOMAIN: 3.0, POCKET: 1.5}  #: Angstrom

Ranges = list[list[int | None]] | None


@dataclass(frozen=True)
class Direction:
    """From one structure to another."""

    protein: str
    start: Path
    goal: Path
    kind: str = DOMAIN
    superposed: Ranges = None  #: residue numbers, ends included; None: all
    measured: Ranges = None

    @property
    def name(self) -> str:
        """As in tables: "1AKE_A to 4AKE_A"."""
        return f"{self.start.stem} to {self.goal.stem}"


def directions_of(folder: Path) -> list[Direction]:
    """Both directions of each subfolder that holds two structures.

    Beside them ``local.json`` may hold ``alignment_resid_ranges`` and ``metric_resid_ranges``: then
    they are a pocket, as are all in a folder with ``references.csv``. Raises InputError where there
    is no pair.
    """
    found = []
    for place in sorted({path.parent for path in _structures(folder)}):
        files = [path for path in _structures(place) if path.parent == place]
        if len(files) != 2:
            continue
        local, kind = _local(place)
        for start, goal in (files, files[::-1]):
            found.append(
                Direction(
                    place.name,
                    start,
                    goal,
                    kind,
                    local.get("alignment_resid_ranges"),
                    local.get("metric_resid_ranges"),
                )
            )
    if not found:
        raise InputError(f"{folder}: no subfolder holds two structures (PDB, mmCIF)")
    return found


def _structures(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES)


def _local(place: Path) -> tuple[dict[str, Any], str]:
    path = place / "local.json"
    is_pocket = path.exists() or (place.parent / "references.csv").exists()
    try:
        local = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    except ValueError as error:
        raise InputError(f"{path}: no JSON: {error}") from None
    return local, POCKET if is_pocket else DOMAIN


class Judge:
    """Distances of frames of a structure, made of one direction's start, from its goal."""

    def __init__(self, direction: Direction, structure: pliant.Structure) -> None:
        self.direction, self.structure = direction, structure
        ours, theirs = _backbones(self.structure), _backbones(read_quietly(direction.goal))
        shared = [key for key in ours if key in theirs]
        if len(shared) < 3:
            raise InputError(
                f"{direction.start} and {direction.goal}: fewer than three residues of one number "
                "have a backbone in both"
            )
        self.atoms = np.array([ours[key][0] for key in shared])  #: (R, 4) of the structure
        self.goal = np.array([theirs[key][1] for key in shared])  #: (R, 4, 3) of the other
        self._fit = _within(shared, direction.superposed)
        self._part = _within(shared, direction.measured)

    def distances(self, frames: np.ndarray) -> np.ndarray:
        """(F,) Angstrom, of frames (F, N, 3) of the structure's atoms.

        Of domain motions and of pockets without residues of their own r.m.s., else the mean.
        """
        backbones = frames[:, self.atoms.ravel()]
        fit = (4 * self._fit[:, None] + np.arange(4)).ravel()
        part = (4 * self._part[:, None] + np.arange(4)).ravel()
        goal = self.goal.reshape(-1, 3)
        moved = agreement.superposed(backbones, goal, fit)[:, part]
        apart = np.linalg.norm(moved - goal[part], axis=2)
        if self.direction.measured is None:
            return np.asarray(np.sqrt((apart**2).mean(axis=1)))
        return np.asarray(apart.mean(axis=1))

    @cached_property
    def at_start(self) -> float:
        """Distance of the start itself (Angstrom)."""
        return float(self.distances(np.asarray(self.structure.positions)[None])[0])

    @property
    def limit(self) -> float:
        """Angstrom below which a frame covers the goal."""
        return COVERED[self.direction.kind]


def _backbones(structure: pliant.Structure) -> dict[int, tuple[list[int], np.ndarray]]:
    """Atoms N, CA, C and O and their positions by residue number; of the first with a number."""
    found: dict[int, dict[str, int]] = {}
    first: dict[int, int] = {}
    numbers, residues = structure.residue_ids, structure.residue_of
    for atom, name in enumerate(structure.names):
        number, residue = int(numbers[atom]), int(residues[atom])
        if str(name) in BACKBONE and first.setdefault(number, residue) == residue:
            found.setdefault(number, {}).setdefault(str(name), atom)
    positions = np.asarray(structure.positions)
    whole = {n: [at[name] for name in BACKBONE] for n, at in found.items() if len(at) == 4}
    return {number: (atoms, positions[atoms]) for number, atoms in whole.items()}


def _within(numbers: list[int], ranges: Ranges) -> np.ndarray:
    """Indices of residues whose numbers lie in the ranges, whose ends may be open (None)."""
    if ranges is None:
        return np.arange(len(numbers))
    return np.array([k for k, n in enumerate(numbers) if any(_inside(n, *r) for r in ranges)])


def _inside(number: int, first: int | None, last: int | None) -> bool:
    low = -math.inf if first is None else first
    high = math.inf if last is None else last
    return low <= number <= high
