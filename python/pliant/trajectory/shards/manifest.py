# SPDX-License-Identifier: MIT
"""The manifest: one line of JSON for each shard that is complete, added when it is.

A line has the numbers of the shard's walkers, how many frames and bytes it has, and the SHA-256 of
its bytes.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from pliant._core import FileError, InputError
from pliant.base.input_files import json_object, open_file
from pliant.trajectory.shards.inspect_shard import ShardRecord
from pliant.trajectory.shards.plan import EnsemblePlan

MANIFEST = "shards.jsonl"


class Manifest:
    """The records of a folder's shards, by number. The latest line of a shard counts.

    Raises InputError where a line is no record of a shard of the plan.
    """

    def __init__(self, folder: Path, plan: EnsemblePlan) -> None:
        self.path = folder / MANIFEST
        data = _bytes_of(self.path)
        self._end = data.rfind(b"\n") + 1  # a line that a crash has cut short does not count
        self.records = dict(_read(self.path, data[: self._end], plan))

    def add(self, record: ShardRecord) -> None:
        """Counts a complete shard. Raises FileError.

        A line that a power cut takes is no loss: the shard's file is found by its own check.
        """
        line = (json.dumps(record.as_json()) + "\n").encode()
        try:
            with open(self.path, "r+b" if self._end else "wb") as file:
                file.seek(self._end)
                file.truncate()
                file.write(line)
        except OSError as error:
            raise FileError(f"{self.path}: {error.strerror}") from None
        self._end += len(line)
        self.records[record.shard] = record

    def in_order(self) -> list[ShardRecord]:
        """All records, by their numbers."""
        return [self.records[number] for number in sorted(self.records)]


def _bytes_of(path: Path) -> bytes:
    if not path.exists():
        return b""
    try:
        with open(path, "rb", opener=open_file) as file:
            return file.read()
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None


def _read(path: Path, data: bytes, plan: EnsemblePlan) -> Iterator[tuple[int, ShardRecord]]:
    for k, line in enumerate(data.splitlines(), 1):
        try:
            record = ShardRecord(**json_object(line))
            _check_types(record)
        except (ValueError, TypeError):
            raise InputError(f"{path}:{k}: expected the record of a shard") from None
        _check_place(f"{path}:{k}", record, plan)
        yield record.shard, record


def _check_types(record: ShardRecord) -> None:
    for name, value in vars(record).items():
        if name in ("file", "sha256"):
            is_good = type(value) is str
        else:
            is_good = type(value) is int and value >= 0
        if not is_good:
            raise ValueError(name)


def _check_place(where: str, record: ShardRecord, plan: EnsemblePlan) -> None:
    """Raises InputError unless the plan has this shard, with these walkers or frames."""
    if record.shard >= plan.shard_count:
        most = plan.shard_count - 1
        raise InputError(f"{where}: shard: expected 0 to {most}, found {record.shard}")
    shard = plan.shard(record.shard)
    if (record.first, record.last) != (shard.first, shard.last):
        raise InputError(
            f"{where}: shard {shard.number}: expected {plan.what} {shard.first} to {shard.last}, "
            f"found {record.first} to {record.last}"
        )
