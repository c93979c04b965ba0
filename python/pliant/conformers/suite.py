# SPDX-License-Identifier: MIT
"""The function ``pliant.conformers``."""

from __future__ import annotations

import inspect
import os
import warnings
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from pliant._core import Error, OptionError, PliantWarning, Structure, conformer_rows
from pliant._extras import MissingPackageError, need
from pliant._processes import usual_workers
from pliant._refusals import refuse_unknown, shown
from pliant.conformers.ligand import part_of
from pliant.conformers.make import make
from pliant.conformers.options import ConformerOptions
from pliant.conformers.records import (
    LIGANDS,
    format_of,
    is_library,
    read_records,
    short,
    smiles_record,
)
from pliant.conformers.repeated import Repeated, canonical_smiles
from pliant.conformers.results import Conformers, FailedMolecule
from pliant.conformers.subject import Subject, subject_of, subject_of_mol, subject_of_structure

if TYPE_CHECKING:
    from rdkit.Chem import Mol


def conformers(
    molecule: Mol | Structure | str | os.PathLike[str] | Iterable[Any],
    n: int = 50,
    *,
    frames: int | None = None,
    starts: int = 5,
    rms: float = 0.5,
    window: float | None = None,
    energy: str = "own",
    minimise: bool = False,
    seed: int = 0,
    embed: bool = False,
    salts: str = "largest",
    amides: bool = False,
    max_input: int = 2_000_000_000,
    smiles: str | None = None,
    threads: int | None = None,
    **molecule_options: Any,
) -> Any:
    """Return ranked conformers of a molecule, or an iterator over those of a library.

    Candidates are drawn from several starts without overlaps, those that are alike are left out,
    and at most `n` are kept, lowest energy first. Lengths and angles are those of the start.

    Parameters
    ----------
    molecule : rdkit.Chem.Mol, SMILES, Structure, path or iterable
        One molecule; or a library: the path of an SDF, MOL or SMILES file (also compressed), or of
        a PDB, mmCIF or XYZ file of one ligand, or an iterable of molecules. A molecule without
        positions is embedded by RDKit, with hydrogens.
    n : int
        Conformers, at most.
    frames : int, optional
        Candidates drawn, from all starts together. Default: 500, or 2 `n` if that is more.
    starts : int
        Structures with lengths and angles of their own to draw from; 1: as given.
    rms : float
        Conformers nearer than this to a better one are left out (Angstrom, heavy atoms); 0: none.
    window : float, optional
        Those more than this above the lowest energy are left out (kcal/mol).
    energy : str
        ``"own"`` (usual torsions and near atoms), ``"MMFF94s"`` or ``"UFF"`` (of RDKit),
        ``"auto"`` (MMFF94s, else UFF, where RDKit is installed, else our own), ``"none"``, or the
        path of a force field of OpenMM (.xml).
    minimise : bool
        Minimise by the energy: lengths and angles are then the force field's.
    seed : int
        Of all that is drawn.
    embed : bool
        Make 2-D drawings, and molecules without hydrogens, 3-D by RDKit.
    salts : str
        Of several molecules in one: ``"largest"`` is kept, or ``"refuse"``.
    amides : bool
        Secondary amides are cis and trans, too.
    max_input : int
        Bytes that a file may have, and expand to. What is larger is refused.
    smiles : str, optional
        Of a structure, or the ligand of a PDB, mmCIF or XYZ file: bond orders, charges and
        hydrogens are those of this SMILES, and heavy atoms stay where they are. Without it RDKit
        guesses orders that are not known from the hydrogens, if all are there.
    threads : int, optional
        Changes no result. By default as many as cores.
    **molecule_options
        Of a structure, or the ligand of a PDB, mmCIF or XYZ file: `select`, `assembly`, `keep`,
        `keep_waters`, `fill_side_chains`, `all_hydrogens` and `protonate` as for ``prepare``, which
        is called where one of the last five is given; `frame`, `format` and `distance_bonds` of the
        file as for ``pliant sample``.

    Returns
    -------
    rdkit.Chem.Mol, Conformers or iterator
        A Mol, with its properties and hydrogens, for a Mol or a SMILES: each conformer has the
        properties pliant_energy (kcal/mol) and pliant_start. Conformers for a Structure. For a
        library one of these after the other (Conformers for a path), in its order, and a
        `FailedMolecule`, which is false, for each molecule that fails.

    Raises
    ------
    ImportError
        RDKit or OpenMM is needed and not installed; the message says how to install it.
    InputError, OptionError, FileError
        A single molecule cannot be used, or an option is wrong; a library cannot be read.

    Warns
    -----
    PliantWarning
        Stereo of a molecule that is made 3-D is not given: one isomer is made. Hydrogens that were
        missing are added. Bond orders or charges of a ligand are guessed. A molecule of a library
        was there before: it is done again.
    """
    options = ConformerOptions(
        n,
        frames,
        starts,
        rms,
        window,
        energy,
        minimise,
        seed,
        embed,
        salts,
        amides,
        max_input,
        smiles,
        _given(molecule_options),
    )
    options.check()
    workers = usual_workers() if threads is None else threads
    kind = options.molecule.get("format")
    if isinstance(molecule, (str, os.PathLike)) and (kind or _is_path(molecule)):
        _check_source(options, is_ligand=format_of(molecule, kind) in LIGANDS)
        return _of_path(molecule, options, workers)
    if _is_molecule(molecule):
        return _of_one(molecule, options, workers, _name(molecule) or "the molecule")
    if isinstance(molecule, Iterable):
        return _of_many(molecule, options, workers)
    raise TypeError(
        f"molecule = {shown(molecule)}: must be an rdkit.Chem.Mol, a SMILES, a Structure, a path "
        "or an iterable of molecules"
    )


def _given(named: dict[str, Any]) -> dict[str, Any]:
    """What is not as usual. Raises TypeError for a name that there is not."""
    usual = {row["name"]: row["default"] for row in conformer_rows() if row["name"] != "max_input"}
    refuse_unknown("conformers", [*inspect.signature(conformers).parameters, *usual], named)
    return {name: x for name, x in named.items() if x not in (None, usual[name], ())}


def _is_path(given: str | os.PathLike[str]) -> bool:
    return not isinstance(given, str) or is_library(given)


def _is_mol(given: object) -> bool:
    return hasattr(given, "GetConformers") and hasattr(given, "GetAtoms")


def _is_molecule(given: object) -> bool:
    return isinstance(given, (str, Structure)) or _is_mol(given)


def _of_one(
    given: Any,
    options: ConformerOptions,
    threads: int,
    place: str,
    repeated: Repeated | None = None,
) -> Any:
    found = _found(_subject(given, options), options, threads, place, repeated=repeated)
    return found if isinstance(given, Structure) else found.to_rdkit()


def _found(
    subject: Subject,
    options: ConformerOptions,
    threads: int,
    place: str,
    number: int = 1,
    repeated: Repeated | None = None,
) -> Conformers:
    """Its conformers, and warnings of what was guessed, or was there before."""
    made = make(subject, options, threads)
    if repeated is not None:
        subject.warnings += repeated.warnings(canonical_smiles(subject), place)
    for text in subject.warnings:
        warnings.warn(f"{place}: {text}", PliantWarning, stacklevel=5)
    return Conformers(made, number)


def _check_source(options: ConformerOptions, *, is_ligand: bool) -> None:
    options.check_source(is_ligand=is_ligand)
    if options.smiles is not None and not is_ligand:
        raise OptionError(
            "smiles: expected None, or as molecule a Structure, or a PDB, mmCIF or XYZ file"
        )


def _subject(given: Any, options: ConformerOptions) -> Subject:
    _check_source(options, is_ligand=isinstance(given, Structure))
    if isinstance(given, str):
        need("a SMILES", "rdkit")
        return subject_of(smiles_record(given), options)
    if isinstance(given, Structure):
        return subject_of_structure(part_of(given, options.molecule), options)
    return subject_of_mol(given, options)


def _of_path(
    path: str | os.PathLike[str], options: ConformerOptions, threads: int
) -> Iterator[Conformers | FailedMolecule]:
    repeated = Repeated()
    for record in read_records(path, options):
        place = _called(record.place, record.name)
        try:
            subject = subject_of(record, options)
            yield _found(subject, options, threads, place, record.number, repeated)
        except MissingPackageError:
            raise
        except (Error, ValueError, RuntimeError) as error:
            yield FailedMolecule(record.number, record.name, str(error))


def _of_many(given: Iterable[Any], options: ConformerOptions, threads: int) -> Iterator[Any]:
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
            yield _of_one(molecule, options, threads, place, repeated)
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
