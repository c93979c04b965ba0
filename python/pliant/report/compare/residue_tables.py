# SPDX-License-Identifier: MIT
"""The comparison residue by residue as text and as JSON."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from pliant.base.console import Table
from pliant.measure.agreement import TEN
from pliant.measure.compared.residue_report import ResidueComparison, Subspaces
from pliant.report.compare.conclusions import figure_text

WIDTH = 96


def print_residues(found: ResidueComparison) -> None:
    """What follows, what does not, the figures, and how residues were matched."""
    print("what follows")
    _print_lines(found.conclusions)
    if found.cautions:
        print("\nwhat cannot be concluded")
        _print_lines(found.cautions)
    if found.theirs is not None:
        print()
        _table(found).print()
    print("\nresidues")
    _print_lines(found.notes)


def _print_lines(lines: Sequence[str]) -> None:
    for line in lines:
        print(textwrap.fill(line, WIDTH, initial_indent="  ", subsequent_indent="    "))


def _number(value: float) -> str:
    return f"{value:.2f}" if math.isfinite(value) else "-"


def _table(found: ResidueComparison) -> Table:
    table = Table(
        "figures, of residues", ["what", "ours", "theirs", "agreement", "ceiling", "by chance"]
    )
    add = table.rows.append
    assert found.theirs is not None
    means = (_number(float(one.rmsf[found.core].mean())) for one in (found.ours, found.theirs))
    add(("RMSF, mean (A)", *means, f"r {figure_text(found.r)}", _number(found.r_ceiling), "0"))
    if found.ends:
        add(("  with free ends", "", "", f"r {_number(found.r_all)}", "", ""))
    if math.isfinite(found.r_in_time):
        add(("  first and second half of theirs", "", "", "", _number(found.r_in_time), ""))
    if found.subspaces is not None:
        _add_modes(table, found.subspaces)
    return table


def _add_modes(table: Table, both: Subspaces) -> None:
    shares = _number(both.ours.share), _number(both.theirs.share)
    found = f"RMSIP {figure_text(both.rmsip)}", _number(both.ceiling), _number(both.chance)
    table.rows.append((f"first {TEN} modes, share of motion", *shares, *found))
    table.rows.append(("  of theirs within ours", "", "", _number(both.share_covered), "", ""))
    for k in range(3):
        covered = _at(both.covered_ours, k), _at(both.covered_theirs, k)
        table.rows.append((f"  mode {k + 1} in the other's {TEN}", *covered, "", "", ""))


def _at(values: np.ndarray, place: int) -> str:
    return _number(float(values[place])) if place < len(values) else "-"


def residues_json(found: ResidueComparison) -> dict[str, Any]:
    """All of it as one JSON object; what is not known is null."""
    return {
        "kind": found.kind,
        "labels": found.labels,
        "core": found.core.tolist(),
        "free_ends": found.ends,
        "rmsf": {
            name: None if one is None else {"value": one.rmsf, "error": one.error}
            for name, one in (("ours", found.ours), ("theirs", found.theirs))
        },
        "r": {
            "value": found.r.value,
            "error": found.r.error,
            "with_free_ends": found.r_all,
            "ceiling": found.r_ceiling,
            "halves_in_time": found.r_in_time,
        },
        "scale": found.scale,
        "more_in_ours": [asdict(one) for one in found.more_stretches],
        "less_in_ours": [asdict(one) for one in found.less_stretches],
        "modes": _modes_json(found.subspaces) if found.subspaces else None,
        "displacement": asdict(found.displacement) if found.displacement else None,
        "notes": found.notes,
    }


def _modes_json(both: Subspaces) -> dict[str, Any]:
    return {
        "rmsip": asdict(both.rmsip),
        "ceiling": both.ceiling,
        "chance": both.chance,
        "overlaps": both.overlaps,
        "covered_ours": both.covered_ours,
        "covered_theirs": both.covered_theirs,
        "share_ours": both.ours.share,
        "share_theirs": both.theirs.share,
        "share_of_theirs_within_ours": both.share_covered,
        "of_ours_alone": [asdict(one) for one in both.of_ours_alone],
        "of_theirs_alone": [asdict(one) for one in both.of_theirs_alone],
    }
