# SPDX-License-Identifier: MIT
"""The molecule of a fit: its model, its nodes, and shapes in its reach."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from pliant._core import (
    InputError,
    MolecularModel,
    PathEnds,
    PathOptions,
    PathWalk,
    Structure,
    nodes_to_fit,
    sample,
)
from pliant.jobs.fit import in_map
from pliant.jobs.fit import nodes as at_nodes
from pliant.jobs.fit.data import Sites
from pliant.jobs.fit.fitted import ARRIVED, Whole
from pliant.trajectory.superposition import superpose_onto
from pliant.trajectory.trajectory import Trajectory

FRAMES = 400  #: of the ensemble that starts are taken from
LEAST_NODES = 10


class Molecule:
    """The molecule of a fit: its model, its nodes, and shapes in its reach."""

    def __init__(self, start: Any, seed: int, options: PathOptions) -> None:
        self.options = options
        self.start: Structure = options.start_of(start)
        self.model: MolecularModel = PathEnds.model_of(self.start, options)
        self.atoms, self.chains = nodes_to_fit(self.model.structure)
        if len(self.atoms) < LEAST_NODES:
            raise InputError(
                f"{self.start.source}: expected a protein or nucleic acid of {LEAST_NODES} "
                f"residues or more, found {len(self.atoms)}"
            )
        self.sites = Sites(self.model.structure, self.atoms)
        self._seed = seed
        self._rotation, self._shift = np.eye(3), np.zeros(3)  # into a map

    def sampled(self, frames: int | str | os.PathLike[str]) -> None:
        """Makes the ensemble, or reads it; the start is its first frame."""
        made = self._made(frames) if isinstance(frames, int) else self._read(frames)
        self.frames = np.concatenate([np.asarray(self.model.positions)[None], made])

    def _made(self, frames: int) -> np.ndarray:
        return np.asarray(sample(self.model, frames, seed=self._seed, sampler="reach").positions)

    def _read(self, path: str | os.PathLike[str]) -> np.ndarray:
        given = Trajectory(path)
        ours, theirs = self.structure, given.structure
        if len(ours) != len(theirs) or (ours.names != theirs.names).any():
            raise InputError(
                f"{os.fspath(path)}: expected frames of the {len(ours)} atoms of "
                f"{self.start.source}, prepared as pliant sample prepares it, found {len(theirs)} "
                "atoms, or others"
            )
        return np.asarray(given.positions)

    def place_into(self, data: in_map.MapData) -> None:
        """Finds where the start is in a map; else it stays where it is."""
        start = in_map.at(self.structure, np.asarray(self.model.positions))
        nodes = np.asarray(self.frames[:, self.atoms], dtype=np.float64)
        self._rotation, self._shift = data.motion(start, self.atoms, nodes)

    @property
    def structure(self) -> Structure:
        """The molecule, prepared."""
        return self.model.structure

    @property
    def placed(self) -> np.ndarray:
        """(N, 3) the start, in the map if there is one."""
        return np.asarray(self.model.positions) @ self._rotation + self._shift

    @property
    def ensemble(self) -> at_nodes.Ensemble:
        """At the nodes, in the map if there is one."""
        nodes = np.ascontiguousarray(self.frames[:, self.atoms], dtype=np.float64)
        nodes = nodes @ self._rotation + self._shift
        return at_nodes.Ensemble(nodes[0], nodes, self.chains)

    def brought(self, fits: at_nodes.NodeFits, k: int) -> Whole:
        """All atoms, walked to the places of the residues of a fit, exactly: from its frame, which
        is near; from the start, too, where something is in the way."""
        found = self._walked(fits.positions[k], self.frames[fits.frames[k]])
        if found.short_of_fit <= ARRIVED:
            return found
        other = self._walked(fits.positions[k], self.frames[0])
        return min(found, other, key=lambda one: one.short_of_fit)

    def _walked(self, goal: np.ndarray, begun: np.ndarray) -> Whole:
        begun = np.asarray(begun, dtype=np.float64)
        here = superpose_onto(goal[None], slice(None), begun[self.atoms])[0]
        ends = PathEnds.at(self.start, self.atoms, here, self.options, begun)
        walk = PathWalk(ends, self.options)
        while walk.advance():
            pass
        last, positions = walk.table()[-1], np.asarray(walk.positions()[-1])
        positions = superpose_onto(positions[None], self.atoms, goal)[0]
        return Whole(
            positions, walk.left, ends.only_start, last.max_residual, last.overlap, last.tightest
        )
