# SPDX-License-Identifier: MIT
"""One size of one kind of framework, measured in a process of its own for the sake of its memory.

Run as ``python -m pliant.lab.bench.scaling_child`` with a JSON object of options; prints another.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import sys
import time
from typing import Any

import numpy as np

import pliant
from pliant.lab.bench.large_frameworks import KINDS
from pliant.measure import bars as _bars


def resident(field: str) -> int | None:
    """Bytes of memory: field VmRSS (now) or VmHWM (peak); None where the system does not say."""
    try:
        with open("/proc/self/status", encoding="ascii") as file:
            line = next(line for line in file if line.startswith(field))
    except (OSError, StopIteration):
        return None
    return 1024 * int(line.split()[1])


def forget_peak() -> None:
    """Makes the peak what is resident now, what was freed given back to the system."""
    with contextlib.suppress(OSError, AttributeError):  # glibc only
        ctypes.CDLL(None).malloc_trim(0)
    try:
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
    except OSError:
        return


def measure_one(options: dict[str, Any]) -> dict[str, Any]:
    """Time and memory of building the framework, the plan, and of repairing it."""
    large = KINDS[options["kind"]](options["joints"], options["seed"])
    broken = _bars.displaced(large.positions, options["displacement"], options["seed"])
    lengths = _bars.lengths(large.positions, large.bars)
    bars = large.bars.astype(np.uint32)
    joints, count = len(large.positions), len(bars)
    del large
    x = broken.copy()
    forget_peak()
    before = resident("VmRSS")
    start = time.thread_time()
    framework = pliant.Framework(bars, lengths, joints)
    built = time.thread_time() - start
    resolver = pliant.Resolver(
        framework, options["technique"], options["weighting"], tolerance=options["tolerance"]
    )
    times, summary = _repair(resolver, x, broken, options["repeats"])
    peak, after = resident("VmHWM"), resident("VmRSS")
    seconds = float(np.median(times[1:]))
    return {
        "joints": joints,
        "bars": count,
        "build_seconds": built,
        "ready_seconds": max(times[0] - seconds, 0.0),
        "seconds": seconds,
        "stop": summary.stop.name,
        "sweeps": summary.sweeps,
        "max_residual": _bars.worst_residual(x, bars, lengths),
        "peak_bytes": peak - before if peak and before else None,
        "bytes": after - before if after and before else None,
    }


def _repair(
    resolver: pliant.Resolver, x: np.ndarray, broken: np.ndarray, repeats: int
) -> tuple[list[float], pliant.ResolveSummary]:
    """Seconds of each repair; the first makes the plan too."""
    times = []
    for _ in range(repeats + 1):
        x[:] = broken
        start = time.thread_time()
        summary = resolver.resolve(x)
        times.append(time.thread_time() - start)
    return times, summary


if __name__ == "__main__":
    print(json.dumps(measure_one(json.loads(sys.argv[1]))))
