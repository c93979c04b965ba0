# SPDX-License-Identifier: MIT
"""What makes the ensembles that are compared, a row each."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant.lab.validity.alpha_carbons import amino_part, trace_of
from pliant.lab.validity.peers import drawn_frames, network_of
from pliant.lab.validity.references import read_quietly

NEAR, WIDE = 1.4, 2.8  #: Angstrom


@dataclass(frozen=True)
class Subject:
    """One structure, and its model."""

    model: pliant.MolecularModel

    @classmethod
    def of(cls, path: Path) -> Subject:
        """The residues of a file that are amino acids. Raises as ``build_model`` does."""
        structure = amino_part(read_quietly(path))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pliant.PliantWarning)  # of chain breaks, no hydrogens
            return cls(pliant.build_model(structure))


@dataclass(frozen=True)
class Ensemble:
    """One way to make frames."""

    name: str
    draw: Callable[[Subject, int, int], np.ndarray]  #: subject, frames, seed: (F, N, 3) Angstrom


def _sampled(sampler: str, amplitude: float) -> Callable[[Subject, int, int], np.ndarray]:
    def draw(subject: Subject, frames: int, seed: int) -> np.ndarray:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pliant.PliantWarning)
            options: dict[str, Any] = {"sampler": sampler, "amplitude": amplitude, "seed": seed}
            found = pliant.sample(subject.model, frames, **options)
        return np.asarray(found.positions)

    return draw


def _straight(network: str) -> Callable[[Subject, int, int], np.ndarray]:
    """Straight displacements along a network's modes, which nothing makes whole."""

    def draw(subject: Subject, frames: int, seed: int) -> np.ndarray:
        structure = subject.model.structure
        trace = trace_of(structure)
        residues = np.asarray(structure.residue_of)
        owners = {int(residues[atom]): k for k, atom in enumerate(trace.atoms)}
        owner = np.array([owners[int(residue)] for residue in residues])
        start = np.asarray(subject.model.positions)
        return drawn_frames(
            network_of(structure, trace, network), trace, start, owner, frames, WIDE
        )

    return draw


ENSEMBLES = (
    Ensemble("reach", _sampled("reach", NEAR)),
    Ensemble("turns", _sampled("turns", NEAR)),
    Ensemble("modes", _sampled("modes", NEAR)),
    Ensemble("modes wide", _sampled("modes", WIDE)),
    Ensemble("ANM", _straight("anm")),
    Ensemble("straight lines", _straight("shared")),
)
