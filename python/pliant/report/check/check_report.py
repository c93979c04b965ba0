# SPDX-License-Identifier: MIT
"""What a check found: its verdict, and its sections."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pliant import _core
from pliant.base.console import Table, listed, printable_name
from pliant.base.display import Displayed, Facts
from pliant.base.verdict import Verdict, verdict_of_all
from pliant.checks import contest as side_by_side
from pliant.checks.check_record import Remeasured
from pliant.checks.contest import Method, Result
from pliant.checks.coverage import Coverage, coverage
from pliant.checks.findings import CANNOT, FAILED, OF_MD_STARTS, Finding
from pliant.checks.force_field.minimised import LONG, SHORT, ForceFieldReport, Minimised
from pliant.checks.force_field.verdicts import md_verdict
from pliant.checks.sample import Sample
from pliant.report.build import Report
from pliant.report.section import Line, Section, Values
from pliant.trajectory.h5md import FramesOfH5md


@dataclass
class CheckReport(Displayed):
    """What `check` found. ``passed`` is the answer; the rest says why."""

    recording: FramesOfH5md
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
        return self._report.verdicts

    @property
    def _report(self) -> Report[CheckReport]:
        """Its sections."""
        return Report(self, SECTIONS)

    @property
    def verdict(self) -> Verdict:
        """What to believe of the frames: made from all findings."""
        return verdict_of_all(self.verdicts.values())

    @property
    def covers(self) -> Coverage:
        """Of which frames and which parts of the molecule the verdict speaks."""
        return coverage(self.recording, self.force_field)

    def facts(self) -> Facts:
        """Each finding with what was measured."""
        checks = [(one.title, f"{one.result}, {one.measured or '-'}") for one in self.findings]
        answer = "yes" if self.passed else "no"
        head = [("verdict", self.verdict.sentence), ("file", self.recording.name)]
        return [*head, ("passed", f"{answer}: {self.covers.text}"), *checks]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return self._report.values


def _bars(report: CheckReport) -> Verdict:
    rows = [one for one in report.findings if not one.title.startswith(OF_MD_STARTS)]
    failed = [one.in_words for one in rows if one.status == FAILED]
    cannot = sum(one.status == CANNOT for one in rows)
    details = f"{cannot} checks are beyond OpenMM." if cannot else ""
    if failed:
        return Verdict("bad", f"Checks failed: {'; '.join(failed)}.", details)
    bars = Coverage(report.covers.frames).text
    return Verdict("good", "Every bar is whole, and OpenMM agrees.", details, bars)


def _md_starts(report: CheckReport) -> Verdict | None:
    found = report.force_field
    if found is not None and not found.why_not:
        return md_verdict(found, len(report.recording))
    if any(one.title.startswith(OF_MD_STARTS) for one in report.findings):
        return Verdict("open", "MD starts were not tested.", "", "MD starts")
    return None


def _head(report: CheckReport) -> Iterator[Line]:
    recording, covers = report.recording, report.covers
    kind = "bars (bonds and angles)" if recording.angle_bars else "bars"
    tolerance = recording.tolerance
    exact = f"{tolerance.length:g} A" if tolerance.length > 0 else f"{tolerance.relative:g}"
    yield report.verdict.sentence
    yield (
        f"{printable_name(recording.name)}: {len(recording)} frames, "
        f"{recording.atom_count} atoms, {len(recording.bars)} {kind}, tolerance {exact}; "
        f"{len(report.sample.frames)} frames shown to OpenMM {report.openmm_version}"
    )
    if covers.left_out:
        of = "the rest" if covers.ligands else "the protein"
        yield (
            f"left out of the force field, which has no parameters for them: {covers.without}. "
            f"MD starts are of\n{of} alone; what frames do near these is not checked."
        )
        yield from _reasons(report.force_field)


def _reasons(found: ForceFieldReport | None) -> Iterator[Line]:
    """Why each of what was left out was."""
    labels: dict[str, list[str]] = {}
    for label, why in (found.why_left_out if found else {}).items():
        labels.setdefault(why, []).append(label)
    for why, those in labels.items():
        yield f"  {listed(those, MOST_NAMED)}: {why}"


def _head_values(report: CheckReport) -> Values:
    recording = report.recording
    return {
        "verdict": report.verdict.kind,
        "verdict_text": report.verdict.sentence,
        "file": recording.name,
        "passed": report.passed,
        "covers": vars(report.covers),
        "pliant": _core.version(),
        "openmm": report.openmm_version,
        "atoms": recording.atom_count,
        "bars": len(recording.bars),
        "pinned": int(recording.pinned.sum()),
        "tolerance": dict(vars(recording.tolerance)),
        "frames": {
            "total": len(recording),
            "not_converged": int((~recording.converged).sum()),
            "shown_to_openmm": report.sample.frames.tolist(),
        },
    }


def findings_table(report: CheckReport, title: str = "checks") -> Table:
    """A line a finding."""
    rows = [
        (one.title, one.result, one.measured or "-", one.allowed or "-") for one in report.findings
    ]
    return Table(title, ["what", "result", "measured", "allowed"], rows, text_columns=(0, 1))


def time_text(seconds: float) -> str:
    """ "4.6 us", "1.2 ms", "3.4 s": two or three digits."""
    if not math.isfinite(seconds):
        return "-"
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size or unit == "us":
            return f"{seconds / size:.3g} {unit}"
    raise AssertionError


def _columns(methods: list[Method]) -> list[str]:
    return ["atoms displaced by", *(f"{r.displacement:g} A" for r in methods[0].results)]


def _times_table(methods: list[Method]) -> Table:
    table = Table(
        "time to repair one structure (Python's call in it), or what became of those not repaired",
        [*_columns(methods), "made ready in"],
    )
    for method in methods:
        ready = [r.ready_seconds for r in method.results if math.isfinite(r.ready_seconds)]
        cells = [_time_cell(result) for result in method.results]
        name = f"{method.name} ({method.description})" if method.whose == "pliant" else method.name
        made = time_text(sorted(ready)[len(ready) // 2]) if ready else "-"
        table.rows.append((name, *cells, made))
    return table


def _time_cell(result: Result) -> str:
    if result.structures and result.whole == result.structures:
        return time_text(result.seconds)
    if len(result.failures) > 1:
        return f"{result.structures - result.whole} of {result.structures} failed"
    return result.outcome


def _residuals_table(methods: list[Method]) -> Table:
    table = Table("largest residual left, measured by us in double precision", _columns(methods))
    before = [f"{r.residual_before:.1e}" for r in methods[0].results]
    table.rows.append(("before (median)", *before))
    for method in methods:
        cells = [_residual_cell(result.worst_residual_after) for result in method.results]
        table.rows.append((method.name, *cells))
    return table


def _residual_cell(residual: float) -> str:
    return f"{residual:.1e}" if math.isfinite(residual) else "no number"


MOST_NAMED = 4  #: of what was left out for one reason
LIGAND_COLUMNS = ("structures", "energy", "contacts", "strain", "moved")
FORCE_FIELD_COLUMNS = ("structures", "worst force before", "100 steps", "500 steps", "CA moved")


def _minimised_table(report: ForceFieldReport) -> Table:
    """Start, frames of the file and of MD; energies are means with the most in brackets."""
    table = Table(
        "minimised by OpenMM, amber14 + OBC2: energy a residue above the start's, kJ/mol; "
        "mean (most)",
        ["", *FORCE_FIELD_COLUMNS],
    )
    table.rows.append(_row(report, "the start", [report.start]))
    table.rows.append(_row(report, "frames of the file", report.usable))
    moved = [frame for frame in report.dynamics if not frame.outcome]
    if report.dynamics:
        table.rows.append(_row(report, f"MD of {report.md_picoseconds:g} ps", moved))
    return table


def _row(report: ForceFieldReport, name: str, structures: Sequence[Minimised]) -> list[str]:
    forces = [s.worst_force for s in structures if not s.outcome]
    return [
        name,
        str(len(structures)),
        f"{np.median(forces):.1e}" if forces else "-",
        _cell(report.above_start(structures, SHORT), "+"),
        _cell(report.above_start(structures, LONG), "+"),
        _cell(report.moved(structures), "") + " A",
    ]


def _cell(values: np.ndarray, sign: str) -> str:
    if len(values) == 0:
        return "-"
    return f"{values.mean():{sign}.2f} ({values.max():{sign}.2f})"


def _ligand_table(report: ForceFieldReport) -> Table:
    """A row for the start, one for the frames, of each ligand; mean and the most."""
    table = Table(
        "ligands after 100 steps, kJ/mol in implicit water; moved: without hydrogens; mean (most)",
        ["", *LIGAND_COLUMNS],
    )
    for label in report.ligands:
        for name, those in (("the start", [report.start]), ("frames", report.usable)):
            found = [one.ligands[label] for one in those if label in one.ligands]
            columns = [np.array([getattr(one, key) for one in found]) for key in LIGAND_COLUMNS[1:]]
            cells = [_cell(column, "") for column in columns]
            table.rows.append([f"{label}, {name}", str(len(found)), *cells[:-1], f"{cells[-1]} A"])
    return table


def _force_field_notes(report: ForceFieldReport) -> list[str]:
    """What the table does not say."""
    if report.why_not:
        return [f"no force field: {report.why_not}", *report.notes]
    lines = [
        f"force field: {report.residues} residues, {report.atoms} atoms, of which "
        f"{report.placed_hydrogens} hydrogens were placed by rule in each frame; cut-off 16 A, "
        f"{_platform(report)}; {report.seconds:.0f} s",
        "worst force before: kJ/(mol nm) on an atom, median; a minimiser also repairs broken "
        "frames: how far it moves atoms shows how good the frame was",
    ]
    return lines + report.notes


def _platform(report: ForceFieldReport) -> str:
    how = {"CPU": "deterministic forces, one thread a frame", "Reference": "double precision"}
    return f"{report.platform} platform with {how.get(report.platform, 'mixed precision')}"


def _contest(report: CheckReport) -> Iterator[Line]:
    if report.methods:
        yield from ("", _times_table(report.methods), "", _residuals_table(report.methods))


def _minimised(report: CheckReport) -> Iterator[Line]:
    if report.force_field is not None and not report.force_field.why_not:
        yield from ("", _minimised_table(report.force_field))
        if report.force_field.ligands:
            yield from ("", _ligand_table(report.force_field))


def _notes(report: CheckReport) -> Iterator[Line]:
    notes = [note for finding in report.findings for note in finding.notes] + report.notes
    notes += [f"{m.name}: {m.description}" for m in report.methods if m.whose == "openmm"]
    if report.force_field is not None:
        notes += _force_field_notes(report.force_field)
    if notes:
        yield "\nnotes"
    yield from (f"  {note}" for note in notes)


SECTIONS: tuple[Section[CheckReport], ...] = (
    Section(name="OpenMM", verdict=_bars, lines=_head, values=_head_values),
    Section(
        name="MD starts",
        verdict=_md_starts,
        lines=lambda report: ["", findings_table(report)],
        values=lambda report: {"checks": [finding.as_json() for finding in report.findings]},
    ),
    Section(
        lines=_contest, values=lambda report: {"side_by_side": side_by_side.as_json(report.methods)}
    ),
    Section(
        lines=_minimised,
        values=lambda report: {
            "force_field": None if report.force_field is None else report.force_field.as_json()
        },
    ),
    Section(lines=_notes, values=lambda report: {"notes": report.notes}),
    Section(
        lines=lambda report: (
            [f"\npicture  {printable_name(report.picture)}"] if report.picture else []
        ),
        values=lambda report: {"picture": report.picture},
    ),
)
