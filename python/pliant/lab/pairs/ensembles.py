# SPDX-License-Identifier: MIT
"""What makes the ensembles that are compared, a row each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

import pliant
from pliant._core import MolecularModel
from pliant.lab.structures import quiet, trace_of
from pliant.lab.validity.peers import drawn_frames, network_of

NEAR, WIDE = 1.4, 2.8  #: Angstrom

#: Of a model, so many frames, a seed: (F, N, 3) Angstrom.
Draw = Callable[[MolecularModel, int, int], np.ndarray]


@dataclass(frozen=True)
class Ensemble:
    """One way to make frames."""

    name: str
    draw: Draw


def sampled(
    model: MolecularModel, frames: int, seed: int, sampler: str = "modes", amplitude: float = NEAR
) -> np.ndarray:
    """By ``pliant.sample``."""
    options: dict[str, Any] = {"sampler": sampler, "amplitude": amplitude, "seed": seed}
    with quiet():
        return np.asarray(pliant.sample(model, frames, **options).positions)


def straight(model: MolecularModel, frames: int, seed: int, *, network: str) -> np.ndarray:
    """Straight displacements along a network's modes, which nothing makes whole."""
    structure = model.structure
    trace = trace_of(structure)
    start, owner = np.asarray(model.positions), trace.owners(structure)
    return drawn_frames(network_of(structure, trace, network), trace, start, owner, frames, WIDE)


ENSEMBLES = (
    Ensemble("reach", partial(sampled, sampler="reach")),
    Ensemble("turns", partial(sampled, sampler="turns")),
    Ensemble("modes", sampled),
    Ensemble("modes wide", partial(sampled, amplitude=WIDE)),
    Ensemble("ANM", partial(straight, network="anm")),
    Ensemble("straight lines", partial(straight, network="shared")),
)
