# SPDX-License-Identifier: MIT
"""The stress table for people: a line for each case, a line for each violation."""

from __future__ import annotations

import math
from collections import Counter

from pliant.base import console
from pliant.lab.bench.stress import CONVERGED, Stress, StressCase, StressRow


def print_report(found: Stress) -> None:
    """A line for each case: how many techniques converged, what became of the others."""
    columns = ["case", "bars", "converged", "worst of these", "others", "worst of these"]
    columns += ["least squares", "OpenMM's CCMA"]
    table = console.Table("", columns, text_columns=(0, 4, 7))
    for case in found.cases:
        table.rows.append(_cells(case))
    table.print()
    print(
        f"\n{len(found.cases)} cases, {sum(len(case.rows) for case in found.cases)} repairs or runs"
    )
    print("violations: " + ("none" if not found.violations else str(len(found.violations))))
    for line in found.violations:
        print(f"  {line}")


def _cells(case: StressCase) -> list[str]:
    good = [row for row in case.rows if row.outcome == CONVERGED]
    others = [row for row in case.rows if row.outcome != CONVERGED]
    counts = Counter(row.outcome for row in others)
    floor = f"{case.floor:.1e}, bar {case.floor_worst_bar}" if math.isfinite(case.floor) else ""
    return [
        case.name,
        str(case.bars),
        f"{len(good)} of {len(case.rows)}",
        _worst(good),
        ", ".join(f"{n} {name}" for name, n in counts.items()) + _share(case, others),
        _worst(others),
        floor,
        _openmm(case.openmm),
    ]


def _share(case: StressCase, others: list[StressRow]) -> str:
    """Of a run: in how many of its steps."""
    missed = [row.unconverged for row in others if row.unconverged is not None]
    if not case.steps or not missed:
        return ""
    return f" in {min(missed)} to {max(missed)} of {case.steps} steps"


def _worst(rows: list[StressRow]) -> str:
    known = [row for row in rows if math.isfinite(row.max_residual)]
    if not known:
        return ""
    row = max(known, key=lambda row: row.max_residual)
    return (
        f"{row.max_residual:.1e}"
        if row.outcome == CONVERGED
        else (f"{row.max_residual:.1e}, bar {row.worst_bar}")
    )


def _openmm(row: StressRow | None) -> str:
    if row is None:
        return "not asked"
    if math.isfinite(row.max_residual) and row.outcome != CONVERGED:
        return f"{row.outcome}: {row.max_residual:.1e}"
    return f"{row.outcome}: {row.note}" if row.note else row.outcome
