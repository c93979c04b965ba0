# SPDX-License-Identifier: MIT
"""Opens a trajectory with MDAnalysis, and says in one line why it cannot be opened."""

from __future__ import annotations

import contextlib
import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import h5py
import MDAnalysis

import pliant.trajectory.shards.reader  # noqa: F401  (makes MDAnalysis read our files)
from pliant import _core
from pliant._core import InputError
from pliant.base.input_files import expect_file
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.frames import check_atoms
from pliant.trajectory.hdf5.expansion import check_stored

if TYPE_CHECKING:
    from MDAnalysis import Universe


def open_universe(
    path: str | os.PathLike[str], topology: str | os.PathLike[str] | None = None
) -> Universe:
    """The MDAnalysis.Universe of a trajectory file, with a topology file or its own.

    Raises InputError with one line: no such file, not HDF5, no frames, no or a wrong topology.
    """
    return _hdf5.while_written(path, lambda: _checked_universe(Path(path), topology))


def _checked_universe(path: Path, topology: str | os.PathLike[str] | None) -> Universe:
    _check_file(path)
    if topology is not None:
        _check_file(Path(topology))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        universe = _open(path, topology)
    frames = None
    with contextlib.suppress(Exception):
        frames = len(universe.trajectory)
    if not frames:
        raise InputError(f"{path}: holds no frames")
    return universe


def _check_file(path: Path) -> None:
    if not path.exists():
        raise InputError(f"{path}: no such file")
    if path.is_dir():
        raise InputError(f"{path}: is a folder, expected a trajectory file")
    expect_file(path)
    if path.is_file() and path.stat().st_size == 0:
        raise InputError(f"{path}: is empty")
    if path.suffix.lower() not in (".h5md", ".h5", ".hdf5"):
        return
    if not h5py.is_hdf5(path):
        raise InputError(f"{path}: is not an HDF5 file, or was cut off while it was written")
    with _hdf5.open_file(path) as file:
        group = _hdf5.first_in(file, "particles")
        if group is None:
            raise InputError(f"{path}: is HDF5 but not H5MD: there is no group in /particles")
        values = _hdf5.item(group, "position/value")
        if not isinstance(values, h5py.Dataset):
            raise InputError(f"{path}: there are no positions in {group.name}")
        _check_positions(path, values)


def _check_positions(path: Path, values: h5py.Dataset) -> None:
    if not _hdf5.is_array(values, "fiu", (None, None, 3)):
        found = f"{values.dtype} of shape {values.shape}"
        raise InputError(f"{path}: {values.name}: expected positions (F, N, 3), found {found}")
    if values.shape[0] == 0:
        raise InputError(f"{path}: holds no frames")
    check_stored(values, 3 * values.shape[1])
    steps = _hdf5.item(values.parent, "step")
    if _hdf5.has_rows(steps) and not _hdf5.is_array(steps, "iu", (None,)):
        raise InputError(f"{path}: {steps.name}: expected whole numbers, found {steps.dtype}")
    frames = min(len(values), len(steps) if _hdf5.has_rows(steps) else len(values))
    check_stored(values, 3 * values.shape[1] * frames, at_once=3 * values.shape[1])


def _open(path: Path, topology: str | os.PathLike[str] | None) -> Universe:
    options = {"format": "H5MD"} if path.suffix.lower() in (".h5md", ".h5", ".hdf5") else {}
    try:
        if topology is not None:
            return MDAnalysis.Universe(str(topology), str(path), **options)
        if options:
            options["topology_format"] = "H5MD"
        return MDAnalysis.Universe(str(path), **options)
    except Exception as error:  # MDAnalysis raises whatever its readers meet
        what = path if topology is None else f"{path} with topology {topology}"
        advice = "" if topology is not None else "; --topology FILE names one with the atoms"
        if topology is not None:
            _check_atoms(path, Path(topology))
        reason = " ".join(str(error).split()) or type(error).__name__
        raise InputError(f"{what}: MDAnalysis cannot read it: {reason}{advice}") from error


def _check_atoms(path: Path, topology: Path) -> None:
    """Raises InputError where a topology is that of what was sampled, not of what was prepared."""
    if path.suffix.lower() not in (".h5md", ".h5", ".hdf5"):
        return
    try:
        structure, frames = _core.read(os.fspath(topology)), _core.H5mdReader(os.fspath(path))
    except _core.Error:  # MDAnalysis says what is wrong with it
        return
    check_atoms(structure, frames.joint_count, f"{path} with topology {topology}")
