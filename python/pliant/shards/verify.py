# SPDX-License-Identifier: MIT
"""``pliant ensemble --verify``: proves that all shards are there and complete, each frame once."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from pliant._core import Error, InputError
from pliant.base.console import counted
from pliant.shards.drive import Progress
from pliant.shards.over_shards import in_threads
from pliant.trajectory.shards.inspect_shard import REMAKE, ShardRecord, check_shard
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.plan import (
    NO_SHARD,
    EnsemblePlan,
    Shard,
    load_plan,
    shards_there,
    strangers,
)

MOST_NAMED = 1000  #: shards that are not there, one by one


@dataclass
class Verification:
    """What was looked at, and what is wrong."""

    plan: EnsemblePlan
    folder: Path
    shards: int = 0  #: complete
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
    records = Manifest(folder, plan).records
    result = Verification(plan, folder)

    def look(shard: Shard) -> ShardRecord | str:
        return _look(plan, folder, shard, records.get(shard.number))

    shards = _to_look_at(plan, folder)
    for done, found in enumerate(in_threads(look, shards), 1):
        show(done, len(shards))
        if isinstance(found, str):
            result.problems.append(found)
            continue
        result.shards += 1
        result.frames += found.frames
        result.bytes += found.bytes
    if left := plan.shard_count - len(shards):
        result.problems.append(f"{folder}: not there either: {counted(left, 'more shard')}")
    result.problems += [f"{path}: {NO_SHARD}" for path in strangers(folder, plan)]
    return result


def _to_look_at(plan: EnsemblePlan, folder: Path) -> list[Shard]:
    """Those that are there, and the first of those that are not: a plan may name any number."""
    there = shards_there(folder, plan)
    numbers = {shard.number for shard in there}
    gone = islice((one for one in plan.shards() if one.number not in numbers), MOST_NAMED)
    return sorted([*there, *gone], key=lambda shard: shard.number)


def _look(
    plan: EnsemblePlan, folder: Path, shard: Shard, expected: ShardRecord | None
) -> ShardRecord | str:
    path = folder / shard.name
    if not path.exists():
        return f"{path}: is not there: the same command makes it"
    try:
        found = check_shard(plan, shard, expected, path)
    except InputError as error:
        return f"{error}; {REMAKE}"
    except Error as error:
        return str(error)
    if expected is None:
        return f"{path}: is complete, but not in the manifest: run the same command again to add it"
    return found
