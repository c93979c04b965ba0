# SPDX-License-Identifier: MIT
"""What HDF5 is not asked for: it would take memory out of proportion to what the file holds."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from typing import Any, TypeAlias

import h5py
import numpy as np

from pliant._core import InputError, expansion_refusal, writer_of

#: Chunks are counted, one by one, where one has more bytes than these.
SMALL_CHUNK = 1 << 24
#: Values of variable length that are read at once.
TEXTS_AT_ONCE = 64
#: What is more than this is as much too much.
MOST_BYTES = (1 << 64) - 1

Item: TypeAlias = "h5py.Group | h5py.Dataset"


def refused(parent: Item, name: str, why: str) -> InputError:
    """An InputError that names the file and the path of something below `parent`."""
    base = (parent.name or "").rstrip("/")
    file = file_name(parent)
    writer = writer_of(file)
    note = f"; it is being written by {writer}: try again" if writer else ""
    return InputError(f"{file}: {base}/{name}: {why}{note}")


def file_name(item: Item) -> str:
    """The name of the file that an item is in."""
    name = item.file.filename
    return name.decode("utf-8", "replace") if isinstance(name, bytes) else str(name)


def guarded(parent: Item, name: str, act: Any) -> Any:
    """What `act` returns; its errors become a FileError that names the item."""
    try:
        return act()
    except KeyError:
        return None
    except (OSError, RuntimeError, TypeError, ValueError, MemoryError) as error:
        raise refused(parent, name, f"cannot be read: {one_line(error)}") from error


def one_line(error: Exception) -> str:
    """The text of an error without line ends."""
    return " ".join(str(error).split())


def check_stored(dataset: h5py.Dataset, values: int, at_once: int | None = None) -> None:
    """Raises InputError if the file cannot hold so many values of a dataset, or if its chunks or
    those values that are in memory `at_once` (default: all) are out of proportion to it."""
    name = (dataset.name or "").rpartition("/")[2]
    why = guarded(dataset.parent, name, lambda: _refusal(dataset, values, at_once))
    if why:
        raise InputError(f"{file_name(dataset)}: {dataset.name}: of shape {dataset.shape} {why}")


def _refusal(dataset: h5py.Dataset, values: int, at_once: int | None) -> str:
    size = dataset.dtype.itemsize
    chunk = math.prod(dataset.chunks) * size if dataset.chunks else 0
    return expansion_refusal(
        values=min(values * size, MOST_BYTES),
        at_once=min((values if at_once is None else at_once) * size, MOST_BYTES),
        chunk=min(chunk, MOST_BYTES),
        stored=dataset.id.get_storage_size(),
        chunks=dataset.id.get_num_chunks() if chunk > SMALL_CHUNK else 1,
        file_size=dataset.file.id.get_filesize(),
    )


def texts_of(dataset: h5py.Dataset) -> np.ndarray:
    """All values of variable length (n,), some at a time: many may be one place in the file."""
    name = (dataset.name or "").rpartition("/")[2]
    found = np.empty(dataset.shape, dtype=dataset.dtype)
    size, file_size = 0, dataset.file.id.get_filesize()
    for first in range(0, len(found), TEXTS_AT_ONCE):
        part = slice(first, first + TEXTS_AT_ONCE)
        found[part] = guarded(dataset.parent, name, lambda part=part: dataset[part])
        size += sum(len(value) for value in found[part])
        why = expansion_refusal(
            values=size, at_once=size, chunk=0, stored=file_size, chunks=1, file_size=file_size
        )
        if why:
            raise InputError(f"{file_name(dataset)}: {dataset.name}: {why}")
    return found


def check_chunks(file: h5py.File) -> None:
    """Raises InputError if any dataset has chunks or rows that expand out of proportion: MDAnalysis
    reads what it likes, a row a frame. What cannot be opened is left to whoever wants it."""
    for dataset in _datasets(file):
        if dataset.chunks and dataset.id.get_storage_size() > 0:
            check_stored(dataset, 0, at_once=math.prod(dataset.shape[1:]))


def _datasets(file: h5py.File) -> Iterator[h5py.Dataset]:
    """All that hard links lead to, each once."""
    seen: set[int] = set()
    groups = [file["/"]]
    while groups:
        for number, found in _members(groups.pop()):
            if number in seen:
                continue
            seen.add(number)
            if isinstance(found, h5py.Dataset):
                yield found
            else:
                groups.append(found)


def _members(group: h5py.Group) -> Iterator[tuple[int, Item]]:
    """Where each is in the file, and itself."""
    names: list[Any] = []
    with contextlib.suppress(Exception):  # damage makes h5py raise whatever it likes
        names = list(group)
    for name in names:
        with contextlib.suppress(Exception):
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                continue
            found = group[name]
            number = h5py.h5o.get_info(found.id).addr
            if isinstance(found, (h5py.Group, h5py.Dataset)):
                yield number, found
