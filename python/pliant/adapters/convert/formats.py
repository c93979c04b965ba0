# SPDX-License-Identifier: MIT
"""The formats that frames are written in, one function each."""

from __future__ import annotations

import errno
import os
import pathlib
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pliant import _core
from pliant.adapters.convert.cif_models import write_models
from pliant.adapters.convert.zarr_store import write_zarr
from pliant.adapters.mdanalysis import to_mdanalysis
from pliant.adapters.rdkit import to_rdkit
from pliant.base.extras import late
from pliant.base.new_file import new_file, new_text
from pliant.trajectory.frames import Moment

if TYPE_CHECKING:
    from MDAnalysis import Universe
    from MDAnalysis.coordinates.base import WriterBase

Chem = late("rdkit.Chem")
MDAnalysis = late("MDAnalysis")
libdcd, libmdaxdr = map(late, ("MDAnalysis.lib.formats.libdcd", "MDAnalysis.lib.formats.libmdaxdr"))


def _write_h5md(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    framework = structure.framework("bonds")
    with _core.H5mdRecorder(
        output, framework, structure=structure, overwrite=overwrite
    ) as recorder:
        for moment in frames:
            found = _core.measure_bars(framework, moment.positions)
            recorder.record(
                _core.Frame(
                    moment.step,
                    moment.time,
                    moment.positions,
                    max_residual=found.max_relative,
                    rms_residual=found.rms_relative,
                )
            )
    return int(recorder.frames)


def _write_sdf(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    molecule = to_rdkit(structure)
    conformer, count = molecule.GetConformer(), 0
    with new_text(output, overwrite=overwrite) as file:
        for moment in frames:
            conformer.SetPositions(np.ascontiguousarray(moment.positions))
            molecule.SetIntProp("frame", moment.step)
            file.write(Chem.SDWriter.GetText(molecule, molid=count))
            count += 1
    return count


def _write_pdb(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    with _core.PdbRecorder(output, structure, overwrite=overwrite) as recorder:
        for moment in frames:
            recorder.record(moment.positions)
    return int(recorder.models)


def _write_cif(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    with new_text(output, overwrite=overwrite) as file:
        return write_models(file, structure, (moment.positions for moment in frames))


def _write_xyz(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    symbols, count = structure.symbols.tolist(), 0
    with new_text(output, overwrite=overwrite) as file:
        for moment in frames:
            file.write(f"{len(symbols)}\nstep {moment.step}, time {moment.time:g} ps\n")
            rows = zip(symbols, moment.positions.tolist(), strict=True)
            file.writelines(f"{one:<2} {x:11.5f} {y:11.5f} {z:11.5f}\n" for one, (x, y, z) in rows)
            count += 1
    return count


def _write_with_mdanalysis(
    output: str, structure: _core.Structure, frames: Iterator[Moment], overwrite: bool
) -> int:
    universe = to_mdanalysis(structure)
    ending = pathlib.Path(output).suffix[1:].upper()
    count = 0
    with new_file(output, overwrite=overwrite) as file, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of boxes and names that are not there
        path = os.fspath(file.path)
        with MDAnalysis.Writer(path, n_atoms=len(structure), format=ending) as writer:
            for moment in frames:
                step = universe.trajectory.ts
                step.positions = moment.positions
                step.time, step.frame = moment.time, count
                step.data["step"] = moment.step
                _written(writer, universe)
                count += 1
        if not _ends_with(path, ending, count, universe.trajectory.ts.positions):
            raise _no_room()
    return count


def _written(writer: WriterBase, universe: Universe) -> None:
    try:
        writer.write(universe.atoms)
    except OSError as error:  # of C, without the system's reason
        raise _no_room() from error


def _no_room() -> OSError:
    return OSError(errno.ENOSPC, "not all frames are there: is the disk full?")


def _ends_with(path: str, ending: str, count: int, positions: np.ndarray) -> bool:
    """Whether all frames are there: the writers do not hear of every full disk."""
    opened = getattr(libdcd if ending == "DCD" else libmdaxdr, f"{ending}File")
    try:
        with opened(path) as file:
            if len(file) != count:
                return False
            file.seek(count - 1)
            last = file.read()
    except OSError:
        return False
    found = last.xyz if ending == "DCD" else 10 * last.x  # Angstrom, nm
    return bool(np.allclose(found, positions, atol=0.01))


#: Endings of names -> what they are, what writes them, and the package that it needs.
FORMATS = {
    ".h5md": ("H5MD", _write_h5md, ""),
    ".h5": ("H5MD", _write_h5md, ""),
    ".pdb": ("PDB, a model a frame", _write_pdb, ""),
    ".ent": ("PDB, a model a frame", _write_pdb, ""),
    ".cif": ("mmCIF, a model a frame", _write_cif, ""),
    ".mmcif": ("mmCIF, a model a frame", _write_cif, ""),
    ".sdf": ("SDF, a record a frame", _write_sdf, "rdkit"),
    ".dcd": ("DCD", _write_with_mdanalysis, "MDAnalysis"),
    ".xtc": ("XTC", _write_with_mdanalysis, "MDAnalysis"),
    ".trr": ("TRR", _write_with_mdanalysis, "MDAnalysis"),
    ".xyz": ("XYZ", _write_xyz, ""),
    ".zarr": ("Zarr", write_zarr, "zarr"),
}
