# SPDX-License-Identifier: MIT
"""Conformers made whole in a second, on one thread and on several."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

import pliant
from pliant import console
from pliant.bench.target import Target, read_target

CONFORMERS, REPEATS, THREADS = 200, 5, (1, 2)


@dataclass
class Throughput:
    """All techniques on all numbers of threads."""

    input: str
    joints: int
    bars: int
    tolerance: float
    cores: int
    rows: list[ThroughputRow] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


@dataclass
class ThroughputRow:
    """One technique on one number of threads."""

    technique: str
    weighting: float | None
    threads: int
    conformers: int  #: of each round
    whole: int  #: of these, measured anew
    conformers_per_second: float  #: median over the rounds, wall time
    ns_per_bar: float  #: wall time for one bar of one conformer
    processor_ns_per_bar: float  #: the same in processor time of the threads, added up
    same_bits: bool  #: the conformers are those of one thread, bit by bit


def throughput(
    path: str | os.PathLike,
    *,
    bars: str = "bonds",
    techniques: Sequence[str] = ("blocks", "bfs_cycle"),
    weighting: float = 1.0,
    tolerance: float = 1e-6,
    displacement: float = 0.1,
    threads: Sequence[int] = THREADS,
    conformers: int = CONFORMERS,
    repeats: int = REPEATS,
    seed: int = 0,
) -> Throughput:
    """Measures all techniques; rounds of all of them take turns."""
    target = read_target(path, bars)
    broken = np.stack(
        [target.broken(displacement, seed + k) for k in range(conformers * max(threads))]
    )
    chosen = [(name, _weighting(name, weighting)) for name in techniques]
    entries = [(name, w, count) for name, w in chosen for count in threads]
    results = [np.empty_like(broken) for _ in entries]
    teams = [
        [_resolver(target, name, w, tolerance) for _ in range(count)] for name, w, count in entries
    ]
    times: list[list[tuple[float, float]]] = [[] for _ in entries]
    for _ in range(repeats + 1):
        for k, (_, _, count) in enumerate(entries):
            results[k][: conformers * count] = broken[: conformers * count]
            times[k].append(_round(teams[k], results[k], conformers))
    found = Throughput(target.name, len(target.positions), len(target.bars), tolerance,
                       os.cpu_count() or 1)  # fmt: skip
    for k, (name, w, count) in enumerate(entries):
        alone = results[next(j for j, e in enumerate(entries) if e[:2] == (name, w))]
        wall, processor = np.median(times[k][1:], axis=0) / (conformers * count)  # first: plans
        found.rows.append(
            ThroughputRow(
                name,
                w,
                count,
                conformers * count,
                sum(target.residual(x) <= tolerance * (1 + 1e-9)
                    for x in results[k][: conformers * count]),
                float(1.0 / wall),
                float(1e9 * wall / len(target.bars)),
                float(1e9 * processor / len(target.bars)),
                np.array_equal(results[k][:conformers], alone[:conformers]),
            )
        )  # fmt: skip
    return found


def _weighting(name: str, weighting: float) -> float | None:
    row = next((row for row in pliant.techniques() if row.name == name), None)
    return weighting if row is None or row.has_weighting else None


def _resolver(
    target: Target, name: str, weighting: float | None, tolerance: float
) -> pliant.Resolver:
    return pliant.Resolver(
        target.framework, name, 0.5 if weighting is None else weighting, tolerance=tolerance
    )


def _round(team: Sequence[pliant.Resolver], copies: np.ndarray, each: int) -> tuple[float, float]:
    """Wall seconds in which every thread repairs its `each` copies; processor seconds of all."""
    busy = [0.0] * len(team)

    def work(number: int) -> None:
        start = time.thread_time()
        for positions in copies[number * each : (number + 1) * each]:
            team[number].resolve(positions)
        busy[number] = time.thread_time() - start

    crew = [threading.Thread(target=work, args=(k,)) for k in range(len(team))]
    start = time.perf_counter()
    for thread in crew:
        thread.start()
    for thread in crew:
        thread.join()
    return time.perf_counter() - start, sum(busy)


def print_report(found: Throughput) -> None:
    """The table for people."""
    print(
        f"{found.input}: {found.joints} joints, {found.bars} bars, tolerance {found.tolerance:g}; "
        f"{found.cores} cores"
    )
    columns = [
        "technique",
        "threads",
        "conformers per second",
        "ns per bar",
        "of processor time",
        "whole",
        "same bits",
    ]
    table = console.Table("", columns)
    for row in found.rows:
        name = row.technique if row.weighting is None else f"{row.technique} {row.weighting:g}"
        table.rows.append(
            [
                name,
                str(row.threads),
                f"{row.conformers_per_second:.0f}",
                f"{row.ns_per_bar:.1f}",
                f"{row.processor_ns_per_bar:.1f}",
                f"{row.whole} of {row.conformers}",
                "yes" if row.same_bits else "no",
            ]
        )
    table.print()
