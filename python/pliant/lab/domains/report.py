# SPDX-License-Identifier: MIT
"""The table of domains for people."""

from __future__ import annotations

import math

import numpy as np

from pliant.base import console
from pliant.lab.domains.measure import Row, Table

COLUMNS = ("protein", "structure", "residues", "domains by seed", "contradicted", "of the pair",
           "found by seeds", "agreement", "worst")  # fmt: skip


def print_report(table: Table) -> None:
    """A line a structure, and what they say together."""
    print(
        "domains by seed: how many are reported, 1 for one piece, 0 for none that repeat;\n"
        "contradicted: pairs of residues, in one domain by one seed and in two by another;\n"
        "agreement: share of the residues reported that are in the pair's domain that goes with it"
    )
    shown = console.Table("", COLUMNS, text_columns=(0, 1, 3, 6))
    shown.rows = [_cells(row) for row in table.rows]
    if shown.rows:
        shown.print()
        print(_together(table.rows))
    for line in table.skipped:
        print(f"not measured: {line}")


def _together(rows: list[Row]) -> str:
    proteins = {row.protein for row in rows if row.pair}
    shown = {row.protein for row in rows if row.pair and row.is_shown}
    agreed = [row.agreement for row in rows if math.isfinite(row.agreement)]
    mean = f"; mean agreement {np.mean(agreed):.3f}" if agreed else ""
    pairs = sum(row.contradicted for row in rows)
    return f"shown for {len(shown)} of {len(proteins)} proteins{mean}; {pairs} pairs contradicted"


def _cells(row: Row) -> list[str]:
    values = [f"{v:.2f}" if math.isfinite(v) else "" for v in (row.agreement, row.worst)]
    numbers, found = (" ".join(map(str, one)) for one in (row.numbers, row.found))
    pair = "" if row.pair is None else str(row.pair)
    return [row.protein, row.structure, str(row.residues), numbers, str(row.contradicted), pair,
            found, *values]  # fmt: skip
