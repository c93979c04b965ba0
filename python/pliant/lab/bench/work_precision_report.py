# SPDX-License-Identifier: MIT
"""Work against precision as a table, as CSV and as a picture."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pliant.base import console
from pliant.lab.bench.work_precision_rows import TOO_SHORT, WHOLE, Row, WorkPrecision
from pliant.lab.peers.gromacs import Program

SHOWN = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)  #: tolerances that the table has columns for
RATIOS = (1e-6, 1e-10)
LEAST_SHOWN = 1e-16  #: where exact zeros are drawn
LABELS = {"ccma": "OpenMM CCMA", "ccma_dynamics": "OpenMM CCMA, as in dynamics"} | {
    f"gromacs_{algorithm}_{precision}": f"GROMACS {algorithm.upper()}, {precision}"
    for precision in ("double", "single")
    for algorithm in ("lincs", "shake")
}
ABOUT_GROMACS = """\
GROMACS is run as in dynamics, each step another push of the same size; its time is what its log
has for the constraints of a step, its error the worst bar's at half of the steps looked at;
precision is that of positions: {}"""
TOLD_INTACT = {"shake_dynamics": "shake, as in dynamics"}


def entries(rows: Sequence[Row]) -> dict[tuple[str, float | None], list[Row]]:
    """Rows by method and weighting, in the order in which they came."""
    grouped: dict[tuple[str, float | None], list[Row]] = {}
    for row in rows:
        grouped.setdefault((row.method, row.weighting), []).append(row)
    return grouped


def label(method: str, weighting: float | None) -> str:
    """How tables and pictures call an entry."""
    name = (LABELS | TOLD_INTACT).get(method, method)
    if method.endswith("_lanes"):
        name = method.removesuffix("_lanes") + ", walkers in lanes"
    return name if weighting is None else f"{name} {weighting:g}"


def at(rows: Sequence[Row], tolerance: float) -> Row | None:
    """The row of that tolerance."""
    return next((r for r in rows if math.isclose(r.tolerance, tolerance, rel_tol=1e-6)), None)


def print_report(found: WorkPrecision) -> None:
    """The table for people: quickest at the tightest tolerance first."""
    target = found.target
    print(
        f"{target.name}: {len(target.positions)} joints, {len(target.bars)} bars of {found.bars}, "
        f"each coordinate off by {found.displacement:g} A (standard deviation), worst bar by "
        f"{100 * found.initial_residual:.0f} %"
    )
    shown = [t for t in SHOWN if any(math.isclose(t, known) for known in found.tolerances)]
    columns = ["ns per bar to", *(f"{t:.0e}" for t in shown), "moved", "by mass"]
    columns += [f"OpenMM / it at {t:.0e}" for t in RATIOS if t in shown]
    table = console.Table("", columns)
    for (method, weighting), rows in _sorted(found.rows):
        cells = [_time(at(rows, t)) for t in shown]
        ratios = [_ratio(at(rows, t)) for t in RATIOS if t in shown]
        table.rows.append([label(method, weighting), *cells, *_moved(rows), *ratios])
    table.print()
    print(
        "moved, by mass: rms distance moved over that to the nearest whole structure, plain and\n"
        "weighted by mass; OpenMM / it: time of CCMA over this one to the same error, (of CCMA as\n"
        "in dynamics)"
    )
    if found.gromacs:
        print(ABOUT_GROMACS.format(", ".join(_build(program) for program in found.gromacs)))
    for note in found.notes:
        console.note(note)


def _build(program: Program) -> str:
    return f"{program.precision} in {program.version} ({program.simd})"


def _sorted(rows: Sequence[Row]) -> list[tuple[tuple[str, float | None], list[Row]]]:
    def key(item: tuple[object, list[Row]]) -> tuple[int, float]:
        whole = [r for r in item[1] if r.outcome == WHOLE]
        return (-len(whole), whole[-1].ns_per_bar if whole else math.inf)

    return sorted(entries(rows).items(), key=key)


def _time(row: Row | None) -> str:
    if row is None:
        return ""
    if row.outcome != WHOLE:
        return row.outcome
    return TOO_SHORT if math.isnan(row.ns_per_bar) else f"{row.ns_per_bar:.1f}"


def _ratio(row: Row | None) -> str:
    if row is None or math.isnan(row.ratio_to_openmm):
        return ""
    return f"{_times(row.ratio_to_openmm)} ({_times(row.ratio_to_openmm_in_dynamics)})"


def _times(ratio: float) -> str:
    if math.isnan(ratio):
        return "?"
    return f"{ratio:.1f}x" if math.isfinite(ratio) else "never"


def _moved(rows: Sequence[Row]) -> tuple[str, str]:
    whole = [r for r in rows if r.outcome == WHOLE and math.isfinite(r.displacement_ratio)]
    if not whole:
        return "", ""
    return f"{whole[-1].displacement_ratio:.3f}", f"{whole[-1].mass_displacement_ratio:.3f}"


def reached(rows: Sequence[Row]) -> tuple[np.ndarray, np.ndarray]:
    """Errors reached and ns per bar of rows that are whole; of equal errors the first, quickest."""
    kept: list[Row] = []
    for row in rows:
        if row.outcome != WHOLE or (kept and row.max_residual > 0.5 * kept[-1].max_residual):
            continue
        kept.append(row)
    return (
        np.array([max(row.max_residual, LEAST_SHOWN) for row in kept]),
        np.array([row.ns_per_bar for row in kept]),
    )
