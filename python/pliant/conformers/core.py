# SPDX-License-Identifier: MIT
"""Candidates of one molecule, drawn from several starts, and which of them are kept."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import Structure

FRAMES = 500  #: candidates drawn of a molecule, from all of its starts
A_CONFORMER = 2  #: candidates for each conformer asked for, if that is more
HYDROGEN = 1


@dataclass(frozen=True)
class Drawn:
    """Candidates of one molecule."""

    positions: npt.NDArray[np.float64]  #: (F, N, 3) Angstrom
    start: npt.NDArray[np.int64]  #: (F,) which start each is drawn from
    score: npt.NDArray[np.float64]  #: (F,) kcal/mol, an energy of our own
    starts: npt.NDArray[np.float64]  #: (S, N, 3) Angstrom; the first is the structure itself
    worst_bar: float  #: largest error of a length that is held, over all candidates, relative


def draw(
    structure: Structure,
    starts: int,
    frames: int,
    seed: int,
    *,
    turn_amides: bool = False,
    threads: int = 1,
) -> Drawn:
    """`frames` candidates, as many from each of `starts` starts.

    Starts after the first are conformers of the first, relaxed with their rings shaken
    (src/pliant/jobs/conformers_task.hpp). There may be fewer of them than asked for.
    """
    if np.count_nonzero(structure.elements != HYDROGEN) < 2:  # nothing can turn
        alone = np.array(structure.positions)[None]
        return Drawn(alone, np.zeros(1, dtype=np.int64), np.zeros(1), alone, 0.0)
    drawn = _core._draw_conformers  # type: ignore[attr-defined]  # stubs have no private names
    made = drawn(structure, starts, frames, seed, turn_amides, threads)
    positions, of_start, energies, of_starts, worst, _, _ = made
    return Drawn(positions, of_start, energies, of_starts, worst)


def choose(
    structure: Structure,
    positions: npt.NDArray[np.float64],
    energies: npt.NDArray[np.float64],
    most: int,
    rms: float,
    window: float | None,
) -> npt.NDArray[np.int64]:
    """Numbers of at most `most` candidates, lowest energy (kcal/mol) first.

    None is within `rms` (Angstrom, heavy atoms, the least over symmetries) of one before it, nor
    more than `window` above the lowest; None: no window.
    """
    limit = float("inf") if window is None else window
    chosen = _core._choose_conformers  # type: ignore[attr-defined]
    return np.asarray(chosen(structure, positions, energies.tolist(), most, rms, limit))
