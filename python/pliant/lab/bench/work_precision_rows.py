# SPDX-License-Identifier: MIT
"""The diagram of work against precision: a row for each contender at each tolerance."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.base import console
from pliant.lab.bench.target import Target
from pliant.lab.peers.ccma import openmm_version
from pliant.lab.peers.gromacs import Program
from pliant.lab.results import Results, print_table

TOLERANCES = tuple(10.0**-k for k in range(2, 13))
WHOLE, STOPPED, SHORT, LOST = "whole", "stopped", "not converged", "not finite"
FAILED = "failed"  #: GROMACS gave up; the note says why

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

#: The note of a row whose time comes out as nothing or less.
TOO_SHORT = "too short to tell"


@dataclass
class Row:
    """One contender at one tolerance."""

    method: str
    weighting: float | None
    tolerance: float  #: relative, as asked for
    outcome: str = STOPPED  #: "whole", "not converged", "not finite", "failed"; or not asked for
    ns_per_bar: float = math.nan  #: median over the repeats
    sweeps: int | None = None
    projections: int | None = None
    max_residual: float = math.nan  #: largest |length - rest| / rest, measured anew
    displacement: float = math.nan  #: rms distance moved from the broken structure, Angstrom
    displacement_ratio: float = math.nan  #: the same over that of the nearest whole structure
    mass_displacement_ratio: float = math.nan  #: the same, distances weighted by mass
    distance_to_ccma: float = math.nan  #: furthest that a joint is from where CCMA has it, Angstrom
    walkers: int = 1  #: structures that were repaired together; times are of one
    repeats: int = 0
    ratio_to_openmm: float = math.nan  #: CCMA's time to reach this tolerance, over this time
    ratio_to_openmm_in_dynamics: float = math.nan  #: the same, CCMA given the intact directions
    note: str = ""


@dataclass
class WorkPrecision(Results):
    """The whole diagram."""

    target: Target
    bars: str
    displacement: float  #: Angstrom, standard deviation of each coordinate
    nearest_displacement: float  #: rms, Angstrom; not a number if not known
    nearest_mass_displacement: float  #: the same, distances weighted by mass
    initial_residual: float
    tolerances: Sequence[float] = TOLERANCES
    rows: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    #: OpenMM's answers by method and tolerance
    openmm_answers: dict[tuple[str, float], np.ndarray] = field(default_factory=dict)
    gromacs: list[Program] = field(default_factory=list)  #: the builds that took part

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {
            "input": self.target.name,
            "pliant": pliant.__version__,
            "openmm": openmm_version(),
            "gromacs": [asdict(program) for program in self.gromacs],
            "joints": len(self.target.positions),
            "bars": len(self.target.bars),
            "bars_of": self.bars,
            "displaced_by": self.displacement,
            "initial_residual": self.initial_residual,
            "nearest_displacement": self.nearest_displacement,
            "nearest_mass_displacement": self.nearest_mass_displacement,
            "rows": [asdict(row) for row in self.rows],
            "notes": self.notes,
        }

    def print_report(self) -> None:
        """The table for people: quickest at the tightest tolerance first."""
        target = self.target
        print(
            f"{target.name}: {len(target.positions)} joints, {len(target.bars)} bars of "
            f"{self.bars}, each coordinate off by {self.displacement:g} A (standard deviation), "
            f"worst bar by {100 * self.initial_residual:.0f} %"
        )
        print_table(_sorted(self.rows), columns_of(self.tolerances))
        print(
            "moved, by mass: rms distance moved over that to the nearest whole structure, plain "
            "and\nweighted by mass; OpenMM / it: time of CCMA over this one to the same error, "
            "(of CCMA as\nin dynamics)"
        )
        if self.gromacs:
            print(ABOUT_GROMACS.format(", ".join(_build(program) for program in self.gromacs)))
        for note in self.notes:
            console.note(note)


def columns_of(tolerances: Sequence[float]) -> dict[str, Callable[[Sequence[Row]], str]]:
    """What the table says of a contender, of its rows."""
    shown = [t for t in SHOWN if any(math.isclose(t, known) for known in tolerances)]

    def of(tolerance: float, say: Callable[[Row], str]) -> Callable[[Sequence[Row]], str]:
        return lambda rows: "".join(say(r) for r in rows if math.isclose(r.tolerance, tolerance))

    columns = {"ns per bar to": lambda rows: label(rows[0].method, rows[0].weighting)}
    columns |= {f"{t:.0e}": of(t, _time) for t in shown}
    columns |= {"moved": lambda rows: _moved(rows, "displacement_ratio")}
    columns |= {"by mass": lambda rows: _moved(rows, "mass_displacement_ratio")}
    return columns | {f"OpenMM / it at {t:.0e}": of(t, _ratio) for t in RATIOS if t in shown}


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


def _build(program: Program) -> str:
    return f"{program.precision} in {program.version} ({program.simd})"


def _sorted(rows: Sequence[Row]) -> list[list[Row]]:
    def key(own: list[Row]) -> tuple[int, float]:
        whole = [row for row in own if row.outcome == WHOLE]
        return (-len(whole), whole[-1].ns_per_bar if whole else math.inf)

    return sorted(entries(rows).values(), key=key)


def _time(row: Row) -> str:
    if row.outcome != WHOLE:
        return row.outcome
    return TOO_SHORT if math.isnan(row.ns_per_bar) else f"{row.ns_per_bar:.1f}"


def _ratio(row: Row) -> str:
    if math.isnan(row.ratio_to_openmm):
        return ""
    return f"{_times(row.ratio_to_openmm)} ({_times(row.ratio_to_openmm_in_dynamics)})"


def _times(ratio: float) -> str:
    if math.isnan(ratio):
        return "?"
    return f"{ratio:.1f}x" if math.isfinite(ratio) else "never"


def _moved(rows: Sequence[Row], ratio: str) -> str:
    found = [getattr(row, ratio) for row in rows if row.outcome == WHOLE]
    known = [value for value in found if math.isfinite(value)]
    return f"{known[-1]:.3f}" if known else ""


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
