# SPDX-License-Identifier: MIT
"""The manifest: one line of JSON for each shard that is whole, added when it is."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from pliant._core import FileError, InputError
from pliant.ensemble.inspect_shard import ShardRecord

MANIFEST = "shards.jsonl"


class Manifest:
    """The records of a folder's shards, by number. The latest line of a shard counts."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / MANIFEST
        data = self.path.read_bytes() if self.path.exists() else b""
        self._end = data.rfind(b"\n") + 1  # a line that a crash has cut short does not count
        self.records = dict(_read(self.path, data[: self._end]))

    def add(self, record: ShardRecord) -> None:
        """Counts a whole shard. Raises FileError.

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


def _read(path: Path, data: bytes) -> Iterator[tuple[int, ShardRecord]]:
    for k, line in enumerate(data.splitlines(), 1):
        try:
            record = ShardRecord(**json.loads(line))
        except (ValueError, TypeError):
            raise InputError(f"{path}:{k}: expected the record of a shard") from None
        yield record.shard, record
