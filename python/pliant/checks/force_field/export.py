# SPDX-License-Identifier: MIT
"""Frames as systems that OpenMM, GROMACS or AMBER run: topology, parameters and positions."""

from __future__ import annotations

import itertools
import os
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.base.extras import need
from pliant.base.force_field_options import PROGRAMS, ForceFieldOptions
from pliant.base.new_file import check_folder, expect_none, write_bytes
from pliant.checks.force_field.jobs import Bench, deadline_in
from pliant.checks.force_field.minimise import Wanted
from pliant.checks.force_field.minimised import SHORT
from pliant.checks.force_field.molecule import Molecule, molecule_of, why_not
from pliant.checks.openmm.child import Job

LONGEST_NAME = 4  #: of an atom, in a PDB file


@dataclass(frozen=True)
class Exported:
    """What was written, and of what."""

    files: list[str]
    atoms: int  #: of the system
    notes: list[str]  #: what was taken for what, and left out


def export(
    structure: Structure,
    frames: npt.NDArray[np.float64],
    numbers: Sequence[int],
    folder: str | os.PathLike[str],
    to: str,
    options: ForceFieldOptions,
    say: Callable[[str], None] = lambda _: None,
    *,
    overwrite: bool = False,
) -> Exported:
    """Writes frames (F, N, 3), Angstrom, each minimised for 100 steps first; `numbers` name them.

    The folder gets one topology with parameters, system.xml, system.top or system.prmtop, and
    frame-0007.pdb, .gro or .inpcrd of each frame. Raises InputError where a frame or the molecule
    cannot be minimised, MissingPackageError for what is missing, FileError where a file is there.
    """
    need(f"--to {to}", *PROGRAMS[to][1])
    check_folder(Path(folder))
    names = [f"frame-{number:04d}" for number in numbers]
    of_system, of_frame = PROGRAMS[to][2]
    written = [f"system{of_system}", *(f"{name}{of_frame}" for name in names)]
    expect_none([Path(folder) / name for name in written], overwrite)
    place = structure.source or "the molecule"
    if reason := why_not(structure):
        raise InputError(f"{place}: the force field is for proteins: {reason}")
    molecule = molecule_of(structure, options, say)
    bench = Bench(molecule, Wanted.time_limit, deadline_in(Wanted.total_limit))
    matched = bench.match()
    if not matched.done:
        raise InputError(f"{place}: {matched.message}")
    bench.choose(options.platform, matched.arrays["platforms"].tolist())
    places = _minimised(bench, [molecule.complete(frame) for frame in frames], numbers)
    with tempfile.TemporaryDirectory(prefix="pliant-export-") as made:
        (outcome,) = bench.run([_job(bench, structure, molecule, places, to, names, made)])
        if not outcome.done:
            raise InputError(f"{place}: {outcome.brief()}")
        files = [_kept(file, Path(folder), overwrite) for file in sorted(Path(made).iterdir())]
    notes = [*molecule.notes, *(f"left out: {k}: {why}" for k, why in molecule.why.items())]
    return Exported(files, len(molecule.elements), notes)


def _kept(file: Path, folder: Path, overwrite: bool) -> str:
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / file.name
    write_bytes(target, file.read_bytes(), overwrite=overwrite)
    return os.fspath(target)


def _minimised(
    bench: Bench, places: Sequence[np.ndarray], numbers: Sequence[int]
) -> npt.NDArray[np.float64]:
    """(F, M, 3) nm."""
    outcomes = bench.run([bench.minimising(x, [SHORT]) for x in places])
    for number, one in zip(numbers, outcomes, strict=True):
        if not one.done or not np.isfinite(one.arrays["positions"]).all():
            raise InputError(f"frame {number}: cannot be minimised: {one.brief()}")
    return np.array([one.arrays["positions"][-1] for one in outcomes])


def _job(
    bench: Bench,
    structure: Structure,
    molecule: Molecule,
    places: npt.NDArray[np.float64],
    to: str,
    names: Sequence[str],
    folder: str,
) -> Job:
    columns = {
        "atom_names": full_names(molecule),
        "chains": structure.chains[molecule.firsts],
        "residue_names": structure.residue_names[molecule.firsts],
        "residue_ids": structure.residue_ids[molecule.firsts],
        "files": np.array(names),
        "structures": places,
    }
    known = bench.match_job()
    return Job("export", {"to": to, "folder": folder}, {**known.arrays, **columns})


def full_names(molecule: Molecule) -> npt.NDArray[np.str_]:
    """(M,) names of atoms, no two alike in a residue: hydrogens placed at CB are HB2 and HB3."""
    names = molecule.names.astype("U8")
    taken = {*zip(molecule.residue_of.tolist(), names.tolist(), strict=True)}
    for parent, placed in _placed(molecule).items():
        residue = int(molecule.residue_of[parent])
        first = 2 if len(placed) == 2 else 1
        for number, k in enumerate(placed, first):
            wanted = "H" + str(names[parent])[1:] + str(number) * (len(placed) > 1)
            names[k] = _free(wanted, residue, taken)
            taken.add((residue, str(names[k])))
    return names


def _placed(molecule: Molecule) -> dict[int, list[int]]:
    """Hydrogens that were placed, by the atom that carries them."""
    found: dict[int, list[int]] = {}
    is_placed = (molecule.names == "H") & (molecule.elements == 1)
    for pair in molecule.bonds.tolist():
        for k, parent in (pair, pair[::-1]):
            if is_placed[k] and molecule.names[parent] != "N":
                found.setdefault(parent, []).append(k)
    return found


def _free(wanted: str, residue: int, taken: set[tuple[int, str]]) -> str:
    """The name, or where it is too long or taken H1, H2, ..."""
    if len(wanted) <= LONGEST_NAME and (residue, wanted) not in taken:
        return wanted
    return next(f"H{k}" for k in itertools.count(1) if (residue, f"H{k}") not in taken)
