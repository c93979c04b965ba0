# SPDX-License-Identifier: MIT
"""Digests of results: equal if and only if all bits are."""

import hashlib
from collections.abc import Callable, Iterator

import numpy as np

Line = tuple[str, str]  # a name, and a digest or what was refused


def digest(thing: object) -> str:
    """SHA-256 of arrays, bytes, lists and dicts of such; of numbers, texts and tuples of these."""
    total = hashlib.sha256()
    for piece in _pieces(thing):
        total.update(piece)
    return total.hexdigest()


def _pieces(thing: object) -> Iterator[bytes]:
    if isinstance(thing, dict):
        yield from _pieces([part for item in thing.items() for part in item])
    elif isinstance(thing, list):
        yield f"{len(thing)} parts;".encode()
        for part in thing:
            yield from _pieces(part)
    elif isinstance(thing, np.ndarray) and thing.dtype.kind not in "OU":
        yield f"{thing.dtype.kind}{thing.shape};".encode()
        yield thing.tobytes()
    elif isinstance(thing, bytes):
        yield f"{len(thing)} bytes;".encode()
        yield thing
    else:  # floats are written so that they are read back as they were
        yield repr(thing.tolist() if isinstance(thing, np.ndarray) else thing).encode()


def lines(name: str, call: Callable[[], dict[str, object]]) -> Iterator[Line]:
    """A line for each part of what a call returns; one with the error if it raises."""
    try:
        parts = call()
    except Exception as error:  # that it is refused, and how, is a result as well
        yield name, f"{type(error).__name__}: {' '.join(str(error).split())}"
        return
    for part, thing in parts.items():
        yield f"{name} {part}", digest(thing)
