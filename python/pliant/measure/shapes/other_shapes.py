# SPDX-License-Identifier: MIT
"""The other shapes in an ensemble: which frames they are, what turned, what broke, what opened."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.distance import pdist

from pliant._core import PlausibleShapes
from pliant.measure.domains.rigid_turns import RigidTurns, rigid_turns
from pliant.measure.pockets.opened_pockets import PocketChange, PocketFinder
from pliant.measure.shapes.known_pairs import quartiles_of_like
from pliant.measure.shapes.shapes import ShapeGroups, find_shapes
from pliant.measure.stages.names import chains_of
from pliant.measure.stages.parts import Part, ReferenceStructure
from pliant.measure.stages.units import trace_of
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.recorded_contacts import HELD

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

REMARK_OF_SHAPES = "one frame per shape; populations are not claimed"
#: chains shorter than this in all have no shapes
LEAST_SITES = 20
#: of more residues than these every second one is compared, or third ...
MOST_SITES = 1000
#: alpha carbons that come this near, from beyond the second, make a contact, Angstrom
MADE_WITHIN, MADE_FROM = 8.0, 10.0
#: frames around the start whose pockets are measured, to know how much pockets differ without cause
NEAR_LOOKED_AT = 5


@dataclass(frozen=True)
class Shape:
    """One shape, by the frame that stands for it."""

    frame: int  #: number in the file
    frames: int  #: how many of the frames compared are of it
    rmsd: float  #: of that frame from the start, Angstrom
    spread: float  #: mean RMSD of its frames from that one, Angstrom
    turns: RigidTurns  #: of the sites, from the start to that frame
    gone: np.ndarray | None  #: contacts of the start that it lacks; None: the file does not say
    made: int  #: pairs of sites that came together: from beyond MADE_FROM to within MADE_WITHIN
    wider: float  #: change of the radius of gyration, as a share of that of the start
    pockets: tuple[PocketChange, ...]  #: larger than at the start, largest growth first


@dataclass(frozen=True)
class OtherShapes(Part):
    """The shapes of an ensemble that are none of the start."""

    looked_for: bool  #: False: all frames were drawn around the start
    sites: np.ndarray  #: (s,) indices of the atoms (CA, P) that the turns are of
    near: int  #: frames no further from the start than the limit
    groups: ShapeGroups | None
    places: np.ndarray  #: (k,) of the representatives, among the frames analysed
    shapes: tuple[Shape, ...]  #: the most plausible first
    #: (3,) quartiles of how far known pairs of like softness are apart, Angstrom; None: not known
    known: np.ndarray | None
    openness: float  #: of the start, from -1, compact, to 1, open

    def is_beyond(self, shape: Shape) -> bool:
        """Whether a shape is further from the start than three of four known pairs are apart."""
        return self.known is not None and shape.rmsd > self.known[2]

    @property
    def alone(self) -> int:
        """Frames beyond the limit that are like no other."""
        return 0 if self.groups is None else len(self.groups.alone)


@dataclass(frozen=True)
class Compared:
    """The sites by which shapes are compared, and how plausible they are."""

    sites: np.ndarray  #: (s,) indices of the atoms (CA, P)
    start: np.ndarray  #: (s, 3) Angstrom
    plausible: PlausibleShapes

    @classmethod
    def of(cls, analysis: Analysis, reference: ReferenceStructure) -> Compared:
        """At most MOST_SITES: what is plausible takes the cube of their number."""
        trace = trace_of(analysis.atoms).ix
        stride = max(1, -(-len(trace) // MOST_SITES))
        sites = trace[::stride]
        start = reference.positions[sites]
        return cls(sites, start, PlausibleShapes(start, stride ** (1 / 3)))


def shape_groups(analysis: Analysis) -> tuple[Compared, ShapeGroups] | None:
    """What is compared, and the shapes of the frames.

    None where frames are no ensemble of residues, or all were drawn around the start.
    """
    if not has_shapes(analysis) or analysis.reaches is None:
        return None
    by = Compared.of(analysis, analysis[ReferenceStructure])
    frames, near = analysis.stored_positions(by.sites), ~analysis.reaches
    return by, find_shapes(frames, by.start, near, by.plausible)


def has_shapes(analysis: Analysis) -> bool:
    """Whether it is an ensemble of enough residues, drawn by more than one way."""
    drawn = analysis.observable("sampler")
    if analysis.kind != ENSEMBLE or drawn is None or not drawn.any():
        return False
    return len(trace_of(analysis.atoms)) >= LEAST_SITES


def other_shapes(analysis: Analysis) -> Iterator[OtherShapes]:
    """Shapes, their turns, contacts and pockets; that there are none to look for, if so."""
    if not has_shapes(analysis):
        return
    found = shape_groups(analysis)
    none = np.zeros(0, dtype=np.int64)
    if found is None:
        yield OtherShapes(False, none, len(analysis.frames), None, none, (), None, 0.0)
        return
    by, groups = found
    trace, start = by.sites, by.start
    places = groups.representatives
    pockets = PocketFinder(analysis, trace)
    if len(places) and not pockets.why_not:
        near = np.flatnonzero(groups.rmsd <= groups.limit)
        pockets.look_at(near[np.linspace(0, len(near) - 1, NEAR_LOOKED_AT).astype(int)])
    chains = chains_of(analysis.universe.atoms[trace])
    one_chain = len(set(chains)) == 1 and len(trace) == len(trace_of(analysis.atoms))
    known = quartiles_of_like(by.plausible.softness) if one_chain else None
    shapes = []
    opened = pockets.larger_than_at_start(places)
    for k, place in enumerate(places):
        end = analysis.positions(place)[trace]
        turns = rigid_turns(start, end, chains)
        shapes.append(
            Shape(
                int(analysis.frames[place]),
                len(groups.members[k]),
                float(groups.rmsd[place]),
                float(groups.distances[k].mean()),
                turns,
                _contacts_gone(analysis, place),
                _contacts_made(start, end),
                _gyration(end) / _gyration(start) - 1.0,
                opened[k],
            )
        )
    near_count = int(np.count_nonzero(groups.rmsd <= groups.limit))
    notes = []
    if len(groups.compared) < len(groups.rmsd) - near_count:
        notes.append(f"shapes are of {len(groups.compared)} frames taken evenly")
    if shapes and pockets.why_not:
        notes.append(f"no pockets of shapes: {pockets.why_not}")
    openness = by.plausible.openness if one_chain else 0.0
    yield OtherShapes(
        True, trace, near_count, groups, places, tuple(shapes), known, openness, notes=tuple(notes)
    )


def _contacts_made(start: np.ndarray, end: np.ndarray) -> int:
    came = (pdist(start) > MADE_FROM) & (pdist(end) < MADE_WITHIN)
    return int(np.count_nonzero(came))


def _gyration(positions: np.ndarray) -> float:
    return float(np.sqrt(positions.var(axis=0).sum()))


def _contacts_gone(analysis: Analysis, place: int) -> np.ndarray | None:
    """Contacts that the model holds at the start and this frame does not."""
    contacts = analysis.source.contacts
    number = analysis.frames[place]
    if contacts is None or contacts.states is None or len(contacts.states) <= number:
        return None
    return np.flatnonzero(contacts.states[number] != HELD)
