# SPDX-License-Identifier: MIT
"""Whether the pocket of a ligand is among frames of its protein alone.

Frames are superposed on the structure with the ligand by the alpha carbons around it. An atom of
the ligand *is free* if no heavy atom overlaps it more than contacts in crystals do. It *fits* if it
is free and the protein no further off than half a water: in an open cleft all of it is free.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation

from pliant._core import InputError, Structure, align
from pliant.lab.structures import amino_part, chain_part, trace_of
from pliant.lab.validity.clashes import RADII
from pliant.lab.validity.rows import NO, Row
from pliant.lab.validity.subject import Subject
from pliant.trajectory.superposition import superpose_onto

OVERLAP = 0.5  #: of van der Waals radii, Angstrom
WATER = 1.4  #: radius of a water, Angstrom
AROUND = 6.0  #: of the ligand, Angstrom
ENOUGH = 0.9  #: of what fits in the structure with the ligand


def radii_of(elements: np.ndarray) -> np.ndarray:
    """Van der Waals radii, Angstrom; others, such as phosphorus, have that of sulphur."""
    return np.array([RADII.get(int(element), RADII[16]) for element in elements])


def shares(
    ligands: np.ndarray, own: np.ndarray, frames: np.ndarray, others: np.ndarray
) -> np.ndarray:
    """(F, 2) which share of a ligand's atoms is free and which fits, in each frame.

    `ligands` (F, L, 3) have the radii `own` (L,), `frames` (F, N, 3) `others` (N,); Angstrom.
    """
    both = zip(ligands, frames, strict=True)
    gaps = np.array([(cdist(ligand, frame) - others).min(axis=1) for ligand, frame in both]) - own
    is_free = gaps >= -OVERLAP
    found: np.ndarray = np.stack([is_free, is_free & (gaps <= WATER)], axis=2).mean(axis=1)
    return found


class Site:
    """Where a ligand, the first of its name, lies in a structure, or in one chain.

    Raises InputError where there is none, and as `amino_part` and `chain_part` do.
    """

    def __init__(self, whole: Structure, name: str, chain: str = "") -> None:
        self.name = name
        is_ligand = (whole.residue_names == name) & (whole.elements > 1)
        if chain:
            is_ligand &= whole.chains == chain
        named, residues = np.flatnonzero(is_ligand), np.asarray(whole.residue_of)
        if len(named) == 0:
            raise InputError(f"{whole.source}: no ligand is named '{name}'")
        atoms = named[residues[named] == residues[named[0]]]
        self.ligand = whole.positions[atoms]
        self.radii = radii_of(whole.elements[atoms])
        protein = chain_part(amino_part(whole), chain)
        heavy = np.flatnonzero(protein.elements > 1)
        frame = protein.positions[heavy]
        near = heavy[(cdist(frame, self.ligand) < AROUND).any(axis=1)]
        self.trace = trace_of(protein)
        self.residues = np.unique(self.trace.owners(protein)[near])
        others = radii_of(protein.elements[heavy])
        self.held = shares(self.ligand[None], self.radii, frame[None], others)[0]


class Host:
    """A subject where a ligand of its protein may go."""

    def __init__(self, subject: Subject, site: Site) -> None:
        self.subject, self.site = subject, site
        elements = subject.model.structure.elements
        self._heavy = np.flatnonzero(elements > 1)
        self._radii = radii_of(elements[self._heavy])
        pairs = align(subject.trace.sequence, site.trace.sequence)
        pairs = pairs[np.isin(pairs[:, 1], site.residues)]
        self._fit = subject.trace.atoms[pairs[:, 0]]
        self._there = site.trace.positions[pairs[:, 1]]

    def drawn(self, sampler: str, seed: int) -> tuple[np.ndarray, np.ndarray]:
        """`shares` where the ligand lies, and with one place of `elsewhere` a frame."""
        around = f"index {' '.join(map(str, self._fit))}" if sampler == "pocket" else ""
        found = self.subject.sample(sampler, seed=seed, around=around)
        self.subject.looks.append(self.subject.checker.look(found.positions))
        frames = self._placed(found.positions)
        places = elsewhere(self.site.ligand, frames, seed)
        return self._shares(self._bound(frames), frames), self._shares(places, frames)

    def at_start(self) -> np.ndarray:
        """`shares` of the start."""
        start = self._placed(np.asarray(self.subject.model.positions)[None])
        found: np.ndarray = self._shares(self._bound(start), start)[0]
        return found

    def _bound(self, frames: np.ndarray) -> np.ndarray:
        return np.broadcast_to(self.site.ligand, (len(frames), *self.site.ligand.shape))

    def _placed(self, frames: np.ndarray) -> np.ndarray:
        """Heavy atoms, superposed on the structure with the ligand."""
        return superpose_onto(frames, self._fit, self._there)[:, self._heavy]

    def _shares(self, ligands: np.ndarray, frames: np.ndarray) -> np.ndarray:
        return shares(ligands, self.site.radii, frames, self._radii)


def elsewhere(ligand: np.ndarray, frames: np.ndarray, seed: int) -> np.ndarray:
    """(F, L, 3) the ligand at one random place in each frame: turned, its middle on an atom."""
    atoms = np.random.default_rng(seed).integers(frames.shape[1], size=len(frames))
    turns = Rotation.random(len(frames), random_state=seed).as_matrix()
    middles = frames[np.arange(len(frames)), atoms][:, None]
    found: np.ndarray = (ligand - ligand.mean(axis=0)) @ turns + middles
    return found


def pocket_rows(host: Host, sampler: str, seeds: int, name: str, data: str) -> list[Row]:
    """The best frame of each seed, mean; how many reach `ENOUGH`, and chance, are in the notes."""
    here, chance = np.swapaxes([host.drawn(sampler, seed) for seed in range(seeds)], 0, 1)
    start, held = host.at_start(), host.site.held
    rows = []
    for k, what in enumerate(("free", "fits")):
        best, least = here[:, :, k].max(axis=1), ENOUGH * held[k]
        note = (
            f"{start[k]:.3f} in the start, {held[k]:.3f} with the ligand; "
            f"{_reached(here[:, :, k], least)}; elsewhere {_reached(chance[:, :, k], least)}"
        )
        figure = f"{host.site.name} {what}, best frame of {sampler}"
        error = float(best.std(ddof=1) / np.sqrt(seeds)) if seeds > 1 else NO
        rows.append(Row(name, figure, float(best.mean()), error, data=data, note=note))
    if start[1] < ENOUGH * held[1]:
        rows[1].must, rows[1].aim = ENOUGH * held[1], held[1]
    return rows


def _reached(found: np.ndarray, least: float) -> str:
    """The best of each seed, and in how many frames that much is reached."""
    best = ", ".join(f"{one.max():.3f}" for one in found)
    many = ", ".join(str(np.count_nonzero(one >= least)) for one in found)
    return f"{best}, with {least:.3f} in {many} of {found.shape[1]}"
