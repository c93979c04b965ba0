# SPDX-License-Identifier: MIT
"""What a shard's file holds, and whether it is complete: all of its walkers, each frame once.

A shard that the manifest counts must also have the very bytes that were counted.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from pliant._core import Error, InputError
from pliant.base.input_files import file_digest
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.shards.plan import EnsemblePlan, Shard

POSITION = "particles/trajectory/position"

#: What to do about a shard that is gone or damaged.
REMAKE = "the same pliant ensemble command makes it again"


@dataclass
class ShardRecord:
    """A line of the manifest: a shard that is complete."""

    shard: int
    first: int
    last: int
    file: str  #: below the ensemble's folder
    frames: int
    left_out: int  #: frames of a sample that could not be resolved
    unconverged: int  #: frames of a run that are not whole, and say so
    bytes: int
    sha256: str = ""  #: of the file's bytes; "" where a manifest does not say

    def as_json(self) -> dict[str, Any]:
        """For the manifest."""
        return asdict(self)


def inspect_shard(plan: EnsemblePlan, shard: Shard, path: Path) -> ShardRecord:
    """The record of a complete shard. Raises InputError saying what is wrong with the file."""
    return _record(plan, shard, path, file_digest(path))


def _record(plan: EnsemblePlan, shard: Shard, path: Path, digest: str) -> ShardRecord:
    with _hdf5.open_file(path) as file:
        _check_header(file, plan)
        numbers = _frame_numbers(file, plan)
        left_out = _check_numbers(path, plan, shard, *numbers)
        frames = len(numbers[0])
        unconverged = _unconverged(file, frames)
    which = (shard.number, shard.first, shard.last, shard.name)
    size = path.stat().st_size
    return ShardRecord(*which, frames, left_out, unconverged, size, digest)


def check_shard(
    plan: EnsemblePlan, shard: Shard, expected: ShardRecord | None, path: Path
) -> ShardRecord:
    """The record of a complete shard, which is the one that the manifest counts where it counts it.

    Reads every byte. Raises FileError where the file cannot be read, InputError saying what is
    wrong with what it holds.
    """
    digest = file_digest(path)  # what fails from here on is the contents, not the disk
    try:
        found = _record(plan, shard, path, digest)
    except Error as error:
        raise InputError(str(error)) from None
    counted = found if expected is None else expected
    names = [k for k, v in found.as_json().items() if v != counted.as_json()[k]]
    if names and not (names == ["sha256"] and not counted.sha256):
        raise InputError(f"{path}: is not what the manifest says: {', '.join(names)}")
    return found


def _check_header(file: h5py.File, plan: EnsemblePlan) -> None:
    """Raises InputError where the file says that it was made with another seed."""
    found = _hdf5.item(file, f"parameters/{plan.command}/seed")
    seed = _hdf5.plain(_hdf5.read(found)) if _hdf5.is_array(found, "OS", ()) else None
    if isinstance(seed, str) and seed.isdecimal() and int(seed) != plan.seed:
        raise InputError(f"{file.filename}: expected --seed {plan.seed}, found {seed}")


def _frame_numbers(file: h5py.File, plan: EnsemblePlan) -> tuple[np.ndarray, np.ndarray]:
    """Walker and step of each frame; each frame of a sample stands for itself."""
    value = _hdf5.item(file, f"{POSITION}/value")
    steps = _integers(file, f"{POSITION}/step")
    if not isinstance(value, h5py.Dataset) or len(value) != len(steps):
        raise InputError(f"{file.filename}: expected as many positions as steps")
    if plan.command == "sample":
        return steps, np.zeros_like(steps)
    walkers = _integers(file, "observables/walker/value")
    if len(walkers) != len(steps):
        raise InputError(f"{file.filename}: expected as many walkers as steps")
    return walkers, steps


def _integers(file: h5py.File, path: str) -> np.ndarray:
    found = _hdf5.item(file, path)
    if not _hdf5.is_array(found, "iu", (None,)):
        raise InputError(f"{file.filename}: /{path}: expected whole numbers")
    return np.asarray(_hdf5.read(found), dtype=np.int64)


def _check_numbers(
    path: Path, plan: EnsemblePlan, shard: Shard, walkers: np.ndarray, steps: np.ndarray
) -> int:
    """Raises InputError unless all are there, in order and once; returns frames left out."""
    order = np.lexsort((steps, walkers))
    pairs = np.stack([walkers, steps])
    if not (order == np.arange(len(order))).all() or (np.diff(pairs) == 0).all(axis=0).any():
        raise InputError(f"{path}: expected each frame once, in order")
    there = np.unique(walkers)
    if len(there) and (there[0] < shard.first or there[-1] > shard.last):
        raise InputError(
            f"{path}: expected {plan.what} {shard.first} to {shard.last}, found {there[0]} to "
            f"{there[-1]}"
        )
    missing = shard.size - len(there)
    if missing and plan.command == "run":
        raise InputError(f"{path}: {missing} of {shard.size} walkers are missing")
    if plan.command == "run" and len(set(np.bincount(walkers - shard.first))) > 1:
        raise InputError(f"{path}: expected as many frames of each walker")
    return missing


def _unconverged(file: h5py.File, frames: int) -> int:
    converged = _hdf5.item(file, "observables/converged/value")
    if not isinstance(converged, h5py.Dataset) or converged.shape != (frames,):
        raise InputError(f"{file.filename}: /observables/converged: expected one value a frame")
    return int(frames - np.count_nonzero(_hdf5.read(converged)))
