# SPDX-License-Identifier: MIT
"""Everything that was found out about one trajectory, and what could not be, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from pliant.analyse.found import ENSEMBLE, Contacts, Reference, Units
from pliant.analysis import (
    BarResiduals,
    PrincipalComponents,
    Rmsf,
    RunRecord,
    TorsionDistributions,
)
from pliant.analysis.domains import LOOSE, Domains
from pliant.analysis.flexibility import Flexibility
from pliant.analysis.frame_store import AT_ONCE_BYTES, FrameStore
from pliant.analysis.stereochemistry import Stereochemistry, StereochemistryResults
from pliant.analysis.stored import StoredPositions

Part = TypeVar("Part")

#: units of correlations and domains; more are thinned along their chains
MOST_SITES = 1000

#: a table of more torsion angles than this is not written
MAX_ANGLES = 250_000


def known(part: Part | None) -> Part:
    """What an analysis gave, for those who know that it was possible."""
    assert part is not None
    return part


def _none() -> np.ndarray:
    return np.zeros(0, dtype=np.int64)


@dataclass
class StudyOptions:
    """What to study and how."""

    path: str
    topology: str | None = None
    select: str = "all"  #: atoms that are analysed, in MDAnalysis' selection language
    superpose: str | None = None  #: atoms that are fitted and enter the PCA; None: chosen
    mass_weighted: bool = False  #: PCA
    hydrogens: bool = False  #: also torsions that turn nothing but hydrogens
    start: int | None = None
    stop: int | None = None
    step: int | None = None
    workers: int = 1
    reference: str | None = None  #: file of the structure that frames are compared with
    distances: tuple[tuple[str, str], ...] = ()  #: pairs of selections, in MDAnalysis' language


@dataclass
class Study:
    """Results; an analysis that was not possible is None and has its reason in `skipped`."""

    options: StudyOptions
    universe: Any
    record: RunRecord | None  #: what the file says of the run; None for foreign formats
    stored: StoredPositions  #: positions with all their digits
    atoms: Any = None  #: AtomGroup that is analysed
    fitted: Any = None  #: AtomGroup that is superposed and enters the PCA
    fitted_name: str = ""
    frames: np.ndarray = field(default_factory=_none)  #: (F,) numbers in the file
    times: np.ndarray = field(default_factory=_none)  #: (F,) ps
    steps: np.ndarray | None = None  #: (F,) steps of the run, if the file tells them
    residuals: BarResiduals | None = None
    rmsd: np.ndarray | None = None  #: (F,) Angstrom, of the fitted atoms
    rmsd_all: np.ndarray | None = None  #: (F,) of all atoms analysed, if there are others
    rmsf: Rmsf | None = None
    radius: np.ndarray | None = None  #: (F,) Angstrom
    radius_weights: str = "mass"  #: or "equal", where there are no masses
    torsions: TorsionDistributions | None = None
    pca: PrincipalComponents | None = None
    pca_stride: int = 1  #: every so many frames analysed are in the PCA
    kind: str = ""  #: ENSEMBLE, PATH or TRAJECTORY
    reference: Reference | None = None  #: what frames are compared with
    units: Units | None = None  #: residues or atoms whose flexibility is told
    flexibility: Flexibility | None = None
    b_estimate: np.ndarray | None = None  #: (n,) B factors of a crystal, over their mean
    correlations: np.ndarray | None = None  #: (s, s) of every `site_stride`-th unit
    domains: Domains | None = None  #: of every `site_stride`-th unit of a chain
    shape: Stereochemistry | None = None
    shape_results: StereochemistryResults | None = None
    contacts: Contacts | None = None
    distances: list[np.ndarray] = field(default_factory=list)  #: (F,) of each asked for
    skipped: dict[str, str] = field(default_factory=dict)  #: analysis -> why it is missing
    notes: list[str] = field(default_factory=list)  #: what a reader of the results should know
    #: positions of the F frames analysed, if the universe has these and no others; else None
    held: FrameStore | None = None

    def positions(self, k: int) -> np.ndarray:
        """Positions (N, 3) of all atoms in the k-th frame analysed, Angstrom, float64."""
        if self.stored.in_file:
            return self.stored.read(self.frames[k])
        number = k if self.held is not None else self.frames[k]
        return self.stored.at(self.universe.trajectory[number])

    def some_positions(self, atoms: np.ndarray) -> Iterator[np.ndarray]:
        """Positions (f, m, 3) of some atoms, Angstrom: some frames of those analysed at a time."""
        if self.held is not None:
            yield from self.held.of_atoms(atoms).blocks()
            return
        size = max(1, AT_ONCE_BYTES // (24 * len(atoms)))
        for first in range(0, len(self.frames), size):
            part = range(first, min(first + size, len(self.frames)))
            yield np.array([self.positions(k)[atoms] for k in part])

    def stored_positions(self, atoms: np.ndarray) -> FrameStore:
        """Positions (F, m, 3) of some atoms in all frames analysed, Angstrom, float64."""
        store, first = FrameStore(len(self.frames), len(atoms)), 0
        for block in self.some_positions(atoms):
            store.put(first, block)
            first += len(block)
        return store

    @property
    def site_stride(self) -> int:
        """Correlations and domains are of every so many units."""
        return 1 if self.units is None else -(-len(self.units.labels) // MOST_SITES)

    @property
    def component_units(self) -> np.ndarray | None:
        """Units that the atoms of the PCA stand for, one each; None if they do not."""
        return None if self.units is None else self.units.of_atoms(self.fitted.ix)

    @property
    def unit_domains(self) -> np.ndarray:
        """(n,) domain of each unit; LOOSE where it has none."""
        assert self.units is not None
        full = np.full(len(self.units.labels), LOOSE)
        if self.domains is not None:
            chain = np.flatnonzero(self.units.of_chain)
            full[chain] = np.repeat(self.domains.domain, self.site_stride)[: len(chain)]
        return full

    def observable(self, name: str) -> np.ndarray | None:
        """(F,) an observable of the run at the frames analysed; None if there is none."""
        values = self.record.observables.get(name) if self.record else None
        return None if values is None or len(values) <= self.frames.max() else values[self.frames]

    @property
    def converged(self) -> np.ndarray | None:
        """(F,) bool: what the run says of each frame; None if it says nothing."""
        flags = self.observable("converged")
        return None if flags is None else flags.astype(bool)

    @property
    def broken_promises(self) -> np.ndarray | None:
        """(F,) bool: the run says converged, but a bar is beyond the tolerance; or None."""
        if self.residuals is None or self.converged is None:
            return None
        broken: np.ndarray = self.converged & ~self.residuals.results.within
        return broken

    @property
    def axis(self) -> tuple[np.ndarray, str]:
        """(F,) values and label of the axis along which things happen: steps, or time."""
        if self.kind == ENSEMBLE:
            return self.frames, "frame"
        if self.steps is not None:
            return self.steps, "step"
        if np.all(np.diff(self.times) > 0):
            return self.times, "time (ps)"
        return self.frames, "frame"
