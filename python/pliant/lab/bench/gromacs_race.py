# SPDX-License-Identifier: MIT
"""GROMACS' part of the race: LINCS and SHAKE, in each precision that is installed.

LINCS knows no tolerance, so that settings of it are tried until the tightest tolerance is met or
more work gains nothing; a row has the quickest setting that meets its tolerance. Each step of a run
is another push of the same size, with the structure before it as in dynamics; a run's error is the
median over its frames of the worst bar's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from pliant.lab.bench.target import Target
from pliant.lab.bench.work_precision_rows import FAILED, LOST, SHORT, WHOLE, Row, WorkPrecision
from pliant.lab.peers.gromacs import Gromacs, Program, Run, lincs_settings, programs
from pliant.lab.peers.gromacs_files import Setting

ORDERS = (4, 8)  #: of LINCS: the default, and what GROMACS' manual recommends for large steps
RUN_SECONDS = 0.5  #: of constraints in a run that counts: the log has thousandths
MOST_ROUNDS = 5
TIME_LIMIT = 60.0  #: seconds for a run
SLACK = 1.02  #: SHAKE judges squared lengths, and rounds what it judged
TIMED_FOR_EACH = 2  #: settings that are timed for a tolerance: those quickest when first tried


@dataclass
class Tried:
    """A setting and what its runs gave."""

    setting: Setting
    failure: str = ""
    residuals: list[float] = field(default_factory=list)  #: of the worst bar, a frame each
    first_seconds: float = math.nan  #: for a step when first tried
    seconds: list[float] = field(default_factory=list)  #: for a step, a round each

    @property
    def residual(self) -> float:
        """What a step leaves."""
        return float(np.median(self.residuals)) if self.residuals else math.nan

    def meets(self, tolerance: float) -> bool:
        """It does what was asked."""
        return self.residual <= tolerance * SLACK

    def add(self, run: Run, target: Target) -> None:
        """Takes note of a run."""
        self.failure = self.failure or run.failure
        self.residuals += [target.residual(frame) for frame in run.frames]


@dataclass
class Series:
    """An algorithm in one precision."""

    program: Program
    algorithm: str
    tried: list[Tried] = field(default_factory=list)

    @property
    def method(self) -> str:
        """Its name in the rows."""
        return f"gromacs_{self.algorithm}_{self.program.precision}"

    def __str__(self) -> str:
        return f"GROMACS {self.algorithm.upper()} in {self.program.precision} precision"


def race_gromacs(
    found: WorkPrecision,
    repeats: int,
    progress: Callable[[int, int], None] = lambda *_: None,
    run_seconds: float = RUN_SECONDS,
) -> None:
    """Adds GROMACS' rows, or the note that it is not installed."""
    found.gromacs = programs()
    if not found.gromacs:
        found.notes.append("GROMACS takes no part: there is neither gmx_d nor gmx on PATH")
        return
    target = found.target
    with Gromacs(
        target.positions, target.masses, target.bars, target.rest_lengths, found.displacement
    ) as molecule:
        series = [Series(p, name) for p in found.gromacs for name in ("lincs", "shake")]
        for one in series:
            _try_settings(one, molecule, found)
        _rounds(series, molecule, found, min(repeats, MOST_ROUNDS), run_seconds, progress)
    for one in series:
        found.rows += rows_of(one, found)


def _try_settings(series: Series, molecule: Gromacs, found: WorkPrecision) -> None:
    if series.algorithm == "shake":
        ladders = [[Setting("shake", tolerance=tolerance) for tolerance in found.tolerances]]
    else:
        ladders = [list(lincs_settings(order)) for order in ORDERS]

    def first(setting: Setting) -> Tried:
        run = molecule.trial(series.program, setting, TIME_LIMIT)
        tried = Tried(setting, first_seconds=run.seconds)
        tried.add(run, found.target)
        return tried

    for ladder in ladders:
        series.tried += climb(ladder, first, found.tolerances[-1])


def climb(
    ladder: Iterable[Setting], first: Callable[[Setting], Tried], tightest: float
) -> Iterator[Tried]:
    """Tries settings from the least exact on, as long as more work gains something."""
    least = math.inf
    for setting in ladder:
        tried = first(setting)
        yield tried
        if tried.failure or tried.meets(tightest) or not _gained(tried, least):
            return
        least = tried.residual


def _gained(tried: Tried, least: float) -> bool:
    if tried.setting.algorithm == "shake":
        return tried.meets(tried.setting.tolerance)
    return tried.residual <= 0.5 * least


def worth_timing(series: Series, tolerances: Sequence[float]) -> list[Tried]:
    """For each tolerance the quickest that meet it, by the errors of the first run."""
    chosen: list[Tried] = []
    for tolerance in tolerances:
        able = [t for t in series.tried if not t.failure and t.meets(tolerance)]
        able.sort(key=lambda t: t.first_seconds)
        chosen += [t for t in able[:TIMED_FOR_EACH] if t not in chosen]
    return chosen


def _rounds(
    series: Sequence[Series],
    molecule: Gromacs,
    found: WorkPrecision,
    rounds: int,
    run_seconds: float,
    progress: Callable[[int, int], None],
) -> None:
    entries = [(one, t) for one in series for t in worth_timing(one, found.tolerances)]
    for number in range(rounds):
        for k, (one, tried) in enumerate(entries):
            progress(number * len(entries) + k, rounds * len(entries))
            steps = int(run_seconds / tried.first_seconds)
            run = molecule.run(one.program, tried.setting, steps, number + 2, TIME_LIMIT)
            tried.add(run, found.target)
            tried.seconds += [] if run.failure else [run.seconds]


def rows_of(series: Series, found: WorkPrecision) -> list[Row]:
    """A row for each tolerance: the quickest timed setting that meets it, or the best there is."""
    rows: list[Row] = []
    why_not = ""
    for tolerance in found.tolerances:
        row = Row(series.method, None, tolerance, note=why_not)
        rows.append(row)
        if why_not:
            continue
        able = [t for t in series.tried if t.seconds and not t.failure and t.meets(tolerance)]
        if able:
            _fill(row, min(able, key=lambda t: np.median(t.seconds)), found)
            row.outcome = WHOLE
        else:
            _fall_short(row, series, found)
            why_not = f"{row.outcome} at {tolerance:.0e}"
    return rows


def _fill(row: Row, tried: Tried, found: WorkPrecision) -> None:
    seconds = float(np.median(tried.seconds)) if tried.seconds else tried.first_seconds
    row.ns_per_bar = 1e9 * seconds / len(found.target.bars)
    row.max_residual, row.repeats = tried.residual, len(tried.seconds)
    row.note = tried.failure or str(tried.setting)


def _fall_short(row: Row, series: Series, found: WorkPrecision) -> None:
    ended = [t for t in series.tried if not t.failure and math.isfinite(t.residual)]
    if ended:
        _fill(row, min(ended, key=lambda t: t.residual), found)
        row.outcome = SHORT
    else:
        _fill(row, series.tried[0], found)
        row.outcome = FAILED if series.tried[0].failure else LOST
        found.notes.append(f"{series}, {row.outcome}: {row.note}")
