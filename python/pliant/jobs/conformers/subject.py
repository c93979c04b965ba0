# SPDX-License-Identifier: MIT
"""One molecule that is ready to be drawn from: 3-D, one component, with its hydrogens."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import InputError, Structure
from pliant.adapters.rdkit import from_rdkit
from pliant.adapters.smiles import MOST_ATOMS, embed, parsed_smiles
from pliant.base.extras import late, need
from pliant.base.said import noted
from pliant.jobs.conformers.axes import are_given
from pliant.jobs.conformers.hydrogens import (
    check_addable,
    completed,
    is_bare,
    labels_of,
    missing_hydrogens,
    names_of,
    numbered,
)
from pliant.jobs.conformers.ligand import needs_orders, ordered, read_ligand
from pliant.jobs.conformers.mol_block import MolBlock, block_of, filled, one_line, parse
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.parts import check_elements, check_elements_of_mol, kept_part
from pliant.jobs.conformers.records import Record
from pliant.jobs.conformers.v3000 import fits_v2000, text_of

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")
rdBase = late("rdkit.rdBase")

HEADER = ("_Name", "_MolFileInfo", "_MolFileComments")  #: lines of a record, as RDKit calls them


@dataclass
class Subject:
    """A molecule, and how its conformers are written."""

    structure: Structure
    block: MolBlock
    name: str = ""
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)  #: what was guessed of it
    given: Mol | None = None  #: RDKit's own, where it was given or made
    hands_open: bool = False  #: those of axes: made 3-D, of what gave none

    @cached_property
    def _form(self) -> str:
        return self.block.form()

    def text(self, positions: npt.NDArray[np.float64]) -> str:
        """The record with positions (N, 3), Angstrom, without data items."""
        if self.block.is_v3000 or fits_v2000(self.block, positions):
            return filled(self._form, positions)
        return text_of(self.block, positions, self.structure.masses)

    @cached_property
    def molecule(self) -> Mol:
        """RDKit's molecule, with all hydrogens. Raises InputError where it cannot be made."""
        if self.given is not None:
            return self.given
        text = self.text(self.structure.positions)
        return _read_by_rdkit(text, self.name or "the molecule")


def subject_of(record: Record, options: ConformerOptions) -> Subject:
    """The molecule of a record. Raises InputError, which says what is wrong and what helps."""
    if record.fault:
        raise InputError(f"{record.place}: {record.fault}")
    if record.is_smiles:
        return _of_smiles(record, options)
    if record.format != "sdf":
        return _of_ligand(record, options)
    with noted() as notes:
        structure = _core.read_text(_text_of(record), record.place, format="sdf")
    block = parse(record.text)
    check_elements(
        structure, [(before + after).split()[0] for before, after in block.atoms], record.place
    )
    parts, labels = block.components(), numbered(structure.symbols)
    if len(parts) > 1:
        kept, said = kept_part(_symbols(structure, parts), record.place)
        labels = [labels[k] for k in parts[kept]]
        notes.append(said)
        block = block.part(parts[kept])
        text = text_of(block, structure.positions[parts[kept]], structure.masses[parts[kept]])
        with noted():
            structure = _core.read_text(text, record.place, format="sdf")
    missing = missing_hydrogens(structure, block.radicals)
    if structure.is_drawing or is_bare(structure, missing):
        what = "a 2-D drawing" if structure.is_drawing else "without its hydrogens"
        if not options.embed:
            raise InputError(f"{record.place}: the molecule is {what}: {options.remedy}")
        return _embedded_record(record, block, structure, notes, options)
    notes = [note for note in notes if "all atoms have z = 0" not in note]
    subject = Subject(structure, block, record.name, notes)
    return _completed(subject, missing, labels, record.place) if missing else subject


def _text_of(record: Record) -> str:
    return record.text.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def _of_ligand(record: Record, options: ConformerOptions) -> Subject:
    with noted() as notes:
        structure = read_ligand(_text_of(record), record.place, record.format, options.molecule)
    most = max(map(len, block_of(structure).components()))
    if most > MOST_ATOMS:
        raise InputError(
            f"{record.place}: expected one ligand of at most {MOST_ATOMS} atoms, found a molecule "
            f"of {most}; pliant sample takes proteins"
        )
    if most == 1 and options.smiles is None:
        raise InputError(f"{record.place}: expected one ligand, found atoms without any bond")
    subject = subject_of_structure(structure, options, record.name)
    subject.notes[:0] = notes
    if structure.model_count > 1 and "frame" not in options.molecule:
        subject.warnings.insert(0, f"the first of {structure.model_count} models is used")
    return subject


def subject_of_mol(
    molecule: Mol, options: ConformerOptions, place: str = "the molecule"
) -> Subject:
    """Of a molecule of RDKit; one without conformers is embedded, with hydrogens."""
    name = one_line(molecule.GetProp("_Name")) if molecule.HasProp("_Name") else ""
    check_elements_of_mol(molecule, place)
    notes, whole = [], molecule
    parts = Chem.GetMolFrags(molecule, asMols=True)
    labels = labels_of(molecule)
    if len(parts) > 1:
        symbols = [[atom.GetSymbol() for atom in part.GetAtoms()] for part in parts]
        kept, said = kept_part(symbols, place)
        notes.append(said)
        molecule = parts[kept]
        labels = [labels[k] for k in Chem.GetMolFrags(whole)[kept]]
        for key, value in whole.GetPropsAsDict(
            includePrivate=True, autoConvertStrings=False
        ).items():
            if isinstance(value, str):
                molecule.SetProp(key, value)
    lacking = [atom.GetIdx() for atom in molecule.GetAtoms() if atom.GetTotalNumHs()]
    bare = lacking and all(atom.GetAtomicNum() > 1 for atom in molecule.GetAtoms())
    has_positions = molecule.GetNumConformers() > 0
    is_flat = has_positions and not molecule.GetConformer().Is3D()
    if has_positions and (bare or is_flat) and not options.embed:
        what = "a 2-D drawing" if is_flat else "without its hydrogens"
        raise InputError(f"{place}: the molecule is {what}: {options.remedy}")
    if bare or is_flat or not has_positions:
        return _embedded(molecule, name, notes, options, place)
    made, warned = completed(molecule, lacking, labels)
    subject = _of_whole_mol(made, name, notes)
    subject.warnings += warned
    return subject


def subject_of_structure(
    structure: Structure, options: ConformerOptions, name: str = ""
) -> Subject:
    """Of a structure with bonds; RDKit finds bond orders where not all are known."""
    place = structure.source or structure.title or "the structure"
    check_elements(structure, structure.symbols.tolist(), place)
    block = block_of(structure)
    parts, notes, labels = block.components(), list[str](), names_of(structure)
    if len(parts) > 1:
        largest, said = kept_part(_symbols(structure, parts), place)
        kept = parts[largest]
        labels = [labels[k] for k in kept]
        notes.append(said)
        block, is_kept = block.part(kept), "index " + " ".join(map(str, kept))
        with noted():
            structure = structure.select(is_kept)
    if needs_orders(structure, options):
        molecule, more, warned = ordered(structure, options, place)
        molecule.SetProp("_Name", name or structure.title)
        subject = subject_of_mol(molecule, options, place)
        subject.notes[:0], subject.warnings[:0] = notes + more, warned
        return subject
    missing = missing_hydrogens(structure, block.radicals)
    if structure.is_drawing or is_bare(structure, missing):
        what, remedy = "without its hydrogens", f"{options.asked_smiles} gives them"
        if structure.is_drawing:
            what = "a 2-D drawing"
            remedy = "pliant.conformers(pliant.to_rdkit(structure), embed=True)"
        raise InputError(f"{place}: the molecule is {what}: {remedy}")
    block.title = name or structure.title
    subject = Subject(structure, block, block.title, notes)
    return _completed(subject, missing, labels, place) if missing else subject


def _symbols(structure: Structure, parts: list[list[int]]) -> list[list[str]]:
    return [structure.symbols[part].tolist() for part in parts]


def _completed(subject: Subject, missing: dict[int, int], labels: list[str], place: str) -> Subject:
    """With the hydrogens that are missing; as it was where RDKit finds that none is."""
    check_addable(missing, labels, place)
    molecule = _read_by_rdkit(subject.text(subject.structure.positions), place)
    molecule.GetConformer().SetPositions(subject.structure.positions)  # with all digits
    made, warned = completed(molecule, missing, labels)
    if not warned:
        return subject
    whole = _of_whole_mol(made, subject.name, subject.notes)
    whole.warnings += warned
    return _with_text_of(subject.block, whole)


def _with_text_of(block: MolBlock, made: Subject) -> Subject:
    """Title, comment and data items of a record for what was made of it."""
    made.block.title, made.block.comment, made.block.items = block.title, block.comment, block.items
    return made


def _of_whole_mol(molecule: Mol, name: str, notes: list[str]) -> Subject:
    with noted():
        structure = from_rdkit(molecule)
    headed = Chem.Mol(molecule)
    for key in HEADER:
        if headed.HasProp(key):
            headed.SetProp(key, one_line(headed.GetProp(key)))
    return Subject(structure, parse(Chem.MolToMolBlock(headed)), name, notes, given=molecule)


def _of_smiles(record: Record, options: ConformerOptions) -> Subject:
    need("a SMILES", "rdkit")
    try:
        molecule = parsed_smiles(record.text)
    except InputError as error:
        raise InputError(f"{record.place}: {error}") from None
    molecule.SetProp("_Name", record.name or record.text)
    subject = subject_of_mol(molecule, options, record.place)
    subject.block.items = "".join(f"> <{name}>\n{value}\n\n" for name, value in record.items)
    return subject


def _embedded(
    molecule: Mol, name: str, notes: list[str], options: ConformerOptions, place: str
) -> Subject:
    made = Chem.Mol(molecule)
    was_flat = not (made.GetNumConformers() and made.GetConformer().Is3D())
    if not was_flat:
        Chem.AssignStereochemistryFrom3D(made)
    made = Chem.AddHs(Chem.RemoveHs(made, sanitize=True))
    left_open = embed(made, place, options.seed)
    subject = _of_whole_mol(made, name, notes)
    subject.warnings += [left_open] if left_open else []
    subject.hands_open = was_flat and not are_given(molecule)
    return subject


def _embedded_record(
    record: Record,
    block: MolBlock,
    structure: Structure,
    notes: list[str],
    options: ConformerOptions,
) -> Subject:
    need(f"{options.dashes}embed", "rdkit")

    text = text_of(block, structure.positions, structure.masses)
    if structure.is_drawing:  # so that RDKit reads stereo from wedges
        text = text.replace("  Pliant            3D", "  Pliant            2D", 1)
    molecule = _read_by_rdkit(text, record.place)
    made = _embedded(molecule, record.name, notes, options, record.place)
    made.notes.append("made 3-D by RDKit, with hydrogens")
    return _with_text_of(block, made)


def _read_by_rdkit(text: str, place: str) -> Mol:
    with rdBase.BlockLogs():
        molecule: Mol = Chem.MolFromMolBlock(text, removeHs=False)
    if molecule is None:
        raise InputError(f"{place}: RDKit does not accept the molecule")
    return molecule
