# SPDX-License-Identifier: MIT
"""What is summed over the frames of an ensemble, shard by shard: no frame stays in memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

from pliant._core import InputError
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.drawn_by import is_near
from pliant.trajectory.shards.inspect_shard import POSITION, ShardRecord
from pliant.trajectory.shards.open_shard import counted_files, positions_in
from pliant.trajectory.shards.plan import EnsemblePlan
from pliant.trajectory.superposition import superpose_onto

_BLOCK_BYTES = 16 << 20  #: of the frames that are read at once
_HELD = 0  #: of contact states


@dataclass
class Half:
    """Sums over the walkers of even, or of odd numbers; ``d`` is from the reference, of U units."""

    units: int
    has_modes: bool
    walkers: int = 0
    frames: int = 0
    shift: np.ndarray = field(init=False)  #: (U, 3) of d, over frames
    outer: np.ndarray | None = None  #: (3U, 3U) of d d^T, over frames
    # Over walkers: a = mean of |d|^2 and b = mean of d, of the frames of each.
    a: np.ndarray = field(init=False)
    aa: np.ndarray = field(init=False)
    b: np.ndarray = field(init=False)
    ab: np.ndarray = field(init=False)
    bb: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        n = self.units
        self.shift, self.b, self.ab = (np.zeros((n, 3)) for _ in range(3))
        self.a, self.aa, self.bb = np.zeros(n), np.zeros(n), np.zeros((n, 3, 3))
        if self.has_modes:
            self.outer = np.zeros((3 * n, 3 * n))

    def add_frames(self, d: np.ndarray) -> None:
        """Frames (F, U, 3)."""
        self.frames += len(d)
        self.shift += d.sum(axis=0)
        if self.outer is not None:
            flat = d.reshape(len(d), 3 * self.units)
            self.outer += flat.T @ flat

    def add_walkers(self, a: np.ndarray, b: np.ndarray) -> None:
        """The means of walkers: (W, U) and (W, U, 3)."""
        self.walkers += len(a)
        self.a += a.sum(axis=0)
        self.aa += (a**2).sum(axis=0)
        self.b += b.sum(axis=0)
        self.ab += (a[:, :, None] * b).sum(axis=0)
        self.bb += np.einsum("wui,wuj->uij", b, b)

    def __iadd__(self, other: Half) -> Half:
        self.walkers += other.walkers
        self.frames += other.frames
        for name in ("shift", "a", "aa", "b", "ab", "bb"):
            getattr(self, name).__iadd__(getattr(other, name))
        if self.outer is not None and other.outer is not None:
            self.outer += other.outer
        return self


@dataclass
class Sums:
    """Sums of both halves, and what is counted of all frames."""

    halves: tuple[Half, Half]
    held: np.ndarray | None = None  #: (C,) frames in which each contact holds
    max_residual: float = 0.0

    def add(self, other: Sums) -> None:
        """Adds the sums of other shards."""
        for ours, theirs in zip(self.halves, other.halves, strict=True):
            ours += theirs
        self.count(other.held, other.max_residual)

    def count(self, held: np.ndarray | None, max_residual: float) -> None:
        """Contacts held and the worst residual of more frames."""
        self.max_residual = max(self.max_residual, max_residual)
        if held is not None:
            self.held = held if self.held is None else self.held + held


@dataclass
class Task:
    """A part of the shards, for one process."""

    plan: EnsemblePlan
    paths: list[Path]
    records: list[ShardRecord | None]  #: what to check the files by, where that is to be done
    atoms: np.ndarray  #: (U,) one of each unit
    reference: np.ndarray  #: (U, 3) Angstrom
    has_modes: bool

    def files(self) -> Iterator[h5py.File]:
        """Each of the files while it is open. Raises as `counted_files`."""
        return counted_files(self.plan, self.paths, self.records)


def mean_of(task: Task) -> tuple[int, np.ndarray]:
    """Frames around the start, and the sum of their superposed positions (U, 3)."""
    count, total = 0, np.zeros_like(task.reference)
    for file in task.files():
        for _, frames in blocks(file, task.atoms, around_start(file, task.plan)):
            count += len(frames)
            total += superpose_onto(frames, slice(None), task.reference).sum(axis=0)
    return count, total


def sums_of(task: Task) -> Sums:
    """All sums, of frames around the start, superposed on the reference."""
    halves = [Half(len(task.atoms), task.has_modes) for _ in range(2)]
    sums = Sums((halves[0], halves[1]))
    for file in task.files():
        _add_shard(sums, file, task)
    return sums


def _add_shard(sums: Sums, file: h5py.File, task: Task) -> None:
    near = around_start(file, task.plan)
    walkers = walkers_of(file, task.plan)[near]
    numbers, place = np.unique(walkers, return_inverse=True)
    counts = np.bincount(place)[:, None]
    a, b = np.zeros((len(numbers), len(task.atoms))), np.zeros((len(numbers), len(task.atoms), 3))
    for rows, frames in blocks(file, task.atoms, near):
        d = superpose_onto(frames, slice(None), task.reference) - task.reference
        np.add.at(a, place[rows], (d**2).sum(axis=2))
        np.add.at(b, place[rows], d)
        for k, half in enumerate(sums.halves):
            half.add_frames(d[walkers[rows] % 2 == k])
    for k, half in enumerate(sums.halves):
        chosen = numbers % 2 == k
        half.add_walkers((a / counts)[chosen], (b / counts[:, :, None])[chosen])
    sums.count(*_counted(file))


def _counted(file: h5py.File) -> tuple[np.ndarray | None, float]:
    residuals = _hdf5.item(file, "observables/max_residual/value")
    worst = float(np.max(_hdf5.read(residuals))) if _hdf5.has_rows(residuals) else 0.0
    states = _hdf5.item(file, "connectivity/contact_states/value")
    if not _hdf5.is_array(states, "iu", (None, None)):
        return None, worst
    return np.count_nonzero(_hdf5.read(states) == _HELD, axis=0), worst


def walkers_of(file: h5py.File, plan: EnsemblePlan) -> np.ndarray:
    """(F,) whose frames they are; each frame of a sample is its own walker."""
    path = f"{POSITION}/step" if plan.command == "sample" else "observables/walker/value"
    found = _hdf5.item(file, path)
    if not _hdf5.is_array(found, "iu", (None,)):
        raise InputError(f"{file.filename}: /{path}: expected whole numbers")
    return np.asarray(_hdf5.read(found), dtype=np.int64)


def around_start(file: h5py.File, plan: EnsemblePlan) -> np.ndarray:
    """(F,) bool: frames by which flexibility is computed. Those that go further are not.

    Of another sampler all are, and of runs.
    """
    found = _hdf5.item(file, "observables/sampler/value")
    if not plan.may_reach or not _hdf5.is_array(found, "u", (None,)):
        return np.ones(len(positions_in(file)), dtype=bool)
    return is_near(_hdf5.read(found))


def blocks(
    file: h5py.File, atoms: np.ndarray, chosen: np.ndarray
) -> Iterator[tuple[slice, np.ndarray]]:
    """Positions (F, U, 3) of chosen frames, some megabytes at a time, and which these are."""
    found, done = positions_in(file), 0
    step = max(1, _BLOCK_BYTES // (24 * max(1, found.shape[1])))
    for begin in range(0, len(found), step):
        rows = slice(begin, min(begin + step, len(found)))
        if not chosen[rows].any():
            continue
        some = _hdf5.read(found, rows)[chosen[rows]][:, atoms].astype(np.float64)
        yield slice(done, done + len(some)), some
        done += len(some)
