# SPDX-License-Identifier: MIT
"""What a comparison found, part by part."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pliant.base.display import Displayed, Facts
from pliant.measure import agreement
from pliant.measure.compared.ensembles import Ensembles
from pliant.measure.compared.residue_report import ResidueComparison


@dataclass
class Fluctuations:
    """RMSF of both, and how they go together."""

    kind: str  #: "atom" or "residue": what the labels name
    labels: list[str]
    ours: np.ndarray  #: (n,) Angstrom
    theirs: np.ndarray  #: (n,) Angstrom

    @property
    def pearson(self) -> float:
        """Correlation of the two profiles."""
        return agreement.correlation(self.ours, self.theirs)


@dataclass
class ModeComparison:
    """Principal components of both, and how far they span the same motions."""

    atoms: int
    overlaps: np.ndarray  #: (K, L) |u_i . v_j|
    rmsip: float
    chance: float  #: RMSIP of random subspaces of these dimensions
    halves_ours: float  #: RMSIP of the first and the second half of our frames
    halves_theirs: float
    share_ours: float  #: of the variance, in these modes
    share_theirs: float


@dataclass
class TorsionComparison:
    """Distributions of one torsion angle."""

    label: str
    ours: np.ndarray  #: (bins,) share of the frames
    theirs: np.ndarray  #: (bins,)
    distance: float  #: Jensen-Shannon, 0 to 1
    halves_theirs: float  #: the same between the halves of theirs: what is noise


@dataclass
class BarLengths:
    """How far bars vary over the frames of each; Angstrom unless stated."""

    labels: list[str]
    spread_ours: np.ndarray  #: (B,) standard deviations
    spread_theirs: np.ndarray  #: (B,)
    residual_ours: float  #: largest |length - rest| / rest of all frames
    residual_theirs: float


@dataclass
class AtomComparison:
    """Both ensembles atom by atom, where they are of the same atoms."""

    ensembles: Ensembles
    atom_fluctuations: Fluctuations
    residue_fluctuations: Fluctuations | None  #: of alpha carbons; None if it is no protein
    modes: ModeComparison
    torsions: list[TorsionComparison]
    bars: BarLengths
    radii: tuple[np.ndarray, np.ndarray]  #: radii of gyration (F,), (G,), Angstrom


@dataclass
class ComparisonReport(Displayed):
    """What `compare` found. One of `residues` and `atoms` at least is there."""

    path: str  #: of ours
    theirs: list[str]  #: paths
    residues: ResidueComparison | None  #: None where ours has no residues to match
    atoms: AtomComparison | None  #: None where theirs are other atoms, or several files
    notes: list[str] = field(default_factory=list)
    pictures: list[str] = field(default_factory=list)

    @property
    def conclusions(self) -> list[str]:
        """What follows, in plain words."""
        return self.residues.conclusions if self.residues else []

    def facts(self) -> Facts:
        """What was compared, and what follows."""
        compared = [("ours", self.path), *(("theirs", path) for path in self.theirs)]
        return [*compared, *(("follows", sentence) for sentence in self.conclusions)]
