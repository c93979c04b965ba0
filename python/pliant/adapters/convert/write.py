# SPDX-License-Identifier: MIT
"""Frames in a format that other programs read."""

from __future__ import annotations

import logging
import os
import pathlib
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pliant import _core
from pliant._core import InputError, OptionError
from pliant.adapters.convert.formats import FORMATS
from pliant.base.checked import Wanted, checked
from pliant.base.extras import late, need
from pliant.base.force_field_options import ONE_OF_CHARGES, PROGRAMS, USUAL, ForceFieldOptions
from pliant.trajectory.files import file_of
from pliant.trajectory.frames import Moment
from pliant.trajectory.results import SampledEnsemble
from pliant.trajectory.sources import Molecule
from pliant.trajectory.superposition import Superposition
from pliant.trajectory.trajectory import HasFrames, Trajectory

analysis = late("pliant.measure.stages.analysis")
shapes = late("pliant.measure.shapes.representatives")
stages = late("pliant.measure.stages.opened")
exports = late("pliant.checks.force_field.export")


@dataclass
class Converted:
    """What was written."""

    path: str
    format: str
    frames: int
    atoms: int
    notes: list[str] = field(default_factory=list)  #: on parameters, of what is written for MD


@checked(charges=ONE_OF_CHARGES, to=Wanted("openmm, gromacs or amber", lambda x: x in PROGRAMS))
def convert(
    source: HasFrames | Molecule,
    output: str | os.PathLike[str],
    *,
    select: str = "",
    every: int = 1,
    representatives: int | None = None,
    superpose: bool = False,
    overwrite: bool = False,
    to: str | None = None,
    charges: str = "am1-bcc",
    ligands: Mapping[str, str] | None = None,
    platform: str = "auto",
) -> Converted:
    """Writes frames in the format that `output` asks for.

    Parameters
    ----------
    source : path, SampledEnsemble, RunResult, MolecularPath, Trajectory, Universe, ...
        What a `Trajectory` is made of. Paths are of an H5MD file, of models (PDB, mmCIF, SDF),
        or of an ensemble: a folder of ``pliant ensemble``, or the ``ensemble.pliant`` in it.
    output : path
        Ends in .h5md, .pdb, .ent, .cif, .mmcif, .sdf, .dcd, .xtc, .trr, .xyz or .zarr.
    select : str
        Atoms that are written; "": all.
    every : int
        Only each so manyth frame, from the first.
    representatives : int, optional
        Instead: so many frames that stand for all others, in the order of the file.
    superpose : bool
        Each frame is laid on the first, by least squares over the atoms that are written.
    overwrite : bool
        Replace an existing file.
    to : "openmm", "gromacs" or "amber", optional
        Write systems with parameters, of a protein and its ligands, that these programs run;
        `output` is then a folder. Frames are minimised for 100 steps first.
    charges, ligands, platform
        With `to`: as `check` takes them.

    Raises
    ------
    OptionError
        The format is not known, or `select` chooses nothing.
    MissingPackageError
        MDAnalysis or RDKit is needed and not there.
    InputError, FileError
        The files cannot be read or written. `output` is then as it was before.
    """
    options = ForceFieldOptions(charges, ligands or {}, platform)
    if to is None and options != USUAL:
        raise OptionError("--charges, --ligand, --platform: go with --to")
    if to is not None and superpose:
        raise OptionError("--superpose: does not go with --to")
    if to is not None:
        chosen = _Chosen(source, select, every, representatives)
        return _exported(chosen, output, to, options, overwrite)
    ending = pathlib.Path(output).suffix.lower()
    if ending not in FORMATS:
        known = ", ".join(FORMATS)
        raise OptionError(f"{os.fspath(output)}: expected a name that ends in {known}")
    name, write, package = FORMATS[ending]
    if package:
        need(f"writing {name}", package)
    _refuse(source, output, overwrite)
    chosen = _Chosen(source, select, every, representatives)
    trajectory, atoms = chosen.trajectory, chosen.atoms
    is_whole = every == 1 and representatives is None
    if ending in (".h5md", ".h5") and isinstance(source, SampledEnsemble) and is_whole:
        source.record(output, overwrite=overwrite, save=select)  # with all that is known of it
        return Converted(os.fspath(output), name, len(trajectory), len(atoms))
    frames = _frames(trajectory, atoms, chosen.numbers, superpose)
    count = write(os.fspath(output), chosen.part, frames, overwrite)
    return Converted(os.fspath(output), name, count, len(atoms))


class _Chosen:
    """The frames and atoms that are written."""

    def __init__(
        self, source: HasFrames | Molecule, select: str, every: int, representatives: int | None
    ) -> None:
        self.trajectory = Trajectory(source)
        structure = self.trajectory.structure
        if len(self.trajectory) == 0:
            raise InputError(f"{structure.source}: holds no frame")
        self.atoms = _chosen(structure, select)
        is_all = len(self.atoms) == len(structure)
        self.part = structure if is_all else _part_of(structure, select)
        self.numbers: Sequence[int] = range(0, len(self.trajectory), every)
        if representatives is not None:
            self.numbers = _representatives(source, representatives)


def _exported(
    chosen: _Chosen,
    output: str | os.PathLike[str],
    to: str,
    options: ForceFieldOptions,
    overwrite: bool,
) -> Converted:
    positions = np.array([chosen.trajectory[k][chosen.atoms] for k in chosen.numbers])
    say = logging.getLogger("pliant").info
    made = exports.export(
        chosen.part, positions, chosen.numbers, output, to, options, say, overwrite=overwrite
    )
    name = f"to start {PROGRAMS[to][0]} from"
    return Converted(os.fspath(output), name, len(positions), made.atoms, made.notes)


def _refuse(source: HasFrames | Molecule, output: str | os.PathLike[str], overwrite: bool) -> None:
    path = source if isinstance(source, (str, os.PathLike)) else None
    if isinstance(source, HasFrames):
        path = source.trajectory.path
    if path and os.path.exists(path) and os.path.exists(output) and os.path.samefile(path, output):
        raise OptionError(f"{os.fspath(output)}: is both input and output")
    if not overwrite and os.path.exists(output):
        raise _core.FileError(f"{os.fspath(output)}: exists; --overwrite replaces it")


def _chosen(structure: _core.Structure, select: str) -> np.ndarray:
    if not select:
        return np.arange(len(structure))
    atoms: np.ndarray = np.asarray(_core.select_atoms(structure, select), dtype=np.int64)
    if len(atoms) == 0:
        raise OptionError(f'--select "{select}": chooses none of {len(structure)} atoms')
    return atoms


def _part_of(structure: _core.Structure, select: str) -> _core.Structure:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", _core.PliantWarning)  # bonds that a selection cuts are gone
        return structure.select(select)


def _representatives(source: HasFrames | Molecule, count: int) -> list[int]:
    """Numbers of the frames."""
    path, _folder = file_of(source, "representatives")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found, _ = shapes.medoids(stages.opened(analysis.AnalysisOptions(path)), count)
    return sorted(int(number) for number in found.frames)


def _frames(
    trajectory: Trajectory, atoms: np.ndarray, numbers: Iterable[int], superpose: bool
) -> Iterator[Moment]:
    fit: Superposition | None = None
    for frame in numbers:
        positions = trajectory[frame][atoms]
        if superpose and fit is None:
            fit = Superposition(positions, np.ones(len(atoms)))
        elif fit is not None:
            positions = fit.apply(positions)
        step, time = trajectory.step(frame), trajectory.time(frame)
        yield Moment(positions, step, time, trajectory._walker(frame))
