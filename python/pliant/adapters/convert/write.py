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
from pliant.adapters.convert.docking import site_of, write_receptors
from pliant.adapters.convert.formats import FORMATS
from pliant.base.checked import Wanted, checked
from pliant.base.extras import late, need
from pliant.base.force_field_options import ONE_OF_CHARGES, PROGRAMS, USUAL, ForceFieldOptions
from pliant.base.new_file import expect_none
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


DOCKING = "vina"
#: what is a folder of files, beside FORMATS
TARGETS = (*PROGRAMS, DOCKING)


@checked(charges=ONE_OF_CHARGES, to=Wanted(f"one of {', '.join(TARGETS)}", lambda x: x in TARGETS))
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
    site: str = "",
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
    to : "openmm", "gromacs", "amber" or "vina", optional
        Write systems with parameters, of a protein and its ligands, that these programs run;
        `output` is then a folder. Frames are minimised for 100 steps first. "vina": receptors in
        PDBQT, superposed by the site on the structure, and box.txt, the site's box.
    charges, ligands, platform
        With `to` of MD: as `check` takes them.
    site : str
        Residues that representatives are superposed by, and differ in; to "vina", where ligands are
        docked. Residues of proteins in this selection, or, if none is in it (a ligand), those
        within 6 Angstrom.

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
    _expect_together(to, options, superpose, site, representatives)
    if to is not None:
        chosen = _Chosen(source, select, every, representatives, site)
        if to == DOCKING:
            return _receptors(chosen, output, site, overwrite)
        return _exported(chosen, output, to, options, overwrite)
    ending = pathlib.Path(output).suffix.lower()
    if ending not in FORMATS:
        known = ", ".join(FORMATS)
        raise OptionError(f"{os.fspath(output)}: expected a name that ends in {known}")
    name, write, package = FORMATS[ending]
    if package:
        need(f"writing {name}", package)
    _refuse(source, output, overwrite)
    chosen = _Chosen(source, select, every, representatives, site)
    trajectory, atoms = chosen.trajectory, chosen.atoms
    is_whole = every == 1 and representatives is None
    if ending in (".h5md", ".h5") and isinstance(source, SampledEnsemble) and is_whole:
        source.record(output, overwrite=overwrite, save=select)  # with all that is known of it
        return Converted(os.fspath(output), name, len(trajectory), len(atoms))
    frames = _frames(trajectory, atoms, chosen.numbers, superpose)
    count = write(os.fspath(output), chosen.part, frames, overwrite)
    return Converted(os.fspath(output), name, count, len(atoms))


def _expect_together(
    to: str | None,
    options: ForceFieldOptions,
    superpose: bool,
    site: str,
    representatives: int | None,
) -> None:
    """Raises OptionError for options that do not go with each other."""
    if to not in PROGRAMS and options != USUAL:
        raise OptionError(f"--charges, --ligand, --platform: go with --to {', '.join(PROGRAMS)}")
    if to is not None and superpose:
        raise OptionError("--superpose: does not go with --to")
    if site and to != DOCKING and representatives is None:
        raise OptionError("--site: goes with --representatives or --to vina")
    if to == DOCKING and not site:
        raise OptionError("--to vina: expected --site, the residues that ligands are docked at")


class _Chosen:
    """The frames and atoms that are written."""

    def __init__(
        self,
        source: HasFrames | Molecule,
        select: str,
        every: int,
        representatives: int | None,
        site: str,
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
            self.numbers = _representatives(source, representatives, structure, site)


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


def _receptors(
    chosen: _Chosen, output: str | os.PathLike[str], site: str, overwrite: bool
) -> Converted:
    positions = (chosen.trajectory[k][chosen.atoms] for k in chosen.numbers)
    made = write_receptors(
        chosen.part, positions, chosen.numbers, output, site, overwrite=overwrite
    )
    name = "to dock into with AutoDock Vina"
    return Converted(os.fspath(output), name, len(chosen.numbers), made.atoms, made.notes)


def _refuse(source: HasFrames | Molecule, output: str | os.PathLike[str], overwrite: bool) -> None:
    path = source if isinstance(source, (str, os.PathLike)) else None
    if isinstance(source, HasFrames):
        path = source.trajectory.path
    if path and os.path.exists(path) and os.path.exists(output) and os.path.samefile(path, output):
        raise OptionError(f"{os.fspath(output)}: is both input and output")
    expect_none([output], overwrite)


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


def _representatives(
    source: HasFrames | Molecule, count: int, structure: _core.Structure, site: str
) -> list[int]:
    """Numbers of the frames."""
    path, _folder = file_of(source, "representatives")
    by = " ".join(["index", *map(str, site_of(structure, site))]) if site else None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found, _ = shapes.medoids(
            stages.opened(analysis.AnalysisOptions(path, superpose=by)), count
        )
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
