# SPDX-License-Identifier: MIT
"""Writes what was saved of a damaged H5MD file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np

from pliant.trajectory.recover.pieces import Salvage, StoredValues

TRAJECTORY = "particles/trajectory"
POSITION = f"{TRAJECTORY}/position"
CONTACT_STATES = "contact_states"

_ATOMS = (
    *("atom_name", "element", "atomic_number", "atom_serial", "residue_of"),
    *("residue_name", "residue_number", "insertion_code", "chain"),
)
_LIMITS = ("least", "most", "kind", "energy", "group")
_STERICS = ("kind", "least", "own", "own_least", "bonds_apart")
_TORSIONS = ("staggered", "free", "backbone", "reach")

#: Datasets that readers take together.
TOGETHER = (
    tuple(f"parameters/topology/{name}" for name in _ATOMS),
    ("connectivity/bars", "parameters/framework/rest_length"),
    ("connectivity/bonds", "parameters/topology/bond_origin", "parameters/topology/bond_order"),
    ("connectivity/limits", *(f"parameters/limit/{name}" for name in _LIMITS)),
    tuple(f"parameters/sterics/{name}" for name in _STERICS),
    tuple(f"parameters/torsion_preferences/{name}" for name in _TORSIONS),
)


@dataclass
class SavedFrames:
    """Frames that were read: numbers in the broken file, and what they hold."""

    numbers: np.ndarray
    positions: np.ndarray  #: (F, N, 3) as stored
    steps: np.ndarray
    times: np.ndarray | None
    units: dict[str, str]


def _drop_incomplete(static: Salvage) -> None:
    """Columns of a table are of use together only."""
    for names in TOGETHER:
        missing = [name for name in names if name not in static.found]
        for name in names if missing else ():
            if static.found.pop(name, None) is not None:
                static.lost[name] = f"of no use without {missing[0]}"


def write_header(file: h5py.File, creator: dict[str, Any]) -> None:
    """Writes /h5md and the box, with the program that wrote the broken file."""
    file.create_group("h5md").attrs["version"] = np.array([1, 1], dtype=np.int32)
    file.create_group("h5md/author").attrs["name"] = "unknown"
    group = file.create_group("h5md/creator")
    for name, value in {"name": "pliant", "version": "", **creator}.items():
        group.attrs[name] = value
    box = file.create_group(f"{TRAJECTORY}/box")
    box.attrs["dimension"] = 3
    box.attrs["boundary"] = ["none", "none", "none"]


def write_frames(file: h5py.File, frames: SavedFrames) -> None:
    """Writes positions, steps and times."""
    chunk = (1, *frames.positions.shape[1:])
    value = file.create_dataset(
        f"{POSITION}/value", data=frames.positions, chunks=chunk, maxshape=(None, *chunk[1:])
    )
    value.attrs["unit"] = frames.units["value"]
    file[f"{POSITION}/step"] = frames.steps
    if frames.times is not None:
        file[f"{POSITION}/time"] = frames.times
        file[f"{POSITION}/time"].attrs["unit"] = frames.units["time"]


def write_static(file: h5py.File, static: Salvage, count: int) -> list[str]:
    """Writes the datasets that fit `count` joints; the others become lost. Returns their names."""
    saved = []
    for name, stored in list(static.found.items()):
        if why := _misfit(name, stored, count):
            static.lost[name] = why
            del static.found[name]
    _drop_incomplete(static)
    for name, stored in static.found.items():
        put(file, name, stored.values)
        for key, value in stored.attributes.items():
            file[name].attrs[key] = value
        saved.append(name)
    return saved


def _misfit(name: str, stored: StoredValues, count: int) -> str:
    """Why a dataset cannot be what its name says; "" if it can."""
    values = np.asarray(stored.values)
    if name.startswith("connectivity/"):
        fits = values.ndim == 2 and values.shape[1] == 2 and values.dtype.kind in "iu"
        if not fits or (values.size and (values.min() < 0 or values.max() >= count)):
            return "names joints that are not there"
    per_joint = (
        f"{TRAJECTORY}/mass",
        "parameters/topology/atom_name",
        "parameters/framework/pinned",
        "parameters/topology/residue_of",
    )
    if name in per_joint and values.shape != (count,):
        return f"has not one value for each of {count} joints"
    if values.dtype.kind == "f" and not np.isfinite(values).all() and "most" not in name:
        return "has values that are not finite"
    return ""


def series_group(name: str) -> str:
    """The group of a series that goes with the frames."""
    return f"connectivity/{name}" if name == CONTACT_STATES else f"observables/{name}"


def write_observable(file: h5py.File, name: str, stored: StoredValues, frames: SavedFrames) -> None:
    """Writes the values of the saved frames."""
    path = series_group(name)
    put(file, f"{path}/value", np.asarray(stored.values)[frames.numbers])
    for key, value in stored.attributes.items():
        file[f"{path}/value"].attrs[key] = value
    for part in ("step", "time"):
        if f"{POSITION}/{part}" in file:
            file[f"{path}/{part}"] = file[f"{POSITION}/{part}"]


def put(file: h5py.File, path: str, value: Any) -> None:
    """A dataset of the type that h5py read: enumerations and fixed texts stay what they are."""
    dtype = getattr(value, "dtype", None)
    if dtype is not None and dtype.kind == "U":
        dtype = h5py.string_dtype()
    file.create_dataset(path, data=value, dtype=dtype)
