# SPDX-License-Identifier: MIT
"""``pliant ensemble --verify``: proves that all shards are there and whole, each frame once."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pliant._core import Error
from pliant.ensemble.cluster import usual_workers
from pliant.ensemble.drive import REMAKE, Progress
from pliant.ensemble.inspect_shard import ShardRecord, inspect_shard
from pliant.ensemble.manifest import Manifest
from pliant.ensemble.plan import SHARDS, Plan, Shard, load_plan


@dataclass
class Verification:
    """What was looked at, and what is wrong."""

    plan: Plan
    folder: Path
    shards: int = 0  #: whole
    frames: int = 0
    bytes: int = 0
    problems: list[str] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "output": str(self.folder),
            "command": self.plan.command,
            "asked": self.plan.count,
            "shards": self.plan.shard_count,
            "shards_whole": self.shards,
            "frames": self.frames,
            "bytes": self.bytes,
            "problems": self.problems,
        }


def verify(folder: Path, show: Progress = lambda done, total: None) -> Verification:
    """Reads every byte of every shard. Raises FileError and InputError if there is no ensemble."""
    plan = load_plan(folder)
    records = Manifest(folder).records
    result = Verification(plan, folder)
    with ThreadPoolExecutor(usual_workers()) as pool:
        looks = pool.map(lambda shard: _look(plan, folder, shard, records), plan.shards())
        for done, found in enumerate(looks, 1):
            show(done, plan.shard_count)
            if isinstance(found, str):
                result.problems.append(found)
                continue
            result.shards += 1
            result.frames += found.frames
            result.bytes += found.bytes
    result.problems += _strangers(plan, folder)
    return result


def _look(
    plan: Plan, folder: Path, shard: Shard, records: dict[int, ShardRecord]
) -> ShardRecord | str:
    path, expected = folder / shard.name, records.get(shard.number)
    if not path.exists():
        return f"{path}: is not there: the same command makes it"
    try:
        found = inspect_shard(plan, shard, path)
    except Error as error:
        return f"{error}; {REMAKE}"
    if expected is None:
        return f"{path}: is complete, but not in the manifest: run the same command again to add it"
    if found != expected:
        names = [k for k, v in found.as_json().items() if v != expected.as_json()[k]]
        return f"{path}: is not what the manifest says: {', '.join(names)}; {REMAKE}"
    return found


def _strangers(plan: Plan, folder: Path) -> list[str]:
    """Files among the shards whose frames would be there twice."""
    known = {Path(shard.name).name for shard in plan.shards()}
    names = sorted(path.name for path in (folder / SHARDS).glob("*"))
    return [
        f"{folder / SHARDS / name}: is no shard of this ensemble"
        for name in names
        if name not in known
    ]
