# SPDX-License-Identifier: MIT
"""A row of the table, what it must show, and whether it does."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from typing import Any

import pliant

NO = float("nan")
HELD_OUT, TUNED, CHOSE, NEITHER = "held out", "tuned on", "helped to choose", ""


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
    must: float = NO
    aim: float = NO
    least: bool = True  #: `must` and `aim` are the least, else the most
    exact: bool = False  #: not to be missed: the exit code says so
    data: str = NEITHER  #: whether the row was tuned on
    note: str = ""

    @property
    def verdict(self) -> str:
        """Of a row with a goal: missing, missed, met, or met beyond the aim."""
        if not math.isfinite(self.must):
            return "missing" if self.is_missing else ""
        if self.is_missing:
            return "missing"
        if not self._reaches(self.must):
            return "MISSED"
        return "aim met" if self._reaches(self.aim) else "met"

    @property
    def is_missing(self) -> bool:
        """Not measured, because a source or the means are missing; the note says which."""
        return not math.isfinite(self.ours)

    def _reaches(self, goal: float) -> bool:
        return self.ours >= goal if self.least else self.ours <= goal


@dataclass
class Validity:
    """The whole table."""

    frames: int
    rows: list[Row] = field(default_factory=list)
    profiles: dict[str, dict[str, list[float]]] = field(default_factory=dict)  #: of the picture
    sampled: int = 0  #: frames in all, each of which was checked

    @property
    def broken(self) -> list[str]:
        """Rows that must be exact and are not."""
        wrong = (row for row in self.rows if row.exact and row.verdict == "MISSED")
        return [f"{row.system}: {row.figure} {row.ours:.3g}" for row in wrong]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        rows = [asdict(row) | {"verdict": row.verdict} for row in self.rows]
        return {"pliant": pliant.__version__, **asdict(self), "rows": rows, "broken": self.broken}
