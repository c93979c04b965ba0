# SPDX-License-Identifier: MIT
"""Conformers made whole in a second: one after the other and in lanes, on one thread and more."""

from __future__ import annotations

import math
import os
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from functools import partial
from typing import Any

import numpy as np

import pliant
from pliant.base import console
from pliant.lab.bench.contenders import Theirs, their_contenders
from pliant.lab.bench.target import Target, read_target

CONFORMERS, REPEATS, THREADS = 200, 5, (1, 2)
TECHNIQUES = ("blocks", "bfs_cycle", "shake", "newton")
WARM_UP = 16  #: conformers repaired by each thread of a round before its clock starts
OPENMM_CONFORMERS = 20  #: of each round; their time does not depend on how many there are


@dataclass
class Throughput:
    """All techniques on all numbers of threads, and OpenMM's CCMA on one."""

    input: str
    joints: int
    bars: int
    tolerance: float
    cores: int
    lane_levels: list[str]  #: instructions that this processor has for lanes, the best first
    rows: list[ThroughputRow] = field(default_factory=list)
    openmm: list[OpenmmRow] = field(default_factory=list)
    about_openmm: str = ""  #: why OpenMM takes no part, or what it was not given

    def wrong(self) -> list[str]:
        """What is not as it must be: conformers not whole, or with other bits than alone."""
        return [
            f"{row.technique} {row.lanes or 'one by one'}, {row.threads} threads: {row.whole} of "
            f"{row.conformers} whole" + ("" if row.same_bits else ", with other bits than alone")
            for row in self.rows
            if row.whole < row.conformers or not row.same_bits
        ]

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


@dataclass
class OpenmmRow:
    """OpenMM's CCMA, one conformer after the other on one thread."""

    method: str  #: "ccma" (applyConstraints) or "ccma_dynamics" (given the intact structure)
    ns_per_bar: float  #: median over the rounds
    max_residual: float  #: of the worst conformer, measured anew


@dataclass
class ThroughputRow:
    """One technique on one number of threads."""

    technique: str
    weighting: float | None
    lanes: str  #: the instructions that take eight conformers at once; "": one after the other
    threads: int
    conformers: int  #: of each round
    whole: int  #: of these, measured anew
    conformers_per_second: float  #: median over the rounds, wall time
    ns_per_bar: float  #: wall time for one bar of one conformer
    processor_ns_per_bar: float  #: the same in processor time of the threads, added up
    same_bits: bool  #: the conformers are those of one thread without lanes, bit by bit
    ratio_to_openmm: float = math.nan  #: CCMA's time for a bar over that of this row
    ratio_to_openmm_in_dynamics: float = math.nan  #: the same, CCMA given the intact structure


@dataclass
class _Entry:
    """What a row is made of."""

    technique: str
    weighting: float | None
    threads: int
    lanes: bool
    team: list[pliant.WalkerResolver] = field(default_factory=list)
    result: np.ndarray = field(default_factory=lambda: np.empty(0))
    times: list[tuple[float, float]] = field(default_factory=list)  #: wall, processor


def throughput(
    path: str | os.PathLike[str],
    *,
    bars: str = "bonds",
    techniques: Sequence[str] = TECHNIQUES,
    weighting: float = 1.0,
    tolerance: float = 1e-6,
    displacement: float = 0.1,
    threads: Sequence[int] = THREADS,
    conformers: int = CONFORMERS,
    repeats: int = REPEATS,
    seed: int = 0,
    openmm: bool = True,
) -> Throughput:
    """Measures all techniques; rounds of all of them and of OpenMM take turns."""
    target = read_target(path, bars)
    broken = np.stack(
        [target.broken(displacement, seed + k) for k in range(conformers * max(threads))]
    )
    entries = list(_entries(target, techniques, weighting, tolerance, threads, conformers))
    theirs, about = their_contenders(target) if openmm else ([], "OpenMM was not asked")
    races = [(who, _OpenmmRace(who, target, tolerance)) for who in theirs]
    for _ in range(repeats + 1):
        for entry in entries:
            np.copyto(entry.result, broken[: conformers * entry.threads])
            entry.times.append(_round(entry.team, entry.result, conformers))
        for _, race in races:
            race.run(broken[:OPENMM_CONFORMERS])
    sizes, cores = (len(target.positions), len(target.bars)), os.cpu_count() or 1
    found = Throughput(target.name, *sizes, tolerance, cores, pliant.lane_levels())
    found.openmm = [race.row() for _, race in races]
    found.about_openmm = about
    found.rows = [_row(entry, entries, found, target, conformers) for entry in entries]
    return found


def _entries(
    target: Target,
    techniques: Sequence[str],
    weighting: float,
    tolerance: float,
    threads: Sequence[int],
    conformers: int,
) -> Iterator[_Entry]:
    for name in techniques:
        for lanes in (False, True):
            entry = _Entry(name, _weighting(name, weighting), 1, lanes)
            if lanes and not _resolver(target, entry, tolerance).level:
                continue
            for count in threads:
                team = [_resolver(target, entry, tolerance) for _ in range(count)]
                room = np.empty((count * conformers, *target.positions.shape))
                yield _Entry(name, entry.weighting, count, lanes, team, room)


class _OpenmmRace:
    """Repairs by OpenMM, timed."""

    def __init__(self, who: Theirs, target: Target, tolerance: float) -> None:
        who.prepare(tolerance)
        self._who, self._target = who, target
        self._seconds: list[float] = []
        self._worst = 0.0

    def run(self, broken: np.ndarray) -> None:
        """One round."""
        repairs = [self._who.repair(positions) for positions in broken]
        self._seconds.append(sum(repair.seconds for repair in repairs) / len(repairs))
        worst = max(self._target.residual(repair.positions) for repair in repairs)
        self._worst = max(self._worst, worst)

    def row(self) -> OpenmmRow:
        """What came of it; the first round does not count."""
        ns_per_bar = 1e9 * np.median(self._seconds[1:]) / len(self._target.bars)
        return OpenmmRow(self._who.method, float(ns_per_bar), float(self._worst))


def _row(
    entry: _Entry, entries: Sequence[_Entry], found: Throughput, target: Target, conformers: int
) -> ThroughputRow:
    alone = next(e for e in entries if e.technique == entry.technique)
    wall, processor = np.median(entry.times[1:], axis=0) / len(entry.result)  # first: plans
    ns_per_bar = float(1e9 * wall / len(target.bars))
    return ThroughputRow(
        entry.technique,
        entry.weighting,
        entry.team[0].level,
        entry.threads,
        len(entry.result),
        sum(target.residual(x) <= found.tolerance * (1 + 1e-9) for x in entry.result),
        float(1.0 / wall),
        ns_per_bar,
        float(1e9 * processor / len(target.bars)),
        np.array_equal(entry.result[:conformers], alone.result[:conformers]),
        *(row.ns_per_bar / ns_per_bar for row in found.openmm),
    )


def _weighting(name: str, weighting: float) -> float | None:
    row = next((row for row in pliant.techniques() if row.name == name), None)
    return weighting if row is None or row.has_weighting else None


def _resolver(target: Target, entry: _Entry, tolerance: float) -> pliant.WalkerResolver:
    return pliant.WalkerResolver(
        target.framework,
        entry.technique,
        0.5 if entry.weighting is None else entry.weighting,
        tolerance=tolerance,
        lanes=entry.lanes,
    )


def _round(
    team: Sequence[pliant.WalkerResolver], copies: np.ndarray, each: int
) -> tuple[float, float]:
    """Wall seconds in which every thread repairs its `each` copies; processor seconds of all.

    Each thread repairs a few others first, so that what came before it is not in its caches, and
    all begin together.
    """
    busy, wall = [0.0] * len(team), [0.0] * len(team)
    ready = threading.Barrier(len(team))

    def work(number: int) -> None:
        mine = copies[number * each : (number + 1) * each]
        team[number].resolve(mine[:WARM_UP].copy(), measured="nothing")
        ready.wait()
        start, start_of_thread = time.perf_counter(), time.thread_time()
        team[number].resolve(mine, measured="nothing")
        busy[number] = time.thread_time() - start_of_thread
        wall[number] = time.perf_counter() - start

    _all_at_once([partial(work, number) for number in range(len(team))])
    return max(wall), sum(busy)


def _all_at_once(calls: Sequence[Callable[[], None]]) -> None:
    """The first one in this thread."""
    crew = [threading.Thread(target=call) for call in calls[1:]]
    for thread in crew:
        thread.start()
    calls[0]()
    for thread in crew:
        thread.join()


def print_report(found: Throughput) -> None:
    """The table for people."""
    print(
        f"{found.input}: {found.joints} joints, {found.bars} bars, tolerance {found.tolerance:g}; "
        f"{found.cores} cores"
    )
    columns = [
        "technique",
        "lanes",
        "threads",
        "conformers per second",
        "ns per bar",
        "of processor time",
        *(f"as fast as {row.method}" for row in found.openmm),
        "whole",
        "same bits",
    ]
    table = console.Table("", columns)
    for row in found.rows:
        name = row.technique if row.weighting is None else f"{row.technique} {row.weighting:g}"
        ratios = (row.ratio_to_openmm, row.ratio_to_openmm_in_dynamics)
        table.rows.append(
            [
                name,
                row.lanes or "-",
                str(row.threads),
                f"{row.conformers_per_second:.0f}",
                f"{row.ns_per_bar:.1f}",
                f"{row.processor_ns_per_bar:.1f}",
                *(f"{ratio:.1f} times" for ratio in ratios[: len(found.openmm)]),
                f"{row.whole} of {row.conformers}",
                "yes" if row.same_bits else "no",
            ]
        )
    table.print()
    for theirs in found.openmm:
        print(
            f"OpenMM {theirs.method}: {theirs.ns_per_bar:.1f} ns per bar, worst residual "
            f"{theirs.max_residual:.1e}"
        )
    for note in [found.about_openmm, *found.wrong()]:
        if note:
            print(note)
