# SPDX-License-Identifier: MIT
"""The tables of conformers for people."""

from __future__ import annotations

import math

from pliant.base import console
from pliant.lab.conformers.rows import WITHIN, Table

SHARES = ("at", "contender", "made", *(f"{limit:g} A" for limit in WITHIN), "nearest, A", "+-",
          "CPU, s", "start", "failed")  # fmt: skip
DIFFERENCES = ("at", "ours less", "molecules", "nearest, A", "+-", "within 1 A", "+-")
FAULTS = ("contender", "asked", "conformers", "handed", "E/Z", "amides", "contacts", "strain")


def print_report(table: Table) -> None:
    """Shares, differences, faults; then what failed or could not be measured."""
    print(
        f"{table.molecules} molecules with a known conformer, each made anew from its graph; share"
        "\nwith a conformer as near as that to the known one (RMSD of heavy atoms, least over\n"
        "symmetry), mean of the nearest, and CPU time a molecule (user); start: of that, RDKit's\n"
        "for the conformer that ours begin from"
    )
    _print(SHARES, (0, 1), [
        [s.at, s.contender, f"{s.made:.0f}", *(f"{v:.2f}" for v in s.within), _number(s.nearest, 3),
         _number(s.error, 3), _number(s.seconds, 3), f"{s.start_seconds:.3f}",
         str(s.failed or "")]
        for s in table.shares
    ])  # fmt: skip
    print("ours less the others', paired by molecule; +- standard errors")
    _print(DIFFERENCES, (0, 1), [
        [d.at, d.other, str(d.molecules), _number(d.nearest, 3, "+"), _number(d.error, 3),
         _number(d.within, 3, "+"), _number(d.within_error, 3)]
        for d in table.differences
    ])  # fmt: skip
    print(
        "conformers in which handedness, E/Z or a secondary amide changed; share with heavy atoms\n"
        "nearer than 2.6 A, four or more bonds apart; strain: median above the lowest minimum\n"
        "(MMFF94s, as they come, kcal/mol)"
    )
    _print(FAULTS, (0,), [
        [f.contender, str(f.asked), str(f.conformers), str(f.handedness), str(f.double_bonds),
         str(f.amides), _number(f.contacts, 3), _number(f.strain, 1)]
        for f in table.faults
    ])  # fmt: skip
    for row in table.made:
        if row.failure:
            print(f"failed: {row.molecule}, {row.contender} {row.asked}: {row.failure}")
    for line in (*(f"not measured: {one}" for one in table.skipped), *table.left_out):
        print(line)


def _print(columns: tuple[str, ...], text: tuple[int, ...], rows: list[list[str]]) -> None:
    shown = console.Table("", columns, text_columns=text)
    shown.rows = [*rows]
    if rows:
        shown.print()


def _number(value: float, digits: int, sign: str = "") -> str:
    return f"{value:{sign}.{digits}f}" if math.isfinite(value) else ""
