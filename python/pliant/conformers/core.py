# SPDX-License-Identifier: MIT
"""Starts of one molecule, candidates drawn from them, and which of these are kept."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import Structure
from pliant._extras import is_there

FRAMES = 1000  #: candidates drawn of a molecule, from all of its starts
HYDROGEN = 1


@dataclass(frozen=True)
class Drawn:
    """Candidates of one molecule."""

    positions: npt.NDArray[np.float64]  #: (F, N, 3) Angstrom
    start: npt.NDArray[np.int64]  #: (F,) which start each is drawn from
    score: npt.NDArray[np.float64]  #: (F,) kcal/mol, an energy of our own
    worst_bar: float  #: Angstrom; largest error of a length that is held, over all candidates


def draw(starts: Sequence[Structure], frames: int, seed: int, **options: Any) -> Drawn:
    """`frames` candidates, as many from each start; `options` are those of `pliant.sample`."""
    shares = [frames // len(starts) + (k < frames % len(starts)) for k in range(len(starts))]
    positions, worst = [], 0.0
    for start, share in zip(starts, shares, strict=True):
        if share == 0:
            continue
        if np.count_nonzero(start.elements != HYDROGEN) < 2:  # nothing can turn
            positions.append(np.array(start.positions)[None])
            continue
        made = _core.sample(start, share, seed=seed, sampler="torsions", **options)
        positions.append(made.positions)
        worst = max(worst, made.max_residual)
    of_start = np.repeat(np.arange(len(positions)), [len(one) for one in positions])
    drawn = np.concatenate(positions)
    return Drawn(drawn, of_start, np.zeros(len(drawn)), worst)


def more_starts(structure: Structure, count: int, seed: int) -> list[Structure]:
    """`count` starts with other lengths and angles; the first is the structure itself."""
    if count == 1 or not is_there("rdkit"):
        return [structure]
    from pliant.adapters.rdkit import to_rdkit
    from pliant.adapters.smiles import embed

    starts = [structure]
    molecule = to_rdkit(structure)
    for k in range(1, count):
        if not embed(molecule, seed + k):
            break
        start = copy(structure)
        start.positions = molecule.GetConformer().GetPositions()
        starts.append(start)
    return starts


def choose(
    structure: Structure,
    positions: npt.NDArray[np.float64],
    energies: npt.NDArray[np.float64],
    most: int,
    rms: float,
    window: float | None,
) -> npt.NDArray[np.int64]:
    """Numbers of at most `most` candidates, lowest energy (kcal/mol) first.

    None is within `rms` (Angstrom, heavy atoms) of one before it, nor more than `window` above the
    lowest; None: no window.
    """
    heavy = np.flatnonzero(structure.elements != HYDROGEN)
    order = np.argsort(energies, kind="stable")
    if window is not None:
        order = order[energies[order] <= energies[order[0]] + window]
    kept: list[int] = []
    for k in order.tolist():
        if len(kept) == most:
            break
        if rms == 0 or not kept or _nearest(positions[kept][:, heavy], positions[k, heavy]) >= rms:
            kept.append(k)
    return np.array(kept, dtype=np.int64)


def _nearest(those: npt.NDArray[np.float64], this: npt.NDArray[np.float64]) -> float:
    """The least r.m.s. distance of (M, n, 3) to (n, 3), best superposed (Kabsch 1976), Angstrom."""
    those, this = those - those.mean(axis=1, keepdims=True), this - this.mean(axis=0)
    products = np.einsum("mni,nj->mij", those, this)
    singular = np.linalg.svd(products, compute_uv=False)
    overlap = singular[:, 0] + singular[:, 1] + np.sign(np.linalg.det(products)) * singular[:, 2]
    squares = np.sum(those**2, axis=(1, 2)) + np.sum(this**2) - 2 * overlap
    return float(np.sqrt(max(squares.min(), 0.0) / len(this)))
