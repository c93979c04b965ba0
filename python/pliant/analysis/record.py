# SPDX-License-Identifier: MIT
"""What an H5MD file of Pliant holds beyond positions: bars, rest lengths, observables, options."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import h5py
import numpy as np

#: used where a file has bars but does not say how exact they were to be
DEFAULT_TOLERANCE = 1e-6


@dataclass
class RunRecord:
    """A run as its file tells it. Fields that the file lacks are None or empty."""

    path: str
    creator: str = ""
    version: str = ""
    bars: np.ndarray | None = None  #: (B, 2) joints of each bar, from 0
    rest_lengths: np.ndarray | None = None  #: (B,) Angstrom
    observables: dict[str, np.ndarray] = field(
        default_factory=dict
    )  #: name -> (F,) one number a frame
    parameters: dict[str, Any] = field(default_factory=dict)  #: "run/technique" -> its value
    complete_frames: int = 0  #: frames of which position, step and time are all there

    @property
    def tolerance(self) -> float:
        """Largest |length - rest| / rest of a whole bar (dimensionless)."""
        return float(self.parameters.get("run/tolerance", DEFAULT_TOLERANCE))

    @property
    def tolerance_length(self) -> float:
        """Largest |length - rest| (Angstrom), which then holds in place of `tolerance`; or 0."""
        return float(self.parameters.get("run/tolerance_length", 0.0))

    @property
    def converged(self) -> np.ndarray | None:
        """(F,) whether the run called a frame converged; None if the file does not say."""
        flags = self.observables.get("converged")
        return None if flags is None else flags.astype(bool)


def read_record(path: str | bytes | os.PathLike[str]) -> RunRecord | None:
    """Reads the RunRecord of an H5MD file; None if the file is not HDF5 with /particles.

    What is there but has not the shape it should have is left out. Raises OSError when the file
    cannot be read.
    """
    path = os.fsdecode(path)
    if not h5py.is_hdf5(path):
        return None
    with h5py.File(path, "r") as file:
        if not isinstance(file.get("particles"), h5py.Group) or not len(file["particles"]):
            return None
        record = RunRecord(path)
        _read_creator(file, record)
        _read_bars(file, record)
        record.complete_frames = _complete_frames(file)
        record.observables = _read_observables(file)
        if isinstance(file.get("parameters"), h5py.Group):
            _read_parameters(file["parameters"], "", record.parameters)
    return record


def _read_creator(file: h5py.File, record: RunRecord) -> None:
    creator = file.get("h5md/creator")
    if creator is not None:
        record.creator = _text(creator.attrs.get("name", ""))
        record.version = _text(creator.attrs.get("version", ""))


def _text(value: object) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _read_bars(file: h5py.File, record: RunRecord) -> None:
    bars = file.get("connectivity/bars")
    lengths = file.get("parameters/framework/rest_length")
    if not isinstance(bars, h5py.Dataset) or not isinstance(lengths, h5py.Dataset):
        return
    if bars.ndim != 2 or bars.shape[1] != 2 or lengths.shape != bars.shape[:1]:
        return
    record.bars = bars[()].astype(np.int64)
    record.rest_lengths = lengths[()].astype(np.float64)


def _complete_frames(file: h5py.File) -> int:
    position = file["particles"][next(iter(file["particles"]))].get("position")
    if not isinstance(position, h5py.Group):
        return 0
    parts = (position.get(name) for name in ("value", "step", "time"))
    return min(
        (len(part) for part in parts if isinstance(part, h5py.Dataset) and part.ndim), default=0
    )


def _read_observables(file: h5py.File) -> dict[str, np.ndarray]:
    observables = file.get("observables")
    if not isinstance(observables, h5py.Group):
        return {}
    found = {}
    for name, element in observables.items():
        value = element.get("value") if isinstance(element, h5py.Group) else None
        if isinstance(value, h5py.Dataset) and value.ndim == 1 and value.dtype.kind in "biuf":
            found[name] = value[()]
    return found


def _read_parameters(group: h5py.Group, prefix: str, found: dict[str, Any]) -> None:
    """Collects the scalars below a group; the atom table and other arrays are not options."""
    for name, item in group.items():
        if isinstance(item, h5py.Group):
            _read_parameters(item, f"{prefix}{name}/", found)
        elif item.shape == ():
            value = item[()]
            found[prefix + name] = _text(value) if isinstance(value, bytes) else value.item()
