# SPDX-License-Identifier: MIT
"""The loop of the thesis on one molecule by one technique, in a process that may be killed.

Run as ``_openmm/worker.py`` is.
"""

from __future__ import annotations

import pathlib
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

import pliant
from pliant.checks.openmm import worker

REPEATS = 3  #: of which the shortest time counts
LONG = 0.3  #: seconds after which a run is not repeated


def loop(job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Mean sweeps of a step, worst residual, steps that did not converge, seconds of a step."""
    structure = pliant.Structure(
        job["positions"],
        elements=job["elements"],
        bonds=job["bonds"],
        bond_orders=job["bond_orders"],
    )
    framework = structure.framework(str(job["bars"]))
    steps = int(job["steps"])
    runs: list[pliant.RunSummary] = []
    while len(runs) < REPEATS and sum(run.seconds for run in runs) < LONG:
        runs.append(
            pliant.run(
                framework,
                job["positions"].copy(),
                steps=steps,
                every=steps,
                technique=str(job["technique"]),
                tolerance=float(job["tolerance"]),
                max_sweeps=int(job["max_sweeps"]),
            )
        )
    first, seconds = runs[0], min(run.seconds for run in runs) / steps
    numbers = [first.mean_sweeps, first.worst_residual, first.unconverged_steps, seconds]
    return {"numbers": np.array(numbers)}


if __name__ == "__main__":
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), {"loop": loop})
