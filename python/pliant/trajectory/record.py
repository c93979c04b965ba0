# SPDX-License-Identifier: MIT
"""What an H5MD file of Pliant holds beyond positions: bars, rest lengths, observables, options."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any

import h5py
import numpy as np

from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.recorded_contacts import RecordedContacts, contacts_of

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
    contacts: RecordedContacts | None = None  #: which a model held, and in which frames
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

    What is there but has not the shape it should have is left out. Raises FileError when the file
    cannot be read, and InputError where it is damaged, links lead to other files or in a circle,
    the file does not hold what it says, or a tolerance is no number above 0.
    """
    name = os.fsdecode(path)
    if not h5py.is_hdf5(name):
        return None
    return _hdf5.while_written(name, lambda: _read_record(name))


def _read_record(path: str) -> RunRecord | None:
    with _hdf5.open_file(path) as file:
        group = _hdf5.first_in(file, "particles")
        if group is None:
            return None
        record = RunRecord(path)
        creator = _hdf5.item(file, "h5md/creator")
        record.creator, record.version = (_hdf5.text(creator, k) for k in ("name", "version"))
        _read_bars(file, record)
        record.contacts = contacts_of(file)
        record.complete_frames = _complete_frames(group)
        record.observables = _read_observables(file)
        record.parameters = dict(_hdf5.scalars(_hdf5.item(file, "parameters")))
    _check_tolerances(record)
    return record


def _check_tolerances(record: RunRecord) -> None:
    for name, least in (("run/tolerance", math.ulp(0.0)), ("run/tolerance_length", 0.0)):
        if name in record.parameters:
            _hdf5.positive(record.path, f"parameters/{name}", record.parameters[name], least)


def _read_bars(file: h5py.File, record: RunRecord) -> None:
    bars = _hdf5.item(file, "connectivity/bars")
    lengths = _hdf5.item(file, "parameters/framework/rest_length")
    if not _hdf5.is_array(bars, "iu", (None, 2)):
        return
    if not _hdf5.is_array(lengths, "fiu", bars.shape[:1]):
        return
    record.bars = _hdf5.read(bars).astype(np.int64)
    record.rest_lengths = _hdf5.read(lengths).astype(np.float64)


def _complete_frames(group: h5py.Group) -> int:
    parts = [_hdf5.item(group, f"position/{name}") for name in ("value", "step", "time")]
    return min((len(part) for part in parts if _hdf5.has_rows(part)), default=0)


def _read_observables(file: h5py.File) -> dict[str, np.ndarray]:
    observables = _hdf5.item(file, "observables")
    found = {}
    for name in _hdf5.names_in(observables) if isinstance(observables, h5py.Group) else []:
        value = _hdf5.item(file, f"observables/{name}/value")
        if _hdf5.is_array(value, "biuf", (None,)):
            found[name] = _hdf5.read(value)
    return found
