# SPDX-License-Identifier: MIT
"""Work against precision: what it takes to repair one broken structure, and how well it is then.

Every contender repairs the same structure to tolerance after tolerance, in rounds in which each has
its turn, so that what else the machine does falls on all. Time is the thread's own on the
processor, ours and OpenMM's alike. Errors are measured anew, by one ruler.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence

import numpy as np

from pliant.lab.bench.contenders import Contender, Repair, our_contenders, their_contenders
from pliant.lab.bench.gromacs_race import race_gromacs
from pliant.lab.bench.nearest import nearest_whole
from pliant.lab.bench.target import Target, read_target
from pliant.lab.bench.time_limit import TimeUp, time_limit
from pliant.lab.bench.work_precision_rows import (
    LOST,
    SHORT,
    TOLERANCES,
    TOO_SHORT,
    WHOLE,
    Row,
    WorkPrecision,
)
from pliant.measure import bars as _bars

REPEATS = 7
LIMIT_SECONDS = 2.0  #: for one contender at one tolerance


def work_precision(
    path: str | os.PathLike[str],
    *,
    bars: str = "bonds",
    displacement: float = 0.1,
    seed: int = 0,
    tolerances: Sequence[float] = TOLERANCES,
    techniques: Sequence[str] = (),
    repeats: int = REPEATS,
    mass_weighted: bool = False,
    peers: str = "all",
    progress: Callable[[int, int], None] = lambda *_: None,
) -> WorkPrecision:
    """Races every technique, OpenMM's CCMA, and GROMACS if installed, on the molecule of a file.

    `techniques` are names in ``pliant.techniques()``, or all; `peers` are "all", "openmm" or
    "none". Raises InputError, OptionError or FileError for what the user gave wrong.
    """
    target = read_target(path, bars)
    ours = list(our_contenders(target, techniques, mass_weighted))
    theirs, note = (
        their_contenders(target) if peers != "none" else ([], "OpenMM was not asked to take part")
    )
    found = prepare(target, bars, displacement, seed, tolerances)
    found.notes += [note] if note else []
    race(
        found, [*theirs, *ours], target.broken(displacement, seed), repeats, LIMIT_SECONDS, progress
    )
    if peers == "all":
        race_gromacs(found, repeats, progress)
    compare_with_openmm(found.rows)
    return found


def prepare(
    target: Target, bars: str, displacement: float, seed: int, tolerances: Sequence[float]
) -> WorkPrecision:
    """The diagram without its rows: how far the nearest whole structure is."""
    broken = target.broken(displacement, seed)
    nearest, heavy = nearest_whole(target, broken), nearest_whole(target, broken, target.masses)
    found = WorkPrecision(
        target,
        bars,
        displacement,
        math.nan if nearest is None else rms_distance(nearest, broken),
        math.nan if heavy is None else rms_distance(heavy, broken, target.masses),
        target.residual(broken),
        tuple(sorted(tolerances, reverse=True)),
    )
    if nearest is None:
        found.notes.append(
            "the nearest whole structure was not found: bars depend on each other, or are far off"
        )
    return found


def rms_distance(a: np.ndarray, b: np.ndarray, masses: np.ndarray | None = None) -> float:
    """Root mean square distance of joints (N, 3), weighted by `masses`; nothing superposed."""
    with np.errstate(over="ignore", invalid="ignore"):
        return float(np.sqrt(np.average(np.sum((a - b) ** 2, axis=1), weights=masses)))


def race(
    found: WorkPrecision,
    contenders: Sequence[Contender],
    broken: np.ndarray,
    repeats: int,
    limit_seconds: float,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> None:
    """Fills found.rows, tolerance by tolerance; who was too slow is not asked for more."""
    out: dict[int, str] = {}
    for k, tolerance in enumerate(found.tolerances):
        progress(k, len(found.tolerances))
        entries = []
        for number, contender in enumerate(contenders):
            row = Row(contender.method, contender.weighting, tolerance, note=out.get(number, ""))
            row.walkers = contender.walkers
            found.rows.append(row)
            if number in out:
                continue
            times = _first(found, row, contender, broken, limit_seconds)
            if row.outcome == WHOLE:
                entries.append((row, contender, times))
            else:
                out[number] = f"{row.outcome} at {tolerance:.0e}"
        _rounds(entries, broken, repeats, limit_seconds)
        for row, _, times in entries:
            row.repeats = len(times)
            _time(row, float(np.median(times)), len(found.target.bars))


def _time(row: Row, seconds: float, bars: int) -> None:
    """Fills the time: none where it is the difference of two that hardly differ."""
    if seconds > 0:
        row.ns_per_bar = 1e9 * seconds / bars
    else:
        row.ns_per_bar, row.note = math.nan, TOO_SHORT


def _first(
    found: WorkPrecision, row: Row, contender: Contender, broken: np.ndarray, limit_seconds: float
) -> list[float]:
    """The first repair, which makes plans and is not timed; fills all of the row but the time."""
    contender.prepare(row.tolerance)
    try:
        with time_limit(limit_seconds):
            repair = contender.repair(broken)
    except TimeUp:
        row.note = f"took more than {limit_seconds:g} s"
        return []
    _judge(found, row, repair, broken)
    if contender.whose == "openmm":
        found.openmm_answers[row.method, row.tolerance] = repair.positions
    same_task = "ccma_dynamics" if row.method.endswith("_dynamics") else "ccma"
    if (same_task, row.tolerance) in found.openmm_answers:
        there = found.openmm_answers[same_task, row.tolerance]
        row.distance_to_ccma = _bars.furthest_move(repair.positions, there)
    if row.outcome != WHOLE:
        _time(row, repair.seconds, len(found.target.bars))
    return []


def _judge(found: WorkPrecision, row: Row, repair: Repair, broken: np.ndarray) -> None:
    row.sweeps, row.projections = repair.sweeps, repair.projections
    row.max_residual = found.target.residual(repair.positions)
    row.displacement = rms_distance(repair.positions, broken)
    row.displacement_ratio = row.displacement / found.nearest_displacement
    heavy = rms_distance(repair.positions, broken, found.target.masses)
    row.mass_displacement_ratio = heavy / found.nearest_mass_displacement
    if not math.isfinite(row.max_residual):
        row.outcome = LOST
    elif row.max_residual <= row.tolerance * (1 + 1e-9) + 4e-16:
        row.outcome = WHOLE
    else:
        row.outcome = SHORT
        if repair.stop == "converged":
            row.note = "said to have converged"


def _rounds(
    entries: list[tuple[Row, Contender, list[float]]],
    broken: np.ndarray,
    repeats: int,
    limit_seconds: float,
) -> None:
    for _ in range(repeats):
        for _, contender, times in entries:
            if not times or 2 * sum(times) * (1 + 1 / len(times)) < limit_seconds:
                contender.repair(broken)  # brings what it needs into the caches, as many steps do
                times.append(contender.repair(broken).seconds)


def fastest_to(rows: Sequence[Row], method: str, error: float) -> float:
    """Least ns per bar in which a method reaches `error` or less.

    Infinite if it never does; not-a-number if none of the times is known.
    """
    reached = [r.ns_per_bar for r in rows if r.method == method and r.max_residual <= error]
    return min((t for t in reached if t > 0), default=math.nan if reached else math.inf)


def compare_with_openmm(rows: Sequence[Row]) -> None:
    """Fills the ratios: OpenMM's time to an error within the row's tolerance, over its time."""
    raced = {row.method for row in rows}
    for row in rows:
        if row.outcome != WHOLE or not row.ns_per_bar > 0:
            continue
        error = row.tolerance * (1 + 1e-9)
        if "ccma" in raced:
            row.ratio_to_openmm = fastest_to(rows, "ccma", error) / row.ns_per_bar
        if "ccma_dynamics" in raced:
            theirs = fastest_to(rows, "ccma_dynamics", error)
            row.ratio_to_openmm_in_dynamics = theirs / row.ns_per_bar
