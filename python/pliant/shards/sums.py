# SPDX-License-Identifier: MIT
"""What is summed over the frames of an ensemble, shard by shard: no frame stays in memory."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

import numpy as np

from pliant.shards.over_shards import parts_of
from pliant.trajectory.drawn_by import is_near
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.recorded_contacts import HELD
from pliant.trajectory.shards.ensemble import EnsembleFrames
from pliant.trajectory.shards.inspect_shard import ShardRecord, counted_shard, walkers_of
from pliant.trajectory.shards.plan import EnsemblePlan
from pliant.trajectory.superposition import superpose_onto

_BLOCK_BYTES = 16 << 20  #: of the frames that are read at once

Made = TypeVar("Made")


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
class Part:
    """Some of the shards, for one process."""

    plan: EnsemblePlan
    paths: list[Path]
    records: list[ShardRecord | None]  #: what to check the files by, where that is to be done
    atoms: np.ndarray  #: (U,) one of each unit

    def shards(self) -> Iterator[FramesOfH5md]:
        """The frames of each. Raises as `counted_shard`."""
        for path, record in zip(self.paths, self.records, strict=True):
            yield counted_shard(self.plan, record, path)


@dataclass
class Task(Part):
    """What to superpose their frames on."""

    reference: np.ndarray  #: (U, 3) Angstrom
    has_modes: bool


def tasks_of(kind: Callable[..., Made], frames: EnsembleFrames, *more: object) -> list[Made]:
    """All shards, dealt to parts of this kind; `more`: its fields from `atoms` on."""
    parts = zip(parts_of(frames.paths), parts_of(frames.records_to_check()), strict=True)
    return [kind(frames.plan, paths, records, *more) for paths, records in parts]


def mean_of(task: Task) -> tuple[int, np.ndarray]:
    """Frames around the start, and the sum of their superposed positions (U, 3)."""
    count, total = 0, np.zeros_like(task.reference)
    for shard in task.shards():
        for _, frames in blocks(shard, task.atoms, around_start(shard, task.plan)):
            count += len(frames)
            total += superpose_onto(frames, slice(None), task.reference).sum(axis=0)
    return count, total


def sums_of(task: Task) -> Sums:
    """All sums, of frames around the start, superposed on the reference."""
    halves = [Half(len(task.atoms), task.has_modes) for _ in range(2)]
    sums = Sums((halves[0], halves[1]))
    for shard in task.shards():
        _add_shard(sums, shard, task)
    return sums


def _add_shard(sums: Sums, shard: FramesOfH5md, task: Task) -> None:
    near = around_start(shard, task.plan)
    walkers = walkers_of(shard, task.plan)[near]
    numbers, place = np.unique(walkers, return_inverse=True)
    counts = np.bincount(place)[:, None]
    a, b = np.zeros((len(numbers), len(task.atoms))), np.zeros((len(numbers), len(task.atoms), 3))
    for rows, frames in blocks(shard, task.atoms, near):
        d = superpose_onto(frames, slice(None), task.reference) - task.reference
        np.add.at(a, place[rows], (d**2).sum(axis=2))
        np.add.at(b, place[rows], d)
        for k, half in enumerate(sums.halves):
            half.add_frames(d[walkers[rows] % 2 == k])
    for k, half in enumerate(sums.halves):
        chosen = numbers % 2 == k
        half.add_walkers((a / counts)[chosen], (b / counts[:, :, None])[chosen])
    sums.count(*_counted(shard))


def _counted(shard: FramesOfH5md) -> tuple[np.ndarray | None, float]:
    worst = float(np.max(shard.observables.get("max_residual", np.zeros(1)), initial=0.0))
    contacts = shard.contacts
    if contacts is None or contacts.states is None:
        return None, worst
    return np.count_nonzero(contacts.states == HELD, axis=0), worst


def around_start(shard: FramesOfH5md, plan: EnsemblePlan) -> np.ndarray:
    """(F,) bool: frames by which flexibility is computed. Those that go further are not.

    Of another sampler all are, and of runs.
    """
    drawn_by = shard.observables.get("sampler")
    if not plan.may_reach or drawn_by is None:
        return np.ones(len(shard), dtype=bool)
    return is_near(drawn_by)


def blocks(
    shard: FramesOfH5md, atoms: np.ndarray, chosen: np.ndarray
) -> Iterator[tuple[slice, np.ndarray]]:
    """Positions (F, U, 3) of chosen frames, some megabytes at a time, and which these are."""
    done, step = 0, max(1, _BLOCK_BYTES // (24 * max(1, shard.atom_count)))
    for begin in range(0, len(shard), step):
        rows = np.arange(begin, min(begin + step, len(shard)))
        rows = rows[chosen[rows]]
        if len(rows) == 0:
            continue
        some = shard.read(rows)[:, atoms]
        yield slice(done, done + len(some)), some
        done += len(some)
