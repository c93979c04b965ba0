# SPDX-License-Identifier: MIT
"""Conformers made whole in a second: one after the other and in lanes, on one thread and more."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

import pliant
from pliant.lab.bench.target import Target, read_target
from pliant.lab.results import Cell, Results, print_table, text_of

CONFORMERS, REPEATS, THREADS = 200, 5, (1, 2)
TECHNIQUES = ("blocks", "bfs_cycle", "shake", "newton")
WARM_UP = 16  #: conformers repaired by each thread of a round before its clock starts


@dataclass
class Throughput(Results):
    """All techniques on all numbers of threads."""

    input: str
    joints: int
    bars: int
    tolerance: float
    cores: int
    lane_levels: list[str]  #: instructions that this processor has for lanes, the best first
    rows: list[ThroughputRow] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """What is not as it must be: conformers not whole, or with other bits than alone."""
        return [
            f"{row.technique} {row.lanes or 'one by one'}, {row.threads} threads: {row.whole} of "
            f"{row.conformers} whole" + ("" if row.same_bits else ", with other bits than alone")
            for row in self.rows
            if row.whole < row.conformers or not row.same_bits
        ]

    def print_report(self) -> None:
        """A line a technique and number of threads, and what is wrong."""
        print(
            f"{self.input}: {self.joints} joints, {self.bars} bars, tolerance {self.tolerance:g}; "
            f"{self.cores} cores"
        )
        print_table(self.rows, COLUMNS)
        for fault in self.faults:
            print(fault)


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


COLUMNS: dict[str, Cell] = {
    "technique": lambda row: f"{row.technique} {text_of(row.weighting, 'g')}".strip(),
    "lanes": lambda row: row.lanes or "-",
    "threads": "threads",
    "conformers per second": "conformers_per_second:.0f",
    "ns per bar": "ns_per_bar:.1f",
    "of processor time": "processor_ns_per_bar:.1f",
    "whole": lambda row: f"{row.whole} of {row.conformers}",
    "same bits": lambda row: "yes" if row.same_bits else "no",
}


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
) -> Throughput:
    """Measures all techniques, in rounds that take turns."""
    target = read_target(path, bars)
    broken = np.stack(
        [target.broken(displacement, seed + k) for k in range(conformers * max(threads))]
    )
    entries = list(_entries(target, techniques, weighting, tolerance, threads, conformers))
    for _ in range(repeats + 1):
        for entry in entries:
            np.copyto(entry.result, broken[: conformers * entry.threads])
            entry.times.append(_round(entry.team, entry.result, conformers))
    sizes, cores = (len(target.positions), len(target.bars)), os.cpu_count() or 1
    found = Throughput(target.name, *sizes, tolerance, cores, pliant.lane_levels())
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
