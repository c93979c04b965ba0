# SPDX-License-Identifier: MIT
"""The ensemble of a study: ``pliant sample`` with what it does by default."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant.jobs.process import run_job


@dataclass(frozen=True)
class Sampled:
    """What `pliant sample` did."""

    facts: dict[str, Any]  #: its JSON
    ensemble: Path


def sampled(file: str | os.PathLike[str], folder: Path, options: Mapping[str, Any]) -> Sampled:
    """Samples FILE into folder/ensemble.h5md, replacing what is there. Raises as `run_job`."""
    ensemble = folder / "ensemble.h5md"
    there = {"task": "sample", "input": os.fspath(file), "output": str(ensemble)}
    return Sampled(run_job({**there, "overwrite": True, **options}), ensemble)
