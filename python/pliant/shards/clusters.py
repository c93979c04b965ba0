# SPDX-License-Identifier: MIT
"""Clusters of an ensemble in many files: a few frames that stand for all, and how many each has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant.measure.shapes.medoids import k_medoids
from pliant.shards.over_shards import each_part
from pliant.shards.sums import Part, blocks, tasks_of
from pliant.trajectory.shards.ensemble import EnsembleFrames
from pliant.trajectory.shards.inspect_shard import walkers_of
from pliant.trajectory.superposition import pairwise_rmsd, rmsd_to

CLUSTERS = 10
#: The frames that stand for all are chosen among so many, taken evenly.
MOST_COMPARED = 1500


@dataclass
class Clusters:
    """k frames, those that stand for most first, and the frames nearest to each. Angstrom."""

    frames: np.ndarray  #: (k,) numbers in the ensemble
    positions: np.ndarray  #: (k, N, 3) of all atoms
    records: list[dict[str, float | int]]  #: (k) step, walker and observables
    shares: np.ndarray  #: (k,) of all frames, each of which belongs to the nearest
    errors: np.ndarray  #: (k,) standard errors, from the differences between walkers
    halves: np.ndarray  #: (2, k) shares of walkers of even and of odd numbers
    distances: np.ndarray  #: (k,) mean RMSD of its frames from it, superposed
    compared: int  #: frames among which they were chosen


@dataclass
class _Task(Part):
    """To which frames all others are dealt."""

    medoids: np.ndarray  #: (k, U, 3)


@dataclass
class _Counts:
    """Sums over walkers, of even and of odd numbers. Each walker counts as one."""

    walkers: np.ndarray  #: (2,)
    shares: np.ndarray  #: (2, k) sums over walkers
    squares: np.ndarray  #: (k,) of the shares, over walkers
    frames: np.ndarray  #: (k,)
    distances: np.ndarray  #: (k,) sums over frames

    def add(self, other: _Counts) -> None:
        """Adds the sums of other shards."""
        for name, value in vars(other).items():
            getattr(self, name).__iadd__(value)


def clusters(
    frames: EnsembleFrames, atoms: np.ndarray, workers: int = 1, most: int = CLUSTERS
) -> Clusters:
    """Chooses `most` frames by k-medoids on the RMSD of `atoms`, and deals all to the nearest.

    Memory does not grow with the number of frames: the choice is among MOST_COMPARED of them, the
    rest is read once, over `workers` processes.
    """
    numbers = np.unique(np.linspace(0, len(frames) - 1, MOST_COMPARED).astype(np.int64))
    compared = np.array([frames.positions(int(number))[atoms] for number in numbers])
    found = k_medoids(pairwise_rmsd(compared), min(most, len(numbers)))
    counts = _counts(frames, atoms, compared[found.frames], workers)
    order = np.argsort(-counts.shares.sum(axis=0), kind="stable")
    return _result(frames, numbers[found.frames[order]], counts, order, len(numbers))


def _result(
    frames: EnsembleFrames, numbers: np.ndarray, counts: _Counts, order: np.ndarray, compared: int
) -> Clusters:
    positions = frames.read(numbers)
    records = [frames.numbers(int(number)) for number in numbers]
    walkers = counts.walkers.sum()
    shares = counts.shares.sum(axis=0) / walkers
    variance = np.maximum(counts.squares / walkers - shares**2, 0.0)
    errors = np.sqrt(variance / max(walkers - 1, 1))
    halves = counts.shares / np.maximum(counts.walkers, 1)[:, None]
    mean = counts.distances / np.maximum(counts.frames, 1)
    made = shares[order], errors[order], halves[:, order]
    return Clusters(numbers, positions, records, *made, mean[order], compared)


def _counts(
    frames: EnsembleFrames, atoms: np.ndarray, medoids: np.ndarray, workers: int
) -> _Counts:
    parts = each_part(_counts_of, tasks_of(_Task, frames, atoms, medoids), workers)
    counts = next(parts)
    for part in parts:
        counts.add(part)
    return counts


def _counts_of(task: _Task) -> _Counts:
    k = len(task.medoids)
    frames, sizes = np.zeros(2, dtype=np.int64), np.zeros(k, dtype=np.int64)
    counts = _Counts(frames, np.zeros((2, k)), np.zeros(k), sizes, np.zeros(k))
    for shard in task.shards():
        walkers = walkers_of(shard, task.plan)
        every = np.ones(len(walkers), dtype=bool)
        dealt = [rmsd_to(some, task.medoids) for _, some in blocks(shard, task.atoms, every)]
        counts.add(_of_shard(walkers, np.concatenate(dealt)))
    return counts


def _of_shard(walkers: np.ndarray, distances: np.ndarray) -> _Counts:
    """Sums over the frames of complete walkers; walkers: (F,) and distances: (F, k)."""
    k = distances.shape[1]
    owner = np.argmin(distances, axis=1)
    nearest = distances[np.arange(len(owner)), owner]
    numbers, place = np.unique(walkers, return_inverse=True)
    table = np.zeros((len(numbers), k))
    np.add.at(table, (place, owner), 1.0)
    shares = table / table.sum(axis=1, keepdims=True)
    halves = [numbers % 2 == half for half in range(2)]
    return _Counts(
        np.array([np.count_nonzero(half) for half in halves]),
        np.array([shares[half].sum(axis=0) for half in halves]),
        (shares**2).sum(axis=0),
        np.bincount(owner, minlength=k),
        np.bincount(owner, weights=nearest, minlength=k),
    )
