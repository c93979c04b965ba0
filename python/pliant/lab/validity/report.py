# SPDX-License-Identifier: MIT
"""The table of validity for people."""

from __future__ import annotations

import math

from pliant.base import console
from pliant.lab.validity.rows import Row, Validity

COLUMNS = (*"system figure ours +- network ANM +- GNM ceiling must aim".split(), "", "data")


def print_report(found: Validity) -> None:
    """A line a row, its notes below, and what is missed last."""
    print(
        f"{found.frames} frames an ensemble; ANM and GNM from the same file by the same code; "
        "network: that of our modes without geometry;\n+-: standard error by bootstrap; ceiling: "
        "random halves of the reference against each other"
    )
    table = console.Table("", COLUMNS, text_columns=(0, 1, 11, 12))
    table.rows = [_cells(row) for row in found.rows if not row.is_missing]
    if table.rows:
        table.print()
    for row in found.rows:
        if row.note:
            print(f"  {row.system}, {row.figure}: {row.note}")
    _print_verdict(found)


def _print_verdict(found: Validity) -> None:
    goals = [row for row in found.rows if math.isfinite(row.must)]
    missed = [row for row in goals if row.verdict == "MISSED"]
    missing = [row.system for row in found.rows if row.is_missing]
    print(f"{len(goals) - len(missed)} of {len(goals)} goals met")
    for row in missed:
        print(f"missed: {row.system}, {row.figure}: {number(row.ours)} for {number(row.must)}")
    if missing:
        print(f"not measured: {', '.join(missing)}")
    for line in found.broken:
        print(f"wrong: {line}")


def _cells(row: Row) -> list[str]:
    measured = (row.ours, row.error, row.network, row.anm, row.anm_error, row.gnm)
    figures = (*measured, row.ceiling, row.must, row.aim)
    return [row.system, row.figure, *map(number, figures), row.verdict, row.data]


def number(value: float) -> str:
    """Three decimals of what is near 1, else three digits; nothing for not-a-number."""
    if not math.isfinite(value):
        return ""
    if value == 0:
        return "0"
    return f"{value:.3f}" if 1e-3 <= abs(value) < 10 else f"{value:.3g}"
