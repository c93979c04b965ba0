# SPDX-License-Identifier: MIT
"""What a check found, and the answer that it comes down to."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from pliant import _core
from pliant.base.display import Displayed, Facts
from pliant.base.verdict import Verdict, verdict_of_all
from pliant.checks import contest as side_by_side
from pliant.checks.check_record import Remeasured
from pliant.checks.contest import Method
from pliant.checks.coverage import Coverage, coverage
from pliant.checks.findings import CANNOT, FAILED, OF_MD_STARTS, Finding
from pliant.checks.force_field.minimised import ForceFieldReport
from pliant.checks.force_field.verdicts import md_verdict
from pliant.checks.sample import Sample
from pliant.trajectory.recording import Recording


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
    def verdicts(self) -> dict[str, Verdict]:
        """The answers that the verdict is made from."""
        made = {"OpenMM": self._of_bars()}
        if self.force_field is not None and not self.force_field.why_not:
            made["MD starts"] = md_verdict(self.force_field, self.recording.frame_count)
        elif any(one.title.startswith(OF_MD_STARTS) for one in self.findings):
            made["MD starts"] = Verdict("open", "MD starts were not tested.", "", "MD starts")
        return made

    @property
    def verdict(self) -> Verdict:
        """What to believe of the frames: made from all findings."""
        return verdict_of_all(self.verdicts.values())

    def _of_bars(self) -> Verdict:
        rows = [one for one in self.findings if not one.title.startswith(OF_MD_STARTS)]
        failed = [one.in_words for one in rows if one.status == FAILED]
        cannot = sum(one.status == CANNOT for one in rows)
        details = f"{cannot} checks are beyond OpenMM." if cannot else ""
        if failed:
            return Verdict("bad", f"Checks failed: {'; '.join(failed)}.", details)
        bars = Coverage(self.covers.frames).text
        return Verdict("good", "Every bar is whole, and OpenMM agrees.", details, bars)

    @property
    def covers(self) -> Coverage:
        """Of which frames and which parts of the molecule the verdict speaks."""
        return coverage(self.recording, self.force_field)

    def facts(self) -> Facts:
        """Each finding with what was measured."""
        checks = [(one.title, f"{one.result}, {one.measured or '-'}") for one in self.findings]
        answer = "yes" if self.passed else "no"
        head = [("verdict", self.verdict.sentence), ("file", self.recording.path)]
        return [*head, ("passed", f"{answer}: {self.covers.text}"), *checks]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        recording = self.recording
        return {
            "verdict": self.verdict.kind,
            "verdict_text": self.verdict.sentence,
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
