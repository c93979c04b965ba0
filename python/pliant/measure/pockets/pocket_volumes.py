# SPDX-License-Identifier: MIT
"""The volume of pockets, frame by frame: sites of ligands, of the start, and what opens."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import cKDTree

from pliant.measure.pockets.opened_pockets import LEAST_GROWTH, why_no_pockets
from pliant.measure.pockets.pocket_grid import RADII, SPACING, Room, find_pockets, room_among
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.parts import Part, ReferenceStructure, Units
from pliant.trajectory.chosen_frames import choose_frames

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.stages.analysis import Analysis

#: frames whose pockets are measured, spread over all
LOOKED_AT = 100
#: chains shorter than this have no pockets
LEAST_CHAIN = 20
#: heavy atoms of the smallest ligand whose site is measured
LEAST_LIGAND = 6
#: atoms within this distance of a ligand line its site, Angstrom
LINING = 4.5
#: a pocket of fewer atoms has no inside
LEAST_LINING = 12
#: a pocket of the start is measured from this volume on, Angstrom^3; with less at the start, which
#: is hardly room for a benzene (83), one that grows opens, with more it is open and widens
LEAST_VOLUME = 100.0
#: a frame has a gap instead of a pocket where less of the room is enclosed than this share of what
#: is at the start: the lining has come apart
LEAST_KEPT = 0.5
#: most sites of ligands, pockets of the start, and pockets that grow
MOST_SITES, MOST_AT_START, MOST_GROWN = 3, 2, 2
#: frames, besides one of each other shape, in which pockets that grow are looked for
SEARCHED = 4
#: two pockets are one where the smaller shares more of its residues than this
SAME = 0.5
WATERS = ("HOH", "WAT", "DOD", "SOL", "TIP3", "TIP4", "SPC")


@dataclass(frozen=True)
class Pocket:
    """A pocket: the atoms that line it, and its room in the frames looked at."""

    name: str  #: for readers
    lining: np.ndarray  #: (k,) indices of atoms
    residues: np.ndarray  #: (r,) resindices of these
    at_start: float  #: Angstrom^3
    error: float  #: of the grid: r.m.s. difference from one of half the spacing, at the start
    volumes: np.ndarray  #: (f,) Angstrom^3
    is_gap: np.ndarray  #: (f,) bool: its lining has come apart there, so that it has no volume

    @property
    def smallest(self) -> int:
        """The place of the frame with the least room, among those looked at that have no gap."""
        return int(np.argmin(np.where(self.is_gap, np.inf, self.volumes)))

    @property
    def largest(self) -> int:
        """The place of the frame with the most room."""
        return int(np.argmax(np.where(self.is_gap, -np.inf, self.volumes)))

    @property
    def mean(self) -> float:
        """Over the frames without a gap, Angstrom^3."""
        return float(self.volumes[~self.is_gap].mean())


@dataclass(frozen=True)
class PocketVolumes(Part):
    """The pockets that were measured."""

    pockets: tuple[Pocket, ...]
    places: np.ndarray  #: (f,) of the frames looked at, among those analysed


class _Surroundings:
    """The heavy atoms that take up room: all but ligands and waters, which count as empty."""

    def __init__(self, analysis: Analysis, left_out: AtomGroup) -> None:
        atoms = analysis.universe.atoms
        atoms = atoms[~is_hydrogen(atoms) & ~np.isin(atoms.resnames, WATERS)] - left_out
        self.atoms: np.ndarray = atoms.ix
        self.residues: np.ndarray = atoms.resindices
        self.radii = np.array([RADII.get(e.capitalize(), RADII["C"]) for e in atoms.elements])

    def room(self, positions: np.ndarray, lining: np.ndarray) -> Room:
        """Room among atoms (places among those of this), of positions (N, 3) of all."""
        return room_among(positions[self.atoms], self.radii, lining)

    def error(self, positions: np.ndarray, lining: np.ndarray) -> float:
        """How far the grid is off, Angstrom^3."""
        own = positions[self.atoms], self.radii, lining
        fine = room_among(*own, spacing=SPACING / 2).enclosed
        coarse = np.array([room_among(*own, offset=k / 4).enclosed for k in range(4)])
        return float(np.sqrt(np.mean((coarse - fine) ** 2)))

    def found(self, positions: np.ndarray) -> list[np.ndarray]:
        """The atoms that line each pocket, the largest pocket first."""
        found = find_pockets(positions[self.atoms], self.radii)
        points = np.bincount(found.pocket) if len(found.pocket) else np.zeros(0)
        large = np.flatnonzero(points * found.volume >= LEAST_VOLUME)
        return [np.unique(found.atom[found.pocket == k]) for k in large]

    def beside(self, positions: np.ndarray, ligand: np.ndarray) -> np.ndarray:
        """The atoms within LINING of those of a ligand (indices)."""
        apart, _ = cKDTree(positions[ligand]).query(positions[self.atoms])
        return np.flatnonzero(apart <= LINING)


def ligands(atoms: AtomGroup) -> list[AtomGroup]:
    """Heavy atoms of each residue that is no polymer, water or part of a chain, largest first."""
    heavy = atoms[~is_hydrogen(atoms)]
    others = heavy - heavy.select_atoms("protein or nucleic")
    bonded = np.zeros(0, dtype=np.int64)
    if hasattr(atoms.universe, "bonds"):
        ends = atoms.universe.atoms.resindices[atoms.universe.bonds.indices]
        bonded = np.unique(ends[ends[:, 0] != ends[:, 1]])
    found = [
        residue.atoms & others
        for residue in others.residues
        if residue.resname not in WATERS and residue.ix not in bonded
    ]
    return sorted((one for one in found if len(one) >= LEAST_LIGAND), key=lambda one: -len(one))


def pocket_volumes(analysis: Analysis) -> Iterator[PocketVolumes]:
    """Volumes of pockets in frames spread over all; nothing without a chain of residues.

    ValueError says why there are none to be looked for.
    """
    if np.count_nonzero(analysis[Units].of_chain) < LEAST_CHAIN:
        return
    kept = ligands(analysis.universe.atoms)
    if why := why_no_pockets(analysis.universe.atoms):
        raise ValueError(why)
    around = _Surroundings(analysis, sum(kept[1:], kept[0]) if kept else analysis.atoms[:0])
    start = analysis[ReferenceStructure].positions
    lined = _lined(analysis, around, kept)
    places = choose_frames(len(analysis.frames), LOOKED_AT)
    rooms = []
    for place in places:
        positions = analysis.positions(place)
        rooms.append([around.room(positions, lining) for lining in lined.values()])
    pockets = tuple(
        _pocket(around, start, name, lining, [row[k] for row in rooms])
        for k, (name, lining) in enumerate(lined.items())
    )
    if measured := tuple(pocket for pocket in pockets if not pocket.is_gap.all()):
        few = f"pockets were measured in {len(places)} of the {len(analysis.frames)} frames"
        yield PocketVolumes(measured, places, notes=(few,) * (len(places) < len(analysis.frames)))


def _pocket(
    around: _Surroundings, start: np.ndarray, name: str, lining: np.ndarray, rooms: list[Room]
) -> Pocket:
    at_start = around.room(start, lining)
    return Pocket(
        name,
        around.atoms[lining],
        np.unique(around.residues[lining]),
        at_start.enclosed,
        around.error(start, lining),
        np.array([room.enclosed for room in rooms]),
        np.array([_is_gap(room, at_start) for room in rooms]),
    )


def _is_gap(room: Room, at_start: Room) -> bool:
    return room.share < LEAST_KEPT * at_start.share


def _lined(
    analysis: Analysis, around: _Surroundings, kept: list[AtomGroup]
) -> dict[str, np.ndarray]:
    """The atoms that line each pocket, by the pocket's name."""
    start = analysis[ReferenceStructure].positions
    labels = analysis.residue_labels
    lined: dict[str, np.ndarray] = {}
    for ligand in kept:
        lining = around.beside(start, ligand.ix)
        if len(lining) >= LEAST_LINING and len(lined) < MOST_SITES:
            lined[f"site of {labels[ligand.resindices[0]]}"] = lining
    sites = len(lined)
    for lining in around.found(start):
        if len(lined) < sites + MOST_AT_START and _is_new(around, lining, lined):
            lined[f"pocket {len(lined) - sites + 1}"] = lining
    for lining in _grown(analysis, around, lined):
        is_open = around.room(start, lining).enclosed >= LEAST_VOLUME
        what = f"pocket that {'widens' if is_open else 'opens'}"
        lined[f"{what} {1 + sum(name.startswith(what) for name in lined)}"] = lining
    return lined


def _is_new(around: _Surroundings, lining: np.ndarray, lined: dict[str, np.ndarray]) -> bool:
    own = np.unique(around.residues[lining])
    if len(lining) < LEAST_LINING:
        return False
    others = [np.unique(around.residues[other]) for other in lined.values()]
    return all(len(np.intersect1d(own, o)) <= SAME * min(len(own), len(o)) for o in others)


def _grown(
    analysis: Analysis, around: _Surroundings, lined: dict[str, np.ndarray]
) -> list[np.ndarray]:
    """The atoms that line pockets of some frames that have more room there than at the start."""
    shapes, start = analysis.get(OtherShapes), analysis[ReferenceStructure].positions
    spread = np.linspace(0, len(analysis.frames) - 1, SEARCHED).round().astype(int)
    grown = []
    for place in np.union1d(spread, [] if shapes is None else shapes.places).astype(int):
        positions = analysis.positions(place)
        for lining in around.found(positions):
            if _is_new(around, lining, lined):
                before, now = around.room(start, lining), around.room(positions, lining)
                if not _is_gap(now, before):
                    grown.append((now.enclosed - before.enclosed, place, lining))
    known = dict(lined)
    for growth, place, lining in sorted(grown, key=lambda one: (-one[0], one[1])):
        if growth < LEAST_GROWTH or len(known) == len(lined) + MOST_GROWN:
            break
        if _is_new(around, lining, known):
            known[f"{place}"] = lining
    return list(known.values())[len(lined) :]
