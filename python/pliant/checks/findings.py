# SPDX-License-Identifier: MIT
"""What a check found: a status, what was measured, what was allowed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

PASSED, FAILED, SKIPPED, CANNOT = "passed", "failed", "skipped", "openmm_cannot"
#: how titles of findings begin that say whether MD can be started from frames
OF_MD_STARTS = "MD starts: "


@dataclass
class Finding:
    """One line of the report."""

    name: str  #: short and stable, for programs: "frames_whole"
    title: str  #: for people
    status: str  #: "passed", "failed", "skipped" or "openmm_cannot"
    measured: str = ""
    allowed: str = ""
    notes: list[str] = field(default_factory=list)
    figures: dict[str, Any] = field(default_factory=dict)

    @property
    def subject(self) -> str:
        """The title without the answer that it goes into."""
        return self.title.removeprefix(OF_MD_STARTS)

    @property
    def result(self) -> str:
        """The status for people."""
        return "OpenMM cannot" if self.status == CANNOT else self.status

    @property
    def in_words(self) -> str:
        """What was measured and what was allowed."""
        allowed = f" ({self.allowed} allowed)" if self.allowed else ""
        return f"{self.subject}: {self.measured or 'no'}{allowed}".replace(" at most", "")

    def as_json(self) -> dict[str, Any]:
        """The finding as one JSON object."""
        return dict(vars(self))


def verdict(good: bool) -> str:
    """ "passed" or "failed"."""
    return PASSED if good else FAILED
