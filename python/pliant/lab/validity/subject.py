# SPDX-License-Identifier: MIT
"""A start structure with all that is made of it: its model, ensembles, networks and looks."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np

import pliant
from pliant.lab.structures import Trace, protein_model, trace_of
from pliant.lab.validity.peers import Network, drawn_frames, network_of
from pliant.lab.validity.stereochemistry import Checker, Stereochemistry

AMPLITUDE = 1.4
FAR = 2.8


@dataclass
class Drawn:
    """An ensemble on its alpha carbons."""

    frames: np.ndarray  #: (F, R, 3) Angstrom
    redrawn: int
    failed: int
    rmsf: float  #: mean of alpha carbons, Angstrom
    look: Stereochemistry  #: at all atoms


class Subject:
    """The residues of a file, or of one chain, that are amino acids.

    Nothing is random but by its seed.
    """

    def __init__(self, path: str | os.PathLike[str], frames: int, *, chain: str = "") -> None:
        self.model = protein_model(path, chain=chain)
        self.trace: Trace = trace_of(self.model.structure)
        self.checker = Checker(self.model)
        self.looks: list[Stereochemistry] = []
        self._frames = frames
        self._drawn: dict[tuple[int, float, str], Drawn] = {}
        self._networks: dict[str, Network] = {}

    def ensemble(
        self, seed: int = 0, amplitude: float = AMPLITUDE, sampler: str = "modes"
    ) -> Drawn:
        """As many frames as asked for, made once, on one thread."""
        key = (seed, amplitude, sampler)
        if key not in self._drawn:
            self._drawn[key] = self._draw(seed, amplitude, sampler)
            self.looks.append(self._drawn[key].look)
        return self._drawn[key]

    def _draw(self, seed: int, amplitude: float, sampler: str) -> Drawn:
        found = self.sample(sampler, amplitude, seed)
        return Drawn(
            np.array(found.positions[:, self.trace.atoms]),
            found.redrawn,
            found.failed,
            float(found.rmsf[self.trace.atoms].mean()),
            self.checker.look(found.positions),
        )

    def sample(
        self, sampler: str, amplitude: float = AMPLITUDE, seed: int = 0, around: str = ""
    ) -> pliant.SampledEnsemble:
        """As many frames as asked for; `around` is for sampler ``pocket``."""
        has_near = any(row.name == sampler and row.near_sampler for row in pliant.samplers())
        near = max(self._frames // 2, 1) if has_near else 0
        options: dict[str, Any] = {"sampler": sampler, "amplitude": amplitude, "seed": seed}
        return pliant.sample(self.model, self._frames, near_frames=near, around=around, **options)

    def network(self, name: str) -> Network:
        """Modes of a network of the alpha carbons."""
        if name not in self._networks:
            self._networks[name] = network_of(self.model.structure, self.trace, name)
        return self._networks[name]

    def anm_look(self) -> Stereochemistry:
        """At as many frames of ANM, all atoms, with the mean RMSF that ours reached."""
        start, owner = np.asarray(self.model.positions), self.trace.owners(self.model.structure)
        frames = drawn_frames(
            self.network("anm"), self.trace, start, owner, self._frames, self.ensemble().rmsf
        )
        return self.checker.look(frames)
