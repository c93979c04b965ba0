# SPDX-License-Identifier: MIT
"""The table of coverage for people."""

from __future__ import annotations

import math

from pliant.base import console
from pliant.lab.coverage.directions import COVERED
from pliant.lab.coverage.rows import Coverage, Share

COLUMNS = ("set", "distance, A", "directions", "frames", "ensemble", "covered", "+-", "nearest, A")


def print_report(found: Coverage) -> None:
    """A line a share; then what could not be measured."""
    limits = ", ".join(f"{kind} below {limit:g} A" for kind, limit in COVERED.items())
    print(
        f"share of directions in which a frame comes near the other structure: {limits};\n"
        "+-: standard error by bootstrap over proteins; nearest: mean distance of the nearest frame"
    )
    table = console.Table("", COLUMNS, text_columns=(0, 1, 4))
    table.rows = [_cells(row) for row in found.shares]
    if table.rows:
        table.print()
    for line in found.skipped:
        print(f"not measured: {line}")


def _cells(row: Share) -> list[str]:
    error = f"{row.error:.3f}" if math.isfinite(row.error) else ""
    return [row.kind, row.of_distance, str(row.directions), str(row.frames), row.ensemble,
            f"{row.covered:.3f}", error, f"{row.nearest:.2f}"]  # fmt: skip
