# SPDX-License-Identifier: MIT
"""What the force field found, as a table and lines of text."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pliant.base.console import Table
from pliant.checks.force_field.minimised import LONG, SHORT, ForceFieldReport, Minimised

_COLUMNS = ("structures", "worst force before", "100 steps", "500 steps", "CA moved")


def table_of(report: ForceFieldReport) -> Table:
    """Start, frames of the file and of MD; energies are means with the most in brackets."""
    table = Table(
        "minimised by OpenMM, amber14 + OBC2: energy a residue above the start's, kJ/mol; "
        "mean (most)",
        ["", *_COLUMNS],
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


def lines_of(report: ForceFieldReport) -> list[str]:
    """What the table does not say."""
    if report.why_not:
        return [f"no force field: {report.why_not}", *report.notes]
    lines = [
        f"force field: {report.residues} residues, {report.atoms} atoms, of which "
        f"{report.placed_hydrogens} hydrogens were placed by rule in each frame; cut-off 16 A, "
        f"CPU platform with deterministic forces, one thread a frame; {report.seconds:.0f} s",
        "worst force before: kJ/(mol nm) on an atom, median; a minimiser also repairs broken "
        "frames: how far it moves atoms shows how good the frame was",
    ]
    return lines + report.notes
