# SPDX-License-Identifier: MIT
"""The volume of pockets, frame by frame: sites of ligands, of the start, and what opens."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import cKDTree

from pliant.measure.pockets.opened_pockets import LEAST_GROWTH, why_no_pockets
from pliant.measure.pockets.pocket_grid import RADII, SPACING, Room, find_pockets, rooms_among
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.parts import Part, ReferenceStructure, Units
from pliant.trajectory.chosen_frames import choose_frames

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.stages.analysis import Analysis

#: frames whose pockets are measured, spread over all
LOOKED_AT = 100
#: of these so many are in memory at once
AT_ONCE = 16
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
        self._analysis = analysis
        #: (1, n, 3)
        self.start: np.ndarray = analysis[ReferenceStructure].positions[None, atoms.ix]
        self.radii = np.array([RADII.get(e.capitalize(), RADII["C"]) for e in atoms.elements])

    def frames(self, places: Iterable[int]) -> np.ndarray:
        """Positions (f, n, 3) of these atoms in some of the frames analysed."""
        return np.array([self._analysis.positions(k)[self.atoms] for k in places])

    def rooms(self, frames: np.ndarray, linings: Sequence[np.ndarray]) -> list[list[Room]]:
        """Room among lining atoms (places among those of this) in each frame (F, n, 3)."""
        return rooms_among(frames, self.radii, linings)

    def errors(self, linings: Sequence[np.ndarray]) -> np.ndarray:
        """How far the grid is off in the room of each lining at the start, Angstrom^3."""
        own = self.start, self.radii, linings
        fine, *coarse = (
            [room.enclosed for room in rooms_among(*own, spacing, offset)[0]]
            for spacing, offset in ((SPACING / 2, 0.0), *((SPACING, k / 4) for k in range(4)))
        )
        return np.asarray(np.sqrt(np.mean((np.array(coarse) - fine) ** 2, axis=0)))

    def found(self, frames: np.ndarray) -> list[list[np.ndarray]]:
        """The atoms that line each pocket of each frame (F, n, 3), the largest pocket first."""
        return [
            [one.lining(k) for k in range(one.count) if one.size(k) >= LEAST_VOLUME]
            for one in find_pockets(frames, self.radii)
        ]

    def beside(self, ligand: np.ndarray) -> np.ndarray:
        """The atoms within LINING of those of a ligand (indices) at the start."""
        start = self._analysis[ReferenceStructure].positions
        apart, _ = cKDTree(start[ligand]).query(self.start[0])
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
    lined = _lined(analysis, around, kept)
    places = choose_frames(len(analysis.frames), LOOKED_AT)
    pockets = _measured(around, lined, places) if lined else []
    if measured := tuple(pocket for pocket in pockets if not pocket.is_gap.all()):
        few = f"pockets were measured in {len(places)} of the {len(analysis.frames)} frames"
        yield PocketVolumes(measured, places, notes=(few,) * (len(places) < len(analysis.frames)))


def _measured(
    around: _Surroundings, lined: dict[str, np.ndarray], places: np.ndarray
) -> list[Pocket]:
    linings = [*lined.values()]
    at_start, errors = around.rooms(around.start, linings)[0], around.errors(linings)
    rooms: list[list[Room]] = []
    for part in np.array_split(places, -(-len(places) // AT_ONCE)):
        rooms += around.rooms(around.frames(part), linings)
    return [
        Pocket(
            name,
            around.atoms[lined[name]],
            np.unique(around.residues[lined[name]]),
            first.enclosed,
            float(error),
            np.array([room.enclosed for room in own]),
            np.array([_is_gap(room, first) for room in own]),
        )
        for name, first, error, own in zip(
            lined, at_start, errors, zip(*rooms, strict=True), strict=True
        )
    ]


def _is_gap(room: Room, at_start: Room) -> bool:
    return room.share < LEAST_KEPT * at_start.share


def _lined(
    analysis: Analysis, around: _Surroundings, kept: list[AtomGroup]
) -> dict[str, np.ndarray]:
    """The atoms that line each pocket, by the pocket's name."""
    labels = analysis.residue_labels
    lined: dict[str, np.ndarray] = {}
    for ligand in kept:
        lining = around.beside(ligand.ix)
        if len(lining) >= LEAST_LINING and len(lined) < MOST_SITES:
            lined[f"site of {labels[ligand.resindices[0]]}"] = lining
    sites = len(lined)
    for lining in around.found(around.start)[0]:
        if len(lined) < sites + MOST_AT_START and _is_new(around, lining, lined):
            lined[f"pocket {len(lined) - sites + 1}"] = lining
    grown = _grown(analysis, around, lined)
    rooms = around.rooms(around.start, grown)[0] if grown else []
    for lining, room in zip(grown, rooms, strict=True):
        what = f"pocket that {'widens' if room.enclosed >= LEAST_VOLUME else 'opens'}"
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
    shapes = analysis.get(OtherShapes)
    spread = np.linspace(0, len(analysis.frames) - 1, SEARCHED).round().astype(int)
    places = np.union1d(spread, [] if shapes is None else shapes.places).astype(int)
    frames = around.frames(places)
    grown = []
    for place, frame, found in zip(places, frames, around.found(frames), strict=True):
        linings = [lining for lining in found if _is_new(around, lining, lined)]
        if not linings:
            continue
        before, now = around.rooms(np.array([around.start[0], frame]), linings)
        for lining, first, then in zip(linings, before, now, strict=True):
            if not _is_gap(then, first):
                grown.append((then.enclosed - first.enclosed, place, lining))
    known = dict(lined)
    for growth, place, lining in sorted(grown, key=lambda one: (-one[0], one[1])):
        if growth < LEAST_GROWTH or len(known) == len(lined) + MOST_GROWN:
            break
        if _is_new(around, lining, known):
            known[f"{place}"] = lining
    return list(known.values())[len(lined) :]
