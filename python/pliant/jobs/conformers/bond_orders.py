# SPDX-License-Identifier: MIT
"""Bond orders of one ligand: as they are known, or guessed from its hydrogens.

The guess is RDKit's rdDetermineBonds, after Y. Kim, W. Y. Kim, Bull. Korean Chem. Soc. 36
(2015) 1769.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pliant._core import InputError, Structure
from pliant.adapters.rdkit import add_conformer, bonded
from pliant.base.extras import late
from pliant.jobs.conformers.hydrogens import labels_of
from pliant.jobs.conformers.options import ConformerOptions

if TYPE_CHECKING:
    from rdkit.Chem import Atom, Bond, Mol

Chem = late("rdkit.Chem")
rdBase = late("rdkit.rdBase")
rdDetermineBonds = late("rdkit.Chem.rdDetermineBonds")
rdMolTransforms = late("rdkit.Chem.rdMolTransforms")

HYDROGEN, CARBON, NITROGEN = 1, 6, 7
CHARGES = (0, 1, -1, 2, -2, 3, -3, 4, -4)  #: that are tried where none is stated
MOST_TRIES = 10_000  #: of RDKit, of one charge
#: Of the sum of covalent radii, by order: single bonds have 1.0 of it, double ones 0.84 to 0.97,
#: triple ones 0.77 to 0.80.
LONGEST = {2.0: 0.98, 3.0: 0.86}
LINEAR = 140.0  #: degrees, at least, at a carbon with two neighbours: those of rings are bent


def skeleton(structure: Structure) -> Mol:
    """All of its atoms, uncharged, and its bonds as single ones, with its positions."""
    made = _placed(structure)
    for bond in made.GetBonds():
        bond.SetBondType(Chem.BondType.SINGLE)
        bond.SetIsAromatic(False)
    for atom in made.GetAtoms():
        atom.SetFormalCharge(0)
        atom.SetIsAromatic(False)
        atom.SetNoImplicit(True)
    return made


def sanitised(molecule: Mol, place: str, remedy: str) -> Mol:
    """With stereo as in 3-D. Raises InputError where RDKit does not accept its valences."""
    with rdBase.BlockLogs():
        unfit = Chem.SanitizeMol(molecule, catchErrors=True)
    if unfit:
        raise InputError(f"{place}: RDKit does not accept its bond orders{remedy}")
    Chem.AssignStereochemistryFrom3D(molecule)
    return molecule


def _placed(structure: Structure) -> Mol:
    made: Mol = bonded(structure)
    add_conformer(made, structure.positions)
    return made


def as_stated(
    structure: Structure, options: ConformerOptions, place: str
) -> tuple[Mol, list[str], list[str]]:
    """All orders are known, and charges follow from them; what lacks hydrogens has none."""
    made = _placed(structure)
    for atom in made.GetAtoms():
        if atom.GetAtomicNum() == NITROGEN and atom.GetFormalCharge() < 0:
            atom.SetFormalCharge(0)
        atom.SetNoImplicit(False)
    made = sanitised(made, place, f": {options.asked_smiles} gives others")
    names = labels_of(made)
    charged = [
        f"{atom.GetFormalCharge():+d} of {name}"
        for atom, name in zip(made.GetAtoms(), names, strict=True)
        if atom.GetFormalCharge()
    ]
    return made, [], [f"formal charges follow from numbers of bonds: {', '.join(charged)}"]


def from_hydrogens(
    structure: Structure, options: ConformerOptions, place: str
) -> tuple[Mol, list[str], list[str]]:
    """Orders, and where no charges are stated the total charge, are guessed.

    Raises InputError where no charge gives a usual molecule.
    """
    is_stated = len(structure.charges) > 0
    charges = [int(structure.charges.sum())] if is_stated else _possible_charges(structure)
    bare = skeleton(structure)
    tried = [(charge, _with_charge(bare, charge)) for charge in charges]
    usual = [(charge, made) for charge, made in tried if made is not None and _is_usual(made)]
    if not usual:
        what = f"the formal charge {_signed(charges[0])}" if is_stated else "any formal charge"
        raise InputError(
            f"{place}: RDKit finds no bond orders with {what}: are all hydrogens there? "
            f"{options.asked_smiles} gives both"
        )
    charge, made = min(usual, key=lambda one: (_charged(one[1]), abs(one[0])))
    what = f"bond orders and the formal charge {_signed(charge)} were"
    if is_stated:
        what = "bond orders were"
    return (
        made,
        [],
        [f"{what} guessed by RDKit from the hydrogens; {options.asked_smiles} states them"],
    )


def _signed(charge: int) -> str:
    return f"{charge:+d}" if charge else "0"


def _possible_charges(structure: Structure) -> list[int]:
    """Those that leave an even number of electrons."""
    total = int(structure.elements.astype(int).sum())
    return [charge for charge in CHARGES if (total - charge) % 2 == 0]


def _with_charge(bare: Mol, charge: int) -> Mol | None:
    made: Mol = Chem.Mol(bare)
    try:
        with rdBase.BlockLogs():
            rdDetermineBonds.DetermineBondOrders(made, charge=charge, maxIterations=MOST_TRIES)
            for sulphur, oxygen in made.GetSubstructMatches(Chem.MolFromSmarts("[S+X3][O-X1]")):
                made.GetAtomWithIdx(sulphur).SetFormalCharge(0)  # a sulphoxide as it is drawn
                made.GetAtomWithIdx(oxygen).SetFormalCharge(0)
                made.GetBondBetweenAtoms(sulphur, oxygen).SetBondType(Chem.BondType.DOUBLE)
            Chem.SanitizeMol(made)
    except (ValueError, RuntimeError):
        return None
    Chem.AssignStereochemistryFrom3D(made)
    return made


def _charged(molecule: Mol) -> int:
    """The sum of all formal charges without their signs: least in what is drawn as usual."""
    return sum(abs(atom.GetFormalCharge()) for atom in molecule.GetAtoms())


def _is_usual(molecule: Mol) -> bool:
    """No radical, no charged or bent carbon that lacks hydrogens, no multiple bond too long."""
    return all(_is_usual_atom(molecule, atom) for atom in molecule.GetAtoms()) and all(
        _is_short(molecule, bond) for bond in molecule.GetBonds()
    )


def _is_usual_atom(molecule: Mol, atom: Atom) -> bool:
    if atom.GetNumRadicalElectrons():
        return False
    if atom.GetAtomicNum() != CARBON:
        return True
    near = [one.GetIdx() for one in atom.GetNeighbors()]
    if len(near) == 2:
        return atom.GetFormalCharge() == 0 and _angle(molecule, near[0], atom, near[1]) > LINEAR
    return atom.GetFormalCharge() == 0 or (len(near) == 1 and atom.GetTotalValence() == 3)


def _angle(molecule: Mol, a: int, atom: Atom, b: int) -> float:
    """Degrees."""
    place = molecule.GetConformer()
    return float(rdMolTransforms.GetAngleDeg(place, a, atom.GetIdx(), b))


def _is_short(molecule: Mol, bond: Bond) -> bool:
    longest = LONGEST.get(bond.GetBondTypeAsDouble())
    if longest is None:
        return True
    ends = bond.GetBeginAtom(), bond.GetEndAtom()
    a, b = (molecule.GetConformer().GetAtomPosition(atom.GetIdx()) for atom in ends)
    radius = Chem.GetPeriodicTable().GetRcovalent
    single = sum(radius(atom.GetAtomicNum()) for atom in ends)
    return bool(a.Distance(b) < longest * single)
