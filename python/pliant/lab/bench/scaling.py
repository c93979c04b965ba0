# SPDX-License-Identifier: MIT
"""Time and memory against size: chains, branched trees and protein-like frameworks."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.base import console
from pliant.base.extras import need
from pliant.lab.bench.large_frameworks import KINDS

SIZES = (1e3, 1e4, 1e5, 1e6, 1e7)
LIMIT_SECONDS = 300.0  #: for one size of one kind
WORST_BYTES = 900.0  #: a joint of a tree has been seen to need less, its arrays here included


@dataclass
class SizeRow:
    """One size of one kind of framework."""

    kind: str
    joints: int
    bars: int = 0
    outcome: str = "stopped"  #: that of resolve; "stopped" (too slow), "left out", "failed"
    ns_per_bar: float = math.nan
    seconds: float = math.nan  #: of one repair, plan made
    build_seconds: float = math.nan  #: of the framework
    ready_seconds: float = math.nan  #: of the plan
    sweeps: int | None = None
    max_residual: float = math.nan  #: measured anew
    bytes_peak: float = math.nan  #: per joint and bar, peak growth of resident memory
    bytes_after: float = math.nan  #: the same once all is done
    note: str = ""


@dataclass
class Slope:
    """Exponent p of seconds ~ joints^p, by least squares in logarithms."""

    kind: str
    slope: float
    confidence: float  #: half width of the interval of 95 %; not a number for less than 3 sizes


@dataclass
class Scaling:
    """All sizes of all kinds."""

    technique: str
    weighting: float
    tolerance: float
    rows: list[SizeRow] = field(default_factory=list)
    slopes: list[Slope] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Sizes that failed, or that count as whole beyond the tolerance."""
        return [f"{r.kind} of {r.joints}: {text}" for r in self.rows if (text := self._fault(r))]

    def _fault(self, row: SizeRow) -> str:
        if row.outcome == "failed":
            return f"failed: {row.note}"
        if row.outcome == "converged" and not row.max_residual <= self.tolerance * (1 + 1e-9):
            return f"counts as whole, but a bar is off by {row.max_residual:.1e}"
        return ""

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


def default_technique() -> str:
    """``auto`` where the table has it, else ``blocks``."""
    names = [row.name for row in pliant.techniques()]
    return "auto" if "auto" in names else "blocks"


def scaling(
    sizes: Sequence[float] = SIZES,
    *,
    kinds: Sequence[str] = tuple(KINDS),
    technique: str = "",
    weighting: float = 0.5,
    tolerance: float = 1e-6,
    displacement: float = 0.1,
    repeats: int = 3,
    seed: int = 0,
    limit_seconds: float = LIMIT_SECONDS,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Scaling:
    """Measures each kind at each size, each in a process of its own."""
    need("pliant lab bench scaling", "scipy")
    for kind in kinds:
        if kind not in KINDS:
            raise pliant.OptionError(f'no kind named "{kind}"; known: {", ".join(KINDS)}')
    chosen = technique or default_technique()
    # Refuses wrong names and numbers before any work is done.
    pliant.Resolver(pliant.Framework([[0, 1]], [1.0]), chosen, weighting, tolerance=tolerance)
    found = Scaling(chosen, weighting, tolerance)
    options = {
        "technique": chosen,
        "weighting": weighting,
        "tolerance": tolerance,
        "displacement": displacement,
        "repeats": repeats,
        "seed": seed,
    }
    jobs = [(kind, round(size)) for kind in kinds for size in sorted(sizes)]
    for k, (kind, joints) in enumerate(jobs):
        progress(k, len(jobs))
        found.rows.append(_one(kind, joints, options, limit_seconds))
    found.slopes = [slope_of(kind, found.rows) for kind in kinds]
    return found


def _free_bytes() -> float:
    try:
        return float(os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (ValueError, OSError):
        return math.inf


def _one(kind: str, joints: int, options: dict[str, Any], limit_seconds: float) -> SizeRow:
    row = SizeRow(kind, joints)
    if joints * WORST_BYTES > _free_bytes():
        row.outcome, row.note = "left out", "more memory than is free"
        return row
    command = [sys.executable, "-W", "ignore", "-m", "pliant.lab.bench.scaling_child"]
    command.append(json.dumps(options | {"kind": kind, "joints": joints}))
    try:
        ended = subprocess.run(command, capture_output=True, text=True, timeout=limit_seconds)
    except subprocess.TimeoutExpired:
        row.note = f"took more than {limit_seconds:g} s"
        return row
    if ended.returncode != 0:
        row.outcome = "failed"
        row.note = (ended.stderr.strip().splitlines() or [f"exit {ended.returncode}"])[-1]
        return row
    return _fill(row, json.loads(ended.stdout))


def _fill(row: SizeRow, said: dict[str, Any]) -> SizeRow:
    parts = said["joints"] + said["bars"]
    row.joints, row.bars, row.outcome = said["joints"], said["bars"], said["stop"]
    row.seconds = said["seconds"]
    row.build_seconds, row.ready_seconds = said["build_seconds"], said["ready_seconds"]
    row.ns_per_bar = 1e9 * said["seconds"] / max(said["bars"], 1)
    row.sweeps, row.max_residual = said["sweeps"], said["max_residual"]
    row.bytes_peak = math.nan if said["peak_bytes"] is None else said["peak_bytes"] / parts
    row.bytes_after = math.nan if said["bytes"] is None else said["bytes"] / parts
    return row


def slope_of(kind: str, rows: Sequence[SizeRow]) -> Slope:
    """The slope over the rows of that kind that have a time."""
    mine = [r for r in rows if r.kind == kind and r.seconds > 0]
    if len(mine) < 2:
        return Slope(kind, math.nan, math.nan)
    x = np.log10([r.joints for r in mine])
    y = np.log10([r.seconds for r in mine])
    x, y = x - x.mean(), y - y.mean()
    spread = float(x @ x)
    slope = float(x @ y) / spread
    if len(mine) < 3:
        return Slope(kind, slope, math.nan)
    from scipy.stats import t as student

    free = len(mine) - 2
    error = math.sqrt(float(np.sum((y - slope * x) ** 2)) / free / spread)
    return Slope(kind, slope, float(student.ppf(0.975, free)) * error)


def print_report(found: Scaling) -> None:
    """The tables for people."""
    print(f"technique {found.technique}, tolerance {found.tolerance:g}")
    columns = ["framework", "joints", "bars", "outcome", "ns per bar", "plan, ns per bar"]
    columns += ["bytes per joint + bar, peak", "after"]
    table = console.Table("", columns, text_columns=(0, 3))
    for row in found.rows:
        table.rows.append(_cells(row))
    table.print()
    for slope in found.slopes:
        print(
            f"{slope.kind}: time grows with the number of joints to the power {slope.slope:.3f}"
            + (f" +- {slope.confidence:.3f} (95 %)" if math.isfinite(slope.confidence) else "")
        )
    for fault in found.faults:
        print(f"wrong: {fault}")


def _cells(row: SizeRow) -> list[str]:
    if not row.seconds > 0:
        return [row.kind, str(row.joints), "", f"{row.outcome}: {row.note}", "", "", "", ""]
    plan = 1e9 * row.ready_seconds / row.bars
    figures = (row.ns_per_bar, plan), (row.bytes_peak, row.bytes_after)
    cells = [f"{x:.1f}" for x in figures[0]] + [f"{x:.0f}" for x in figures[1]]
    return [row.kind, str(row.joints), str(row.bars), row.outcome, *cells]
