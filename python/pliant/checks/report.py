# SPDX-License-Identifier: MIT
"""The check as text: what was looked at, what was found, who repaired what."""

from __future__ import annotations

import math

from pliant.base.console import Table, printable_name
from pliant.checks.check_report import CheckReport
from pliant.checks.contest import Method, Result
from pliant.checks.findings import Finding
from pliant.checks.force_field import text as force_field


def time_text(seconds: float) -> str:
    """ "4.6 us", "1.2 ms", "3.4 s": two or three digits."""
    if not math.isfinite(seconds):
        return "-"
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size or unit == "us":
            return f"{seconds / size:.3g} {unit}"
    raise AssertionError


def print_report(report: CheckReport) -> None:
    """Prints the report on stdout."""
    recording = report.recording
    print(report.verdict.sentence)
    print(f"{printable_name(recording.path)}: {_headline(report)}")
    covers = report.covers
    if covers.left_out:
        print(
            f"left out of the force field, which has no parameters for them: {covers.without}. "
            "MD starts are of\nthe protein alone; what frames do near these is not checked."
        )
    print()
    _checks_table(report.findings).print()
    if report.methods:
        print()
        _times_table(report.methods).print()
        print()
        _residuals_table(report.methods).print()
    if report.force_field is not None and not report.force_field.why_not:
        print()
        force_field.table_of(report.force_field).print()
    notes = [note for finding in report.findings for note in finding.notes] + report.notes
    notes += [f"{m.name}: {m.description}" for m in report.methods if m.whose == "openmm"]
    if report.force_field is not None:
        notes += force_field.lines_of(report.force_field)
    if notes:
        print("\nnotes")
        print("\n".join(f"  {note}" for note in notes))
    if report.picture:
        print(f"\npicture  {printable_name(report.picture)}")


def _headline(report: CheckReport) -> str:
    recording = report.recording
    kind = "bars (bonds and angles)" if recording.angle_bars else "bars"
    tolerance = recording.tolerance
    exact = f"{tolerance.length:g} A" if tolerance.length > 0 else f"{tolerance.relative:g}"
    return (
        f"{recording.frame_count} frames, {recording.joint_count} atoms, "
        f"{len(recording.bars)} {kind}, tolerance {exact}; "
        f"{len(report.sample.frames)} frames shown to OpenMM {report.openmm_version}"
    )


def _checks_table(findings: list[Finding]) -> Table:
    table = Table("checks", ["what", "result", "measured", "allowed"], text_columns=(0, 1))
    for finding in findings:
        table.rows.append(
            (finding.title, finding.result, finding.measured or "-", finding.allowed or "-")
        )
    return table


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
