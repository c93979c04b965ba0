# SPDX-License-Identifier: MIT
"""A row of the table, what it must show, and whether it does."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from typing import Any

from pliant.lab.results import Cell, Results, print_table

NO = float("nan")
HELD_OUT, TUNED, CHOSE, NEITHER = "held out", "tuned on", "helped to choose", ""

#: (system, figure) or figure: must, aim, whether these are the least, whether it must be exact.
GOALS: dict[tuple[str, str] | str, tuple[float, float, bool, bool]] = {
    ("ubiquitin", "r of RMSF, residues 1-70"): (0.90, 0.94, True, False),
    ("ubiquitin", "RMSIP of 10"): (0.75, 0.80, True, False),
    ("HIV-PR", "r of RMSF"): (0.93, 0.97, True, False),
    ("HIV-PR", "RMSIP of 10"): (0.77, 0.79, True, False),
    ("AdK, closed to open", "cumulative overlap of 10"): (0.88, 0.92, True, False),
    ("AdK, open to closed", "cumulative overlap of 10"): (0.96, 0.975, True, False),
    ("domain motions, held out", "cumulative overlap of 10, mean"): (0.868, 0.89, True, False),
    ("domain motions, held out", "cumulative overlap of 10, median"): (0.92, 0.95, True, False),
    "two seeds, r of RMSF, the worst": (0.995, 0.999, True, False),
    "two seeds, RMSIP of 10, the worst": (0.95, 0.98, True, False),
    "Ramachandran outliers above the start's, %": (1.0, 0.5, False, False),
    "worst bar, relative": (1e-10, 1e-13, False, True),
    "new overlaps > 0.1 Angstrom": (0, 0, False, True),
    "flipped chirality": (0, 0, False, True),
    "omega off > 5 degrees": (0, 0, False, True),
    "redrawn at 1.4 Angstrom, %": (1.0, 0.2, False, False),
    "redrawn at 2.8 Angstrom, %": (5.0, 1.0, False, False),
    "nearest frame of reach, Angstrom": (3.0, 2.0, False, False),
}


@dataclass
class Row:
    """One figure of one system; not-a-number is not known or makes no sense there."""

    system: str
    figure: str
    ours: float = NO
    error: float = NO  #: standard error by bootstrap
    network: float = NO  #: of the network alone that frames are drawn from, without geometry
    anm: float = NO
    anm_error: float = NO
    gnm: float = NO
    ceiling: float = NO  #: of random halves of the reference against each other
    must: float = NO  #: where it is not said, as GOALS has it
    aim: float = NO
    least: bool = True  #: `must` and `aim` are the least, else the most
    exact: bool = False  #: not to be missed: the exit code says so
    data: str = NEITHER  #: whether the row was tuned on
    note: str = ""

    def __post_init__(self) -> None:
        goal = GOALS.get((self.system, self.figure)) or GOALS.get(self.figure)
        if goal and not math.isfinite(self.must):
            self.must, self.aim, self.least, self.exact = goal

    @property
    def verdict(self) -> str:
        """Of a row with a goal: missing, missed, met, or met beyond the aim."""
        if self.is_missing:
            return "missing"
        if not math.isfinite(self.must):
            return ""
        if not self._reaches(self.must):
            return "MISSED"
        return "aim met" if self._reaches(self.aim) else "met"

    @property
    def is_missing(self) -> bool:
        """Not measured, because a source or the means are missing; the note says which."""
        return not math.isfinite(self.ours)

    def _reaches(self, goal: float) -> bool:
        return self.ours >= goal if self.least else self.ours <= goal


def number(value: float) -> str:
    """Three decimals of what is near 1, else three digits; nothing for not-a-number."""
    if not math.isfinite(value):
        return ""
    if value == 0:
        return "0"
    return f"{value:.3f}" if 1e-3 <= abs(value) < 10 else f"{value:.3g}"


COLUMNS: dict[str, Cell] = {
    "system": "system",
    "figure": "figure",
    "ours": lambda row: number(row.ours),
    "+-": lambda row: number(row.error),
    "network": lambda row: number(row.network),
    "ANM": lambda row: number(row.anm),
    " +-": lambda row: number(row.anm_error),
    "GNM": lambda row: number(row.gnm),
    "ceiling": lambda row: number(row.ceiling),
    "must": lambda row: number(row.must),
    "aim": lambda row: number(row.aim),
    "": "verdict",
    "data": "data",
}


@dataclass
class Validity(Results):
    """The whole table."""

    frames: int
    rows: list[Row] = field(default_factory=list)
    profiles: dict[str, dict[str, list[float]]] = field(default_factory=dict)  #: of the picture
    sampled: int = 0  #: frames in all, each of which was checked

    @property
    def faults(self) -> list[str]:
        """Rows that must be exact and are not."""
        wrong = (row for row in self.rows if row.exact and row.verdict == "MISSED")
        return [f"{row.system}: {row.figure} {row.ours:.3g}" for row in wrong]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        rows = [asdict(row) | {"verdict": row.verdict} for row in self.rows]
        return super().as_json() | {"rows": rows, "broken": self.faults}

    def print_report(self) -> None:
        """A line a row, its notes below, and what is missed last."""
        print(
            f"{self.frames} frames an ensemble; ANM and GNM from the same file by the same code; "
            "network: that of our modes without geometry;\n+-: standard error by bootstrap; "
            "ceiling: random halves of the reference against each other"
        )
        print_table([row for row in self.rows if not row.is_missing], COLUMNS)
        for row in self.rows:
            if row.note:
                print(f"  {row.system}, {row.figure}: {row.note}")
        goals = [row for row in self.rows if math.isfinite(row.must)]
        missed = [row for row in goals if row.verdict == "MISSED"]
        missing = [row.system for row in self.rows if row.is_missing]
        print(f"{len(goals) - len(missed)} of {len(goals)} goals met")
        for row in missed:
            print(f"missed: {row.system}, {row.figure}: {number(row.ours)} for {number(row.must)}")
        if missing:
            print(f"not measured: {', '.join(missing)}")
        for line in self.faults:
            print(f"wrong: {line}")
