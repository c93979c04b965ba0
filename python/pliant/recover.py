# SPDX-License-Identifier: MIT
"""``pliant recover``: what can be read of a damaged H5MD file, in a file that is whole again."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import h5py
import numpy as np

from pliant import _hdf5, console
from pliant._core import FileError, InputError, OptionError, check_hdf5_structure
from pliant._salvage import Salvage, StoredValues, dataset, rows, salvage
from pliant._superblock import mend_superblock

TRAJECTORY = "particles/trajectory"
POSITION = f"{TRAJECTORY}/position"
FRAMES_AT_ONCE = 64

#: Datasets that are the same in all frames: name -> how many axes.
STATIC = {
    f"{TRAJECTORY}/mass": 1,
    f"{TRAJECTORY}/species": 1,
    "connectivity/bars": 2,
    "connectivity/bonds": 2,
    "connectivity/limits": 2,
    **{
        f"parameters/{name}": None
        for name in (
            "framework/rest_length framework/pinned framework/planar limit/least limit/most "
            "limit/kind limit/energy limit/group sterics/kind sterics/least sterics/own "
            "sterics/own_least sterics/unit sterics/bonds sterics/bonds_apart "
            "topology/atom_name topology/element topology/atomic_number topology/atom_serial "
            "topology/residue_of topology/residue_name topology/residue_number "
            "topology/insertion_code topology/chain topology/bond_origin topology/bond_order"
        ).split()
    },
}

#: Observables that are looked for by name where the group cannot be listed.
OBSERVABLES = (
    "sweeps projections max_residual rms_residual converged stop root_joint force_x force_y force_z "
    "max_limit max_overlap"
).split()

EPILOG = """\
Every frame that can be read is kept, wherever it is, with its step and time, and so are the
observables, names, bonds, bars and options that can be read. Coordinates have no checksums: a wrong
digit cannot be told from a right one. BROKEN is not changed.

exit codes: 0 frames were saved, 1 none, 2 bad option

examples:
  pliant recover broken.h5md -o good.h5md
"""


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


def recover(
    broken: str | os.PathLike[str], good: str | os.PathLike[str], *, overwrite: bool = False
) -> Recovery:
    """Copies what can be read of a damaged H5MD file.

    Raises InputError where no frame can be read, FileError where `good` exists or cannot be written;
    OptionError if both are one file. `good` exists only if frames were saved.
    """
    broken, good = os.fspath(broken), os.fspath(good)
    _refuse(broken, good, overwrite)
    folder = os.path.dirname(os.path.abspath(good))
    if not os.path.isdir(folder):
        raise FileError(f"{good}: the directory {folder} does not exist")
    with tempfile.TemporaryDirectory(prefix=f".{os.path.basename(good)}.", dir=folder) as own:
        copy = os.path.join(own, "broken")
        shutil.copyfile(broken, copy)
        recovery = Recovery(good)
        if mended := mend_superblock(copy):
            recovery.lost["superblock"] = mended
        whole = os.path.join(own, "good")
        _rebuild(copy, whole, recovery)
        if recovery.frames == 0:
            why = "; ".join(f"{what}: {reason}" for what, reason in recovery.lost.items())
            raise InputError(f"{broken}: no frame can be read{': ' + why if why else ''}")
        check_hdf5_structure(whole)
        os.replace(whole, good)
    return recovery


def _refuse(broken: str, good: str, overwrite: bool) -> None:
    if not os.path.isfile(broken):
        raise InputError(f"{broken}: no such file")
    if os.path.exists(good):
        if os.path.samefile(broken, good):
            raise OptionError(f"{good}: is both input and output")
        if not overwrite:
            raise FileError(f"{good}: exists; --overwrite replaces it")


def _rebuild(broken: str, good: str, recovery: Recovery) -> None:
    frames = _read_frames(broken, recovery)
    if frames is None:
        return
    static = salvage(broken, [(name, dataset(name)) for name in STATIC])
    observables = _read_observables(broken, len(frames.steps), recovery)
    parameters = salvage(broken, [("parameters", _parameters)])
    creator = salvage(broken, [("h5md/creator", _creator)])
    for part in (static, parameters, creator):
        recovery.lost.update(part.lost)
    with h5py.File(good, "w", libver=("earliest", "v108")) as file:
        _write_header(file, creator.found.get("h5md/creator", {}))
        _write_frames(file, frames)
        _write_static(file, static, recovery, frames.positions.shape[1])
        for name, values in observables.items():
            _write_observable(file, name, values, frames)
        for name, value in parameters.found.get("parameters", {}).items():
            if f"parameters/{name}" not in file:
                _put(file, f"parameters/{name}", value)
                recovery.parameters += 1


@dataclass
class _Frames:
    """Frames that were read: numbers in the broken file, and what they hold."""

    numbers: np.ndarray
    positions: np.ndarray  #: (F, N, 3) as stored
    steps: np.ndarray
    times: np.ndarray | None
    units: dict[str, str]


def _shape(file: h5py.File) -> tuple[tuple[int, ...], dict[str, str]]:
    value = _hdf5.item(file, f"{POSITION}/value")
    if not _hdf5.is_array(value, "f", (None, None, 3)):
        raise ValueError("no positions (F, N, 3)")
    _hdf5.check_stored(value, 3 * value.shape[1])
    return tuple(value.shape), {
        "value": _hdf5.text(value, "unit") or "Angstrom",
        "time": _hdf5.text(_hdf5.item(file, f"{POSITION}/time"), "unit") or "ps",
    }


def _read_frames(path: str, recovery: Recovery) -> _Frames | None:
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
    return _Frames(
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
    spans = [(first, min(first + FRAMES_AT_ONCE, count)) for first in range(0, count, FRAMES_AT_ONCE)]
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
    names = listed.found.get("observables") or OBSERVABLES
    found = salvage(path, [(name, dataset(f"observables/{name}/value")) for name in names])
    for name, why in found.lost.items():
        recovery.lost[f"observable {name}"] = why
    for name, stored in found.found.items():
        if np.ndim(stored.values) == 1 and len(stored.values) >= count:
            recovery.observables.append(name)
        else:
            recovery.lost[f"observable {name}"] = "has not one value a frame"
    return {name: found.found[name] for name in recovery.observables}


def _names(file: h5py.File) -> list[str]:
    group = _hdf5.item(file, "observables")
    return _hdf5.names_in(group) if isinstance(group, h5py.Group) else []


def _parameters(file: h5py.File) -> dict[str, Any]:
    return dict(_hdf5.scalars(_hdf5.item(file, "parameters")))


def _creator(file: h5py.File) -> dict[str, Any]:
    creator = _hdf5.item(file, "h5md/creator")
    schema = None if creator is None else _hdf5.plain(_hdf5.attribute(creator, "schema"))
    names = {name: _hdf5.text(creator, name) for name in ("name", "version")}
    return names | ({"schema": schema} if isinstance(schema, int) else {})


def _write_header(file: h5py.File, creator: dict[str, Any]) -> None:
    file.create_group("h5md").attrs["version"] = np.array([1, 1], dtype=np.int32)
    file.create_group("h5md/author").attrs["name"] = "unknown"
    group = file.create_group("h5md/creator")
    for name, value in {"name": "pliant", "version": "", **creator}.items():
        group.attrs[name] = value
    box = file.create_group(f"{TRAJECTORY}/box")
    box.attrs["dimension"] = 3
    box.attrs["boundary"] = ["none", "none", "none"]


def _write_frames(file: h5py.File, frames: _Frames) -> None:
    chunk = (1, *frames.positions.shape[1:])
    value = file.create_dataset(
        f"{POSITION}/value", data=frames.positions, chunks=chunk, maxshape=(None, *chunk[1:])
    )
    value.attrs["unit"] = frames.units["value"]
    file[f"{POSITION}/step"] = frames.steps
    if frames.times is not None:
        file[f"{POSITION}/time"] = frames.times
        file[f"{POSITION}/time"].attrs["unit"] = frames.units["time"]


def _write_static(file: h5py.File, static: Salvage, recovery: Recovery, count: int) -> None:
    for name, stored in static.found.items():
        if why := _misfit(name, stored, count):
            recovery.lost[name] = why
            continue
        _put(file, name, stored.values)
        for key, value in stored.attributes.items():
            file[name].attrs[key] = value
        recovery.saved.append(name)


def _misfit(name: str, stored: StoredValues, count: int) -> str:
    """Why a dataset cannot be what its name says; "" if it can."""
    values = np.asarray(stored.values)
    if name.startswith("connectivity/"):
        fits = values.ndim == 2 and values.shape[1] == 2 and values.dtype.kind in "iu"
        if not fits or (values.size and (values.min() < 0 or values.max() >= count)):
            return "names joints that are not there"
    per_joint = (f"{TRAJECTORY}/mass", "parameters/topology/atom_name",
                 "parameters/framework/pinned", "parameters/topology/residue_of")  # fmt: skip
    if name in per_joint and values.shape != (count,):
        return f"has not one value for each of {count} joints"
    if values.dtype.kind == "f" and not np.isfinite(values).all() and "most" not in name:
        return "has values that are not finite"
    return ""


def _write_observable(
    file: h5py.File, name: str, stored: StoredValues, frames: _Frames
) -> None:
    path = f"observables/{name}"
    _put(file, f"{path}/value", np.asarray(stored.values)[frames.numbers])
    for key, value in stored.attributes.items():
        file[f"{path}/value"].attrs[key] = value
    for part in ("step", "time"):
        if f"{POSITION}/{part}" in file:
            file[f"{path}/{part}"] = file[f"{POSITION}/{part}"]


def _put(file: h5py.File, path: str, value: Any) -> None:
    """A dataset of the type that h5py read: enumerations and fixed texts stay what they are."""
    dtype = getattr(value, "dtype", None)
    if dtype is not None and dtype.kind == "U":
        dtype = h5py.string_dtype()
    file.create_dataset(path, data=value, dtype=dtype)


def make_parser() -> console.Parser:
    """The options of pliant recover."""
    parser = console.Parser(
        "recover",
        "Copies what can be read of a damaged H5MD file into a new one, and says what was lost.",
        EPILOG,
    )
    add = parser.add_argument
    add("file", metavar="BROKEN", help="H5MD file that other commands call damaged")
    add("-o", "--output", metavar="GOOD", required=True, help="H5MD file to write")
    add("--overwrite", action="store_true", help="replace an existing GOOD")
    add("--json", action="store_true", help="print the report as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("recover", lambda: _recover(arguments))


def _recover(arguments: argparse.Namespace) -> int:
    recovery = recover(arguments.file, arguments.output, overwrite=arguments.overwrite)
    if arguments.json:
        console.print_json(vars(recovery))
        return console.EXIT_OK
    print(
        f"{recovery.path}: {recovery.frames} of {recovery.frames_stated} frames, "
        f"{len(recovery.observables)} observables, {len(recovery.saved)} tables, "
        f"{recovery.parameters} options"
    )
    for what, why in recovery.lost.items():
        print(f"lost: {why}" if why.startswith(f"/{what}") else f"lost: {what}: {why}")
    if not recovery.lost:
        print("nothing was lost")
    return console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
