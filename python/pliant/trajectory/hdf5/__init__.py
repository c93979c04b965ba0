# SPDX-License-Identifier: MIT
"""HDF5 files that may be damaged or made to do harm: what is read from them, and what is refused.

The structure of a file is looked at before HDF5 does, which a wrong byte can crash. Objects are
opened one link at a time, so that links in circles and links to other files are seen before they
are followed. Memory is taken for what a file holds, never for what it says to hold.
"""

from __future__ import annotations

import errno
import math
import os
import re
import time
from collections.abc import Callable, Iterator
from typing import Any, TypeGuard, TypeVar

import h5py
import numpy as np

from pliant._core import FileError, InputError, check_hdf5_structure, writer_of
from pliant.trajectory.hdf5.expansion import (
    Item,
    check_chunks,
    check_stored,
    guarded,
    one_line,
    refused,
    texts_of,
)
from pliant.trajectory.hdf5.probe import probe

#: Soft links that are followed on one path.
MOST_LINKS = 16
#: Levels of groups that are looked into.
MOST_LEVELS = 8

#: Seconds for which a file that is being written is tried again.
PATIENCE = 2.0
PAUSE = 0.02

_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP}

Result = TypeVar("Result")

#: Files whose structure was found good, as they were then: path -> device, number, size, time.
_good: dict[str, tuple[int, ...]] = {}


def open_file(path: str | os.PathLike[str]) -> h5py.File:
    """An HDF5 file that is open for reading, once its structure was looked at.

    Raises InputError where it is damaged, FileError or OSError where it cannot be read.
    """
    name = os.fspath(path)
    status = os.stat(name)
    state = (status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns)
    if _good.get(name) != state and not _is_open_here(name):
        if not check_hdf5_structure(name):
            probe(name)
        with _opened_file(name) as file:
            check_chunks(file)
        _good[name] = state
    return _opened_file(name)


def _opened_file(name: str) -> h5py.File:
    try:
        return h5py.File(name, "r")
    except OSError as error:
        if _is_without_locks(error):  # Pliant's own files need none, also while they are written
            return h5py.File(name, "r", locking=False)
        raise FileError(f"{name}: cannot be opened: {one_line(error)}") from error


def _is_without_locks(error: OSError) -> bool:
    found = re.search(r"unable to lock file, errno = (\d+)", str(error))
    return found is not None and int(found[1]) in _NO_LOCKS


def _is_open_here(name: str) -> bool:
    """Whether this process writes the file with h5py: HDF5 then reads what it holds in memory."""
    files = h5py.h5f.get_obj_ids(h5py.h5f.OBJ_ALL, h5py.h5f.OBJ_FILE)
    return any(_is_written(file, name) for file in files)


def _is_written(file: h5py.h5f.FileID, name: str) -> bool:
    try:
        if file.get_intent() == h5py.h5f.ACC_RDONLY:
            return False
        return os.path.exists(file.name) and os.path.samefile(file.name, name)
    except ValueError:  # closed since it was listed, by another thread or the garbage collector
        return False


def while_written(path: str | os.PathLike[str], read: Callable[[], Result]) -> Result:
    """What `read` returns, which is called again for two seconds while somebody writes the file.

    A failure may come from a commit that is half done. Raises what `read` raises, or FileError
    "is being written by ...".
    """
    deadline = time.monotonic() + PATIENCE
    is_last = False
    while True:
        try:
            return read()
        except (InputError, FileError, OSError) as error:
            writer = writer_of(os.fsdecode(path))
            if is_last or not (writer or _is_new(path)):
                raise
            if not writer:
                is_last = True  # it may have ended just now: once more
            elif time.monotonic() > deadline:
                name = os.fsdecode(path)
                raise FileError(f"{name}: is being written by {writer} ({error})") from error
        time.sleep(PAUSE)


def _is_new(path: str | os.PathLike[str]) -> bool:
    try:
        return time.time() - os.stat(path).st_mtime < PATIENCE
    except OSError:
        return False


def item(group: h5py.Group, path: str) -> Item | None:
    """The group or dataset at a path; None if there is none, or it is something else.

    Raises InputError where a link leads to another file or in a circle, or HDF5 cannot read it.
    """
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
    link = guarded(group, name, lambda: group.get(name, getlink=True))
    if link is None:
        return None
    if isinstance(link, h5py.ExternalLink):
        raise refused(group, name, "leads to another file, which is not read")
    if isinstance(link, h5py.SoftLink):
        left[0] -= 1
        if left[0] < 0:
            raise refused(group, name, "is a link that leads in a circle")
        return _follow(group, link.path, left)
    found = guarded(group, name, lambda: _opened(group, name))
    if isinstance(found, h5py.Dataset) and guarded(group, name, lambda: _is_elsewhere(found)):
        raise refused(group, name, "has its values in other files, which are not read")
    return found if isinstance(found, (h5py.Group, h5py.Dataset)) else None


def _opened(group: h5py.Group, name: str) -> Any:
    """What a link leads to. h5py's KeyError says that it is damaged: the link is there."""
    try:
        return group[name]
    except KeyError as error:
        raise OSError(error.args[0]) from error


def _is_elsewhere(found: h5py.Dataset) -> bool:
    """Whether values are in other files; asks for all that damage may make h5py fail to tell."""
    _ = found.dtype, found.shape, found.chunks, found.name
    return bool(found.external or found.is_virtual)


def read(dataset: h5py.Dataset, selection: Any = ()) -> Any:
    """The values of a dataset, or those of a selection, as h5py gives them.

    Raises InputError before any memory is asked for if the file has not stored so many, and when
    HDF5 cannot read them.
    """
    name = (dataset.name or "").rpartition("/")[2]
    check_stored(dataset, _selected(dataset, selection))
    if dataset.dtype.kind == "O" and dataset.ndim == 1 and isinstance(selection, tuple):
        return texts_of(dataset)
    return guarded(dataset.parent, name, lambda: dataset[selection])


def _selected(dataset: h5py.Dataset, selection: Any) -> int:
    """How many values a selection along the first extent has."""
    if not dataset.shape:
        return 1
    rows = int(dataset.shape[0])
    row = math.prod(int(extent) for extent in dataset.shape[1:])
    if isinstance(selection, slice):
        rows = len(range(*selection.indices(rows)))
    elif isinstance(selection, (int, np.integer)):
        rows = 1
    elif isinstance(selection, np.ndarray):
        rows = len(selection)
    return rows * row


def is_array(found: Item | None, kinds: str, shape: tuple[int | None, ...]) -> TypeGuard[Any]:
    """Whether this is a dataset of these kinds of numbers and this shape (None: any extent)."""
    if not isinstance(found, h5py.Dataset) or found.shape is None:  # None: h5py.Empty
        return False
    fits = len(found.shape) == len(shape) and all(
        want in (None, have) for want, have in zip(shape, found.shape, strict=True)
    )
    return fits and found.dtype.kind in kinds


def has_rows(found: Item | None) -> TypeGuard[Any]:
    """Whether this is a dataset with at least one extent."""
    return isinstance(found, h5py.Dataset) and bool(found.shape)


def first_in(file: h5py.File, path: str) -> h5py.Group | None:
    """The first group in a group, which is the one that MDAnalysis reads; None if there is none."""
    group = item(file, path)
    for name in names_in(group) if isinstance(group, h5py.Group) else []:
        found = item(group, name)
        return found if isinstance(found, h5py.Group) else None
    return None


def scalars(group: Item | None, levels: int = MOST_LEVELS) -> Iterator[tuple[str, Any]]:
    """Path and value (bool, int, float or str) of each scalar below a group.

    Groups that contain themselves, and those deeper than `levels`, are left out.
    """
    yield from _scalars(group, "", levels, set())


def _scalars(
    group: Item | None, prefix: str, levels: int, above: set[int]
) -> Iterator[tuple[str, Any]]:
    if not isinstance(group, h5py.Group) or levels == 0:
        return
    number = guarded(group, "", lambda: h5py.h5o.get_info(group.id).addr)
    if number in above:
        return
    for name in names_in(group):
        found = item(group, name)
        if isinstance(found, h5py.Group):
            yield from _scalars(found, f"{prefix}{name}/", levels - 1, above | {number})
        elif isinstance(found, h5py.Dataset) and found.shape == ():
            value = plain(read(found))
            if value is not None:
                yield prefix + name, value


def names_in(group: h5py.Group) -> list[str]:
    """The names in a group that are text."""
    names = guarded(group, "", lambda: list(group))
    return [name for name in names or [] if isinstance(name, str)]


def plain(value: Any) -> bool | int | float | str | None:
    """A scalar as Python has it; None if it is no truth value, number or text."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, np.generic):
        value = value.item()
    return value if isinstance(value, (bool, int, float, str)) else None


def attribute(found: Item, name: str) -> Any:
    """An attribute; None if there is none."""
    return guarded(found, f"attribute {name}", lambda: found.attrs.get(name))


def text(found: Item | None, name: str) -> str:
    """A text attribute; "" if there is none."""
    value = None if found is None else plain(attribute(found, name))
    return value if isinstance(value, str) else ""


def positive(path: str, name: str, value: Any, least: float = math.ulp(0.0)) -> float:
    """A finite number from `least`, of an option in a file. Raises InputError for anything else."""
    if isinstance(value, (int, float)) and math.isfinite(value) and value >= least:
        return float(value)
    wanted = "a number above 0" if least > 0 else "a number from 0"
    raise InputError(f"{path}: /{name}: expected {wanted}, found {value}")


def rounded_to(positions: h5py.Dataset) -> float:
    """What the coordinates of a dataset are multiples of, in its unit; 0 where it says nothing."""
    value = attribute(positions, "rounded_to")
    return float(value) if isinstance(value, (int, float)) and 0 < value < 1 else 0.0


def joints_of_whole(particles: h5py.Group) -> int | None:
    """How many atoms the molecule has, of which these particles are some; None: they are all."""
    found = item(particles, "id")
    count = None if found is None else plain(attribute(found, "joints_of_whole"))
    return count if isinstance(count, int) and count > 0 else None
