# SPDX-License-Identifier: MIT
"""What a ligand of a structure is: bond orders, charges, and hydrogens that are placed in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.adapters.smiles import metals_in
from pliant.base.extras import late, need
from pliant.checks.ligands.guessed_orders import guess_orders
from pliant.jobs.conformers.bond_orders import (
    HYDROGEN,
    as_stated,
    from_hydrogens,
    sanitised,
    skeleton,
)
from pliant.jobs.conformers.options import USUAL
from pliant.jobs.conformers.template import by_smiles

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")

CARBON = 6
#: what GAFF2 has parameters for
OF_GAFF = frozenset("H C N O F P S Cl Br I".split())
GUESSED = "bond orders, charges and hydrogens were guessed from lengths and angles"
MOST_HEAVY = 120  #: atoms without hydrogens; AM1 takes hours for more


@dataclass(frozen=True)
class Chemistry:
    """A molecule: atoms of the file, then hydrogens that it lacks."""

    molecule: Mol  #: RDKit's, with all hydrogens
    bare: Mol  #: without those that were added, which it counts
    source: str  #: where bond orders, charges and hydrogens are from

    @property
    def given(self) -> int:
        """Atoms of the file."""
        return int(self.bare.GetNumAtoms())

    @property
    def charge(self) -> int:
        """Formal, in e."""
        return int(Chem.GetFormalCharge(self.molecule))

    @property
    def smiles(self) -> str:
        """Without hydrogens."""
        return str(Chem.MolToSmiles(Chem.RemoveHs(self.molecule)))

    def complete(self, positions: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(L, 3) of positions (given, 3), Angstrom: hydrogens are placed by RDKit's rules."""
        bare = Chem.Mol(self.bare)
        bare.GetConformer().SetPositions(np.ascontiguousarray(positions, np.float64))
        whole = Chem.AddHs(bare, addCoords=True)
        return np.asarray(whole.GetConformer().GetPositions())

    def corners(self) -> npt.NDArray[np.int64]:
        """(C, 4) stereo centres: three neighbours that the file has, and the centre."""
        found = []
        for atom in self.molecule.GetAtoms():
            near = sorted(one.GetIdx() for one in atom.GetNeighbors())
            if atom.HasProp("_CIPCode") and len(near) > 3:
                found.append([*near[:3], atom.GetIdx()])
        return np.array(found, np.int64).reshape(-1, 4)


def chemistry_of(
    part: Structure, place: str, smiles: Mapping[str, str], *, is_capped: bool = False
) -> Chemistry:
    """Of a ligand, which is all of a structure; `smiles` are those that are known, by residue name.

    A residue with caps, which lack hydrogens, is guessed.

    Without one, bond orders are those that the file states, or that RDKit finds from hydrogens, or
    that are guessed from lengths and angles. Raises InputError, which begins with `place`.
    """
    need("parameters of a ligand", "rdkit", "scipy", extra="ligands")
    _check_elements(part, place)
    known = smiles.get(str(part.residue_names[0]))
    if is_capped:
        made, source = _guessed(part, place), GUESSED
    elif known is not None:
        made, _, _ = by_smiles(part, known, place)
        source = "its chemistry is that of the SMILES given"
    elif (part.bond_orders > 0).all() and len(part.bonds):
        made, _, _ = as_stated(part, USUAL, place)
        source = "bond orders are those of the file"
    elif _has_hydrogens_on_carbon(part):
        made, _, _ = from_hydrogens(part, USUAL, place)
        source = "bond orders were guessed from the hydrogens"
    else:
        made, source = _guessed(part, place), GUESSED
    return _checked(_without_added(made, len(part)), source, place)


def _checked(bare: Mol, source: str, place: str) -> Chemistry:
    """Raises InputError for a radical, or an odd number of electrons."""
    molecule = Chem.AddHs(bare, addCoords=True)
    Chem.AssignStereochemistryFrom3D(molecule)
    found = Chemistry(molecule, bare, source)
    electrons = sum(one.GetAtomicNum() for one in molecule.GetAtoms()) - found.charge
    if electrons % 2 or any(one.GetNumRadicalElectrons() for one in molecule.GetAtoms()):
        raise InputError(
            f"{place}: expected paired electrons, found {electrons} with charge {found.charge:+d} "
            f"({found.smiles})"
        )
    return found


def _check_elements(part: Structure, place: str) -> None:
    symbols = [str(one) for one in part.symbols]
    heavy = sum(one != "H" for one in symbols)
    if odd := [*metals_in(symbols), *sorted({*symbols} - OF_GAFF - {*metals_in(symbols)})]:
        raise InputError(f"{place}: GAFF2 has no parameters for {', '.join(odd)}")
    if heavy > MOST_HEAVY:
        raise InputError(
            f"{place}: expected at most {MOST_HEAVY} atoms without hydrogens, found {heavy}"
        )


def _has_hydrogens_on_carbon(part: Structure) -> bool:
    ends = part.elements[part.bonds]
    return bool(((ends.min(axis=1) == HYDROGEN) & (ends.max(axis=1) == CARBON)).any())


def _guessed(part: Structure, place: str) -> Mol:
    made = skeleton(part)
    guess_orders(made)
    return sanitised(Chem.AddHs(made, addCoords=True), place, "")


def _without_added(made: Mol, given: int) -> Mol:
    """With the hydrogens after the atoms that were given counted at those that carry them."""
    bare = Chem.RWMol(made)
    for k in range(made.GetNumAtoms() - 1, given - 1, -1):
        (parent,) = bare.GetAtomWithIdx(k).GetNeighbors()
        parent.SetNumExplicitHs(parent.GetNumExplicitHs() + 1)
        bare.RemoveAtom(k)
    for atom in bare.GetAtoms():
        atom.SetNoImplicit(True)
    bare.UpdatePropertyCache(strict=False)
    made_bare: Mol = bare.GetMol()
    return made_bare
