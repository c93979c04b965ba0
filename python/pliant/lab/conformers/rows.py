# SPDX-License-Identifier: MIT
"""Rows of the table of conformers."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

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


@dataclass
class Table:
    """The whole table."""

    molecules: int
    made: list[Made] = field(default_factory=list)
    shares: list[Share] = field(default_factory=list)
    differences: list[Difference] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: records that could not be used, why
    left_out: list[str] = field(default_factory=list)  #: contenders that are not installed

    def as_json(self) -> dict[str, Any]:
        """For --json."""
        return {"within": WITHIN, **asdict(self)}
