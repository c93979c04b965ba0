# SPDX-License-Identifier: MIT
"""What choosing by structure costs: technique ``auto`` beside every fixed technique."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant import console
from pliant._weightings import WEIGHTINGS
from pliant.lab.bench.target import Target, read_target

TOLERANCES = (1e-6, 1e-10)
BARS = ("bonds", "angles")
COPIES, ROUNDS = 4, 41
ROUND_SECONDS = 2e-4  #: least of one entry in one round; short, so that little else falls into it
MOST_REPEATS = 200
HOPELESS = 3.0  #: times the best: such an entry is timed once, in its trial
MOST_RATIO = 1.2  #: that auto is allowed


@dataclass
class AutoRow:
    """One molecule with one set of bars at one tolerance. Times are medians over the rounds."""

    input: str
    bars_of: str
    joints: int
    bars: int
    tolerance: float
    chosen: str  #: what auto takes
    why: str
    auto_microseconds: float = math.nan  #: of one repair, by the library's own clock
    best: str = ""  #: the quickest fixed technique of those that made all copies whole
    best_microseconds: float = math.nan
    ratio: float = math.nan  #: auto over best
    whole: int = 0  #: fixed techniques, with their weightings, that made all copies whole
    fixed: int = 0  #: fixed techniques, with their weightings
    runners: list[str] = field(default_factory=list)  #: the quickest, with microseconds
    faults: list[str] = field(default_factory=list)


@dataclass
class Auto:
    """All molecules."""

    displacement: float
    rows: list[AutoRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Where auto left a bar broken that a fixed technique mends, or said what is not so."""
        return [
            f"{r.input}, {r.bars_of}, {r.tolerance:g}: {f}" for r in self.rows for f in r.faults
        ]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


class Entry:
    """A technique with a weighting on one framework at one tolerance."""

    def __init__(
        self, target: Target, technique: str, weighting: float | None, tolerance: float
    ) -> None:
        self.label = technique if weighting is None else f"{technique} {weighting:g}"
        self.is_fixed = technique != "auto"
        self._target, self._tolerance = target, tolerance
        self._resolver = pliant.Resolver(
            target.framework, technique, 0.5 if weighting is None else weighting,
            tolerance=tolerance,
        )  # fmt: skip
        self.times: list[float] = []  #: of one repair, one a round
        self.repeats = 1
        self.whole = False
        self.faults: list[str] = []

    def trial(self, copies: np.ndarray) -> None:
        """Makes the plan, looks whether all copies become whole, and takes the time."""
        self.whole = True
        for broken in copies:
            x = broken.copy()
            summary = self._resolver.resolve(x)
            worst = self._target.residual(x)
            is_whole = worst <= self._tolerance * (1 + 1e-9) + 1e-15
            if summary.converged and not is_whole:
                self.faults.append(f"{self.label} says converged, but a bar is off by {worst:.1e}")
            self.whole &= summary.converged and is_whole
        if self.whole:
            self.times = [self.once(copies)]

    def once(self, copies: np.ndarray) -> float:
        """Seconds of one repair, mean over the copies and repeats."""
        seconds = 0.0
        x = np.empty_like(copies[0])
        for _ in range(self.repeats):
            for broken in copies:
                x[:] = broken
                seconds += self._resolver.resolve(x).seconds
        return seconds / (self.repeats * len(copies))

    @property
    def seconds(self) -> float:
        """Of one repair: median over the rounds; infinite if not all copies became whole."""
        return float(np.median(self.times)) if self.whole else math.inf


def entries_for(target: Target, tolerance: float) -> list[Entry]:
    """auto first, then every technique that takes these bars, with every weighting."""
    is_forest = target.framework.graph_facts().is_forest
    rows = sorted(pliant.techniques(), key=lambda row: row.name != "auto")
    return [
        Entry(target, row.name, weighting, tolerance)
        for row in rows
        if is_forest or not row.forests_only
        for weighting in (WEIGHTINGS if row.has_weighting else (None,))
    ]


def race(entries: Sequence[Entry], copies: np.ndarray, rounds: int) -> None:
    """Trials, then rounds in which all that may be best take turns, each round begun elsewhere."""
    for entry in entries:
        entry.trial(copies)
    best = min((entry.seconds for entry in entries if entry.is_fixed), default=math.inf)
    racing = [e for e in entries if e.whole and (e.seconds <= HOPELESS * best or not e.is_fixed)]
    for entry in racing:
        enough = math.ceil(ROUND_SECONDS / max(entry.seconds * len(copies), 1e-9))
        entry.repeats = min(enough, MOST_REPEATS)
        entry.times.clear()
    for turn in range(rounds):
        for k in range(len(racing)):
            entry = racing[(k + turn) % len(racing)]
            entry.times.append(entry.once(copies))


def molecules() -> list[Path]:
    """Every molecule of data/molecules in the sources. Raises InputError where it is missing."""
    for above in Path(__file__).resolve().parents:
        folder = above / "data" / "molecules"
        if folder.is_dir():
            return sorted(path for path in folder.iterdir() if path.is_file())
    raise pliant.InputError("no FILE is given, and data/molecules is not beside the package")


def auto(
    files: Sequence[str | os.PathLike[str]] = (),
    *,
    bars: Sequence[str] = BARS,
    tolerances: Sequence[float] = TOLERANCES,
    displacement: float = 0.1,
    copies: int = COPIES,
    rounds: int = ROUNDS,
    seed: int = 0,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Auto:
    """Measures every file with every set of bars at every tolerance."""
    jobs = [(path, which, t) for path in files or molecules() for which in bars for t in tolerances]
    found = Auto(displacement)
    for k, (path, which, tolerance) in enumerate(jobs):
        progress(k, len(jobs))
        target = read_target(path, which)
        broken = np.stack([target.broken(displacement, seed + c) for c in range(copies)])
        found.rows.append(_one(target, which, tolerance, broken, rounds))
    return found


def _one(
    target: Target, bars_of: str, tolerance: float, broken: np.ndarray, rounds: int
) -> AutoRow:
    chosen, why = pliant.choose_technique(target.framework)
    row = AutoRow(target.name, bars_of, len(target.positions), len(target.bars), tolerance,
                  chosen, why)  # fmt: skip
    entries = entries_for(target, tolerance)
    race(entries, broken, rounds)
    ours, *fixed = entries
    whole = sorted((e for e in fixed if e.whole), key=lambda e: e.seconds)
    row.fixed, row.whole = len(fixed), len(whole)
    row.faults = [fault for entry in entries for fault in entry.faults]
    row.runners = [f"{e.label} {1e6 * e.seconds:.2f}" for e in whole[:4]]
    if ours.whole:
        row.auto_microseconds = 1e6 * ours.seconds
    if whole:
        row.best, row.best_microseconds = whole[0].label, 1e6 * whole[0].seconds
        row.ratio = row.auto_microseconds / row.best_microseconds
        if not ours.whole:
            row.faults.append(f"auto leaves a bar broken, {row.best} none")
    return row


def print_report(found: Auto) -> None:
    """A line for each molecule, set of bars and tolerance; the worst last."""
    print(
        f"each coordinate off by {found.displacement:g} A (standard deviation); times of one "
        "repair by the library's own clock,\nwithout the call from Python; best: of the fixed "
        "techniques that made every copy whole"
    )
    columns = ["molecule, bars", "joints", "bars", "tolerance", "auto takes", "us", "best", "us",
               "ratio", "whole"]  # fmt: skip
    table = console.Table("", columns, text_columns=(0, 4, 6))
    table.rows = [_cells(row) for row in found.rows]
    table.print()
    known = [row for row in found.rows if math.isfinite(row.ratio)]
    over = [row for row in known if row.ratio > MOST_RATIO]
    if known:
        worst = max(known, key=lambda row: row.ratio)
        print(
            f"worst: {worst.ratio:.2f} ({worst.input}, {worst.bars_of}, {worst.tolerance:g}); "
            f"{len(over)} of {len(known)} over {MOST_RATIO:g}"
        )
    for fault in found.faults:
        print(f"wrong: {fault}")


def _cells(row: AutoRow) -> list[str]:
    return [
        f"{row.input}, {row.bars_of}",
        str(row.joints),
        str(row.bars),
        f"{row.tolerance:.0e}",
        row.chosen,
        f"{row.auto_microseconds:.2f}",
        row.best,
        f"{row.best_microseconds:.2f}",
        f"{row.ratio:.2f}",
        f"{row.whole} of {row.fixed}",
    ]
