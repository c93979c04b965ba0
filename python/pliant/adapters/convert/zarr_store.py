# SPDX-License-Identifier: MIT
"""Frames as a Zarr store, which xarray opens: positions(frame, atom, xyz), named."""

from __future__ import annotations

import itertools
import os
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant import _core
from pliant.base.extras import late, need
from pliant.base.new_file import cannot_write

if TYPE_CHECKING:
    import xarray

    from pliant.trajectory.frames import Moment
else:
    xarray = late("xarray")

#: Bytes of positions in a chunk, which is read at once; and chunks that are written at once.
_CHUNK_BYTES = 4 << 20
_CHUNKS = 4


def write_zarr(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    """Writes the store as a folder, which takes its name once it is whole; returns the frames."""
    need("writing Zarr", "xarray", extra="zarr")
    rows = max(1, _CHUNK_BYTES // (24 * len(structure)))
    folder, name = os.path.split(os.path.abspath(output))
    if not os.path.isdir(folder):
        raise _core.FileError(f"{output}: the directory {folder} does not exist")
    try:
        with tempfile.TemporaryDirectory(prefix=f".{name}.", dir=folder) as own:
            count = _write(os.path.join(own, name), structure, frames, rows)
            _take_name(Path(own, name), Path(output), overwrite)
    except OSError as error:
        raise cannot_write(output, error) from error
    return count


def _take_name(made: Path, output: Path, overwrite: bool) -> None:
    """An older store goes once the new one is there."""
    old = made.with_name("older")
    if os.path.lexists(output):
        if not overwrite:
            raise _core.FileError(f"{output}: exists; --overwrite replaces it")
        output.rename(old)
    try:
        made.rename(output)
    except OSError:
        if os.path.lexists(old):
            old.rename(output)
        raise


def _write(path: str, structure: _core.Structure, frames: Iterator[Moment], rows: int) -> int:
    count = 0
    while part := list(itertools.islice(frames, rows * _CHUNKS)):
        dataset = _dataset(part, count)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of Zarr, on texts of a fixed length
            if count == 0:
                chunks = {"positions": {"chunks": (rows, len(structure), 3)}}
                dataset = dataset.assign_coords(_atoms(structure))
                dataset.attrs = {"source": structure.source, "creator": "pliant"}
                dataset.to_zarr(path, mode="w", encoding=chunks, consolidated=False)
            else:
                dataset.to_zarr(path, append_dim="frame", consolidated=False)
        count += len(part)
    return count


def _dataset(part: list[Moment], first: int) -> xarray.Dataset:
    walkers = [one.walker for one in part if one.walker is not None]
    coordinates: dict[str, Any] = {
        "frame": np.arange(first, first + len(part)),
        "step": ("frame", [one.step for one in part]),
        "time": ("frame", [one.time for one in part], {"units": "ps"}),
        "xyz": ["x", "y", "z"],
    }
    if walkers:
        coordinates["walker"] = ("frame", walkers)
    if first > 0:
        del coordinates["xyz"]
    values = np.array([one.positions for one in part])
    positions = (("frame", "atom", "xyz"), values, {"units": "Angstrom"})
    return xarray.Dataset({"positions": positions}, coordinates)


def _atoms(structure: _core.Structure) -> dict[str, tuple[str, np.ndarray]]:
    columns = {
        "name": structure.names,
        "element": structure.symbols,
        "residue": np.asarray(structure.residue_ids).astype(np.int64),  # Zarr knows no long long
        "residue_name": structure.residue_names,
        "chain": structure.chains,
    }
    return {name: ("atom", np.asarray(values)) for name, values in columns.items()}
