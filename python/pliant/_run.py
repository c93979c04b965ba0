# SPDX-License-Identifier: MIT
"""The main job as one call: perturb, resolve, show and record."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
import numpy.typing as npt

from pliant import _core


def _state_from(state: _core.State | npt.ArrayLike) -> _core.State:
    return state if isinstance(state, _core.State) else _core.State(np.asarray(state))


def run(
    framework: _core.Framework,
    state: _core.State | npt.ArrayLike,
    *,
    steps: int = 1000,
    every: int = 1,
    technique: str = "bfs_cycle",
    weighting: float = 0.5,
    mass_weighted: bool = False,
    tolerance: float = 1e-6,
    tolerance_length: float | None = None,
    max_sweeps: int = 10000,
    perturb: str = "force",
    force: float = 50.0,
    timestep: float = 0.01,
    damping: float = 0.0,
    displacement: float = 0.1,
    seed: int = 0,
    walker: int = 0,
    observers: Iterable[Callable[[_core.Frame], bool | None]] = (),
) -> _core.RunSummary:
    """Push a framework again and again, resolve the bars that break, show what moved."""
    options = _core.RunOptions()
    options.steps = steps
    options.every = every
    options.technique = technique
    options.weighting = weighting
    options.mass_weighted = mass_weighted
    options.tolerance = tolerance
    options.tolerance_length = tolerance_length or 0.0
    options.max_sweeps = max_sweeps
    options.perturb = perturb
    options.force = force
    options.timestep = timestep
    options.damping = damping
    options.displacement = displacement
    options.seed = seed
    options.walker = walker
    return _core.run_steps(framework, _state_from(state), options, list(observers), 2)
