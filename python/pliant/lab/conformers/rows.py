# SPDX-License-Identifier: MIT
"""Rows of the table of conformers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant.lab.results import Cell, Results, print_table

Floats = npt.NDArray[np.float64]

WITHIN = (0.5, 0.75, 1.0, 2.0)  #: Angstrom


@dataclass(frozen=True)
class Made:
    """One molecule, by one contender."""

    molecule: str
    contender: str
    asked: int
    start_rmsd: float  #: of the start from the known conformer (Angstrom)
    made: int = 0
    nearest: float | None = None  #: symmetric RMSD of the nearest (Angstrom)
    seconds: float | None = None  #: CPU, of the user, starts included
    start_seconds: float = 0.0  #: of it, for the start that RDKit makes
    handedness: int = 0  #: conformers in which that of an atom changed
    double_bonds: int = 0  #: in which E and Z changed
    amides: int = 0  #: in which a secondary amide changed
    contacts: int = 0  #: with heavy atoms too near, four or more bonds apart
    strain: float | None = None  #: median of some above the lowest minimum (kcal/mol)
    failure: str = ""


@dataclass(frozen=True)
class Run:
    """What one contender made of one molecule, in the order in which it came."""

    row: Made
    distances: Floats = field(default_factory=lambda: np.zeros(0))  #: (F,) Angstrom
    frames: Floats = field(default_factory=lambda: np.zeros((0, 0, 3)))  #: (F, N, 3) Angstrom


@dataclass(frozen=True)
class Share:
    """All molecules, by one contender with so many conformers."""

    contender: str
    at: str  #: "50 conformers", "equal CPU"
    asked: int
    molecules: int
    failed: int
    made: float  #: mean
    within: tuple[float, ...]  #: share of all molecules, for each of WITHIN
    nearest: float  #: mean of those that were made (Angstrom)
    error: float  #: standard error of that
    seconds: float  #: mean
    start_seconds: float  #: mean, of it, for the start that RDKit makes


@dataclass(frozen=True)
class Fault:
    """All molecules, by one contender: what is wrong with its conformers."""

    contender: str
    asked: int
    conformers: int
    handedness: int
    double_bonds: int
    amides: int
    contacts: float  #: share of the conformers
    strain: float  #: median of the molecules (kcal/mol)


@dataclass(frozen=True)
class Difference:
    """Ours less another contender's, molecule by molecule; those that both could make."""

    other: str
    at: str
    molecules: int
    nearest: float  #: mean of the difference (Angstrom)
    error: float  #: standard error of that
    within: float  #: difference of the share within 1 Angstrom
    within_error: float


def _shares_text(shares: Sequence[float]) -> str:
    return " ".join(f"{share:.2f}" for share in shares)


SHARES: dict[str, Cell] = {
    "at": "at",
    "contender": "contender",
    "made": "made:.0f",
    " ".join(f"{limit:g}" for limit in WITHIN) + " A": lambda row: _shares_text(row.within),
    "nearest, A": "nearest:.3f",
    "+-": "error:.3f",
    "CPU, s": "seconds:.3f",
    "start": "start_seconds:.3f",
    "failed": lambda row: row.failed or None,
}
DIFFERENCES: dict[str, Cell] = {
    "at": "at",
    "ours less": "other",
    "molecules": "molecules",
    "nearest, A": "nearest:+.3f",
    "+-": "error:.3f",
    "within 1 A": "within:+.3f",
    " +-": "within_error:.3f",
}
FAULTS: dict[str, Cell] = {
    "contender": "contender",
    "asked": "asked",
    "conformers": "conformers",
    "handed": "handedness",
    "E/Z": "double_bonds",
    "amides": "amides",
    "contacts": "contacts:.3f",
    "strain": "strain:.1f",
}


@dataclass
class Table(Results):
    """The whole table."""

    molecules: int
    rows: list[Made] = field(default_factory=list)
    shares: list[Share] = field(default_factory=list)
    differences: list[Difference] = field(default_factory=list)
    flaws: list[Fault] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: records that could not be used, why
    left_out: list[str] = field(default_factory=list)  #: contenders that are not installed
    within: tuple[float, ...] = WITHIN  #: Angstrom, of the shares

    def __post_init__(self) -> None:
        self.runs: list[Run] = []  #: of which rows are made, for the picture

    def print_report(self) -> None:
        """Shares, differences, faults; then what failed or could not be measured."""
        print(
            f"{self.molecules} molecules with a known conformer, each made anew from its graph; "
            "share\nwith a conformer as near as that to the known one (RMSD of heavy atoms, least "
            "over\nsymmetry), mean of the nearest, and CPU time a molecule (user); start: of that, "
            "RDKit's\nfor the conformer that ours begin from"
        )
        print_table(self.shares, SHARES)
        print("ours less the others', paired by molecule; +- standard errors")
        print_table(self.differences, DIFFERENCES)
        print(
            "conformers in which handedness, E/Z or a secondary amide changed; share with heavy "
            "atoms\nnearer than 2.6 A, four or more bonds apart; strain: median above the lowest "
            "minimum\n(MMFF94s, as they come, kcal/mol)"
        )
        print_table(self.flaws, FAULTS)
        for row in self.rows:
            if row.failure:
                print(f"failed: {row.molecule}, {row.contender} {row.asked}: {row.failure}")
        for line in (*(f"not measured: {one}" for one in self.skipped), *self.left_out):
            print(line)
