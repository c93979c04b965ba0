# SPDX-License-Identifier: MIT
"""Many walkers of one framework as one call."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Sequence

import numpy.typing as npt

from pliant import _core
from pliant._checked import WALKERS, checked
from pliant._progress import begin
from pliant._run import JointForce, Ordering, Sweep, _options, _start
from pliant._run_outputs import Observer

#: Gives the observers of a walker before it begins: recorders, or what is called with frames.
ObserversOf = Callable[[int], Iterable[Observer | _core.H5mdRecorder]]


@checked(shard=WALKERS)
def run_ensemble(
    framework: _core.Framework,
    state: _core.State | npt.ArrayLike,
    shard: tuple[int, int] = (0, 8),
    *,
    threads: int = 1,
    observers_of: ObserversOf | None = None,
    steps: int = 1000,
    every: int = 1,
    technique: str | Sweep = "auto",
    weighting: float = 0.5,
    mass_weighted: bool = False,
    ordering: Ordering | None = None,
    tolerance: float = 1e-6,
    tolerance_length: float | None = None,
    tolerance_limit: float = 0.01,
    tolerance_overlap: float = 0.1,
    max_sweeps: int = 10000,
    perturb: str = "force",
    force: float = 50.0,
    timestep: float = 0.01,
    damping: float = 0.0,
    displacement: float = 0.1,
    replay: Sequence[JointForce] | None = None,
    seed: int = 0,
) -> list[_core.RunSummary]:
    """Run many walkers from one start, on threads and in lanes.

    Each walker does what `run` does with its number, whatever the shard and the threads: two
    halves of the walkers on two machines give the same bits as all of them in one call.

    Parameters
    ----------
    framework : Framework
    state : State or (N, 3) Angstrom
        Where all walkers start; it is not changed.
    shard : (first, end)
        The walkers to run: first, first + 1, ..., end - 1.
    threads : int
        Number of threads; up to eight walkers step together on each if lanes can take them (bars
        alone), else one follows the other.
    observers_of : callable, optional
        Called with a walker's number before it begins; returns its observers. Each frame that they
        see holds a copy of its positions. Recorders are closed when their walker ends. An
        exception of an observer stops its own walker only.
    steps, every, technique, weighting, mass_weighted, ordering
        As for `run`. A function as technique is called from one thread at a time.
    tolerance, tolerance_length, tolerance_limit, tolerance_overlap, max_sweeps
        As for `run`.
    perturb, force, timestep, damping, displacement, replay, seed
        As for `run`.

    Returns
    -------
    list of RunSummary
        In the order of the walkers' numbers. `state` is where a walker ended; None if it never
        began.

    Raises
    ------
    OptionError, InputError
        As for `run`. The first exception of an observer is raised once all walkers have ended.
    """
    options = _options(
        replay,
        None,
        ordering,
        steps=steps,
        every=every,
        technique=technique,
        weighting=weighting,
        mass_weighted=mass_weighted,
        tolerance=tolerance,
        tolerance_length=0.0 if tolerance_length is None else tolerance_length,
        tolerance_limit=tolerance_limit,
        tolerance_overlap=tolerance_overlap,
        max_sweeps=max_sweeps,
        perturb=perturb,
        force=force,
        timestep=timestep,
        damping=damping,
        displacement=displacement,
        seed=seed,
    )
    bar = begin("walkers begun", shard[1] - shard[0])
    begun = itertools.count(1)

    def counted(walker: int) -> Iterable[Observer | _core.H5mdRecorder]:
        if bar is not None:
            bar.show(next(begun))
        return observers_of(walker) if observers_of is not None else ()

    watched = observers_of if bar is None else counted
    try:
        return _core.run_shard(framework, _start(state, None), options, shard, threads, watched)
    finally:
        if bar is not None:
            bar.close()
