# SPDX-License-Identifier: MIT
"""Makes all shards of a plan: those that are missing, with Dask, each counted once."""

from __future__ import annotations

import contextlib
import fcntl
import itertools
import shutil
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TextIO

from pliant._core import Error, FileError, OptionError
from pliant.ensemble.inspect_shard import ShardRecord
from pliant.ensemble.make_shard import MAKING, make_shard
from pliant.ensemble.manifest import Manifest
from pliant.ensemble.plan import PLAN, Plan, Shard, has_shards

#: Shards that the scheduler knows of at once: it need not hold 10^5 to keep hundreds of workers.
WINDOW = 1024

#: What to do about a shard that is damaged.
REMAKE = "remove it, and the same command makes it again"

Progress = Callable[[int, int], None]


@dataclass
class Outcome:
    """What is there after all."""

    plan: Plan
    folder: Path
    found: int = 0  #: shards that were there already
    made: int = 0
    seconds: float = 0.0
    records: list[ShardRecord] = field(default_factory=list)

    def total(self, name: str) -> int:
        """The sum of a number over all shards."""
        return sum(getattr(record, name) for record in self.records)

    def as_json(self) -> dict[str, Any]:
        """For ``--json``."""
        sums = {name: self.total(name) for name in ("frames", "left_out", "unconverged", "bytes")}
        return {
            "output": str(self.folder),
            "command": self.plan.command,
            "asked": self.plan.count,
            "shards": len(self.records),
            "shards_found": self.found,
            "shards_made": self.made,
            **sums,
            "seconds": self.seconds,
        }


def _lock_file(folder: Path) -> TextIO:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return open(folder / ".lock", "w", encoding="utf-8")
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror}: expected a folder for the ensemble") from None


@contextlib.contextmanager
def alone_in(folder: Path) -> Iterator[None]:
    """Makes the folder. Raises FileError if that fails, or if another command is at work there.

    A folder that was made here and holds neither plan nor shard goes when the work fails.
    """
    is_new = not folder.exists()
    with _lock_file(folder) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise FileError(f"{folder}: another pliant ensemble is at work in it") from None
        try:
            yield
        except Exception:
            if is_new and not (folder / PLAN).exists() and not has_shards(folder):
                shutil.rmtree(folder, ignore_errors=True)
            raise


def complete(
    plan: Plan,
    folder: Path,
    client: Callable[[], contextlib.AbstractContextManager[Any]],
    show: Progress,
    retries: int = 3,
) -> Outcome:
    """Makes the shards that are missing. `client` is asked for only if there are such.

    Raises OptionError and Error with what the first shard that failed for good has said; all shards
    that were whole by then stay, and are found the next time.
    """
    began = time.monotonic()
    manifest = Manifest(folder)
    outcome = Outcome(plan, folder)
    missing = _take_stock(plan, folder, manifest)
    outcome.found = plan.shard_count - len(missing)
    show(outcome.found, plan.shard_count)
    if missing:
        with client() as dask_client:
            for record in made_by(dask_client, make, plan, folder, missing, retries):
                manifest.add(record)
                outcome.made += 1
                show(outcome.found + outcome.made, plan.shard_count)
    outcome.records = manifest.in_order()
    outcome.seconds = time.monotonic() - began
    return outcome


def _take_stock(plan: Plan, folder: Path, manifest: Manifest) -> list[Shard]:
    """Counts shards that are there, by the manifest or by their own check; returns the others."""
    shutil.rmtree(folder / MAKING, ignore_errors=True)  # of workers that were killed
    missing = []
    for shard in plan.shards():
        path, record = folder / shard.name, manifest.records.get(shard.number)
        if not path.exists():
            missing.append(shard)
        elif record is None:
            manifest.add(make_shard(plan, shard, str(folder)))
        elif path.stat().st_size != record.bytes:
            raise FileError(
                f"{path}: has {path.stat().st_size} bytes, expected {record.bytes}: it is damaged; "
                f"{REMAKE}"
            )
    return missing


def make(plan: Plan, shard: Shard, folder: str) -> ShardRecord | str:
    """On a worker: the record, or why no attempt can succeed."""
    try:
        return make_shard(plan, shard, folder)
    except OptionError as error:
        return str(error)


def made_by(
    client: Any,
    task: Callable[[Plan, Shard, str], ShardRecord | str],
    plan: Plan,
    folder: Path,
    shards: Iterable[Shard],
    retries: int,
) -> Iterator[ShardRecord]:
    """The records of the shards, as they come, each once."""
    from distributed import as_completed

    waiting = iter(shards)
    place = str(folder.absolute())

    def submit(shard: Shard) -> Any:
        return client.submit(task, plan, shard, place, retries=retries, pure=False)

    first = [submit(shard) for shard in itertools.islice(waiting, WINDOW)]
    futures = as_completed(first, loop=client.loop)
    for future in futures:
        yield _result(future)
        for shard in waiting:
            futures.add(submit(shard))
            break


def _result(future: Any) -> ShardRecord:
    error = future.exception()
    if error is not None:
        raise error if isinstance(error, (Error, OSError)) else Error(_text(error))
    result = future.result()
    if isinstance(result, str):
        raise OptionError(result)
    record: ShardRecord = result
    return record


def _text(error: BaseException) -> str:
    return f"a shard could not be made: {type(error).__name__}: {error}"
