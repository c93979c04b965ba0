# SPDX-License-Identifier: MIT
"""A SMILES for a ligand: bond orders, charges and hydrogens of its atoms."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.adapters.smiles import parsed_smiles
from pliant.base.extras import late
from pliant.base.refusals import shown
from pliant.jobs.conformers.bond_orders import HYDROGEN, sanitised, skeleton
from pliant.jobs.conformers.hydrogens import completed, labels_of

if TYPE_CHECKING:
    from rdkit.Chem import Atom, Bond, Mol

Chem = late("rdkit.Chem")

MOST_MATCHES = 10_000  #: ways to lay the SMILES onto the ligand
#: Lengths of bonds by their order, of the sum of covalent radii.
_LENGTHS = {1.0: 1.0, 1.5: 0.92, 2.0: 0.87, 3.0: 0.79}

Ways = npt.NDArray[np.int64]  #: (W, N) for each atom of the SMILES that of the ligand


def by_smiles(structure: Structure, smiles: str, place: str) -> tuple[Mol, list[str], list[str]]:
    """The ligand with bond orders, charges and hydrogens of the SMILES, notes, and warnings.

    Of several ways to lay one onto the other, that with the best bond lengths is taken. Raises
    InputError, which names what differs, where the two are not the same molecule or isomer.
    """
    template, ligand = Chem.RemoveAllHs(parsed_smiles(smiles)), skeleton(structure)
    place = f"{place}: is not {shown(smiles)}"
    names = labels_of(ligand)
    ways = _ways(template, ligand, names, place)
    match = ways[_misfits(template, ligand, ways).argmin()].tolist()
    _lay(template, ligand, match)
    ligand = sanitised(ligand, place, "")
    lacking = [atom.GetIdx() for atom in ligand.GetAtoms() if atom.GetTotalNumHs()]
    made, added = completed(ligand, lacking, names)
    _check_stereo(template, made, [(k, names[k]) for k in match], place)
    notes = ["its bond orders, charges and hydrogens are those of the SMILES"]
    return made, notes, added if (structure.elements == HYDROGEN).any() else []


def _ways(template: Mol, ligand: Mol, names: Sequence[str], place: str) -> Ways:
    """All that keep the bonds, and give no atom more hydrogens than the SMILES."""
    wanted, found = _formula(template), _formula(ligand)
    if wanted != found:
        raise InputError(f"{place}: expected {wanted} without hydrogens, found {found}")
    bonds = sum(_is_heavy(bond) for bond in ligand.GetBonds())
    if bonds != template.GetNumBonds():
        raise InputError(
            f"{place}: expected {template.GetNumBonds()} bonds without hydrogens, found {bonds}"
        )
    ways = np.array(
        ligand.GetSubstructMatches(_pattern(template), uniquify=False, maxMatches=MOST_MATCHES)
    )
    if not len(ways):
        raise InputError(f"{place}: other atoms are bonded to each other")
    given = _hydrogens(ligand)[ways]
    wanted_hydrogens = np.array([atom.GetTotalNumHs() for atom in template.GetAtoms()])
    excess = np.maximum(given - wanted_hydrogens, 0)
    least = int(excess.sum(axis=1).argmin())
    for k in np.flatnonzero(excess[least]).tolist():
        raise InputError(
            f"{place}: expected {wanted_hydrogens[k]} hydrogens at {names[ways[least, k]]}, found "
            f"{given[least, k]}"
        )
    fitting: Ways = ways[excess.sum(axis=1) == 0]
    return fitting


def _formula(molecule: Mol) -> str:
    """ "C9 O4"."""
    symbols = (atom.GetSymbol() for atom in molecule.GetAtoms() if atom.GetAtomicNum() != HYDROGEN)
    return " ".join(f"{symbol}{count}" for symbol, count in sorted(Counter(symbols).items()))


def _is_heavy(bond: Bond) -> bool:
    return HYDROGEN not in (bond.GetBeginAtom().GetAtomicNum(), bond.GetEndAtom().GetAtomicNum())


def _pattern(template: Mol) -> Mol:
    """Its atoms and bonds alone: no orders, charges or isotopes."""
    made = Chem.RWMol()
    for atom in template.GetAtoms():
        made.AddAtom(Chem.Atom(atom.GetAtomicNum()))
    for bond in template.GetBonds():
        made.AddBond(bond.GetBeginAtomIdx(), bond.GetEndAtomIdx(), Chem.BondType.SINGLE)
    bare: Mol = made.GetMol()
    return bare


def _hydrogens(molecule: Mol) -> npt.NDArray[np.int64]:
    """(N,) those among the neighbours of each atom."""
    near = ([one.GetAtomicNum() for one in atom.GetNeighbors()] for atom in molecule.GetAtoms())
    return np.array([one.count(HYDROGEN) for one in near])


def _misfits(template: Mol, ligand: Mol, ways: Ways) -> npt.NDArray[np.float64]:
    """(W,) Angstrom^2: how far lengths are from those of the orders that each way gives."""
    radius = Chem.GetPeriodicTable().GetRcovalent
    radii = [radius(atom.GetAtomicNum()) for atom in template.GetAtoms()]
    x, found = ligand.GetConformer().GetPositions(), np.zeros(len(ways))
    for bond in template.GetBonds():
        a, b = bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()
        wanted = (radii[a] + radii[b]) * _LENGTHS.get(bond.GetBondTypeAsDouble(), 1.0)
        found += (np.linalg.norm(x[ways[:, a]] - x[ways[:, b]], axis=1) - wanted) ** 2
    return found


def _lay(template: Mol, ligand: Mol, match: Sequence[int]) -> None:
    """Gives the ligand orders and charges; hydrogens that it lacks are then implied."""
    given = _hydrogens(ligand)
    for bond in template.GetBonds():
        ends = match[bond.GetBeginAtomIdx()], match[bond.GetEndAtomIdx()]
        own = ligand.GetBondBetweenAtoms(*ends)
        own.SetBondType(bond.GetBondType())
        own.SetIsAromatic(bond.GetIsAromatic())
    for atom, k in zip(template.GetAtoms(), match, strict=True):
        own = ligand.GetAtomWithIdx(k)
        own.SetFormalCharge(atom.GetFormalCharge())
        own.SetIsAromatic(atom.GetIsAromatic())
        own.SetNumRadicalElectrons(atom.GetNumRadicalElectrons())
        own.SetIsotope(atom.GetIsotope())
        own.SetNumExplicitHs(int(atom.GetTotalNumHs() - given[k]))


def _check_stereo(template: Mol, made: Mol, placed: Sequence[tuple[int, str]], place: str) -> None:
    """Raises InputError where stereo that the SMILES gives is not that of the positions.

    `placed` are number and name in the ligand of each atom of the SMILES.
    """
    if Chem.RemoveHs(made).HasSubstructMatch(template, useChirality=True):
        return
    differ = []
    for atom, (k, name) in zip(template.GetAtoms(), placed, strict=True):
        differ += _difference(_code(atom), _code(made.GetAtomWithIdx(k)), name)
    for bond in template.GetBonds():
        (a, first), (b, second) = placed[bond.GetBeginAtomIdx()], placed[bond.GetEndAtomIdx()]
        own = made.GetBondBetweenAtoms(a, b)
        differ += _difference(_side(bond), _side(own), f"{first}={second}")
    what = "; ".join(differ) or "its stereo is another"
    raise InputError(f"{place}: {what} (without stereo in the SMILES, the file's is kept)")


def _difference(wanted: str, found: str, where: str) -> list[str]:
    if wanted in ("", found):
        return []
    return [f"expected {wanted} at {where}, found {found or 'none'}"]


def _code(atom: Atom) -> str:
    """ "R", "S" or ""."""
    return str(atom.GetProp("_CIPCode")) if atom.HasProp("_CIPCode") else ""


def _side(bond: Bond) -> str:
    """ "E", "Z" or ""."""
    return {"STEREOE": "E", "STEREOZ": "Z"}.get(str(bond.GetStereo()), "")
