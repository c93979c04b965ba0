# SPDX-License-Identifier: MIT
"""Makes all shards of a plan: those that are missing, with Dask, each counted once."""

from __future__ import annotations

import contextlib
import itertools
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from pliant._core import Error, InputError, OptionError
from pliant.base.console import warn
from pliant.base.extras import late
from pliant.shards.cluster import Place
from pliant.shards.commits import remove_logs
from pliant.shards.make_shard import Making, make_shard
from pliant.shards.over_shards import in_threads
from pliant.shards.scratch import making_in, place_of, remove_left
from pliant.shards.time_limit import OutOfTimeError
from pliant.trajectory.shards.inspect_shard import ShardRecord, check_shard
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.plan import NO_SHARD, EnsemblePlan, Shard, shards_there, strangers

distributed = late("distributed")

#: Shards that the scheduler knows of at once: it need not hold 10^5 to keep hundreds of workers.
WINDOW = 1024

#: Seconds between looks at a queue while no shard comes.
_PAUSE = 0.02

Progress = Callable[[int, int], None]


@dataclass
class Outcome:
    """What is there after all."""

    plan: EnsemblePlan
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


def complete(
    plan: EnsemblePlan,
    folder: Path,
    place: Callable[[int], contextlib.AbstractContextManager[Place]],
    show: Progress,
    retries: int,
    how: Making | None = None,
) -> Outcome:
    """Makes the shards that are missing. `place` is asked for one, if there are any.

    Raises OutOfTimeError where the deadline comes first; OptionError and Error with what the first
    shard that failed for good has said. All shards that were complete by then stay, and are found
    the next time, as is what the others have committed.
    """
    began, how = time.monotonic(), how or Making()
    manifest = Manifest(folder, plan)
    _tidy(folder, how)
    outcome = Outcome(plan, folder)
    missing = _take_stock(plan, folder, manifest, show)
    outcome.found = plan.shard_count - len(missing)
    show(outcome.found, plan.shard_count)
    if missing:
        with _left_tidy(place, len(missing), folder, how) as opened:
            for record in made_by(opened, partial(make, how=how), plan, folder, missing, retries):
                manifest.add(record)
                outcome.made += 1
                show(outcome.found + outcome.made, plan.shard_count)
    outcome.records = manifest.in_order()
    outcome.seconds = time.monotonic() - began
    return outcome


def _tidy(folder: Path, how: Making, owner: str = "", wait: float = 0.0) -> None:
    """Removes what killed processes have left of shards, here and on the scratch disk.

    Jobs on other machines do so there.
    """
    remove_left(making_in(folder), folder, owner, wait)
    if how.scratch is not None:
        with contextlib.suppress(OptionError):  # a disk that other machines have
            remove_left(place_of(folder, how.scratch), folder, owner, wait)


@contextlib.contextmanager
def _left_tidy(
    place: Callable[[int], contextlib.AbstractContextManager[Place]],
    shards: int,
    folder: Path,
    how: Making,
) -> Iterator[Place]:
    """Where shards are made. At its end nothing is left here of those that are not complete."""
    wait = 0.0
    try:
        with place(shards) as opened:
            wait = opened.end_seconds
            yield opened
    finally:
        _tidy(folder, how, how.owner, wait)


def _take_stock(
    plan: EnsemblePlan, folder: Path, manifest: Manifest, show: Progress
) -> list[Shard]:
    """Checks every byte of the shards that are there; returns those to be made.

    One that is damaged, or in the place of another, is removed: the same bits will be made again.
    """
    there = shards_there(folder, plan)
    bad = set()
    for done, (shard, found) in enumerate(_checked(plan, folder, there, manifest), 1):
        if isinstance(found, str):
            warn(f"{found}: it is made again")
            (folder / shard.name).unlink()
            bad.add(shard.number)
        else:
            remove_logs(folder, shard)
            if shard.number not in manifest.records:
                manifest.add(found)
        show(done - len(bad), plan.shard_count)
    for path in strangers(folder, plan):
        warn(f"{path}: {NO_SHARD}")
    good = {shard.number for shard in there} - bad
    return [shard for shard in plan.shards() if shard.number not in good]


def _checked(
    plan: EnsemblePlan, folder: Path, shards: list[Shard], manifest: Manifest
) -> Iterator[tuple[Shard, ShardRecord | str]]:
    """The record of each shard, or what is wrong with it."""
    counted = dict(manifest.records)

    def check(shard: Shard) -> ShardRecord | str:
        try:
            return check_shard(plan, shard, counted.get(shard.number), folder / shard.name)
        except InputError as error:
            return str(error)

    return zip(shards, in_threads(check, shards), strict=True)


@dataclass(frozen=True)
class OutOfTime:
    """Of a worker that had to end before its shard was complete."""


#: What a worker brings back: the record of a shard, or why no further attempt is of use.
Made = ShardRecord | OutOfTime | str


def make(plan: EnsemblePlan, shard: Shard, folder: str, how: Making | None = None) -> Made:
    """On a worker: makes a shard."""
    try:
        return make_shard(plan, shard, folder, how)
    except OptionError as error:
        return str(error)
    except OutOfTimeError:
        return OutOfTime()


def made_by(
    place: Place,
    task: Callable[[EnsemblePlan, Shard, str], Made],
    plan: EnsemblePlan,
    folder: Path,
    shards: Iterable[Shard],
    retries: int,
) -> Iterator[ShardRecord]:
    """The records of the shards, as they come, each once. Raises as `complete`."""
    client, waiting = place.client, iter(shards)
    where = str(folder.absolute())

    def submit(shard: Shard) -> Any:
        return client.submit(task, plan, shard, where, retries=retries, pure=False)

    first = [submit(shard) for shard in itertools.islice(waiting, WINDOW)]
    futures = distributed.as_completed(first, loop=client.loop)
    while not futures.is_empty():
        if not futures.has_ready():
            place.expect_workers()
            time.sleep(_PAUSE)
            continue
        yield _result(next(futures))
        for shard in waiting:
            futures.add(submit(shard))
            break


def _result(future: Any) -> ShardRecord:
    error = future.exception()
    if error is not None:
        raise error if isinstance(error, (Error, OSError)) else Error(_text(error))
    result = future.result()
    if isinstance(result, OutOfTime):
        raise OutOfTimeError
    if isinstance(result, str):
        raise OptionError(result)
    record: ShardRecord = result
    return record


def _text(error: BaseException) -> str:
    return f"a shard could not be made: {type(error).__name__}: {error}"
