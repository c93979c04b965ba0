# SPDX-License-Identifier: MIT
"""A start structure with all that is made of it: its model, ensembles, networks and looks."""

from __future__ import annotations

import os
import time
import warnings
from dataclasses import dataclass

import numpy as np

import pliant
from pliant.lab.validity.alpha_carbons import Trace, amino_part, heavy_part, trace_of
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
    """The residues of a file that are amino acids. Nothing is random but by its seed."""

    def __init__(
        self, path: str | os.PathLike[str], frames: int, *, polar_hydrogens: bool = False
    ) -> None:
        part = amino_part(read_quietly(path))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pliant.PliantWarning)  # of chain breaks
            self.model = pliant.build_model(heavy_part(part) if polar_hydrogens else part)
        self.path = os.fspath(path)
        self.trace: Trace = trace_of(self.model.structure)
        self.checker = Checker(self.model)
        self.looks: list[Stereochemistry] = []
        self._frames = frames
        self._drawn: dict[tuple[int, float], Drawn] = {}
        self._networks: dict[str, Network] = {}

    def ensemble(self, seed: int = 0, amplitude: float = AMPLITUDE) -> Drawn:
        """As many frames as asked for, made once, on one thread."""
        key = (seed, amplitude)
        if key not in self._drawn:
            self._drawn[key] = self._draw(seed, amplitude)
            self.looks.append(self._drawn[key].look)
        return self._drawn[key]

    def _draw(self, seed: int, amplitude: float) -> Drawn:
        began = time.process_time()
        found = pliant.sample(
            self.model, self._frames, amplitude=amplitude, seed=seed, sampler="modes"
        )
        seconds = time.process_time() - began
        return Drawn(
            np.array(found.positions[:, self.trace.atoms]),
            seconds,
            found.redrawn,
            found.failed,
            float(found.rmsf[self.trace.atoms].mean()),
            self.checker.look(found.positions),
        )

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

    def seconds_a_frame(self) -> float:
        """Processor time of a frame, without what comes before frames."""
        return (self.ensemble().seconds - self.seconds_of_one()) / max(self._frames - 1, 1)

    def seconds_of_one(self) -> float:
        """Processor time of what comes before frames, and one frame."""
        began = time.process_time()
        pliant.sample(self.model, 1)
        return time.process_time() - began
