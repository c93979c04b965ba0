# SPDX-License-Identifier: MIT
"""What a check found: a status, what was measured, what was allowed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

PASSED, FAILED, SKIPPED, CANNOT = "passed", "failed", "skipped", "openmm_cannot"


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

    def as_json(self) -> dict[str, Any]:
        """The finding as one JSON object."""
        return dict(vars(self))


def verdict(good: bool) -> str:
    """ "passed" or "failed"."""
    return PASSED if good else FAILED
