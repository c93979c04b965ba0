# SPDX-License-Identifier: MIT
"""Reading a damaged HDF5 file with h5py: what it has within itself, and no more than it holds.

Objects are opened one link at a time, so that links in circles and links to other files are seen
before they are followed. Memory is taken for what a file holds, never for what it says to hold.
Raises InputError, and whatever h5py meets.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, TypeAlias

import h5py
import numpy as np

from pliant._core import InputError, expansion_refusal

#: Soft links that are followed on one path.
MOST_LINKS = 16
#: Levels of groups that are looked into.
MOST_LEVELS = 8
#: Chunks are counted, one by one, where one has more bytes than these.
SMALL_CHUNK = 1 << 24
#: Values of variable length that are read at once.
TEXTS_AT_ONCE = 64
#: What is more than this is as much too much.
MOST_BYTES = (1 << 64) - 1

Item: TypeAlias = "h5py.Group | h5py.Dataset"


def item(group: h5py.Group, path: str) -> Item | None:
    """The group or dataset at a path; None if there is none, or it is something else."""
    return _follow(group, path, [MOST_LINKS])


def _follow(group: h5py.Group, path: str, left: list[int]) -> Item | None:
    here: Item | None = group.file["/"] if path.startswith("/") else group
    for name in path.split("/"):
        if name in ("", "."):
            continue
        if not isinstance(here, h5py.Group):
            return None
        here = _step(here, name, left)
    return here


def _step(group: h5py.Group, name: str, left: list[int]) -> Item | None:
    """One link on: `left` counts the soft links that may still be followed."""
    where = f"{(group.name or '').rstrip('/')}/{name}"
    link = group.get(name, getlink=True) if name in group else None
    if link is None:
        return None
    if isinstance(link, h5py.ExternalLink):
        raise InputError(f"{where}: leads to another file, which is not read")
    if isinstance(link, h5py.SoftLink):
        left[0] -= 1
        if left[0] < 0:
            raise InputError(f"{where}: is a link that leads in a circle")
        return _follow(group, link.path, left)
    found = group[name]
    if isinstance(found, h5py.Dataset) and (found.external or found.is_virtual):
        raise InputError(f"{where}: has its values in other files, which are not read")
    return found if isinstance(found, (h5py.Group, h5py.Dataset)) else None


def read(dataset: h5py.Dataset, rows: slice | None = None) -> Any:
    """The values of a dataset, or of some of its rows. Raises InputError before any memory is asked
    for if the file has not stored so many."""
    count = math.prod(dataset.shape or (1,))
    if rows is not None and dataset.shape[0]:
        count = count // dataset.shape[0] * len(range(*rows.indices(dataset.shape[0])))
    check_stored(dataset, count)
    if dataset.dtype.kind == "O" and dataset.ndim == 1:
        return _texts_of(dataset)
    return dataset[() if rows is None else rows]


def check_stored(dataset: h5py.Dataset, values: int) -> None:
    """Raises InputError if the file cannot hold so many values of a dataset, or if these or its
    chunks are out of proportion to it."""
    size = dataset.dtype.itemsize
    chunk = math.prod(dataset.chunks) * size if dataset.chunks else 0
    why = expansion_refusal(
        values=min(values * size, MOST_BYTES),
        at_once=min(values * size, MOST_BYTES),
        chunk=min(chunk, MOST_BYTES),
        stored=dataset.id.get_storage_size(),
        chunks=dataset.id.get_num_chunks() if chunk > SMALL_CHUNK else 1,
        file_size=dataset.file.id.get_filesize(),
    )
    if why:
        raise InputError(f"{dataset.name}: of shape {dataset.shape} {why}")


def _texts_of(dataset: h5py.Dataset) -> np.ndarray:
    """All values of variable length (n,), some at a time: many may be one place in the file."""
    found = np.empty(dataset.shape, dtype=dataset.dtype)
    size, file_size = 0, dataset.file.id.get_filesize()
    for first in range(0, len(found), TEXTS_AT_ONCE):
        part = slice(first, first + TEXTS_AT_ONCE)
        found[part] = dataset[part]
        size += sum(len(value) for value in found[part])
        why = expansion_refusal(
            values=size, at_once=size, chunk=0, stored=file_size, chunks=1, file_size=file_size
        )
        if why:
            raise InputError(f"{dataset.name}: {why}")
    return found


def scalars(
    group: Item | None, levels: int = MOST_LEVELS, above: frozenset[int] = frozenset()
) -> Iterator[tuple[str, Any]]:
    """Path and value (bool, int, float or str) of each scalar below a group.

    Groups that contain themselves, and those deeper than `levels`, are left out.
    """
    if not isinstance(group, h5py.Group) or levels == 0:
        return
    number = h5py.h5o.get_info(group.id).addr
    if number in above:
        return
    for name in names_in(group):
        found = item(group, name)
        if isinstance(found, h5py.Group):
            for path, value in scalars(found, levels - 1, above | {number}):
                yield f"{name}/{path}", value
        elif isinstance(found, h5py.Dataset) and found.shape == ():
            value = plain(read(found))
            if value is not None:
                yield name, value


def names_in(group: Item | None) -> list[str]:
    """The names in a group that are text."""
    names = list(group) if isinstance(group, h5py.Group) else []
    return [name for name in names if isinstance(name, str)]


def plain(value: Any) -> bool | int | float | str | None:
    """A scalar as Python has it; None if it is no truth value, number or text."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, np.generic):
        value = value.item()
    return value if isinstance(value, (bool, int, float, str)) else None


def text(found: Item | None, name: str) -> str:
    """A text attribute; "" if there is none."""
    value = None if found is None else plain(found.attrs.get(name))
    return value if isinstance(value, str) else ""
