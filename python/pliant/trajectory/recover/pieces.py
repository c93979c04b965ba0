# SPDX-License-Identifier: MIT
"""What can be read of a damaged HDF5 file, piece by piece, in processes that may crash.

A process reads one piece after the other and sends each as soon as it has it. Where it dies, the
piece that it was at is lost, and another process goes on with the next.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NoReturn

import h5py
import numpy as np

with contextlib.suppress(ModuleNotFoundError):  # of Windows, which cannot fork either
    import resource

from pliant.trajectory.recover.reading import item, text
from pliant.trajectory.recover.reading import read as read_values

#: Seconds of the processor for one piece.
MOST_SECONDS = 20
#: Bytes of memory of a process that reads.
MOST_BYTES = 4 << 30

#: Reads one piece of an open file; raises what it likes.
Piece = Callable[[h5py.File], Any]


@dataclass
class Salvage:
    """Pieces by name, and why others are lost."""

    found: dict[str, Any] = field(default_factory=dict)
    lost: dict[str, str] = field(default_factory=dict)


@dataclass
class StoredValues:
    """A dataset as it is written anew: its values and attributes."""

    values: Any
    attributes: dict[str, Any]


def salvage(path: str, pieces: Iterable[tuple[str, Piece]]) -> Salvage:
    """Reads the pieces of a file, each in its turn. Pieces that give None are not there."""
    result = Salvage()
    left = list(pieces)
    if not hasattr(os, "fork"):  # Windows: where HDF5 crashes, this process ends
        for name, piece in left:
            _keep(result, _message(path, name, piece))
        return result
    while left:
        done = _read_in_process(path, left, result)
        if done < len(left) and left[done][0] not in result.lost:
            result.lost[left[done][0]] = "HDF5 crashes when it reads it"
        left = left[done + 1 :]
    return result


def _read_in_process(path: str, pieces: Sequence[tuple[str, Piece]], result: Salvage) -> int:
    """How many pieces were read, or refused, before the process ended."""
    ours, theirs = os.pipe()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # threads: the child calls HDF5 only
        child = os.fork()
    if child == 0:
        os.close(ours)
        _send(path, pieces, theirs)
    os.close(theirs)
    done = 0
    with os.fdopen(ours, "rb") as pipe:
        for message in _messages(pipe):
            done += 1
            _keep(result, message)
    os.waitpid(child, 0)
    return done


def _keep(result: Salvage, message: tuple[str, bool, Any]) -> None:
    name, is_found, value = message
    if not is_found:
        result.lost[name] = value
    elif value is not None:
        result.found[name] = value


def _messages(pipe: Any) -> Iterator[tuple[str, bool, Any]]:
    with contextlib.suppress(EOFError, pickle.UnpicklingError):
        while True:
            yield pickle.load(pipe)


def _send(path: str, pieces: Sequence[tuple[str, Piece]], pipe: int) -> NoReturn:
    try:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
        for number in (signal.SIGSEGV, signal.SIGABRT, signal.SIGPROF, signal.SIGBUS):
            signal.signal(number, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)  # what a crash prints
        with os.fdopen(pipe, "wb") as out:
            for name, piece in pieces:
                signal.setitimer(signal.ITIMER_PROF, MOST_SECONDS)
                pickle.dump(_message(path, name, piece), out)
                out.flush()
    finally:
        os._exit(0)


def _message(path: str, name: str, piece: Piece) -> tuple[str, bool, Any]:
    try:
        with h5py.File(path, "r") as file:
            return name, True, piece(file)
    except Exception as error:  # whatever HDF5 and h5py meet
        reason = " ".join(str(error).split()).removeprefix(f"{path}: ")
        return name, False, reason or type(error).__name__


def dataset(path: str) -> Piece:
    """A piece: the values of a dataset, and its attributes that are text or numbers."""

    def read(file: h5py.File) -> StoredValues | None:
        found = item(file, path)
        if not isinstance(found, h5py.Dataset):
            return None
        unit = text(found, "unit")
        return StoredValues(read_values(found), {"unit": unit} if unit else {})

    return read


def rows(path: str, first: int, last: int) -> Piece:
    """A piece: some rows of a dataset, all of which are stored and finite."""

    def read(file: h5py.File) -> np.ndarray:
        found = item(file, path)
        if not isinstance(found, h5py.Dataset):
            raise ValueError("is not there")
        values: np.ndarray = read_values(found, slice(first, last))
        if len(values) != last - first or not np.isfinite(values).all():
            raise ValueError("has coordinates that are not finite")
        return values

    return read
