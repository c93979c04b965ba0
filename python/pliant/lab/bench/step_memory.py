# SPDX-License-Identifier: MIT
"""Memory of a scene of ``pliant lab bench step``: in a process of its own, less the interpreter's.

Run as ``python -m pliant.lab.bench.step_memory`` with a JSON object of options; prints another.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import subprocess
import sys
from typing import Any

import numpy as np

import pliant
from pliant.lab.bench.step_scenes import make_scene

STEPS = 10
LIMIT_SECONDS = 600.0


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
    with contextlib.suppress(OSError), open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")


def measure_one(options: dict[str, Any]) -> dict[str, float | None]:
    """Bytes per joint of framework, plan and positions while it runs; of making the framework."""
    np.linalg.norm(np.ones((2, 3)), axis=1)  # what NumPy loads when first used is not ours
    forget_peak()
    before = resident("VmRSS")
    scene = make_scene(options["source"], options["size"], options["model"])
    made = resident("VmHWM")
    forget_peak()
    pliant.run(
        scene.framework,
        pliant.State(scene.positions),
        steps=STEPS,
        every=STEPS,
        technique=options["technique"],
        **options["run"],
    )
    peak, count = resident("VmHWM"), scene.framework.joint_count

    def each(found: int | None) -> float | None:
        return None if found is None or before is None else (found - before) / count

    return {"run": each(peak), "made": each(made)}


def bytes_per_joint(options: dict[str, Any]) -> dict[str, float | None]:
    """The same, measured in a new process; None where it did not end well."""
    command = [sys.executable, "-W", "ignore", "-m", __name__, json.dumps(options)]
    try:
        done = subprocess.run(command, capture_output=True, timeout=LIMIT_SECONDS, check=True)
    except subprocess.SubprocessError:
        return {"run": None, "made": None}
    found: dict[str, float | None] = json.loads(done.stdout)
    return found


if __name__ == "__main__":
    print(json.dumps(measure_one(json.loads(sys.argv[1]))))
