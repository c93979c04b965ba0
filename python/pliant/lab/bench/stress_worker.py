# SPDX-License-Identifier: MIT
"""What repairs a stress case, ours or OpenMM's, in a process of its own, as either may end it.

Run as ``_openmm/worker.py`` is, and does its jobs too.
"""

from __future__ import annotations

import pathlib
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

import pliant
from pliant.checks.openmm import worker


def framework_of(job: Mapping[str, Any]) -> pliant.Framework:
    """The framework of the job's arrays; joints that are pinned stay where they are."""
    return pliant.Framework(
        job["bars"].astype(np.uint32),
        job["rest_lengths"],
        len(job["positions"]),
        masses=job["masses"],
        pinned=job["pinned"],
    )


def resolve(job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """One repair by one technique; numbers: sweeps, residual, how many not converged, seconds."""
    framework, x = framework_of(job), job["positions"].copy()
    summary = pliant.resolve(
        framework,
        x,
        str(job["technique"]),
        float(job["weighting"]),
        mass_weighted=bool(job["mass_weighted"]),
        tolerance=float(job["tolerance"]),
        max_sweeps=int(job["max_sweeps"]),
    )
    return {
        "positions": x,
        "stop": np.array(summary.stop.name),
        "numbers": np.array(
            [summary.sweeps, summary.max_residual, not summary.converged, summary.seconds]
        ),
    }


def run(job: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Many steps of random pushes; what is left at the end, and what the worst step left."""
    summary = pliant.run(
        framework_of(job),
        job["positions"],
        steps=int(job["steps"]),
        every=int(job["steps"]),
        technique=str(job["technique"]),
        weighting=float(job["weighting"]),
        tolerance=float(job["tolerance"]),
        max_sweeps=int(job["max_sweeps"]),
    )
    return {
        "positions": np.array(summary.state.positions),
        "stop": np.array("converged" if summary.converged else "max_sweeps"),
        "numbers": np.array(
            [summary.sweeps, summary.worst_residual, summary.unconverged_steps, summary.seconds]
        ),
    }


KINDS = {"resolve": resolve, "run": run, **worker.KINDS}

if __name__ == "__main__":
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), KINDS)
