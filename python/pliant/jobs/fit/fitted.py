# SPDX-License-Identifier: MIT
"""What a fit found: structures, how they agree with the data, and what is not known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pliant._core import MolecularModel, Structure
from pliant.base.display import Displayed, Facts
from pliant.jobs.fit.atom_sites import atom_distance
from pliant.jobs.fit.data import Datum
from pliant.jobs.fit.in_map import MapAgreement
from pliant.jobs.fit.nodes import LeftOut, distances, outside
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.trajectory import HasFrames, Trajectory

ARRIVED = 0.5  #: Angstrom, r.m.s.: atoms so near have come to the fit
HOLDS = 1.0  #: Angstrom: a datum violated by less holds


@dataclass(frozen=True)
class Agreement:
    """A datum, and what the best structure has."""

    name: str  #: "A:45 - A:112"
    low: float  #: Angstrom
    high: float
    at_start: float
    found: float
    violation: float  #: above 0 where too long
    contradicts: bool  #: it cannot hold with the others, and was let go
    predicted: float | None  #: by fits to the others


@dataclass(frozen=True)
class Whole:
    """An all-atom structure, and what it took."""

    positions: np.ndarray  #: (N, 3) Angstrom
    short_of_fit: float  #: how far its residues are from those of the fit, r.m.s. Angstrom
    contacts_let_go: int
    max_residual: float  #: worst bar, relative to its length
    overlap: float  #: Angstrom
    tightest: str


@dataclass
class FittedStructure(HasFrames, Displayed):
    """Structures that agree with measured distances or a map, the best first."""

    model: MolecularModel = field(repr=False)  #: of the start
    kept: list[Whole] = field(repr=False)
    data: list[Agreement]
    density: MapAgreement | None  #: with a map; the structures are there
    labels: list[str] = field(repr=False)  #: (M) residues
    spread: np.ndarray = field(repr=False)  #: (M) Angstrom, over all fits that agree
    rmsd_from_start: float  #: of alpha carbons, Angstrom
    outliers_at_start: float  #: share of residues outside the allowed regions of phi and psi
    outliers: float  #: of the best structure
    agreeing: int  #: fits that agree about as well as the best
    fits: int
    off_at_start: float  #: violation of the start by the data that were kept, r.m.s. Angstrom
    off_left_out: float | None  #: by which the others miss a datum, r.m.s. Angstrom
    seconds: float = 0.0

    @property
    def structure(self) -> Structure:
        """The molecule, prepared."""
        return self.model.structure

    @property
    def positions(self) -> np.ndarray:
        """(n, N, 3) Angstrom, the best first."""
        return np.array([one.positions for one in self.kept])

    @property
    def trajectory(self) -> Trajectory:
        """The structures, in memory."""
        return Trajectory._of(FramesInMemory(self.structure, self.positions))

    @property
    def agrees(self) -> bool:
        """Whether the map agrees and all data hold but those that contradict the others."""
        return (self.density is None or self.density.agrees) and all(
            abs(one.violation) <= HOLDS for one in self.data if not one.contradicts
        )

    @property
    def is_predicted(self) -> bool:
        """Whether distances that START misses are predicted better than by it, each by the rest."""
        left, start = self.off_left_out, self.off_at_start
        return left is None or start <= HOLDS or left < start

    def verdict(self) -> str:
        """In words: whether data and structure agree, and what that is worth."""
        parts = [] if self.density is None else self.density.verdict()
        parts += self._of_distances() if self.data else []
        parts.append(
            f"The fits that agree differ by {np.median(self.spread):.1f} A (median residue)."
        )
        short = self.kept[0].short_of_fit
        if short > ARRIVED:
            parts.append(f"The atoms stop {short:.1f} A short of the fit.")
        if not self.data:
            return " ".join(parts)
        if self.off_at_start <= HOLDS:
            parts.append("START agrees as it is.")
        elif not self.is_predicted:
            parts.append("The data do not predict each other: do not rely on this fit.")
        return " ".join(parts)

    def _of_distances(self) -> list[str]:
        used = [one for one in self.data if not one.contradicts]
        holding = sum(abs(one.violation) <= HOLDS for one in used)
        agree = "agree" if holding == len(used) else "do not agree"
        return [
            f"Data and structure {agree}: {holding} of {len(self.data)} distances hold within "
            f"{HOLDS:g} A.",
            *(f"{one.name} cannot hold with the others." for one in self.data if one.contradicts),
        ]

    def facts(self) -> Facts:
        """How it agrees, and what is not known."""
        best = self.kept[0]
        tightest = f" ({best.tightest})" if best.tightest else ""
        missed = "" if self.off_left_out is None else f"; left out, by {self.off_left_out:.2f} A"
        off = [("violations", f"START's {self.off_at_start:.2f} A r.m.s.{missed}")]
        return [
            ("verdict", self.verdict()),
            ("moved", f"{self.rmsd_from_start:.2f} A from START (alpha carbons, r.m.s.)"),
            *([] if self.density is None else self.density.facts()),
            *(off if self.data else []),
            ("spread", f"{self.spread.min():.1f} to {self.spread.max():.1f} A by residue, over "
                       f"{self.agreeing} of {self.fits} fits: precision, not accuracy"),
            ("contacts", f"{best.contacts_let_go} let go"),
            ("backbone", f"{100 * self.outliers:.1f} % of residues are Ramachandran outliers "
                         f"(START {100 * self.outliers_at_start:.1f})"),
            ("quality", f"bonds and angles off by {best.max_residual:.0e} at most, overlap "
                        f"{best.overlap:.3f} A{tightest}"),
        ]  # fmt: skip

    def as_json(self) -> dict[str, Any]:
        """All of it but the positions."""
        best = self.kept[0]
        return {
            "verdict": self.verdict(),
            "agrees": self.agrees,
            "distances": [vars(one) for one in self.data],
            "map": None if self.density is None else self.density.as_json(self.labels),
            "rmsd_from_start": self.rmsd_from_start,
            "outliers": self.outliers,
            "outliers_at_start": self.outliers_at_start,
            "off_at_start": self.off_at_start,
            "off_left_out": self.off_left_out,
            "fits": self.fits,
            "agreeing": self.agreeing,
            "kept": len(self.kept),
            "short_of_fit": best.short_of_fit,
            "contacts_let_go": best.contacts_let_go,
            "worst_residual": max(one.max_residual for one in self.kept),
            "overlap": max(one.overlap for one in self.kept),
            "tightest": best.tightest,
            "spread": dict(zip(self.labels, self.spread.tolist(), strict=True)),
            "seconds": self.seconds,
        }


def measured(data: Sequence[Datum], positions: np.ndarray, atoms: np.ndarray) -> np.ndarray:
    """(K,) distances in a structure (N, 3), with nodes at some of its atoms (M); Angstrom."""
    found = distances(positions[atoms], data)
    for k, one in enumerate(data):
        if one.atoms is not None:
            found[k] = atom_distance(positions, *one.atoms)
    return found


def agreement_of(
    data: Sequence[Datum],
    at_start: np.ndarray,
    found: np.ndarray,
    contradicting: list[int],
    left_out: dict[int, LeftOut],
) -> list[Agreement]:
    """Of distances (K,) in the start and in the best structure."""
    off = outside(found, [(one.low, one.high) for one in data])
    return [
        Agreement(
            one.name,
            one.low,
            one.high,
            float(at_start[k]),
            float(found[k]),
            float(off[k]),
            k in contradicting,
            left_out[k].predicted if k in left_out and one.atoms is None else None,
        )
        for k, one in enumerate(data)
    ]
