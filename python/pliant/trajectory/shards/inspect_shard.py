# SPDX-License-Identifier: MIT
"""What a shard's file holds, and whether it is complete: all of its walkers, each frame once.

A shard that the manifest counts must also have the very bytes that were counted.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pliant._core import Error, FileError, InputError
from pliant.base.input_files import file_digest
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.shards.plan import EnsemblePlan, Shard

#: What to do about a shard that is gone or damaged.
REMAKE = "the same pliant ensemble command makes it again"

#: Shards that were found to be those of their manifest, as they were then, by this process:
#: path -> device, number, size, time, SHA-256.
_good: dict[Path, tuple[int | str, ...]] = {}


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


def counted_shard(plan: EnsemblePlan, record: ShardRecord | None, path: Path) -> FramesOfH5md:
    """The frames of a shard, every byte of which is read first, where there is a record of it to
    check it by: once as long as the file stays as it is.

    Raises FileError where it is gone or cannot be read, InputError unless it is what the manifest
    counts.
    """
    try:
        status = path.stat()
    except FileNotFoundError:
        raise FileError(f"{path}: is gone: {REMAKE}") from None
    if record is None:
        return FramesOfH5md(path)
    state = (status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns, record.sha256)
    try:
        if _good.get(path) != state:
            check_shard(plan, plan.shard(record.shard), record, path)
            _good[path] = state
    except InputError as error:
        raise InputError(f"{error}; {REMAKE}") from None
    return FramesOfH5md(path)


def inspect_shard(plan: EnsemblePlan, shard: Shard, path: Path) -> ShardRecord:
    """The record of a complete shard. Raises InputError saying what is wrong with the file."""
    return _record(plan, shard, path, file_digest(path))


def _record(plan: EnsemblePlan, shard: Shard, path: Path, digest: str) -> ShardRecord:
    frames = FramesOfH5md(path)
    _check_seed(frames, plan)
    left_out = _check_numbers(frames, plan, shard)
    unconverged = int(np.count_nonzero(~_column(frames, "converged").astype(bool)))
    which = (shard.number, shard.first, shard.last, shard.name)
    size = path.stat().st_size
    return ShardRecord(*which, len(frames), left_out, unconverged, size, digest)


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


def _check_seed(frames: FramesOfH5md, plan: EnsemblePlan) -> None:
    """Raises InputError where the file says that it was made with another seed."""
    seed = frames.parameters.get(f"{plan.command}/seed")
    if isinstance(seed, str) and seed.isdecimal() and int(seed) != plan.seed:
        raise InputError(f"{frames.path}: expected --seed {plan.seed}, found {seed}")


def _column(frames: FramesOfH5md, name: str) -> np.ndarray:
    found = frames.observables.get(name)
    if found is None:
        raise InputError(f"{frames.path}: /observables/{name}: expected one value a frame")
    return found


def walkers_of(frames: FramesOfH5md, plan: EnsemblePlan) -> np.ndarray:
    """(F,) whose frames they are; each frame of a sample is its own walker."""
    return frames.steps if plan.command == "sample" else _column(frames, "walker")


def _check_numbers(frames: FramesOfH5md, plan: EnsemblePlan, shard: Shard) -> int:
    """Raises InputError unless all are there, in order and once; returns frames left out."""
    path, walkers = frames.path, walkers_of(frames, plan)
    if frames.frames_left_out:
        raise InputError(f"{path}: expected as many positions as steps")
    steps = np.zeros_like(walkers) if plan.command == "sample" else frames.steps
    pairs = np.stack([walkers, steps])
    order = np.lexsort((steps, walkers))
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
