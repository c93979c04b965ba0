# SPDX-License-Identifier: MIT
"""What the function ``pliant.conformers`` does."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pliant._core import Error, OptionError, PliantWarning, Structure
from pliant.base.extras import MissingPackageError, need
from pliant.base.refusals import shown
from pliant.jobs.conformers.ligand import part_of
from pliant.jobs.conformers.make import make
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import (
    LIGANDS,
    format_of,
    is_library,
    read_records,
    short,
    smiles_record,
)
from pliant.jobs.conformers.repeated import Repeated, canonical_smiles
from pliant.jobs.conformers.results import Conformers, FailedMolecule
from pliant.jobs.conformers.subject import Subject, subject_of, subject_of_mol, subject_of_structure


def found(molecule: Any, given: Mapping[str, Any]) -> Any:
    """Behind ``pliant.conformers``, which says what is given and returned."""
    options = ConformerOptions(**given)
    options.check_energy()
    kind = options.molecule.get("format")
    if isinstance(molecule, (str, os.PathLike)) and (kind or _is_path(molecule)):
        options.check_source(is_ligand=format_of(molecule, kind) in LIGANDS)
        return _of_path(molecule, options)
    if _is_molecule(molecule):
        return _of_one(molecule, options, _name(molecule) or "the molecule")
    if isinstance(molecule, Iterable):
        return _of_many(molecule, options)
    raise TypeError(
        f"molecule = {shown(molecule)}: must be an rdkit.Chem.Mol, a SMILES, a Structure, a path "
        "or an iterable of molecules"
    )


def _is_path(given: str | os.PathLike[str]) -> bool:
    return not isinstance(given, str) or is_library(given)


def _is_mol(given: object) -> bool:
    return hasattr(given, "GetConformers") and hasattr(given, "GetAtoms")


def _is_molecule(given: object) -> bool:
    return isinstance(given, (str, Structure)) or _is_mol(given)


def _of_one(
    given: Any, options: ConformerOptions, place: str, repeated: Repeated | None = None
) -> Any:
    found = _found(_subject(given, options), options, place, repeated=repeated)
    return found if isinstance(given, Structure) else found.to_rdkit()


def _found(
    subject: Subject,
    options: ConformerOptions,
    place: str,
    number: int = 1,
    repeated: Repeated | None = None,
) -> Conformers:
    """Its conformers, and warnings of what was guessed, or was there before."""
    made = make(subject, options, options.threads)
    if repeated is not None:
        subject.warnings += repeated.warnings(canonical_smiles(subject), place)
    for text in subject.warnings:
        warnings.warn(f"{place}: {text}", PliantWarning, stacklevel=5)
    return Conformers(made, number)


def _subject(given: Any, options: ConformerOptions) -> Subject:
    options.check_source(is_ligand=isinstance(given, Structure))
    if isinstance(given, str):
        need("a SMILES", "rdkit")
        return subject_of(smiles_record(given), options)
    if isinstance(given, Structure):
        return subject_of_structure(part_of(given, options.molecule), options)
    return subject_of_mol(given, options)


def _of_path(
    path: str | os.PathLike[str], options: ConformerOptions
) -> Iterator[Conformers | FailedMolecule]:
    repeated = Repeated()
    for record in read_records(path, options):
        place = _called(record.place, record.name)
        try:
            subject = subject_of(record, options)
            yield _found(subject, options, place, record.number, repeated)
        except MissingPackageError:
            raise
        except (Error, ValueError, RuntimeError) as error:
            yield FailedMolecule(record.number, record.name, str(error))


def _of_many(given: Iterable[Any], options: ConformerOptions) -> Iterator[Any]:
    repeated = Repeated()
    for number, molecule in enumerate(given, 1):
        name = ""
        try:
            if not _is_molecule(molecule):
                raise OptionError(
                    f"molecule {number}: expected an rdkit.Chem.Mol, a SMILES or a Structure, "
                    f"found {shown(molecule)}"
                )
            name = _name(molecule)
            place = _called(f"molecule {number}", name)
            yield _of_one(molecule, options, place, repeated)
        except MissingPackageError:
            raise
        except (Error, ValueError, RuntimeError) as error:
            yield FailedMolecule(number, name, str(error))


def _called(place: str, name: str) -> str:
    return f"{place} ({short(name)})" if name else place


def _name(molecule: Any) -> str:
    if isinstance(molecule, str):
        return molecule
    if isinstance(molecule, Structure):
        return molecule.title
    return str(molecule.GetProp("_Name")) if molecule.HasProp("_Name") else ""
