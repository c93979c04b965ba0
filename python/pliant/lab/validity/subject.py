# SPDX-License-Identifier: MIT
"""A start structure with all that is made of it: its model, ensembles, networks and looks."""

from __future__ import annotations

import os
import time
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

import pliant
from pliant.lab.validity.alpha_carbons import Trace, amino_part, chain_part, heavy_part, trace_of
from pliant.lab.validity.peers import Network, drawn_frames, network_of
from pliant.lab.validity.references import read_quietly
from pliant.lab.validity.stereochemistry import Checker, Stereochemistry

AMPLITUDE = 1.4
FAR = 2.8


@dataclass
class Drawn:
    """An ensemble on its alpha carbons."""

    frames: np.ndarray  #: (F, R, 3) Angstrom
    seconds: float  #: of processor time, the network included
    redrawn: int
    failed: int
    rmsf: float  #: mean of alpha carbons, Angstrom
    look: Stereochemistry  #: at all atoms


class Subject:
    """The residues of a file, or of one chain, that are amino acids.

    Nothing is random but by its seed.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        frames: int,
        *,
        polar_hydrogens: bool = False,
        chain: str = "",
    ) -> None:
        part = chain_part(amino_part(read_quietly(path)), chain)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pliant.PliantWarning)  # of chain breaks
            self.model = pliant.build_model(heavy_part(part) if polar_hydrogens else part)
        self.path = os.fspath(path)
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
        began = time.process_time()
        found = self._sample(self._frames, sampler, amplitude, seed)
        seconds = time.process_time() - began
        return Drawn(
            np.array(found.positions[:, self.trace.atoms]),
            seconds,
            found.redrawn,
            found.failed,
            float(found.rmsf[self.trace.atoms].mean()),
            self.checker.look(found.positions),
        )

    def _sample(
        self, frames: int, sampler: str, amplitude: float = AMPLITUDE, seed: int = 0
    ) -> pliant.SampledEnsemble:
        has_near = any(row.name == sampler and row.near_sampler for row in pliant.samplers())
        near = max(frames // 2, 1) if has_near else 0
        options: dict[str, Any] = {"sampler": sampler, "amplitude": amplitude, "seed": seed}
        return pliant.sample(self.model, frames, near_frames=near, **options)

    def network(self, name: str) -> Network:
        """Modes of a network of the alpha carbons."""
        if name not in self._networks:
            self._networks[name] = network_of(self.model.structure, self.trace, name)
        return self._networks[name]

    def anm_look(self) -> Stereochemistry:
        """At as many frames of ANM, all atoms, with the mean RMSF that ours reached."""
        residues = np.asarray(self.model.structure.residue_of)
        owners = {int(residues[atom]): k for k, atom in enumerate(self.trace.atoms)}
        owner = np.array([owners[int(residue)] for residue in residues])
        start = np.asarray(self.model.positions)
        frames = drawn_frames(
            self.network("anm"), self.trace, start, owner, self._frames, self.ensemble().rmsf
        )
        return self.checker.look(frames)

    def seconds_a_frame(self, sampler: str = "modes") -> float:
        """Processor time of a frame, without what comes before frames."""
        whole = self.ensemble(sampler=sampler).seconds
        return (whole - self.seconds_of_one(sampler)) / max(self._frames - 1, 1)

    def seconds_of_one(self, sampler: str = "modes") -> float:
        """Processor time of what comes before frames, and one frame."""
        began = time.process_time()
        self._sample(1, sampler)
        return time.process_time() - began
