# SPDX-License-Identifier: MIT
"""Candidates of one molecule, drawn from several starts, and which of them are kept."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import Structure
from pliant.jobs.conformers.options import ConformerOptions

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
    structure: Structure, options: ConformerOptions, threads: int = 1, *, both_hands: bool = False
) -> Drawn:
    """Candidates, as many from each of the starts; axes of atropisomers keep their hand, or take
    `both_hands`.

    Starts after the first are conformers of the first, relaxed with their rings shaken
    (src/pliant/jobs/conformers_task.hpp). There may be fewer of them than asked for.
    """
    if np.count_nonzero(structure.elements != HYDROGEN) < 2:  # nothing can turn
        alone = np.array(structure.positions)[None]
        return Drawn(alone, np.zeros(1, dtype=np.int64), np.zeros(1), alone, 0.0)
    drawn = _core._draw_conformers  # type: ignore[attr-defined]  # stubs have no private names
    asked = vars(options) | {"threads": threads, "both_hands": both_hands}
    return Drawn(*drawn(structure, asked))


def choose(
    structure: Structure,
    positions: npt.NDArray[np.float64],
    energies: npt.NDArray[np.float64],
    options: ConformerOptions,
) -> npt.NDArray[np.int64]:
    """Numbers of those that are kept, lowest energy (kcal/mol) first.

    None is within `rms` (heavy atoms, the least over symmetries) of one before it.
    """
    chosen = _core._choose_conformers  # type: ignore[attr-defined]
    return np.asarray(chosen(structure, positions, energies.tolist(), vars(options)))
