# SPDX-License-Identifier: MIT
"""Stereo that a molecule leaves open: what is made 3-D of it is one isomer of several."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pliant.base.extras import late

if TYPE_CHECKING:
    from rdkit.Chem import Atom, Bond, Mol

Chem = late("rdkit.Chem")
rdMolDescriptors = late("rdkit.Chem.rdMolDescriptors")


def open_stereo(molecule: Mol) -> str:
    """What to say of a molecule that was just made 3-D; "" where all of its stereo was given.

    Neither counted are what exchanges its hydrogen (=NH, the acids of phosphorus and sulphur), nor
    double bonds in a row, nor bridgeheads that hold each other, as those of norbornane.
    """
    found = Chem.FindPotentialStereo(Chem.Mol(molecule))  # which may change what it is given
    left = [one for one in found if one.specified != Chem.StereoSpecified.Specified]
    double = [one.centeredOn for one in left if one.type == Chem.StereoType.Bond_Double]
    centres = [one.centeredOn for one in left if one.type == Chem.StereoType.Atom_Tetrahedral]
    double = [k for k in double if _is_lasting_bond(molecule.GetBondWithIdx(k))]
    centres = [k for k in centres if _is_lasting_centre(molecule.GetAtomWithIdx(k))]
    centres = _without_alternative(molecule, centres)
    named = ((centres, "stereo centre"), (double, "double bond"))
    counts = [f"{len(one)} {name}{'s' * (len(one) > 1)}" for one, name in named if one]
    if not counts:
        return ""
    verb = "is" if len(centres) + len(double) == 1 else "are"
    return f"{' and '.join(counts)} {verb} not given: one isomer was made"


def _is_lasting_bond(bond: Bond) -> bool:
    ends = (bond.GetBeginAtom(), bond.GetEndAtom())
    return not any(_is_imine(atom) or _is_within_a_row(atom) for atom in ends)


def _is_imine(atom: Atom) -> bool:
    return bool(atom.GetAtomicNum() == 7 and _heavy(atom) == 1)


def _is_within_a_row(atom: Atom) -> bool:
    return bool(sum(one.GetBondTypeAsDouble() == 2 for one in atom.GetBonds()) > 1)


def _is_lasting_centre(atom: Atom) -> bool:
    oxygens = [one for one in atom.GetNeighbors() if one.GetAtomicNum() == 8 and _heavy(one) == 1]
    return bool(atom.GetAtomicNum() == 6) or len(oxygens) < 2


def _heavy(atom: Atom) -> int:
    """How many neighbours are no hydrogens."""
    return sum(one.GetAtomicNum() > 1 for one in atom.GetNeighbors())


def _without_alternative(molecule: Mol, centres: list[int]) -> list[int]:
    """The centres without bridgeheads that give the same molecule when all are inverted."""
    bridgeheads: Any = []  # which is filled
    rdMolDescriptors.CalcNumBridgeheadAtoms(molecule, bridgeheads)
    held = set(bridgeheads).intersection(centres)
    if not held:
        return centres
    made = Chem.Mol(molecule)
    Chem.AssignStereochemistryFrom3D(made)
    inverted = Chem.Mol(made)
    for k in held:
        inverted.GetAtomWithIdx(k).InvertChirality()
    # not by canonical SMILES, which differs for some meso compounds
    if not Chem.RemoveHs(inverted).HasSubstructMatch(Chem.RemoveHs(made), useChirality=True):
        return centres
    return [k for k in centres if k not in held]
