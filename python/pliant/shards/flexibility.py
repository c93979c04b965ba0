# SPDX-License-Identifier: MIT
"""Flexibility of an ensemble in many files: in three passes, with memory for a few frames."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from pliant._core import InputError
from pliant.base.extras import late
from pliant.measure.agreement import TEN, correlation, rmsip
from pliant.measure.flexibility import STILL
from pliant.measure.stages.amplitude import asked_amplitude
from pliant.measure.stages.names import atom_labels
from pliant.measure.stages.parts import Units
from pliant.measure.stages.units import single_atoms, trace_of, trace_units
from pliant.shards.clusters import CLUSTERS, Clusters, clusters
from pliant.shards.over_shards import each_part
from pliant.shards.sums import Half, Sums, Task, mean_of, sums_of, tasks_of
from pliant.trajectory.shards.ensemble import EnsembleFrames
from pliant.trajectory.universe import universe_of

linalg = late("scipy.linalg")

#: Units of which the matrix of covariances is kept: 3 x 2000 squared takes 288 MB, twice.
MOST_FOR_MODES = 2000

Result = TypeVar("Result")


def _none() -> np.ndarray:
    return np.empty(0)


@dataclass
class EnsembleFlexibility:
    """What the frames of all walkers tell. Lengths in Angstrom; U units."""

    units: Units  #: residues, by their CA or P, or atoms
    what: str  #: that is independent: "walkers" of runs, or "frames" of samples
    frames: int
    near: int  #: of these, around the start: flexibility is theirs
    walkers: int  #: or frames of a sample, each of which counts as a walker
    rmsf: np.ndarray  #: (U,) about the mean of all frames, superposed
    error: np.ndarray  #: (U,) standard error, from the differences between walkers
    halves: np.ndarray  #: (2, U) RMSF of walkers of even and of odd numbers
    correlation: float  #: Pearson's r of the halves; not a number where they do not vary
    total_variance: float
    max_residual: float  #: of the bars, before any rounding
    contacts: list[tuple[str, str, float]]  #: atoms, kind, share held
    atoms: Any  #: of MDAnalysis, those of each frame
    variances: np.ndarray = field(default_factory=_none)  #: (10,) of the principal components, A^2
    modes: np.ndarray = field(default_factory=_none)  #: (3U, 10) their directions, of length 1
    rmsip: float | None = None  #: of the first ten components of the halves
    why_no_modes: str = ""  #: where there are none
    amplitude: float | None = None  #: that samples were asked for, Angstrom: an input
    clusters: Clusters = field(init=False)

    @property
    def still(self) -> bool:
        """Whether nothing moves."""
        return bool(np.all(self.rmsf < STILL))


def flexibility(
    folder: Path, workers: int = 1, on_stage: Callable[[str], None] = lambda name: None
) -> EnsembleFlexibility:
    """Reads the frames of an ensemble three times, over some processes.

    Raises FileError and InputError if there is no ensemble, a shard is gone, or one walker is all.
    """
    frames = EnsembleFrames(folder)
    all_atoms = universe_of(frames).atoms
    units = _units(all_atoms)
    atoms = units.atoms
    on_stage("mean")
    reference = _mean(frames, atoms, frames.positions(0)[atoms], workers)
    frames.are_checked = True  # by the first pass over all of them
    on_stage("fluctuations")
    sums = _sums(frames, atoms, reference, workers)
    what = frames.plan.what
    if min(half.walkers for half in sums.halves) == 0:
        raise InputError(f"{folder}: one {what[:-1]}: errors and convergence need two")
    found = _result(units, what, sums, _contacts(frames, sums, all_atoms), all_atoms)
    found.frames = len(frames)
    found.amplitude = asked_amplitude(frames.parameters)
    on_stage("clusters")
    found.clusters = clusters(frames, atoms, workers, 1 if found.still else CLUSTERS)
    return found


def _units(atoms: Any) -> Units:
    trace = trace_of(atoms)
    if len(trace) >= 3:
        return trace_units(trace)
    heavy = atoms.select_atoms("not element H") if hasattr(atoms, "elements") else atoms
    return single_atoms(heavy if len(heavy) >= 3 else atoms)


def _mean(frames: EnsembleFrames, atoms: np.ndarray, start: np.ndarray, workers: int) -> np.ndarray:
    count, total = 0, np.zeros_like(start)
    for more, part in _over(mean_of, frames, atoms, start, workers):
        count += more
        total += part
    if count == 0:
        raise InputError(f"{frames.path}: no frame around the start is there yet")
    mean: np.ndarray = total / count
    return mean


def _sums(frames: EnsembleFrames, atoms: np.ndarray, reference: np.ndarray, workers: int) -> Sums:
    parts = _over(sums_of, frames, atoms, reference, workers)
    sums = next(parts)
    for part in parts:
        sums.add(part)
    return sums


def _over(
    work: Callable[[Task], Result],
    frames: EnsembleFrames,
    atoms: np.ndarray,
    reference: np.ndarray,
    workers: int,
) -> Iterator[Result]:
    """The results of parts of the shards, in their order."""
    tasks = tasks_of(Task, frames, atoms, reference, len(atoms) <= MOST_FOR_MODES)
    return each_part(work, tasks, workers)


def _result(
    units: Units, what: str, sums: Sums, contacts: list[tuple[str, str, float]], atoms: Any
) -> EnsembleFlexibility:
    even, odd = sums.halves
    halves = np.array([np.sqrt(_moments(even)[0]), np.sqrt(_moments(odd)[0])])
    both = Half(even.units, even.has_modes)
    both += even
    both += odd
    square, square_error = _moments(both)
    rmsf = np.sqrt(square)
    errors = np.divide(square_error, 2 * rmsf, out=np.zeros_like(rmsf), where=rmsf > 0)
    profile = rmsf, errors, halves, correlation(halves[0], halves[1]), float(square.sum())
    found = EnsembleFlexibility(
        units,
        what,
        both.frames,
        both.frames,
        both.walkers,
        *profile,
        sums.max_residual,
        contacts,
        atoms,
    )
    if found.still:
        found.why_no_modes = "nothing moves"
    elif both.has_modes:
        _add_modes(found, even, odd, both)
    else:
        found.why_no_modes = f"more than {MOST_FOR_MODES} units"
    return found


def _add_modes(found: EnsembleFlexibility, even: Half, odd: Half, both: Half) -> None:
    halves = [_principal(half)[1] for half in (even, odd)]
    found.variances, found.modes = _principal(both)
    found.rmsip = rmsip(halves[0].T, halves[1].T, min(TEN, halves[0].shape[1]))


def _moments(half: Half) -> tuple[np.ndarray, np.ndarray]:
    """Mean square fluctuation (U,) about the mean of these walkers, and its standard error.

    Of a walker it is m = a - 2 b.c + c.c, with c the mean of b; the error is from m's variance.
    """
    count = half.walkers
    c = half.b / count
    c_c = (c**2).sum(axis=1)
    mean = half.a / count - c_c
    # E[m^2], from the moments of a and b
    b_c = (half.b * c).sum(axis=1) / count
    second = (
        half.aa / count
        - 4 * (half.ab * c).sum(axis=1) / count
        + 4 * np.einsum("ui,uij,uj->u", c, half.bb, c) / count
        + 2 * c_c * (half.a / count - 2 * b_c)
        + c_c**2
    )
    variance = np.maximum(second - mean**2, 0.0)
    return np.maximum(mean, 0.0), np.sqrt(variance / max(count - 1, 1))


def _principal(half: Half) -> tuple[np.ndarray, np.ndarray]:
    """The largest variances and their directions (3U, 10)."""
    assert half.outer is not None
    c = (half.shift / half.frames).reshape(-1)
    covariance = half.outer / half.frames - np.outer(c, c)
    size = len(covariance)
    most = min(TEN, max(1, size - 6))
    values, vectors = linalg.eigh(covariance, subset_by_index=(size - most, size - 1))
    return np.maximum(values[::-1], 0.0), vectors[:, ::-1]


def _contacts(frames: EnsembleFrames, sums: Sums, atoms: Any) -> list[tuple[str, str, float]]:
    if sums.held is None:
        return []
    names = atom_labels(atoms)
    found = frames.first_shard.contacts
    if found is None or len(found.kinds) != len(sums.held):
        return []
    return [
        (f"{names[a]} – {names[b]}", kind, float(held / len(frames)))
        for (a, b), kind, held in zip(found.joints, found.kinds, sums.held, strict=True)
    ]
