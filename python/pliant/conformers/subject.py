# SPDX-License-Identifier: MIT
"""One molecule that is ready to be drawn from: 3-D, one component, with its hydrogens."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import InputError, Structure
from pliant._extras import need
from pliant._refusals import shown
from pliant._said import noted
from pliant.conformers.hydrogens import check_addable, completed, is_bare, missing_hydrogens
from pliant.conformers.mol_block import MolBlock, block_of, filled, one_line, parse
from pliant.conformers.options import ConformerOptions
from pliant.conformers.records import Record
from pliant.conformers.v3000 import fits_v2000, text_of

if TYPE_CHECKING:
    from rdkit.Chem import Mol

HEADER = ("_Name", "_MolFileInfo", "_MolFileComments")  #: lines of a record, as RDKit calls them
COUNTER_IONS = frozenset("Li Na K Rb Cs Fr Be Mg Ca Sr Ba Ra".split())


@dataclass
class Subject:
    """A molecule, and how its conformers are written."""

    structure: Structure
    block: MolBlock
    name: str = ""
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)  #: what was guessed of it
    given: Mol | None = None  #: RDKit's own, where it was given or made

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
    with noted() as notes:
        structure = _core.read_text(record.text, record.place, format="sdf")
    block = parse(record.text)
    _check_elements(
        structure, [(before + after).split()[0] for before, after in block.atoms], record.place
    )
    parts, labels = block.components(), _labels(structure.symbols.tolist())
    if len(parts) > 1:
        kept = largest([(_heavy(structure, part), len(part)) for part in parts])
        labels = [labels[k] for k in parts[kept]]
        notes.append(_salt_note(len(parts), options, record.place))
        _check_left_out(_symbols(structure, parts), kept, record.place)
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


def subject_of_mol(
    molecule: Mol, options: ConformerOptions, place: str = "the molecule"
) -> Subject:
    """Of a molecule of RDKit; one without conformers is embedded, with hydrogens."""
    from rdkit import Chem

    name = one_line(molecule.GetProp("_Name")) if molecule.HasProp("_Name") else ""
    _check_elements_of_mol(molecule, place)
    notes, whole = [], molecule
    parts = Chem.GetMolFrags(molecule, asMols=True)
    labels = _labels(atom.GetSymbol() for atom in molecule.GetAtoms())
    if len(parts) > 1:
        notes.append(_salt_note(len(parts), options, place))
        sizes = [(part.GetNumHeavyAtoms(), part.GetNumAtoms()) for part in parts]
        kept = largest(sizes)
        symbols = [[atom.GetSymbol() for atom in part.GetAtoms()] for part in parts]
        _check_left_out(symbols, kept, place)
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


def subject_of_structure(structure: Structure, options: ConformerOptions) -> Subject:
    """Of a structure with bonds, whose bond orders are known."""
    place = structure.source or structure.title or "the structure"
    _check_elements(structure, structure.symbols.tolist(), place)
    block = block_of(structure)
    parts, notes = block.components(), list[str]()
    labels = _labels(structure.symbols.tolist())
    if len(parts) > 1:
        largest_part = largest([(_heavy(structure, part), len(part)) for part in parts])
        kept = parts[largest_part]
        labels = [labels[k] for k in kept]
        notes.append(_salt_note(len(parts), options, place))
        _check_left_out(_symbols(structure, parts), largest_part, place)
        block, is_kept = block.part(kept), "index " + " ".join(map(str, kept))
        with noted():
            structure = structure.select(is_kept)
    missing = missing_hydrogens(structure, block.radicals)
    if structure.is_drawing or is_bare(structure, missing):
        what = "a 2-D drawing" if structure.is_drawing else "without its hydrogens"
        raise InputError(
            f"{place}: the molecule is {what}: "
            "pliant.conformers(pliant.to_rdkit(structure), embed=True)"
        )
    subject = Subject(structure, block, structure.title, notes)
    return _completed(subject, missing, labels, place) if missing else subject


def _labels(symbols: Iterable[str]) -> list[str]:
    return [f"{symbol}{number}" for number, symbol in enumerate(symbols, 1)]


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
    from rdkit import Chem

    from pliant.adapters.rdkit import from_rdkit

    with noted():
        structure = from_rdkit(molecule)
    headed = Chem.Mol(molecule)
    for key in HEADER:
        if headed.HasProp(key):
            headed.SetProp(key, one_line(headed.GetProp(key)))
    return Subject(structure, parse(Chem.MolToMolBlock(headed)), name, notes, given=molecule)


def _of_smiles(record: Record, options: ConformerOptions) -> Subject:
    need("a SMILES", "rdkit")
    from pliant.adapters.smiles import parsed_smiles

    try:
        molecule = parsed_smiles(record.text)
    except InputError as error:
        raise InputError(f"{record.place}: {error}") from None
    molecule.SetProp("_Name", record.name or record.text)
    return subject_of_mol(molecule, options, record.place)


def _embedded(
    molecule: Mol, name: str, notes: list[str], options: ConformerOptions, place: str
) -> Subject:
    from rdkit import Chem

    from pliant.adapters.smiles import embed

    made = Chem.Mol(molecule)
    if made.GetNumConformers() and made.GetConformer().Is3D():
        Chem.AssignStereochemistryFrom3D(made)
    made = Chem.AddHs(Chem.RemoveHs(made, sanitize=True))
    left_open = embed(made, place, options.seed)
    subject = _of_whole_mol(made, name, notes)
    subject.warnings += [left_open] if left_open else []
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
    from rdkit import Chem, rdBase

    with rdBase.BlockLogs():
        molecule = Chem.MolFromMolBlock(text, removeHs=False)
    if molecule is None:
        raise InputError(f"{place}: RDKit does not accept the molecule")
    return molecule


def largest(sizes: list[tuple[int, int]]) -> int:
    """The part with most heavy atoms, then most atoms; the first of equals."""
    return max(range(len(sizes)), key=lambda k: (*sizes[k], -k))


def _heavy(structure: Structure, part: list[int]) -> int:
    return int(np.count_nonzero(structure.elements[part] != 1))


def _symbols(structure: Structure, parts: list[list[int]]) -> list[list[str]]:
    return [structure.symbols[part].tolist() for part in parts]


def _check_elements(structure: Structure, written: list[str], place: str) -> None:
    for k in np.flatnonzero(structure.elements == 0).tolist():
        raise InputError(f"{place}: atom {k + 1} is {shown(written[k])}: expected an element")


def _check_elements_of_mol(molecule: Mol, place: str) -> None:
    for atom in molecule.GetAtoms():
        if atom.GetAtomicNum() == 0:
            symbol = shown(atom.GetSymbol())
            raise InputError(f"{place}: atom {atom.GetIdx() + 1} is {symbol}: expected an element")


def _check_left_out(parts: list[list[str]], kept: int, place: str) -> None:
    """Raises InputError where a metal that is no counter-ion would be left out."""
    from pliant.adapters.smiles import metals_in

    for k, symbols in enumerate(parts):
        is_ion = len(symbols) == 1 and symbols[0] in COUNTER_IONS
        if k != kept and not is_ion and (metals := metals_in(symbols)):
            raise InputError(
                f"{place}: the metal {', '.join(metals)} is not bonded to the largest of "
                f"{len(parts)} molecules: only lone ions of groups 1 and 2 are left out"
            )


def _salt_note(parts: int, options: ConformerOptions, place: str) -> str:
    if options.salts == "refuse":
        raise InputError(
            f"{place}: expected one molecule, found {parts}; {options.dashes}salts largest keeps "
            "the largest"
        )
    return f"the largest of {parts} molecules is kept"
