# SPDX-License-Identifier: MIT
"""A trajectory of ours as it is checked: everything in double precision, nothing guessed."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np

from pliant._core import InputError
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.drawn_by import around_start
from pliant.trajectory.hdf5.expansion import check_stored
from pliant.trajectory.shards.plan import refuse_ensemble

ANGSTROM_PER_UNIT = {"Angstrom": 1.0, "A": 1.0, "nm": 10.0, "pm": 0.01}
BLOCK_BYTES = 32 << 20  #: frames are read in pieces of about this size


@dataclass(frozen=True)
class Tolerance:
    """When a bar counts as whole."""

    relative: float = 1e-6  #: largest |length - rest| / rest; used if `length` is 0
    length: float = 0.0  #: largest |length - rest|, Angstrom

    def of(self, rest_lengths: np.ndarray) -> np.ndarray:
        """Largest |length - rest| / rest accepted of each bar."""
        if self.length > 0:
            return self.length / rest_lengths
        return np.full(len(rest_lengths), self.relative)


@dataclass
class Recording:
    """The framework and the frames of an H5MD file. Lengths in Angstrom, masses in u."""

    path: str
    bars: np.ndarray  #: (B, 2) joints, from 0
    rest_lengths: np.ndarray  #: (B,)
    bonds: np.ndarray  #: (C, 2) joints that are bonded atoms; empty if the file does not say
    masses: np.ndarray  #: (N,)
    pinned: np.ndarray  #: (N,) bool
    steps: np.ndarray  #: (F,)
    observables: dict[str, np.ndarray]  #: name -> (F,)
    options: dict[str, Any]  #: "technique" -> its value, from /parameters/run
    angle_bars: bool  #: bars were made of angles too
    is_ensemble: bool  #: frames of `pliant sample`: each is drawn, none is made of the one before
    single: bool  #: positions are stored as 32-bit floats
    rounded_to: float  #: coordinates are multiples of this, Angstrom; 0: as they were
    to_angstrom: float
    names: list[str]  #: (N) of the atoms; empty if the file has none
    joints_of_whole: int | None = None  #: of the molecule, of which these are some; None: all

    @property
    def frame_count(self) -> int:
        """Frames of which position, step and time are all there."""
        return len(self.steps)

    @property
    def joint_count(self) -> int:
        """Joints of the framework: atoms of the molecule."""
        return len(self.masses)

    @property
    def tolerance(self) -> Tolerance:
        """The tolerance of the run; 1e-6 if the file does not say."""
        return Tolerance(
            float(self.options.get("tolerance", 1e-6)),
            float(self.options.get("tolerance_length", 0.0)),
        )

    @property
    def converged(self) -> np.ndarray:
        """(F,) bool: what the file says of each frame; true where it does not say."""
        flags = self.observables.get("converged")
        return np.ones(self.frame_count, bool) if flags is None else flags.astype(bool)

    @property
    def around_start(self) -> np.ndarray:
        """Numbers of the frames by which flexibility is computed, ascending.

        All, but for an ensemble of sampler ``reach``: those drawn along the modes.
        """
        near = around_start(self.observables.get("sampler"))
        return np.arange(self.frame_count) if near is None else np.flatnonzero(near)

    def bar_label(self, bar: int) -> str:
        """ "C1(0) - C2(1)": names and numbers (from 0) of both joints."""
        a, b = (f"{self.names[j]}({j})" if self.names else f"joint {j}" for j in self.bars[bar])
        return f"{a} - {b}"

    def rounding(self, positions: np.ndarray) -> float:
        """How much the storing of coordinates may change a length, Angstrom.

        Each coordinate is off by half a unit in the last place, at both ends, along three axes.
        """
        half_unit = 2.0**-24 if self.single else 2.0**-53
        off = max(half_unit * float(np.abs(positions).max(initial=0.0)), self.rounded_to / 2)
        return 2.0 * math.sqrt(3.0) * off

    def positions(self, frames: np.ndarray) -> np.ndarray:
        """(len(frames), N, 3) of ascending frame numbers."""
        with _hdf5.open_file(self.path) as file:
            value = _Parts(file, self.path).positions()
            found = _hdf5.read(value, np.asarray(frames))
            positions: np.ndarray = found.astype(np.float64) * self.to_angstrom
            return positions

    def blocks(self) -> Iterator[tuple[int, np.ndarray]]:
        """All frames in pieces: number of the first frame, positions (n, N, 3)."""
        size = max(1, BLOCK_BYTES // max(24 * self.joint_count, 1))
        with _hdf5.open_file(self.path) as file:
            value = _Parts(file, self.path).positions()
            for first in range(0, self.frame_count, size):
                block = _hdf5.read(value, slice(first, min(first + size, self.frame_count)))
                yield first, block.astype(np.float64) * self.to_angstrom


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads all but the positions.

    Raises InputError naming the file and the part of it that is missing or has not the shape it
    must have; OSError when the file cannot be read.
    """
    path = os.fspath(path)
    refuse_ensemble(path)
    if not os.path.exists(path):
        raise InputError(f"{path}: no such file")
    if not h5py.is_hdf5(path):
        raise InputError(f"{path}: not an HDF5 file")
    return _hdf5.while_written(path, lambda: _read_file(path))


def _read_file(path: str) -> Recording:
    with _hdf5.open_file(path) as file:
        return _read(_Parts(file, path))


class _Parts:
    """Datasets of one file, checked for kind and shape as they are taken out."""

    def __init__(self, file: h5py.File, path: str) -> None:
        self.file, self.path = file, path

    def refuse(self, name: str, expected: str, found: object) -> InputError:
        return InputError(f"{self.path}: /{name}: expected {expected}, found {found}")

    def dataset(
        self, name: str, kinds: str, shape: tuple[int | None, ...], expected: str
    ) -> h5py.Dataset:
        """A dataset whose dtype is of `kinds` and whose shape is `shape` (None: any extent)."""
        found = _hdf5.item(self.file, name)
        if not isinstance(found, h5py.Dataset):
            raise self.refuse(name, expected, "nothing")
        if not _hdf5.is_array(found, kinds, shape):
            raise self.refuse(name, expected, f"{found.dtype} of shape {found.shape}")
        return found

    def values(
        self, name: str, kinds: str, shape: tuple[int | None, ...], expected: str
    ) -> np.ndarray:
        """The numbers of such a dataset."""
        found: np.ndarray = _hdf5.read(self.dataset(name, kinds, shape, expected))
        return found

    def step(self) -> h5py.Dataset:
        """The numbers of the steps of all frames."""
        name = "particles/trajectory/position/step"
        return self.dataset(name, "iu", (None,), "one number a frame")

    def positions(self) -> h5py.Dataset:
        """The positions of all frames."""
        name = "particles/trajectory/position/value"
        return self.dataset(name, "f", (None, None, 3), "positions (F, N, 3)")


def _read(parts: _Parts) -> Recording:
    value = parts.positions()
    joints = value.shape[1]
    frames = _complete_frames(parts, value)
    check_stored(value, frames * joints * 3, at_once=joints * 3)
    bars, rest_lengths = _read_bars(parts, joints)
    options = _read_options(parts)
    return Recording(
        path=parts.path,
        bars=bars,
        rest_lengths=rest_lengths,
        bonds=_read_bonds(parts),
        masses=_read_masses(parts, joints),
        pinned=_read_pinned(parts, joints),
        steps=_hdf5.read(parts.step(), slice(frames)),
        observables=_read_observables(parts, frames),
        options=options,
        angle_bars=_has_angle_bars(parts),
        is_ensemble=bool(_scalars(parts, "parameters/sample")),
        single=value.dtype.itemsize < 8,
        rounded_to=_hdf5.rounded_to(value) * _unit_of(parts, value),
        to_angstrom=_unit_of(parts, value),
        names=_read_names(parts, joints),
        joints_of_whole=_hdf5.joints_of_whole(value.parent.parent),
    )


def _has_angle_bars(parts: _Parts) -> bool:
    model = _scalars(parts, "parameters/model").get("kind", "bonds")
    return _scalars(parts, "parameters/input").get("bars") == "angles" or model != "bonds"


def _read_names(parts: _Parts, joints: int) -> list[str]:
    names = _hdf5.item(parts.file, "parameters/topology/atom_name")
    if not _hdf5.is_array(names, "OS", (joints,)):
        return []
    return [str(_hdf5.plain(name)) for name in _hdf5.read(names)]


def _unit_of(parts: _Parts, value: h5py.Dataset) -> float:
    stated = _hdf5.attribute(value, "unit")
    unit = "Angstrom" if stated is None else _hdf5.plain(stated)
    if not isinstance(unit, str) or unit not in ANGSTROM_PER_UNIT:
        known = ", ".join(ANGSTROM_PER_UNIT)
        found = f"'{unit}'" if isinstance(unit, str) else "no text"
        raise parts.refuse("particles/trajectory/position/value", f"unit {known}", found)
    return ANGSTROM_PER_UNIT[unit]


def _complete_frames(parts: _Parts, value: h5py.Dataset) -> int:
    time = "particles/trajectory/position/time"
    times = parts.dataset(time, "fiu", (None,), "one number a frame")
    frames = min(len(value), len(parts.step()), len(times))
    if frames == 0:
        raise InputError(f"{parts.path}: holds no frame")
    return frames


def _read_bars(parts: _Parts, joints: int) -> tuple[np.ndarray, np.ndarray]:
    name = "connectivity/bars"
    bars = parts.values(name, "iu", (None, 2), "joints (B, 2)").astype(np.int64)
    if len(bars) and (bars.min() < 0 or bars.max() >= joints):
        raise parts.refuse(name, f"joints from 0 to {joints - 1}", bars.max())
    name = "parameters/framework/rest_length"
    wanted = f"one length for each of {len(bars)} bars"
    lengths = parts.values(name, "f", (len(bars),), wanted).astype(np.float64)
    bad = ~(np.isfinite(lengths) & (lengths > 0))
    if bad.any():
        k = int(np.argmax(bad))
        raise parts.refuse(name, "lengths above 0", f"{lengths[k]} for bar {k}")
    return bars, lengths


def _read_bonds(parts: _Parts) -> np.ndarray:
    bonds = _hdf5.item(parts.file, "connectivity/bonds")
    if not _hdf5.is_array(bonds, "iu", (None, 2)):
        return np.empty((0, 2), np.int64)
    found: np.ndarray = _hdf5.read(bonds).astype(np.int64)
    return found


def _read_masses(parts: _Parts, joints: int) -> np.ndarray:
    name = "particles/trajectory/mass"
    if _hdf5.item(parts.file, name) is None:
        return np.ones(joints)
    masses = parts.values(name, "f", (joints,), f"one mass for each of {joints} joints")
    bad = ~(np.isfinite(masses) & (masses > 0))
    if bad.any():
        k = int(np.argmax(bad))
        raise parts.refuse(name, "masses above 0", f"{masses[k]} for joint {k}")
    exact: np.ndarray = masses.astype(np.float64)
    return exact


def _read_pinned(parts: _Parts, joints: int) -> np.ndarray:
    name = "parameters/framework/pinned"
    if _hdf5.item(parts.file, name) is None:
        return np.zeros(joints, bool)
    wanted = f"one truth value for each of {joints} joints"
    pinned: np.ndarray = parts.values(name, "biu", (joints,), wanted).astype(bool)
    return pinned


def _read_observables(parts: _Parts, frames: int) -> dict[str, np.ndarray]:
    group = _hdf5.item(parts.file, "observables")
    found = {}
    for name in _hdf5.names_in(group) if isinstance(group, h5py.Group) else []:
        values = _hdf5.item(parts.file, f"observables/{name}/value")
        if _hdf5.is_array(values, "biuf", (None,)) and len(values) >= frames:
            found[name] = _hdf5.read(values, slice(frames))
    return found


def _read_options(parts: _Parts) -> dict[str, Any]:
    options = _scalars(parts, "parameters/run")
    for name, least in (("tolerance", math.ulp(0.0)), ("tolerance_length", 0.0)):
        if name in options:
            _hdf5.positive(parts.path, f"parameters/run/{name}", options[name], least)
    return options


def _scalars(parts: _Parts, group: str) -> dict[str, Any]:
    return dict(_hdf5.scalars(_hdf5.item(parts.file, group), levels=1))
