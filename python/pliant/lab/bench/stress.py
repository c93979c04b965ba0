# SPDX-License-Identifier: MIT
"""Every hard case by every technique, and what OpenMM does with the same, each in a child process.

What must never happen is called a violation: a process that dies, a position that is no number, a
joint moved that is pinned, "converged" where a bar measured anew is beyond the tolerance.
"""

from __future__ import annotations

import math
import pathlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.base.extras import need
from pliant.checks.openmm.angles import MOST_BARS_WITH_ANGLES
from pliant.checks.openmm.child import Job, Outcome, run_jobs
from pliant.lab.bench.least_squares import MOST_BARS, least_squares_floor
from pliant.lab.bench.stress_cases import Broken, Case
from pliant.lab.peers.ccma import NM
from pliant.measure import bars as _bars

WORKER = pathlib.Path(__file__).with_name("stress_worker.py")
LIMIT_SECONDS = 30.0  #: for one technique on one case
MOST_TOGETHER = 20  #: cases that share a child process
CONVERGED, INFEASIBLE, REFUSED = "converged", "infeasible", "refused"


@dataclass
class StressRow:
    """One technique, or OpenMM, on one case."""

    method: str
    weighting: float | None
    outcome: str  #: "converged", "max_sweeps", "infeasible", "not_finite", "refused", "died" ...
    max_residual: float = math.nan  #: measured anew; of a run that of its worst step
    worst_bar: str = ""
    sweeps: int | None = None
    unconverged: int | None = None  #: repairs, or steps of a run, that did not converge
    seconds: float = math.nan
    note: str = ""
    violation: str = ""


@dataclass
class StressCase:
    """One case with all its rows."""

    name: str
    group: str
    source: str
    joints: int
    bars: int
    tolerance: float
    steps: int
    feasible: bool | None
    floor: float = math.nan  #: rms relative residual of least squares, where anyone fell short
    floor_worst_bar: str = ""
    rows: list[StressRow] = field(default_factory=list)
    openmm: StressRow | None = None


@dataclass
class Stress:
    """The whole table."""

    cases: list[StressCase]
    openmm_version: str = ""

    @property
    def violations(self) -> list[str]:
        """One line for each thing that must never happen."""
        return [
            f"{case.name}, {row.method}: {row.violation}"
            for case in self.cases
            for row in case.rows
            if row.violation
        ]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {
            "pliant": pliant.__version__,
            "openmm": self.openmm_version,
            "violations": self.violations,
            "cases": [asdict(case) for case in self.cases],
        }


def stress(
    cases: Sequence[Case],
    *,
    techniques: Sequence[str] = (),
    weightings: Sequence[float] = (0.5,),
    limit_seconds: float = LIMIT_SECONDS,
    openmm: bool = True,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Stress:
    """Tries all techniques, or those named, on all cases."""
    need("pliant lab bench stress", "openmm", "scipy", extra="lab")
    for name in techniques:
        pliant.Resolver(pliant.Framework([[0, 1]], [1.0]), name)  # refuses unknown names
    found = Stress([])
    done = 0
    for batch in _batches(cases):
        progress(done, len(cases))
        made = [(case, case.make()) for case in batch]
        plans = [list(_entries(row, techniques, weightings)) for row in made]
        jobs = [job for plan in plans for _, _, job in plan]
        asked = [_openmm_job(case, start) if openmm else None for case, start in made]
        outcomes, found.openmm_version = run_jobs(
            [*jobs, *filter(None, asked)], limit_seconds, worker=WORKER
        )
        answers = iter(outcomes)
        for (case, start), plan in zip(made, plans, strict=True):
            rows = [_row(case, start, m, w, next(answers)) for m, w, _ in plan]
            found.cases.append(_describe(case, start, rows))
        for row, (case, start), job in zip(found.cases[-len(made) :], made, asked, strict=True):
            row.openmm = _their_row(case, start, next(answers)) if job else None
        done += len(batch)
    return found


def _batches(cases: Sequence[Case]) -> Iterator[list[Case]]:
    """Cases that share a child process; large ones are alone, for their arrays are."""
    together: list[Case] = []
    for case in cases:
        if case.group == "large":
            yield [case]
        else:
            together.append(case)
        if len(together) == MOST_TOGETHER:
            yield together
            together = []
    if together:
        yield together


def _entries(
    made: tuple[Case, Broken], techniques: Sequence[str], weightings: Sequence[float]
) -> Iterator[tuple[str, float | None, Job]]:
    case, start = made
    forest = _is_forest(start)
    arrays = asdict(start)
    for row in pliant.techniques():
        if (techniques and row.name not in techniques) or (row.forests_only and not forest):
            continue
        for weighting in weightings if row.has_weighting else (None,):
            values: dict[str, float | int | str] = {
                "technique": row.name,
                "weighting": 0.5 if weighting is None else weighting,
                "tolerance": case.tolerance,
                "max_sweeps": case.max_sweeps,
                "steps": case.steps,
                "mass_weighted": case.mass_weighted,
            }
            yield row.name, weighting, Job("run" if case.steps else "resolve", values, arrays)


def _is_forest(start: Broken) -> bool:
    try:
        return _framework(start).graph_facts().is_forest
    except pliant.Error:
        return False


def _framework(start: Broken) -> pliant.Framework:
    return pliant.Framework(start.bars.astype(np.uint32), start.rest_lengths, len(start.positions))


def _openmm_job(case: Case, start: Broken) -> Job | None:
    if case.steps or len(start.bars) > MOST_BARS_WITH_ANGLES or len(start.bars) == 0:
        return None
    masses = start.masses.copy()
    masses[start.pinned] = 0.0  # so does OpenMM keep an atom in its place
    arrays = {
        "masses": masses,
        "bars": start.bars,
        "rest_lengths": start.rest_lengths * NM,
        "broken": start.positions[None, None] * NM,
    }
    values: dict[str, float | str] = {"platform": "Reference", "tolerance": case.tolerance}
    values |= {"repeats": 1, "budget_seconds": 10.0}
    return Job("apply_constraints", values, arrays)


def _row(
    case: Case, start: Broken, method: str, weighting: float | None, outcome: Outcome
) -> StressRow:
    row = StressRow(method, weighting, outcome.event, note=outcome.message)
    if outcome.event == "raised":
        row.outcome = REFUSED
    elif outcome.event == "died":
        row.violation = f"the process died: {outcome.message}"
    elif outcome.done:
        _judge(case, start, row, outcome.arrays)
    return row


def _judge(case: Case, start: Broken, row: StressRow, said: dict[str, np.ndarray]) -> None:
    x = said["positions"]
    sweeps, claimed, unconverged, row.seconds = said["numbers"].tolist()
    row.outcome, row.sweeps, row.unconverged = str(said["stop"]), int(sweeps), int(unconverged)
    row.max_residual, row.worst_bar = worst(start, x)
    row.violation = _violation(case, start, row, x, claimed)
    if case.steps:
        row.max_residual = max(row.max_residual, claimed)


def _violation(case: Case, start: Broken, row: StressRow, x: np.ndarray, claimed: float) -> str:
    # What two ways to measure the same length may differ by, relative to a rest length.
    rounding = 1e-12 * (1.0 + row.max_residual)
    if row.outcome == "not_finite":
        same = np.array_equal(x, start.positions, equal_nan=True)
        return "" if same else "lengths that are not finite, but positions were not put back"
    if not np.isfinite(x).all():
        return "a position is not a finite number"
    if len(start.pinned) and not np.array_equal(x[start.pinned], start.positions[start.pinned]):
        return "a pinned joint moved"
    if row.outcome == CONVERGED and not row.max_residual <= case.tolerance + rounding:
        return f"said to have converged, but {row.worst_bar} is off by {row.max_residual:.3e}"
    if case.feasible is False and row.outcome == CONVERGED:
        return "said to have converged on what cannot be whole"
    if not case.steps and not abs(claimed - row.max_residual) <= rounding:
        return f"says that the worst bar is off by {claimed:.3e}, but it is {row.max_residual:.3e}"
    return ""


def worst(start: Broken, x: np.ndarray) -> tuple[float, str]:
    """Largest relative residual, and its bar by name; 0 without bars."""
    if len(start.bars) == 0:
        return 0.0, ""
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        residual = _bars.relative_residuals(x, start.bars, start.rest_lengths)
    bar = int(np.argmax(residual))
    a, b = start.bars[bar]
    return float(residual[bar]), f"{a} - {b}"


def _describe(case: Case, start: Broken, rows: list[StressRow]) -> StressCase:
    found = StressCase(
        case.name,
        case.group,
        case.source,
        len(start.positions),
        len(start.bars),
        case.tolerance,
        case.steps,
        case.feasible,
        rows=rows,
    )
    short = [row for row in rows if row.outcome == "max_sweeps"]
    if not short or case.steps or not 0 < len(start.bars) <= MOST_BARS:
        return found
    x = least_squares_floor(start)
    if x is None:
        return found
    residual = _bars.relative_residuals(x, start.bars, start.rest_lengths)
    found.floor = float(np.sqrt(np.mean(residual**2)))
    found.floor_worst_bar = worst(start, x)[1]
    if case.feasible is False or (case.feasible is None and found.floor > case.tolerance):
        for row in short:
            row.outcome = INFEASIBLE
    return found


def _their_row(case: Case, start: Broken, outcome: Outcome) -> StressRow:
    row = StressRow("ccma", None, outcome.event, note=outcome.message)
    if not outcome.done:
        row.outcome = REFUSED if outcome.event == "raised" else outcome.event
        return row
    x = outcome.arrays["positions"][0, 0] / NM
    row.max_residual, row.worst_bar = worst(start, x)
    row.seconds = float(outcome.arrays["seconds"][0, 0])
    if not (np.isfinite(x).all() and math.isfinite(row.max_residual)):
        row.outcome = "not_finite"
    else:
        whole = row.max_residual <= case.tolerance * (1 + 1e-9) + 1e-12
        row.outcome = CONVERGED if whole else "stopped short, says nothing"
    return row
