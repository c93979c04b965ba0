# SPDX-License-Identifier: MIT
"""RDKit: a molecule with a conformer as a structure, and frames as conformers."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, PliantWarning, Structure
from pliant.base.checked import checked, having
from pliant.base.extras import late, need
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import Trajectory

_WANTED = 'an rdkit.Chem.Mol, such as Chem.MolFromMolFile("x.sdf", removeHs=False)'

if TYPE_CHECKING:
    from rdkit.Chem import Conformer, Mol

Chem = late("rdkit.Chem")


@checked(molecule=having("GetConformers", _WANTED))
def from_rdkit(molecule: Mol, conformer: int = -1) -> Structure:
    """Return an RDKit molecule as a structure: its atoms, bonds with orders, and one conformer.

    Parameters
    ----------
    molecule : rdkit.Chem.Mol
    conformer : int
        Id of the conformer (Angstrom); -1 for the first.

    Raises
    ------
    InputError
        The molecule has no such conformer.

    Warns
    -----
    PliantWarning
        Implicit hydrogens are left out, as they have no positions.
    """
    ids = [known.GetId() for known in molecule.GetConformers()]
    if not ids:
        raise InputError(
            "the molecule has no conformer, so that its atoms have no positions: make one with "
            "molecule = Chem.AddHs(molecule); AllChem.EmbedMolecule(molecule, randomSeed=1)"
        )
    if conformer != -1 and conformer not in ids:
        raise InputError(f"the molecule has no conformer {conformer}; it has {ids}")
    _warn_of_implicit_hydrogens(molecule)
    atoms = list(molecule.GetAtoms())
    places = [_place(atom) for atom in atoms]
    bonds = list(molecule.GetBonds())
    structure = Structure(
        molecule.GetConformer(conformer).GetPositions(),
        elements=[atom.GetAtomicNum() for atom in atoms],
        names=[name for name, *_ in places],
        residue_names=[name for _, name, *_ in places],
        residue_ids=[number for *_, number, _, _ in places],
        insertion_codes=[code for *_, code, _ in places],
        chains=[chain for *_, chain in places],
        bonds=[(bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()) for bond in bonds],
        bond_orders=[_order(bond) for bond in bonds],
        charges=[atom.GetFormalCharge() for atom in atoms],
        title=molecule.GetProp("_Name") if molecule.HasProp("_Name") else "",
    )
    structure.gather_residues()
    return structure


def rdkit_frames(molecule: Mol) -> npt.NDArray[np.float64]:
    """(F, N, 3) Angstrom: all conformers."""
    return np.array([conformer.GetPositions() for conformer in molecule.GetConformers()])


def to_rdkit(source: Molecule | Structure) -> Mol:
    """Return an RDKit molecule with a conformer for each frame.

    Bond orders and formal charges are those that are known; where an order is not known, it is 1,
    and charges then follow from the number of bonds. Stereo is assigned from the first frame.

    Parameters
    ----------
    source : Structure, SampledEnsemble, Trajectory, path, ...
        What a `Trajectory` is made of.

    Raises
    ------
    ImportError
        RDKit is not installed; the message says how to install it.

    Warns
    -----
    PliantWarning
        RDKit does not accept its valences: the molecule is then not sanitised.
    """
    need("pliant.to_rdkit", "rdkit")
    frames = Trajectory(source)
    molecule = bonded(frames.structure)
    for positions in frames:
        add_conformer(molecule, positions)
    unfit = Chem.SanitizeMol(molecule, catchErrors=True)
    if unfit:
        warnings.warn(
            f"RDKit does not accept the molecule ({unfit}): it is not sanitised",
            PliantWarning,
            stacklevel=3,
        )
    elif len(frames):
        Chem.AssignStereochemistryFrom3D(molecule)
    made: Mol = molecule
    return made


def add_conformer(molecule: Mol, positions: npt.NDArray[np.float64]) -> Conformer:
    """A further conformer of a molecule, with positions (N, 3) in Angstrom."""
    conformer = Chem.Conformer(len(positions))
    conformer.SetPositions(np.ascontiguousarray(positions))
    return molecule.GetConformer(molecule.AddConformer(conformer, assignId=True))


def bonded(structure: Structure) -> Any:
    """Atoms and bonds, without conformers."""
    kinds = Chem.BondType
    known = {2: kinds.DOUBLE, 3: kinds.TRIPLE, 4: kinds.AROMATIC}
    orders, bonds = structure.bond_orders, structure.bonds
    molecule = Chem.RWMol()
    for number in structure.elements:
        molecule.AddAtom(Chem.Atom(int(number)))
    for (a, b), order in zip(bonds.tolist(), orders.tolist(), strict=True):
        molecule.AddBond(a, b, known.get(order, kinds.SINGLE))
    for a, b in bonds[orders == 4].tolist():
        for atom in (a, b):
            molecule.GetAtomWithIdx(atom).SetIsAromatic(True)
    charges = charges_of(structure)
    on_carbon = _has_hydrogens_on_carbon(structure)
    described = zip(molecule.GetAtoms(), charges, _residue_infos(structure), strict=True)
    for atom, charge, residue in described:
        atom.SetFormalCharge(int(charge))
        atom.SetNoImplicit(on_carbon or atom.GetAtomicNum() != _CARBON)
        if residue.GetResidueName() != "UNK":
            atom.SetMonomerInfo(residue)
    if structure.title:
        molecule.SetProp("_Name", structure.title)
    made: Any = molecule.GetMol()
    return made


_CARBON = 6
_AROMATIC = 4  #: order

#: Charges by element and number of valences in use, for atoms all of whose hydrogens are there.
_CHARGED = {(7, 4): 1, (7, 2): -1, (8, 3): 1, (8, 1): -1, (16, 1): -1, (16, 3): 1, (15, 4): 1}


def charges_of(structure: Structure) -> npt.NDArray[np.int64]:
    """(N,) those of the structure, else by valence; none where it has no hydrogens."""
    if len(structure.charges):
        return structure.charges
    charges = np.zeros(len(structure), dtype=np.int64)
    if not (structure.elements == 1).any():
        return charges
    used = np.zeros(len(structure), dtype=np.int64)
    orders = np.maximum(structure.bond_orders, 1).astype(np.int64)
    for ends in structure.bonds.T:
        np.add.at(used, ends, orders)
    used[structure.bonds[structure.bond_orders == _AROMATIC]] = 0
    elements = structure.elements
    for k in np.flatnonzero(used):
        charges[k] = _CHARGED.get((int(elements[k]), int(used[k])), 0)
    return charges


def _has_hydrogens_on_carbon(structure: Structure) -> bool:
    ends = structure.elements[structure.bonds]
    return (
        bool(((ends.min(axis=1) == 1) & (ends.max(axis=1) == _CARBON)).any())
        if len(ends)
        else False
    )


def _residue_infos(structure: Structure) -> list[Any]:
    """Of each atom. Each column is asked for once, for a structure makes all of it each time."""
    columns = (
        structure.names,
        structure.serials,
        structure.residue_names,
        structure.residue_ids,
        structure.chains,
        structure.insertion_codes,
    )
    return [
        Chem.AtomPDBResidueInfo(
            f" {name:<3}" if len(name) < 4 else str(name),
            int(serial),
            residueName=str(residue),
            residueNumber=int(number),
            chainId=str(chain),
            insertionCode=str(code),
        )
        for name, serial, residue, number, chain, code in zip(*columns, strict=True)
    ]


def _warn_of_implicit_hydrogens(molecule: Mol) -> None:
    count = sum(atom.GetTotalNumHs() for atom in molecule.GetAtoms())
    if count:
        warnings.warn(
            f"hydrogens without positions are left out: {count}; Chem.AddHs(molecule, "
            "addCoords=True) gives them some",
            PliantWarning,
            stacklevel=4,
        )


def _place(atom: Any) -> tuple[str, str, int, str, str]:
    """Name, residue name and number, insertion code and chain."""
    known = atom.GetPDBResidueInfo()
    if known is None and atom.GetAtomicNum() == 1 and atom.GetDegree() == 1:
        _, name, number, code, chain = _place(atom.GetNeighbors()[0])
        return "H", name, number, code, chain  # of a hydrogen that RDKit has added
    if known is None:
        symbol = atom.GetSymbol() if atom.GetAtomicNum() else "X"
        return symbol, "UNK", 1, "", ""
    return (
        known.GetName().strip() or atom.GetSymbol(),
        known.GetResidueName().strip() or "UNK",
        known.GetResidueNumber(),
        known.GetInsertionCode().strip(),
        known.GetChainId().strip(),
    )


def _order(bond: Any) -> int:
    return {"SINGLE": 1, "DOUBLE": 2, "TRIPLE": 3, "AROMATIC": 4}.get(str(bond.GetBondType()), 0)
