# SPDX-License-Identifier: MIT
"""Reads an HDF5 file in a process of its own first, which may crash in our place.

Our own check knows the formats of HDF5 1.0 to 1.8. What it left out, such as groups with many links
in a file of HDF5 1.10, is read here by the HDF5 of h5py.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import warnings
from typing import NoReturn

import h5py

from pliant._core import InputError

#: Seconds of the processor after which a file is given up.
MOST_SECONDS = 5
MOST_LEVELS = 50
_START = 60  # seconds in which a process has begun: it imports h5py


def probe(path: str) -> None:
    """Raises InputError if HDF5 crashes when it looks at all objects of a file, or does not end."""
    if not hasattr(os, "fork"):
        probe_anew(path)
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # threads: the child calls HDF5 only
        child = os.fork()
    if child == 0:
        _look_in_child(path)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        raise InputError(f"{path}: is damaged: HDF5 crashes when it reads it (signal {number})")


def probe_anew(path: str) -> None:
    """The same where no process can fork, as on Windows: in one that begins anew."""
    look = f"import sys; from {__name__} import look_at_all; look_at_all(sys.argv[1])"
    command = [sys.executable, "-c", look, path]
    try:
        code = subprocess.run(command, check=False, timeout=_START + MOST_SECONDS).returncode
    except subprocess.TimeoutExpired:
        raise InputError(f"{path}: is damaged: HDF5 does not come to an end with it") from None
    if code != 0:
        raise InputError(f"{path}: is damaged: HDF5 crashes when it reads it (exit code {code})")


def _look_in_child(path: str) -> NoReturn:
    import resource

    try:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))
        signal.signal(signal.SIGSEGV, signal.SIG_DFL)
        look_at_all(path)
    finally:
        os._exit(0)


def look_at_all(path: str) -> None:
    """Whatever is said of the file, unless this crashes."""
    with contextlib.suppress(Exception), h5py.File(path, "r") as file:
        _look_at(file)
        _look_at_members(file, 0)


def _look_at_members(group: h5py.Group, depth: int) -> None:
    """Goes on behind what cannot be opened, as readers do, and looks up by name, as they do."""
    names: list[str] = []
    with contextlib.suppress(Exception):
        group.id.links.iterate(lambda name: names.append(name.decode(errors="surrogateescape")))
    for name in names:
        with contextlib.suppress(Exception):
            if isinstance(group.get(name, getlink=True), h5py.ExternalLink):
                continue
            found = group[name]
            _look_at(found)
            if isinstance(found, h5py.Group) and depth < MOST_LEVELS:
                _look_at_members(found, depth + 1)


def _look_at(found: object) -> None:
    with contextlib.suppress(Exception):
        if isinstance(found, h5py.Dataset):
            _ = (found.shape, found.dtype, found.chunks, found.id.get_storage_size())
    with contextlib.suppress(Exception):
        if isinstance(found, (h5py.Group, h5py.Dataset)):
            _ = [found.attrs.get(name) for name in found.attrs]
