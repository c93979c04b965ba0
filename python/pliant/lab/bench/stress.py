# SPDX-License-Identifier: MIT
"""Every hard case by every technique, each in a child process.

What must never happen is called a violation: a process that dies, a position that is no number, a
joint moved that is pinned, "converged" where a bar measured anew is beyond the tolerance.
"""

from __future__ import annotations

import itertools
import math
import pathlib
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.checks.openmm import worker
from pliant.checks.openmm.child import Job, Outcome, run_jobs
from pliant.lab.bench.stress_cases import Case
from pliant.lab.bench.stress_frameworks import Broken
from pliant.lab.results import Results, print_table
from pliant.measure import bars as _bars

LIMIT_SECONDS = 30.0  #: for one technique on one case
MOST_TOGETHER = 20  #: cases that share a child process
CONVERGED, REFUSED = "converged", "refused"


@dataclass
class Row:
    """One technique on one case."""

    case: str
    bars: int
    steps: int
    method: str
    weighting: float | None
    outcome: str  #: "converged", "max_sweeps", "not_finite", "refused", "died", "too_slow"
    max_residual: float = math.nan  #: measured anew; of a run that of its worst step
    worst_bar: str = ""
    sweeps: int | None = None
    unconverged: int | None = None  #: repairs, or steps of a run, that did not converge
    seconds: float = math.nan
    note: str = ""
    violation: str = ""


@dataclass
class Stress(Results):
    """All techniques on all cases."""

    rows: list[Row] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """The violations."""
        return [f"{row.case}, {row.method}: {row.violation}" for row in self.rows if row.violation]

    def print_report(self) -> None:
        """A line for each case: how many techniques converged, what became of the others."""
        groups = itertools.groupby(self.rows, lambda row: row.case)
        cases = [list(rows) for _, rows in groups]
        print_table(cases, COLUMNS)
        print(f"\n{len(cases)} cases, {len(self.rows)} repairs or runs")
        print(f"violations: {len(self.faults) or 'none'}")
        for line in self.faults:
            print(f"  {line}")


def _good(rows: Sequence[Row]) -> list[Row]:
    return [row for row in rows if row.outcome == CONVERGED]


def _others(rows: Sequence[Row]) -> list[Row]:
    return [row for row in rows if row.outcome != CONVERGED]


def _outcomes(rows: Sequence[Row]) -> str:
    """Of those that did not converge; of a run in how many of its steps."""
    others = _others(rows)
    counts = Counter(row.outcome for row in others)
    text = ", ".join(f"{count} {name}" for name, count in counts.items())
    missed = [row.unconverged for row in others if row.unconverged is not None]
    if rows[0].steps and missed:
        text += f" in {min(missed)} to {max(missed)} of {rows[0].steps} steps"
    return text


def _worst(rows: Sequence[Row]) -> str:
    known = [row for row in rows if math.isfinite(row.max_residual)]
    if not known:
        return ""
    row = max(known, key=lambda row: row.max_residual)
    return f"{row.max_residual:.1e}, bar {row.worst_bar}"


COLUMNS: dict[str, Callable[[Sequence[Row]], object]] = {
    "case": lambda rows: rows[0].case,
    "bars": lambda rows: rows[0].bars,
    "converged": lambda rows: f"{len(_good(rows))} of {len(rows)}",
    "worst of these": lambda rows: _worst(_good(rows)),
    "others": _outcomes,
    "worst of them": lambda rows: _worst(_others(rows)),
}


def stress(
    cases: Sequence[Case],
    *,
    techniques: Sequence[str] = (),
    weightings: Sequence[float] = (0.5,),
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Stress:
    """Tries all techniques, or those named, on all cases."""
    for name in techniques:
        pliant.Resolver(pliant.Framework([[0, 1]], [1.0]), name)  # refuses unknown names
    found = Stress()
    done = 0
    for batch in _batches(cases):
        progress(done, len(cases))
        plan = [
            (case, start, row, job)
            for case, start in ((case, case.make()) for case in batch)
            for row, job in _entries(case, start, techniques, weightings)
        ]
        outcomes, _ = run_jobs([job for *_, job in plan], LIMIT_SECONDS, worker=WORKER)
        for (case, start, row, _), outcome in zip(plan, outcomes, strict=True):
            _fill(case, start, row, outcome)
            found.rows.append(row)
        done += len(batch)
    return found


def _batches(cases: Sequence[Case]) -> Iterator[Sequence[Case]]:
    """Cases that share a child process; large ones are alone, for their arrays are."""
    large = [case for case in cases if case.group == "large"]
    others = [case for case in cases if case.group != "large"]
    yield from (others[k : k + MOST_TOGETHER] for k in range(0, len(others), MOST_TOGETHER))
    yield from ([case] for case in large)


def _entries(
    case: Case, start: Broken, techniques: Sequence[str], weightings: Sequence[float]
) -> Iterator[tuple[Row, Job]]:
    forest = _is_forest(start)
    arrays = asdict(start)
    for entry in pliant.techniques():
        if (techniques and entry.name not in techniques) or (entry.forests_only and not forest):
            continue
        for weighting in weightings if entry.has_weighting else (None,):
            values: dict[str, float | int | str] = {
                "technique": entry.name,
                "weighting": 0.5 if weighting is None else weighting,
                "tolerance": case.tolerance,
                "max_sweeps": case.max_sweeps,
                "steps": case.steps,
                "mass_weighted": case.mass_weighted,
            }
            row = Row(case.name, len(start.bars), case.steps, entry.name, weighting, "")
            yield row, Job("run" if case.steps else "resolve", values, arrays)


def _is_forest(start: Broken) -> bool:
    try:
        bars, joints = start.bars.astype(np.uint32), len(start.positions)
        return pliant.Framework(bars, start.rest_lengths, joints).graph_facts().is_forest
    except pliant.Error:
        return False


def _fill(case: Case, start: Broken, row: Row, outcome: Outcome) -> None:
    """What came of it, and whether that may be."""
    row.outcome, row.note = outcome.event, outcome.message
    if outcome.event == "raised":
        row.outcome = REFUSED
    elif outcome.event == "died":
        row.violation = f"the process died: {outcome.message}"
    elif outcome.done:
        _judge(case, start, row, outcome.arrays)


def _judge(case: Case, start: Broken, row: Row, said: dict[str, np.ndarray]) -> None:
    x = said["positions"]
    sweeps, claimed, unconverged, row.seconds = said["numbers"].tolist()
    row.outcome, row.sweeps, row.unconverged = str(said["stop"]), int(sweeps), int(unconverged)
    row.max_residual, row.worst_bar = worst(start, x)
    row.violation = _violation(case, start, row, x, claimed)
    if case.steps:
        row.max_residual = max(row.max_residual, claimed)


def _violation(case: Case, start: Broken, row: Row, x: np.ndarray, claimed: float) -> str:
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


# What follows works in the child process, which runs this file as that of OpenMM's jobs is run.

WORKER = pathlib.Path(__file__)
OPTIONS: dict[str, Callable[[Any], object]] = {
    "technique": str, "weighting": float, "tolerance": float, "max_sweeps": int,
}  # fmt: skip  # some pairs a line


def _asked(job: Mapping[str, Any]) -> tuple[pliant.Framework, np.ndarray, dict[str, Any]]:
    """Framework, positions and options of a job."""
    count = len(job["positions"])
    how = {"masses": job["masses"], "pinned": job["pinned"]}
    framework = pliant.Framework(job["bars"].astype(np.uint32), job["rest_lengths"], count, **how)
    options = {name: kind(job[name]) for name, kind in OPTIONS.items()}
    return framework, job["positions"].copy(), options


def resolve(job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """One repair by one technique; numbers: sweeps, residual, how many not converged, seconds."""
    framework, x, options = _asked(job)
    done = pliant.resolve(framework, x, mass_weighted=bool(job["mass_weighted"]), **options)
    numbers = [done.sweeps, done.max_residual, not done.converged, done.seconds]
    return {"positions": x, "stop": np.array(done.stop.name), "numbers": np.array(numbers)}


def run(job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Many steps of random pushes; what is left at the end, and what the worst step left."""
    framework, x, options = _asked(job)
    steps = int(job["steps"])
    done = pliant.run(framework, x, steps=steps, every=steps, **options)
    numbers = [done.sweeps, done.worst_residual, done.unconverged_steps, done.seconds]
    stop = np.array(CONVERGED if done.converged else "max_sweeps")
    positions = np.array(done.state.positions)
    return {"positions": positions, "stop": stop, "numbers": np.array(numbers)}


if __name__ == "__main__":
    kinds = {"resolve": resolve, "run": run}
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), kinds)
