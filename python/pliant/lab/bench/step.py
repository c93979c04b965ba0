# SPDX-License-Identifier: MIT
"""What a step costs after a push of one joint, in small and in large frameworks."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant import _bars, console
from pliant.lab.bench.large_frameworks import KINDS

SIZES = (1e4, 1e6)
TECHNIQUES = ("blocks", "auto")
STEPS, ROUNDS = 20_000, 9


@dataclass
class StepRow:
    """One technique on one kind of framework of one size. Times are medians over the rounds."""

    kind: str
    technique: str
    joints: int
    bars: int
    step_microseconds: float = math.nan  #: push and resolve
    quarter: float = math.nan  #: a quarter of the rounds took less
    three_quarters: float = math.nan  #: a quarter took more
    projections: float = math.nan  #: bars looked at in a step, mean
    ratio: float = math.nan  #: to the smallest size
    ratio_least: float = math.nan  #: three quarters of the smallest over a quarter of this
    ratio_most: float = math.nan
    unconverged: int = 0  #: steps
    max_residual: float = math.nan  #: at the end, measured anew
    faults: list[str] = field(default_factory=list)


@dataclass
class Steps:
    """All rows."""

    weighting: float
    tolerance: float
    steps: int  #: of a round
    rows: list[StepRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Where bars were broken in the end."""
        return [f"{r.kind} of {r.joints}, {r.technique}: {f}" for r in self.rows for f in r.faults]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


class Subject:
    """A framework that is run on and on by one technique; the plan is not among the times."""

    def __init__(self, kind: str, size: int, technique: str, options: dict[str, Any]) -> None:
        large = KINDS[kind](size)
        self._bars = large.bars
        self._lengths = _bars.lengths(large.positions, large.bars)
        self._framework = pliant.Framework(
            large.bars.astype(np.uint32), self._lengths, len(large.positions)
        )
        self._state = pliant.State(large.positions)
        self._options = options
        self.row = StepRow(kind, technique, len(large.positions), len(large.bars))
        self.times: list[float] = []
        self._projections: list[float] = []

    def run(self, steps: int) -> None:
        """So many steps more, timed by the run's own summary."""
        summary = pliant.run(
            self._framework,
            self._state,
            steps=steps,
            every=steps,
            technique=self.row.technique,
            **self._options,
        )
        self.times.append((summary.perturb_seconds + summary.resolve_seconds) / steps)
        self._projections.append(summary.projections / steps)
        self.row.unconverged += summary.unconverged_steps

    def finish(self, warm_up: int) -> None:
        """Fills the row; the first rounds do not count."""
        row, times = self.row, 1e6 * np.array(self.times[warm_up:])
        row.quarter, row.step_microseconds, row.three_quarters = map(
            float, np.percentile(times, (25, 50, 75))
        )
        row.projections = float(np.mean(self._projections[warm_up:]))
        row.max_residual = _bars.worst_residual(self._state.positions, self._bars, self._lengths)
        if row.unconverged:
            row.faults.append(f"{row.unconverged} steps did not converge")
        elif not row.max_residual <= self._options["tolerance"] * (1 + 1e-9):
            row.faults.append(f"a bar is off by {row.max_residual:.1e} in the end")


def steps_of_pushes(
    sizes: Sequence[float] = SIZES,
    *,
    kinds: Sequence[str] = ("protein",),
    techniques: Sequence[str] = TECHNIQUES,
    weighting: float = 0.5,
    tolerance: float = 1e-6,
    steps: int = STEPS,
    rounds: int = ROUNDS,
    seed: int = 0,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Steps:
    """Runs every technique on every size in rounds that take turns."""
    for kind in kinds:
        if kind not in KINDS:
            raise pliant.OptionError(f'no kind named "{kind}"; known: {", ".join(KINDS)}')
    found = Steps(weighting, tolerance, steps)
    options = {"weighting": weighting, "tolerance": tolerance, "seed": seed}
    jobs = [(kind, technique) for kind in kinds for technique in techniques]
    warm_up = 1
    for k, (kind, technique) in enumerate(jobs):
        progress(k, len(jobs))
        subjects = [Subject(kind, round(size), technique, options) for size in sorted(sizes)]
        for _ in range(rounds + warm_up):
            for subject in subjects:
                subject.run(steps)
        for subject in subjects:
            subject.finish(warm_up)
        found.rows += _with_ratios([subject.row for subject in subjects])
    return found


def _with_ratios(rows: list[StepRow]) -> list[StepRow]:
    least = rows[0]
    for row in rows:
        row.ratio = row.step_microseconds / least.step_microseconds
        row.ratio_least = row.quarter / least.three_quarters
        row.ratio_most = row.three_quarters / least.quarter
    return rows


def print_report(found: Steps) -> None:
    """The table for people."""
    print(
        f"a push of one joint, tolerance {found.tolerance:g}, weighting {found.weighting:g} where "
        f"it means something; {found.steps} steps a round"
    )
    columns = ["framework, technique", "joints", "us a step", "half of the rounds"]
    columns += ["bars a step", "ratio", "from to"]
    table = console.Table("", columns)
    table.rows = [_cells(row) for row in found.rows]
    table.print()
    for fault in found.faults:
        print(f"wrong: {fault}")


def _cells(row: StepRow) -> list[str]:
    return [
        f"{row.kind}, {row.technique}",
        str(row.joints),
        f"{row.step_microseconds:.2f}",
        f"{row.quarter:.2f} to {row.three_quarters:.2f}",
        f"{row.projections:.1f}",
        f"{row.ratio:.2f}",
        f"{row.ratio_least:.2f} to {row.ratio_most:.2f}",
    ]
