# SPDX-License-Identifier: MIT
"""Rows of the table of coverage."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any


@dataclass(frozen=True)
class Nearest:
    """One direction and one way to make frames."""

    kind: str
    protein: str
    direction: str
    residues: int  #: that both structures have
    ensemble: str
    frames: int
    at_start: float  #: distance of the start from the goal (Angstrom)
    nearest: float  #: of the nearest frame
    limit: float

    @property
    def is_covered(self) -> bool:
        """Whether a frame is nearer than the limit."""
        return self.nearest < self.limit


@dataclass(frozen=True)
class Share:
    """All directions of a kind, or those of some distance, for one way to make frames."""

    kind: str
    ensemble: str
    frames: int
    of_distance: str  #: "all", "0-5", ...
    directions: int
    covered: float  #: share
    error: float  #: of it, by bootstrap over proteins; nan for fewer than two
    nearest: float  #: mean (Angstrom)


@dataclass
class Coverage:
    """The whole table."""

    directions: list[Nearest] = field(default_factory=list)
    shares: list[Share] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: directions that could not be measured, why

    def as_json(self) -> dict[str, Any]:
        """For --json."""
        return asdict(self)
