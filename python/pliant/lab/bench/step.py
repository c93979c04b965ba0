# SPDX-License-Identifier: MIT
"""What a step costs after a push of one joint, in small and in large frameworks and molecules."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant.lab.bench.step_memory import bytes_per_joint
from pliant.lab.bench.step_scenes import Scene, check_kind, make_scene
from pliant.lab.results import Cell, Results, print_table
from pliant.measure import bars as _bars

SIZES = (1e4, 1e6)
TECHNIQUES = ("blocks", "auto")
STEPS, ROUNDS = 20_000, 9
SECONDS = 2.0  #: that a round takes at most, by what the first steps take
PILOT = 20  #: steps by which the number of a round's steps is found
LIMIT_TOLERANCE, OVERLAP_TOLERANCE = 0.01, 0.1  #: Angstrom, as of `run`


@dataclass
class StepRow:
    """One technique on one kind of framework of one size. Times are medians over the rounds."""

    kind: str  #: of framework or molecule, or the name of a file
    model: str  #: bonds, angles, molecule or protein
    technique: str
    joints: int
    bars: int
    steps: int = 0  #: of a round
    step_microseconds: float = math.nan  #: push and resolve
    quarter: float = math.nan  #: a quarter of the rounds took less
    three_quarters: float = math.nan  #: a quarter took more
    projections: float = math.nan  #: bars looked at in a step, mean
    ratio: float = math.nan  #: to the smallest size
    ratio_least: float = math.nan  #: three quarters of the smallest over a quarter of this
    ratio_most: float = math.nan
    bytes_per_joint: float | None = None  #: of framework, plan and positions, while it runs
    bytes_to_make: float | None = None  #: at most while the framework is made
    unconverged: int = 0  #: steps
    max_residual: float = math.nan  #: of all bars at the end, measured anew
    max_limit: float = math.nan  #: Angstrom beyond an interval, at the end, measured anew
    max_overlap: float = math.nan  #: Angstrom, at the end, by pliant.measure_bars
    faults: list[str] = field(default_factory=list)


@dataclass
class Steps(Results):
    """All rows."""

    weighting: float
    tolerance: float
    steps: int  #: of a round, at most
    rows: list[StepRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Where bars were broken in the end."""
        return [f"{r.kind} of {r.joints}, {r.technique}: {f}" for r in self.rows for f in r.faults]

    def print_report(self) -> None:
        """A line a technique and size, and what is wrong."""
        print(
            f"a push of one joint, tolerance {self.tolerance:g}, weighting {self.weighting:g} "
            f"where it means something; at most {self.steps} steps a round"
        )
        print_table(self.rows, COLUMNS)
        for fault in self.faults:
            print(f"wrong: {fault}")


COLUMNS: dict[str, Cell] = {
    "framework, model, technique": lambda row: f"{row.kind}, {row.model}, {row.technique}",
    "joints": "joints",
    "us a step": "step_microseconds:.2f",
    "half of the rounds": lambda row: f"{row.quarter:.2f} to {row.three_quarters:.2f}",
    "bars a step": "projections:.1f",
    "ratio": "ratio:.2f",
    "from to": lambda row: f"{row.ratio_least:.2f} to {row.ratio_most:.2f}",
    "bytes a joint": "bytes_per_joint:.0f",
}


class Subject:
    """A framework that is run on and on by one technique; the plan is not among the times."""

    def __init__(self, scene: Scene, technique: str, options: dict[str, Any]) -> None:
        self._framework = scene.framework
        self._bars = np.array(scene.framework.bars, dtype=np.int64).reshape(-1, 2)
        self._lengths = np.array(scene.framework.rest_lengths)
        self._state = pliant.State(scene.positions)
        self._options = options
        self.row = StepRow(
            scene.kind, scene.model, technique, len(scene.positions), len(self._bars)
        )
        self.times: list[float] = []
        self._projections: list[float] = []

    def choose_steps(self, most: int, seconds: float) -> None:
        """So many for a round that it takes `seconds`, but `most` at most."""
        summary = self._go_on(min(PILOT, most))
        step = (summary.perturb_seconds + summary.resolve_seconds) / summary.steps
        self.row.steps = max(1, min(most, int(seconds / max(step, 1e-9))))

    def run(self) -> None:
        """One round: its steps less a quarter as many, so that what only a start takes is out.

        On a busy machine the quarter may take longer: then the start stays in.
        """
        short = self._go_on(self.row.steps // 4) if self.row.steps >= 8 else None
        seconds, projections, steps = _sums(self._go_on(self.row.steps))
        if short is not None and (less := _sums(short))[0] < seconds:
            seconds, projections, steps = (
                seconds - less[0],
                projections - less[1],
                steps - less[2],
            )
        self.times.append(seconds / steps)
        self._projections.append(projections / steps)

    def _go_on(self, steps: int) -> pliant.RunSummary:
        summary: pliant.RunResult = pliant.run(
            self._framework,
            self._state,
            steps=steps,
            every=steps,
            technique=self.row.technique,
            **self._options,
        )
        self.row.unconverged += summary.unconverged_steps
        return summary

    def finish(self, warm_up: int) -> None:
        """Fills the row; the first rounds do not count."""
        row, times = self.row, 1e6 * np.array(self.times[warm_up:])
        row.quarter, row.step_microseconds, row.three_quarters = map(
            float, np.percentile(times, (25, 50, 75))
        )
        row.projections = float(np.mean(self._projections[warm_up:]))
        self._judge(np.asarray(self._state.positions))

    def _judge(self, positions: np.ndarray) -> None:
        row, tolerance = self.row, self._options["tolerance"]
        row.max_residual = _bars.worst_residual(positions, self._bars, self._lengths)
        row.max_limit = worst_limit(positions, self._framework.limits)
        row.max_overlap = float(pliant.measure_bars(self._framework, positions).max_overlap)
        if row.unconverged:
            row.faults.append(f"{row.unconverged} steps did not converge")
        elif not row.max_residual <= tolerance * (1 + 1e-9):
            row.faults.append(f"a bar is off by {row.max_residual:.1e} in the end")
        elif not row.max_limit <= LIMIT_TOLERANCE * (1 + 1e-9):
            row.faults.append(f"a limit is off by {row.max_limit:.1e} Angstrom in the end")
        elif not row.max_overlap <= OVERLAP_TOLERANCE * (1 + 1e-9):
            row.faults.append(f"two joints overlap by {row.max_overlap:.1e} Angstrom in the end")


def _sums(summary: pliant.RunSummary) -> tuple[float, int, int]:
    seconds = summary.perturb_seconds + summary.resolve_seconds
    return seconds, summary.projections, summary.steps


def worst_limit(positions: np.ndarray, limits: Any) -> float:
    """Largest distance in Angstrom by which a pair is outside its interval; 0 without limits."""
    if len(limits) == 0:
        return 0.0
    rows = [tuple(row)[:4] for row in limits]
    pairs = np.array([row[:2] for row in rows], dtype=np.int64)
    least, most = np.array([row[2:] for row in rows]).T
    apart = _bars.lengths(positions, pairs)
    return float(np.max(np.maximum(np.maximum(least - apart, apart - most), 0.0)))


def steps_of_pushes(
    sizes: Sequence[float] = SIZES,
    *,
    kinds: Sequence[str] = ("protein",),
    files: Sequence[str | os.PathLike[str]] = (),
    bars: str = "bonds",
    model: str | None = None,
    techniques: Sequence[str] = (),
    weighting: float = 0.5,
    tolerance: float = 1e-6,
    steps: int = STEPS,
    rounds: int = ROUNDS,
    seconds: float = SECONDS,
    memory: bool = False,
    seed: int = 0,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Steps:
    """Runs every technique on every size in rounds that take turns.

    With `files` their molecules take the place of kinds and sizes; the ratio is to the smallest.
    Raises OptionError for a kind that there is not, and what `read` and `build_model` raise.
    """
    model = model or bars
    techniques = techniques or (TECHNIQUES if model == "bonds" else ("auto",))
    for kind in () if files else kinds:
        check_kind(kind, model)
    found = Steps(weighting, tolerance, steps)
    options = {"weighting": weighting, "tolerance": tolerance, "seed": seed}
    groups: list[list[tuple[str, int | None]]] = [
        [(kind, round(size)) for size in sorted(sizes)] for kind in kinds
    ]
    if files:
        groups = [[(os.fspath(path), None) for path in files]]
    jobs = [(group, technique) for group in groups for technique in techniques]
    for k, (group, technique) in enumerate(jobs):
        progress(k, len(jobs))
        rows = _race(group, model, technique, options, (steps, seconds, rounds))
        if memory:
            for row, (source, size) in zip(rows, group, strict=True):
                _weigh(row, source, size, options)
        found.rows += _with_ratios(rows)
    return found


def _race(
    group: Sequence[tuple[str, int | None]],
    model: str,
    technique: str,
    options: dict[str, Any],
    lengths: tuple[int, float, int],
) -> list[StepRow]:
    steps, seconds, rounds = lengths
    warm_up = 1
    subjects = [Subject(make_scene(*one, model), technique, options) for one in group]
    for subject in subjects:
        subject.choose_steps(steps, seconds)
    for _ in range(rounds + warm_up):
        for subject in subjects:
            subject.run()
    for subject in subjects:
        subject.finish(warm_up)
    return [subject.row for subject in subjects]


def _weigh(row: StepRow, source: str, size: int | None, options: dict[str, Any]) -> None:
    asked = {"source": source, "size": size, "model": row.model, "technique": row.technique}
    weights = bytes_per_joint({**asked, "run": options})
    row.bytes_per_joint, row.bytes_to_make = weights["run"], weights["made"]


def _with_ratios(rows: list[StepRow]) -> list[StepRow]:
    least = min(rows, key=lambda row: row.joints)
    for row in rows:
        row.ratio = row.step_microseconds / least.step_microseconds
        row.ratio_least = row.quarter / least.three_quarters
        row.ratio_most = row.three_quarters / least.quarter
    return rows
