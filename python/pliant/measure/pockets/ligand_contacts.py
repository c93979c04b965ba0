# SPDX-License-Identifier: MIT
"""The contacts of ligands frame by frame (interaction fingerprints), and groups of their poses."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pliant._core import contacts
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.parts import Part, ReferenceStructure
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.sources import structure_of
from pliant.trajectory.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant._core import Structure
    from pliant.measure.stages.analysis import Analysis

#: of more frames so many are looked at, spread over all
MOST_FRAMES = 400
#: heavy atoms of a ligand at least
LEAST_ATOMS = 6
#: alpha carbons within so many Angstrom of a ligand at the start are superposed
SITE = 10.0
#: poses of one group are nearer than this on average, Angstrom
APART = 2.0


@dataclass(frozen=True)
class LigandFound:
    """One ligand: its contacts and its poses in the F frames looked at."""

    name: str  #: "A:XK2263"
    partners: list[tuple[str, str]]  #: (c,) residue, and kind of contact
    at_start: np.ndarray  #: (c,) bool
    seen: np.ndarray  #: (F, c) bool
    moved: np.ndarray  #: (F,) Angstrom, r.m.s. of heavy atoms from the start, its site superposed
    pose: np.ndarray  #: (F,) the group of each frame, from 0: the largest
    medoids: np.ndarray  #: (groups,) places of the frames that stand for them

    @property
    def share(self) -> np.ndarray:
        """(c,) in which share of the frames looked at there is each contact."""
        return np.asarray(self.seen.mean(axis=0))


@dataclass(frozen=True)
class LigandContacts(Part):
    """All ligands."""

    places: np.ndarray  #: (F,) of the frames looked at among those analysed
    ligands: tuple[LigandFound, ...] = ()


def ligand_contacts(analysis: Analysis) -> Iterator[LigandContacts]:
    """Of residues of 6 heavy atoms and more that are neither polymer nor water, and bonded to
    nothing else.

    Contacts are found anew in each frame, as `pliant.contacts` finds those of a structure.
    """
    ligands = ligands_of(analysis.atoms)
    if not ligands:
        return
    places = choose_frames(len(analysis.frames), MOST_FRAMES)
    start = analysis[ReferenceStructure].positions
    structure, labels = structure_of(analysis.universe), analysis.residue_labels
    seats = [_Seat(atoms, start) for atoms in ligands]
    for x in (start, *map(analysis.positions, places)):
        pairs = _pairs(structure, x)
        for seat in seats:
            seat.look(x, pairs)
    yield LigandContacts(places, tuple(seat.found(labels) for seat in seats))


def ligands_of(atoms: AtomGroup) -> list[AtomGroup]:
    """The ligands among some atoms, a residue each."""
    if not hasattr(atoms, "resnames") or not hasattr(atoms, "bonds") or not len(atoms.bonds):
        return []
    polymer = atoms.select_atoms("protein or nucleic")
    others = (atoms - polymer).residues
    found = []
    for residue in others if len(polymer) else ():
        own = residue.atoms
        bonded = own.bonds.indices.ravel()
        is_free = np.isin(bonded, own.ix).all()
        if is_free and np.count_nonzero(~is_hydrogen(own)) >= LEAST_ATOMS:
            found.append(own)
    return found


def _pairs(structure: Structure, positions: np.ndarray) -> list[tuple[str, int, int]]:
    """Kind and the two atoms of each contact."""
    structure.positions = positions
    rows = contacts(structure)
    return list(zip(rows["kind"].tolist(), rows["a"].tolist(), rows["b"].tolist(), strict=True))


class _Seat:
    """What is seen of one ligand, frame by frame, the start first."""

    def __init__(self, atoms: AtomGroup, start: np.ndarray) -> None:
        self._atoms, self._own = atoms, set(atoms.ix.tolist())
        self._heavy = atoms.ix[~is_hydrogen(atoms)]
        self._residue_of = atoms.universe.atoms.resindices
        trace = atoms.universe.select_atoms("(protein and name CA) or (nucleic and name C4')").ix
        away = np.linalg.norm(start[trace][:, None] - start[self._heavy], axis=2).min(axis=1)
        self._site = trace[away < SITE] if np.count_nonzero(away < SITE) >= 3 else trace
        self._fit = Superposition(start[self._site], np.ones(len(self._site)))
        self._poses: list[np.ndarray] = []
        self._contacts: list[set[tuple[int, str]]] = []

    def look(self, x: np.ndarray, pairs: list[tuple[str, int, int]]) -> None:
        """At positions (N, 3) of all atoms, and the contacts there."""
        own, of = self._own, self._residue_of
        others = [(kind, b if a in own else a) for kind, a, b in pairs if (a in own) != (b in own)]
        self._contacts.append({(int(of[other]), kind) for kind, other in others})
        self._poses.append(self._fit.apply(x[self._heavy], x[self._site]))

    def found(self, labels: list[str]) -> LigandFound:
        """All of it; labels: of the residues of the universe."""
        every = sorted(set().union(*self._contacts))
        seen = np.array([[one in here for one in every] for here in self._contacts], dtype=bool)
        seen = seen.reshape(len(self._contacts), len(every))
        poses, classes = np.array(self._poses), classes_of(self._atoms)
        pose, medoids = _groups(pose_distances(poses[1:], classes))
        return LigandFound(
            labels[self._atoms.residues[0].resindex],
            [(labels[residue], kind) for residue, kind in every],
            seen[0],
            seen[1:],
            pose_distances(poses, classes, first=1)[0, 1:],
            pose,
            medoids,
        )


def classes_of(atoms: AtomGroup) -> np.ndarray:
    """(n,) numbers of heavy atoms: the same for those that bonds and elements do not tell apart."""
    heavy = atoms[~is_hydrogen(atoms)]
    place = {atom: k for k, atom in enumerate(heavy.ix.tolist())}
    bonded: list[list[int]] = [[] for _ in place]
    for a, b in heavy.bonds.indices.tolist():
        if a in place and b in place:
            bonded[place[a]].append(place[b])
            bonded[place[b]].append(place[a])
    found = np.unique(heavy.elements.astype(str), return_inverse=True)[1].tolist()
    for _ in place:
        keys = [(found[k], sorted(found[j] for j in near)) for k, near in enumerate(bonded)]
        known = sorted({(one, tuple(others)) for one, others in keys})
        finer = [known.index((one, tuple(others))) for one, others in keys]
        if len(set(finer)) == len(set(found)):
            break
        found = finer
    return np.array(found)


def pose_distances(poses: np.ndarray, classes: np.ndarray, first: int | None = None) -> np.ndarray:
    """(first, P) r.m.s. distances, Angstrom, of poses (P, n, 3) as they lie, of the first ones
    (default: all).

    Each atom is compared with the nearest of its class: rings that turn over by symmetry do not
    count.
    """
    some = poses[:first]
    one, other = np.zeros((len(some), len(poses))), np.zeros((len(some), len(poses)))
    for kind in np.unique(classes):
        own = classes == kind
        for k, pose in enumerate(some[:, own]):
            apart = ((poses[:, own][:, None] - pose[None, :, None]) ** 2).sum(axis=3)
            one[k] += apart.min(axis=1).sum(axis=1)
            other[k] += apart.min(axis=2).sum(axis=1)
    return np.asarray(np.sqrt(np.maximum(one, other) / len(classes)))


def _groups(distances: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(F,) groups by average linkage, the largest first, and the frame that stands for each."""
    if len(distances) < 2:
        return np.zeros(len(distances), dtype=int), np.arange(len(distances))
    distances = (distances + distances.T) / 2
    tree = linkage(squareform(distances, checks=False), "average")
    _, of_frame = np.unique(fcluster(tree, APART, "distance"), return_inverse=True)
    order = np.argsort(-np.bincount(of_frame), kind="stable")
    of_frame = np.argsort(order)[of_frame]
    members = [np.flatnonzero(of_frame == k) for k in range(len(order))]
    medoids = [own[np.argmin(distances[np.ix_(own, own)].sum(axis=0))] for own in members]
    return of_frame, np.array(medoids)
