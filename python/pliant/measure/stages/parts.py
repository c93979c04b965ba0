# SPDX-License-Identifier: MIT
"""The parts of an analysis: what its stages return, each whole and under the name of its type."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from MDAnalysis.analysis.base import Results

    from pliant.measure.domains import Domains
    from pliant.measure.flexibility import Flexibility
    from pliant.measure.pca import PrincipalComponents
    from pliant.measure.residuals import BarResiduals
    from pliant.measure.rmsf import Rmsf
    from pliant.measure.stereochemistry import Stereochemistry, StereochemistryResults
    from pliant.measure.torsions import TorsionDistributions

#: units of correlations and domains; more are thinned along their chains
MOST_SITES = 1000
#: a table of more torsion angles than this is not written
MAX_ANGLES = 250_000


class Part:
    """What a stage returns."""

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        return ()


@dataclass(frozen=True)
class ReferenceStructure(Part):
    """The structure that frames are compared with; it has the atoms of the trajectory."""

    positions: np.ndarray  #: (N, 3) Angstrom
    name: str  #: what it is, for readers
    note: str = ""  #: why it is this one, where that is not plain
    found: bool = True  #: it is the one that was looked for

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        return (self.note,) if self.note else ()


@dataclass(frozen=True)
class Units(Part):
    """The n residues or atoms that are reported on, and the m atoms that stand for them."""

    what: str  #: "residue" or "atom"
    labels: list[str]  #: (n,) "A:LYS12", "C4"
    numbers: np.ndarray  #: (n,) of the residue, or of the atom from 1
    chains: np.ndarray  #: (n,) chain, "" where there is none
    owners: np.ndarray  #: (n,) resindex, or index of the atom
    atoms: np.ndarray  #: (m,) indices in the universe
    unit: np.ndarray  #: (m,) the unit of each
    of_chain: np.ndarray  #: (n,) bool: a residue of a chain, by its CA or P

    @property
    def ranked(self) -> np.ndarray:
        """(n,) bool: residues of chains, which ligands are not ranked with; all without chains."""
        return self.of_chain if self.of_chain.any() else np.ones(len(self.labels), dtype=bool)

    @property
    def site_stride(self) -> int:
        """Correlations and domains are of every so many units."""
        return -(-len(self.labels) // MOST_SITES)

    def of_atoms(self, atoms: np.ndarray) -> np.ndarray | None:
        """(k,) the units that atoms (k,), indices in the universe, alone stand for; or None."""
        place = np.minimum(np.searchsorted(self.atoms, atoms), len(self.atoms) - 1)
        own = self.unit[place]
        alone = np.bincount(self.unit)[own] == 1
        return own if np.all(self.atoms[place] == atoms) and alone.all() else None

    def sites(self, positions: np.ndarray) -> np.ndarray:
        """(F, n, 3) centre of each unit's atoms, of positions (F, m, 3)."""
        if len(self.atoms) == len(self.labels):
            return positions
        share = 1.0 / np.bincount(self.unit, minlength=len(self.labels))
        found = np.zeros((len(positions), len(self.labels), 3))
        for sites, frame in zip(found, positions, strict=True):
            np.add.at(sites, self.unit, share[self.unit, None] * frame)
        return found


@dataclass(frozen=True)
class Residuals(Part):
    """How far the bars of each frame are from their rest lengths."""

    measured: BarResiduals
    #: (F,) bool: the run says converged, but a bar is beyond the tolerance; None: it says nothing
    broken_promises: np.ndarray | None

    @property
    def found(self) -> Results:
        """One number a frame, or a bar: see `BarResiduals`."""
        return self.measured.results

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        if self.measured.precision != "float32" or self.measured.tolerance >= 1e-5:
            return ()
        text = "coordinates are stored as 32-bit floats, so residuals are known to a few 1e-6 only"
        return (text,)


@dataclass(frozen=True)
class Sweeps(Part):
    """Sweeps that resolving each frame took."""

    counts: np.ndarray  #: (F,)


@dataclass(frozen=True)
class Rmsd(Part):
    """RMSD of each frame from the first, or from the start structure of an ensemble, Angstrom."""

    fitted: np.ndarray  #: (F,) of the atoms that are superposed
    analysed: np.ndarray | None  #: (F,) of all atoms analysed, if there are others


@dataclass(frozen=True)
class AtomFluctuations(Part):
    """RMSF of each atom and residue."""

    measured: Rmsf
    #: how many frames around the start it is of, and how many there are; None: of all
    frames: tuple[int, int] | None = None

    @property
    def found(self) -> Results:
        """One number an atom, or a residue: see `Rmsf`."""
        return self.measured.results

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        notes = []
        if not self.found.average_converged:
            notes.append("the average structure of the RMSF did not come to rest")
        if self.frames is not None:
            notes.append(
                f"fluctuations, correlations and domains are those of the {self.frames[0]} frames "
                f"along modes; the other {self.frames[1] - self.frames[0]} reach further"
            )
        return tuple(notes)


@dataclass(frozen=True)
class Gyration(Part):
    """Radius of gyration of each frame."""

    radius: np.ndarray  #: (F,) Angstrom
    weights: str  #: "mass", or "equal" where there are no masses


@dataclass(frozen=True)
class Torsions(Part):
    """Angles of the rotatable bonds."""

    measured: TorsionDistributions
    of_bars: bool  #: the file has no bonds

    @property
    def found(self) -> Results:
        """Angles of each frame, and how they are distributed: see `TorsionDistributions`."""
        return self.measured.results

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        size = self.found.angles.size
        bars = ("the file has no bonds: torsions are those of its bars",)
        large = (f"the table torsion_angles.csv is left out: {size:,} numbers",)
        return (bars if self.of_bars else ()) + (large if size > MAX_ANGLES else ())


@dataclass(frozen=True)
class Components(Part):
    """Principal components of the superposed atoms."""

    measured: PrincipalComponents
    stride: int  #: every so many frames analysed are in the PCA

    @property
    def found(self) -> Results:
        """Variances, directions and projections: see `PrincipalComponents`."""
        return self.measured.results

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the results should know."""
        text = f"PCA uses every {self.stride}th frame, to fit into memory"
        return (text,) if self.stride > 1 else ()


@dataclass(frozen=True)
class UnitsInComponents(Part):
    """The units that the atoms of the principal components stand for, one each."""

    units: np.ndarray  #: (m,) their numbers


@dataclass(frozen=True)
class UnitFlexibility(Part):
    """RMSF of each unit, with its error."""

    found: Flexibility
    #: (n,) B factors of a crystal, over their mean; NaN for units of no chain; None without chains
    b_estimate: np.ndarray | None


@dataclass(frozen=True)
class Correlations(Part):
    """Correlations of the displacements of units."""

    matrix: np.ndarray  #: (s, s) of every `site_stride`-th unit


@dataclass(frozen=True)
class RigidDomains(Part):
    """Domains that move as rigid bodies."""

    found: Domains  #: of some units of chains, the sites
    sites: np.ndarray  #: (s,) numbers of these units
    of_unit: np.ndarray  #: (n,) domain of each unit; LOOSE where it has none
    hinge_share: np.ndarray  #: (n,) share of the resamples in which a unit is a hinge

    def units_of(self, sites: np.ndarray) -> np.ndarray:
        """Numbers of the units that some sites stand for."""
        ends = np.append(self.sites[1:], self.sites[-1] + 1)
        ranges = [np.arange(self.sites[k], ends[k]) for k in sites]
        return np.concatenate(ranges) if ranges else np.zeros(0, dtype=np.int64)


@dataclass(frozen=True)
class Shapes(Part):
    """Stereochemistry of frames that are spread over all."""

    measured: Stereochemistry
    found: StereochemistryResults
    frames: np.ndarray  #: (f,) numbers in the file


@dataclass(frozen=True)
class ContactFrequencies(Part):
    """Pairs of residues in contact (heavy atoms within 4.5 Angstrom) and how often."""

    pairs: np.ndarray  #: (k, 2) numbers of units
    share: np.ndarray  #: (k,) of the frames looked at
    at_start: np.ndarray  #: (k,) bool: in the reference structure
    frames: int  #: that were looked at


@dataclass(frozen=True)
class Distances(Part):
    """Distances that were asked for."""

    ends: tuple[tuple[str, str], ...]  #: pairs of selections
    values: tuple[np.ndarray, ...]  #: (F,) of each pair, Angstrom
