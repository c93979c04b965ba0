# SPDX-License-Identifier: MIT
"""``pliant convert --recover``: what can be read of a damaged H5MD file, in a new one."""

from __future__ import annotations

import os
import shutil
import tempfile
from dataclasses import dataclass, field
from typing import Any

import h5py
import numpy as np

from pliant._core import FileError, InputError, OptionError, check_hdf5
from pliant.base.checked import checked
from pliant.base.new_file import NewFile, new_file
from pliant.trajectory.recover.pieces import Salvage, StoredValues, dataset, rows, salvage
from pliant.trajectory.recover.reading import check_stored, item, names_in, plain, scalars, text
from pliant.trajectory.recover.recovered_file import (
    CONTACT_STATES,
    POSITION,
    TRAJECTORY,
    SavedFrames,
    put,
    series_group,
    write_frames,
    write_header,
    write_observable,
    write_static,
)
from pliant.trajectory.recover.superblock import mend_superblock

FRAMES_AT_ONCE = 64

#: Datasets that are the same in all frames, by group.
STATIC = {
    TRAJECTORY: ("mass", "species"),
    "connectivity": ("bars", "bonds", "limits"),
    "parameters/framework": ("rest_length", "pinned", "planar"),
    "parameters/limit": ("least", "most", "kind", "energy", "group"),
    "parameters/sterics": ("kind", "least", "own", "own_least", "unit", "bonds", "bonds_apart"),
    "parameters/torsion_preferences": ("staggered", "free", "backbone", "reach"),
    "parameters/topology": (
        *("atom_name", "element", "atomic_number", "atom_serial", "residue_of", "residue_name"),
        *("residue_number", "insertion_code", "chain", "bond_origin", "bond_order"),
    ),
}

#: Observables that are looked for by name where the group cannot be listed.
OBSERVABLES = (
    *("sweeps", "projections", "max_residual", "rms_residual", "converged", "stop", "root_joint"),
    *("force_x", "force_y", "force_z", "max_limit", "max_overlap"),
)


@dataclass
class Recovery:
    """What was saved, and what was lost and why."""

    path: str
    frames: int = 0  #: saved
    frames_stated: int = 0  #: by the file
    observables: list[str] = field(default_factory=list)
    parameters: int = 0
    saved: list[str] = field(default_factory=list)  #: other datasets
    lost: dict[str, str] = field(default_factory=dict)  #: what -> why

    def lines(self) -> list[str]:
        """The same as text."""
        saved = (
            f"{self.path}: {self.frames} of {self.frames_stated} frames, "
            f"{len(self.observables)} observables, {len(self.saved)} tables, "
            f"{self.parameters} options"
        )
        lost = [
            f"lost: {why}" if why.startswith(f"/{what}") else f"lost: {what}: {why}"
            for what, why in self.lost.items()
        ]
        return [saved, *(lost or ["nothing was lost"])]


@checked()
def recover(
    broken: str | os.PathLike[str], good: str | os.PathLike[str], *, overwrite: bool = False
) -> Recovery:
    """Copies what can be read of a damaged H5MD file.

    Raises InputError where no frame can be read, FileError where `good` exists or cannot be
    written, OptionError if both are one file. `good` exists only if frames were saved.
    """
    broken, good = os.fspath(broken), os.fspath(good)
    _refuse(broken, good, overwrite)
    folder = os.path.dirname(os.path.abspath(good))
    with (
        new_file(good, overwrite=overwrite, tells_late=True) as file,
        tempfile.TemporaryDirectory(prefix=f".{os.path.basename(good)}.", dir=folder) as own,
    ):
        copy = os.path.join(own, "broken")
        shutil.copyfile(broken, copy)
        recovery = Recovery(good)
        if mended := mend_superblock(copy):
            recovery.lost["superblock"] = mended
        _rebuild(copy, file, recovery)
        if recovery.frames == 0:
            why = "; ".join(f"{what}: {reason}" for what, reason in recovery.lost.items())
            raise InputError(f"{broken}: no frame can be read{': ' + why if why else ''}")
        check_hdf5(file.path)
    return recovery


def _refuse(broken: str, good: str, overwrite: bool) -> None:
    if not os.path.isfile(broken):
        raise InputError(f"{broken}: no such file")
    if os.path.exists(good):
        if os.path.samefile(broken, good):
            raise OptionError(f"{good}: is both input and output")
        if not overwrite:
            raise FileError(f"{good}: exists; --overwrite replaces it")


def _rebuild(broken: str, good: NewFile, recovery: Recovery) -> None:
    frames = _read_frames(broken, recovery)
    if frames is None:
        return
    tables = [f"{group}/{name}" for group, names in STATIC.items() for name in names]
    static = salvage(broken, [(name, dataset(name)) for name in tables])
    observables = _read_observables(broken, len(frames.steps), recovery)
    parameters = salvage(broken, [("parameters", _parameters)])
    creator = salvage(broken, [("h5md/creator", _creator)])
    with h5py.File(good, "w", libver=("earliest", "v108")) as file:
        write_header(file, creator.found.get("h5md/creator", {}))
        write_frames(file, frames)
        recovery.saved = write_static(file, static, frames.positions.shape[1])
        for name, values in observables.items():
            write_observable(file, name, values, frames)
        for name, value in parameters.found.get("parameters", {}).items():
            if f"parameters/{name}" not in file:
                put(file, f"parameters/{name}", value)
                recovery.parameters += 1
    for part in (static, parameters, creator):
        recovery.lost.update(part.lost)


def _shape(file: h5py.File) -> tuple[tuple[int, ...], dict[str, str]]:
    value = item(file, f"{POSITION}/value")
    if not isinstance(value, h5py.Dataset) or value.dtype.kind != "f" or value.ndim != 3:
        raise ValueError("no positions (F, N, 3)")
    check_stored(value, 3 * value.shape[1])
    return tuple(value.shape), {
        "value": text(value, "unit") or "Angstrom",
        "time": text(item(file, f"{POSITION}/time"), "unit") or "ps",
    }


def _read_frames(path: str, recovery: Recovery) -> SavedFrames | None:
    about = salvage(path, [("shape", _shape)])
    if "shape" not in about.found:
        recovery.lost["positions"] = about.lost.get("shape", "not there")
        return None
    shape, units = about.found["shape"]
    series = salvage(path, [(name, dataset(f"{POSITION}/{name}")) for name in ("step", "time")])
    steps, times = (_column(series, name, recovery) for name in ("step", "time"))
    count = min(len(column) for column in (range(shape[0]), steps, times) if column is not None)
    recovery.frames_stated = shape[0]
    blocks = _read_blocks(path, count, recovery)
    numbers = np.array(sorted(blocks), dtype=np.int64)
    if len(numbers) == 0:
        return None
    recovery.frames = len(numbers)
    return SavedFrames(
        numbers,
        np.array([blocks[number] for number in numbers]),
        numbers if steps is None else steps[numbers],
        None if times is None else times[numbers],
        units,
    )


def _column(series: Salvage, name: str, recovery: Recovery) -> np.ndarray | None:
    """One number a frame; None, and said, if it cannot be used."""
    stored = series.found.get(name)
    values = None if stored is None else np.asarray(stored.values)
    if values is not None and values.ndim == 1 and values.dtype.kind in "iuf":
        return values
    recovery.lost[name] = series.lost.get(name, "not there")
    return None


def _read_blocks(path: str, count: int, recovery: Recovery) -> dict[int, np.ndarray]:
    """Frames by number; those of a block that cannot be read are tried one by one."""
    name = f"{POSITION}/value"
    spans = [
        (first, min(first + FRAMES_AT_ONCE, count)) for first in range(0, count, FRAMES_AT_ONCE)
    ]
    blocks = salvage(path, [(f"{a}", rows(name, a, b)) for a, b in spans])
    frames = {int(a) + k: row for a, block in blocks.found.items() for k, row in enumerate(block)}
    missing = [number for a, b in spans if f"{a}" in blocks.lost for number in range(a, b)]
    single = salvage(path, [(f"{k}", rows(name, k, k + 1)) for k in missing])
    frames.update({int(k): block[0] for k, block in single.found.items()})
    for k, why in single.lost.items():
        recovery.lost[f"frame {k}"] = why
    return frames


def _read_observables(path: str, count: int, recovery: Recovery) -> dict[str, StoredValues]:
    listed = salvage(path, [("observables", _names)])
    names = [*(listed.found.get("observables") or OBSERVABLES), CONTACT_STATES]
    found = salvage(path, [(name, dataset(f"{series_group(name)}/value")) for name in names])
    for name, why in found.lost.items():
        recovery.lost[f"observable {name}"] = why
    for name, stored in found.found.items():
        dimensions = 2 if name == CONTACT_STATES else 1
        if np.ndim(stored.values) == dimensions and len(stored.values) >= count:
            recovery.observables.append(name)
        else:
            recovery.lost[f"observable {name}"] = "has not one value a frame"
    return {name: found.found[name] for name in recovery.observables}


def _names(file: h5py.File) -> list[str]:
    return names_in(item(file, "observables"))


def _parameters(file: h5py.File) -> dict[str, Any]:
    return dict(scalars(item(file, "parameters")))


def _creator(file: h5py.File) -> dict[str, Any]:
    creator = item(file, "h5md/creator")
    schema = None if creator is None else plain(creator.attrs.get("schema"))
    names = {name: text(creator, name) for name in ("name", "version")}
    return names | ({"schema": schema} if isinstance(schema, int) else {})
