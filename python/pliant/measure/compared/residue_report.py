# SPDX-License-Identifier: MIT
"""What the comparison residue by residue found."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pliant.measure.agreement import NOTHING, Figure, Modes


@dataclass(frozen=True)
class Profile:
    """How far each of K residues moves, superposed on the core."""

    rmsf: np.ndarray  #: (K,) Angstrom
    error: np.ndarray  #: (K,) standard error; not a number where there are too few frames
    frames: int


@dataclass(frozen=True)
class MissingMode:
    """A principal mode of one ensemble that the first modes of the other hardly have."""

    mode: int  #: from 1
    share: float  #: of the variance of its ensemble
    covered: float  #: cumulative overlap with the modes of the other
    residues: str  #: which move most in it


@dataclass(frozen=True)
class Stretch:
    """Residues next to each other that move more, or less, in ours than in theirs."""

    residues: str  #: "A:46-50"
    ours: float  #: mean RMSF, scaled to theirs, Angstrom
    theirs: float  #: Angstrom


@dataclass(frozen=True)
class Subspaces:
    """Principal modes of both, and how far they span the same motions."""

    ours: Modes
    theirs: Modes
    overlaps: np.ndarray  #: (K, L) |u_i . v_j|
    rmsip: Figure
    ceiling: float  #: RMSIP of random halves of theirs
    chance: float  #: of random subspaces of as many modes
    covered_ours: np.ndarray  #: (K,) cumulative overlap of each of our modes with theirs
    covered_theirs: np.ndarray  #: (L,) the reverse
    share_covered: float  #: of the variance of theirs, within our first modes
    of_ours_alone: list[MissingMode]
    of_theirs_alone: list[MissingMode]


@dataclass(frozen=True)
class Displacement:
    """The way from the middle of ours to the one structure that theirs is."""

    distance: float  #: RMSD of the core, Angstrom
    nearest: float  #: RMSD of the frame of ours that is nearest, Angstrom
    overlap: Figure  #: cumulative overlap with our first modes
    chance: float  #: of random modes


@dataclass
class ResidueComparison:
    """Both ensembles on the K residues that they share."""

    kind: str  #: of reference: trajectory, models, structures or structure
    labels: list[str]  #: (K,) of ours
    chains: np.ndarray  #: (K,)
    core: np.ndarray  #: (K,) bool: superposed, and what r and modes are of
    ends: str  #: residues that are not in the core: ends that wave freely; "" for none
    ours: Profile
    theirs: Profile | None  #: None of a single structure
    r: Figure = field(default_factory=Figure)  #: of RMSF over the core
    r_all: float = NOTHING  #: with the ends
    r_ceiling: float = NOTHING  #: of random halves of theirs
    r_in_time: float = NOTHING  #: of the first and the second half of a trajectory
    scale: float = NOTHING  #: mean RMSF of theirs over that of ours, core
    more: np.ndarray = field(
        default_factory=lambda: np.zeros(0, bool)
    )  #: (K,) of the core, beyond error
    less: np.ndarray = field(default_factory=lambda: np.zeros(0, bool))
    more_stretches: list[Stretch] = field(default_factory=list)
    less_stretches: list[Stretch] = field(default_factory=list)
    subspaces: Subspaces | None = None
    displacement: Displacement | None = None
    conclusions: list[str] = field(default_factory=list)  #: in plain words
    cautions: list[str] = field(default_factory=list)  #: what cannot be concluded
    notes: list[str] = field(default_factory=list)  #: how residues were matched
