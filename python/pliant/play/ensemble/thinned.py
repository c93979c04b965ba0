# SPDX-License-Identifier: MIT
"""An H5MD file of some of the frames of another, with all that it says of the molecule."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np

from pliant.base.new_file import new_file

LEFT_OUT = ("parameters/checkpoint", "parameters/sterics")  #: which the page has no use for


def write_thinned(
    source: Path, output: Path, chosen: np.ndarray, positions: Callable[[int], np.ndarray]
) -> None:
    """Writes the frames numbered `chosen`: what has a value a frame keeps those of these alone.

    positions: gives (N, 3) of a frame, Angstrom. `source` may be one of several files that share
    the frames; then observables, which would be of this one alone, are left out.
    """
    with (
        h5py.File(source) as old,
        new_file(output, tells_late=True) as file,
        h5py.File(file, "w") as new,
    ):
        groups = old["particles"]
        name = next(one for one in groups if "position" in groups[one])
        place = f"particles/{name}/position"
        frames = len(old[f"{place}/value"])
        _copy(old, new, place, frames, chosen if chosen.max() < frames else None)
        _write_positions(new, place, chosen, positions)


def _copy(
    old: h5py.File, new: h5py.File, place: str, frames: int, chosen: np.ndarray | None
) -> None:
    def visit(name: str, item: h5py.Group | h5py.Dataset) -> None:
        if not isinstance(item, h5py.Dataset) or name.startswith((place, *LEFT_OUT)):
            return
        is_row_a_frame = name.startswith(("observables/", "connectivity/contact_states/"))
        if not is_row_a_frame:
            old.copy(item, new.require_group(name.rpartition("/")[0]), name.rpartition("/")[2])
        elif chosen is not None and item.shape and item.shape[0] == frames:
            new.create_dataset(name, data=item[chosen], dtype=item.dtype)

    old.visititems(visit)


def _write_positions(
    new: h5py.File, place: str, chosen: np.ndarray, positions: Callable[[int], np.ndarray]
) -> None:
    first = positions(int(chosen[0]))
    value = new.create_dataset(
        f"{place}/value", (len(chosen), *first.shape), "<f8", chunks=(1, *first.shape)
    )
    value.attrs["unit"] = "Angstrom"
    for k, frame in enumerate(chosen):
        value[k] = positions(int(frame))
    new[f"{place}/step"] = np.asarray(chosen, dtype=np.int64)
