# SPDX-License-Identifier: MIT
"""What a check found, and the answer that it comes down to."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from pliant import _core
from pliant._display import Displayed, Facts
from pliant.check import contest as side_by_side
from pliant.check.check_record import Remeasured
from pliant.check.contest import Method
from pliant.check.coverage import Coverage, coverage
from pliant.check.findings import FAILED, Finding
from pliant.check.force_field.minimised import ForceFieldReport
from pliant.check.recording import Recording
from pliant.check.sample import Sample


@dataclass
class CheckReport(Displayed):
    """What `check` found. ``passed`` is the answer; the rest says why."""

    recording: Recording
    sample: Sample
    remeasured: Remeasured
    findings: list[Finding]
    methods: list[Method]
    openmm_version: str
    tolerance: float  #: relative, at which bars were repaired side by side
    notes: list[str] = field(default_factory=list)
    picture: str | None = None
    force_field: ForceFieldReport | None = None  #: what minimising found; None if not asked for

    @property
    def passed(self) -> bool:
        """No finding failed. What OpenMM cannot do is not a failure of the trajectory."""
        return not self.failed

    @property
    def failed(self) -> list[str]:
        """Names of the findings that failed."""
        return [finding.name for finding in self.findings if finding.status == FAILED]

    @property
    def covers(self) -> Coverage:
        """Of which frames and which parts of the molecule the verdict speaks."""
        return coverage(self.recording, self.force_field)

    def facts(self) -> Facts:
        """Each finding with what was measured."""
        checks = [(one.title, f"{one.status}, {one.measured or '-'}") for one in self.findings]
        answer = "yes" if self.passed else "no"
        return [("file", self.recording.path), ("passed", f"{answer}: {self.covers.text}"), *checks]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        recording = self.recording
        return {
            "file": recording.path,
            "passed": self.passed,
            "covers": vars(self.covers),
            "pliant": _core.version(),
            "openmm": self.openmm_version,
            "atoms": recording.joint_count,
            "bars": len(recording.bars),
            "pinned": int(recording.pinned.sum()),
            "tolerance": dict(vars(recording.tolerance)),
            "frames": {
                "total": recording.frame_count,
                "not_converged": int((~recording.converged).sum()),
                "shown_to_openmm": self.sample.frames.tolist(),
            },
            "checks": [finding.as_json() for finding in self.findings],
            "side_by_side": side_by_side.as_json(self.methods),
            "force_field": None if self.force_field is None else self.force_field.as_json(),
            "notes": self.notes,
            "picture": self.picture,
        }
