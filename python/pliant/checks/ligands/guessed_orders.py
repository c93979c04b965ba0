# SPDX-License-Identifier: MIT
"""Bond orders and hydrogens of a ligand without hydrogens, guessed from its lengths and angles.

Double bonds are those that together are shortest for their elements, each atom having as many as
its valence allows: a matching of greatest weight, found by SciPy's milp. Groups that are charged
in water then are: carboxylates, phosphates, amines, amidines.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.base.extras import late

if TYPE_CHECKING:
    from rdkit.Chem import Atom, Bond, Mol

Chem = late("rdkit.Chem")
rdMolTransforms = late("rdkit.Chem.rdMolTransforms")
optimize = late("scipy.optimize")

#: Angstrom below which a bond between elements is rather double: half-way between bonds of
#: aromatic rings, or those that are double, and single bonds of planar atoms
LONGEST_DOUBLE = {
    (6, 6): 1.435, (6, 7): 1.385, (6, 8): 1.30, (6, 16): 1.69, (7, 7): 1.37, (7, 8): 1.30,
    (7, 16): 1.58, (8, 15): 1.54, (8, 16): 1.50, (15, 16): 2.0,
}  # fmt: skip
#: Added to the score of an atom with one neighbour: rather carbonyls than enols, amines than imines
LONE = {7: -0.5, 8: 0.1}
LONGEST_TRIPLE = {(6, 6): 1.25, (6, 7): 1.20}
LINEAR = 160.0  #: degrees, at least, at an atom with a triple bond
FLAT = 0.16  #: Angstrom, at most, of a planar atom from the plane of its three neighbours
FLAT_RING = 15.0  #: degrees, at most, of the torsions of an aromatic ring of six, on average
SP2_ANGLE = 111.0  #: degrees, at least, at an atom of a double bond that has two neighbours
NEAR = 3  #: bonds between two cations, of which the second is then none
VALENCES = {5: 3, 6: 4, 7: 3, 8: 2, 9: 1, 14: 4, 15: 5, 16: 6, 17: 1, 35: 1, 53: 1}
#: groups that have a charge in water, each with its first atom and that charge
CHARGED = (
    ("[OX1H1,$([OX2H1])]C(=O)[#6,#1]", -1),
    ("[$([OX2H1])]P(=O)", -1),
    ("[$([OX2H1])]S(=O)(=O)", -1),
    ("[NX3;!$(N-[!#6;!#1]);!$(N-[#6]=,:,#*);!$(N[CX4](F)F)]", +1),
    ("[NX2]=C([NX3;!$(N[#6]=[O,S]);!$(NS(=O))])[#6,#1,$([NX3])]", +1),
)


def guess_orders(molecule: Mol) -> None:
    """Gives a skeleton of single bonds, with a conformer, its orders, charges and hydrogens.

    Hydrogens that the skeleton has stay, and others are implied.
    """
    Chem.FastFindRings(molecule)
    doubles, triples = _multiple(molecule)
    for order, bonds in ((Chem.BondType.DOUBLE, doubles), (Chem.BondType.TRIPLE, triples)):
        for k in bonds:
            molecule.GetBondWithIdx(k).SetBondType(order)
    for atom in molecule.GetAtoms():
        _nitro_or_quaternary(atom)
    for atom in molecule.GetAtoms():
        atom.SetNumExplicitHs(_hydrogens(atom))
    _charge_groups(molecule)


def _multiple(molecule: Mol) -> tuple[list[int], list[int]]:
    """Bonds that are double, and that are triple."""
    triples = [bond.GetIdx() for bond in molecule.GetBonds() if _is_triple(bond)]
    taken = {end for k in triples for end in _ends(molecule.GetBondWithIdx(k))}
    scores = {
        bond.GetIdx(): score
        for bond in molecule.GetBonds()
        if not taken & {*_ends(bond)} and (score := _score(bond)) > 0
    }
    return _heaviest(molecule, scores), triples


def _heaviest(molecule: Mol, scores: dict[int, float]) -> list[int]:
    if not scores:
        return []
    bonds = [molecule.GetBondWithIdx(k) for k in scores]
    rows = np.zeros((molecule.GetNumAtoms(), len(bonds)))
    for column, bond in enumerate(bonds):
        rows[[*_ends(bond)], column] = 1
    room = [_room(atom) for atom in molecule.GetAtoms()]
    found = optimize.milp(
        -np.array([*scores.values()]),
        constraints=optimize.LinearConstraint(rows, -np.inf, room),
        integrality=np.ones(len(bonds)),
        bounds=optimize.Bounds(0, 1),
    )
    return [k for k, taken in zip(scores, found.x, strict=True) if taken > 0.5]


def _room(atom: Atom) -> int:
    """How many double bonds it may have."""
    number, free = atom.GetAtomicNum(), VALENCES.get(atom.GetAtomicNum(), 0) - atom.GetDegree()
    if len(_nitro_oxygens(atom)) == 2:
        return 1
    most = {15: 1, 16: 2 if atom.GetDegree() >= 3 else 1 if atom.GetDegree() == 1 else 0}
    return max(0, min(free, most.get(number, 1)))


def _score(bond: Bond) -> float:
    """How much shorter a bond of planar ends is than it may be, tenths of an Angstrom."""
    ends = bond.GetBeginAtom(), bond.GetEndAtom()
    longest, in_ring = LONGEST_DOUBLE.get(_elements(bond), 0.0), _is_in_flat_ring(bond)
    if not longest or not all(_room(atom) and (in_ring or _is_planar(atom)) for atom in ends):
        return 0.0
    if in_ring:
        return max(10 * (longest - _length(bond)) + 0.5, 0.1)
    lone = sum(LONE.get(atom.GetAtomicNum(), 0.0) for atom in ends if atom.GetDegree() == 1)
    return 10 * (longest - _length(bond)) + lone


def _is_in_flat_ring(bond: Bond) -> bool:
    """Whether it is in a ring of six that is as flat as no saturated one is."""
    molecule = bond.GetOwningMol()
    place, ends = molecule.GetConformer(), {*_ends(bond)}
    for ring in molecule.GetRingInfo().AtomRings():
        if len(ring) == 6 and ends <= {*ring}:
            fours = [[ring[(k + j) % 6] for j in range(4)] for k in range(6)]
            turns = [abs(rdMolTransforms.GetDihedralDeg(place, *four)) for four in fours]
            if sum(turns) / 6 < FLAT_RING:
                return True
    return False


def _is_planar(atom: Atom) -> bool:
    if atom.GetAtomicNum() in (15, 16):
        return True
    place = atom.GetOwningMol().GetConformer().GetPositions()
    near = [one.GetIdx() for one in atom.GetNeighbors()]
    x = place[near] - place[atom.GetIdx()]
    if len(near) == 3:
        normal = np.cross(x[1] - x[0], x[2] - x[0])
        return bool(abs(normal @ x[0]) < FLAT * np.linalg.norm(normal))
    is_wide = len(near) == 1 or atom.GetAtomicNum() == 7 or atom.IsInRingSize(5)
    return is_wide or (len(near) == 2 and _angle(x) > SP2_ANGLE)


def _is_triple(bond: Bond) -> bool:
    longest = LONGEST_TRIPLE.get(_elements(bond), 0.0)
    ends = bond.GetBeginAtom(), bond.GetEndAtom()
    return _length(bond) < longest and all(_is_linear(atom) for atom in ends)


def _is_linear(atom: Atom) -> bool:
    place = atom.GetOwningMol().GetConformer().GetPositions()
    x = place[[one.GetIdx() for one in atom.GetNeighbors()]] - place[atom.GetIdx()]
    return len(x) == 1 or (len(x) == 2 and _angle(x) > LINEAR)


def _angle(x: np.ndarray) -> float:
    """Degrees between two vectors (2, 3)."""
    cosine = x[0] @ x[1] / np.linalg.norm(x[0]) / np.linalg.norm(x[1])
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def _ends(bond: Bond) -> tuple[int, int]:
    return bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()


def _elements(bond: Bond) -> tuple[int, int]:
    a, b = bond.GetBeginAtom().GetAtomicNum(), bond.GetEndAtom().GetAtomicNum()
    return min(a, b), max(a, b)


def _length(bond: Bond) -> float:
    """Angstrom."""
    place = bond.GetOwningMol().GetConformer().GetPositions()
    a, b = _ends(bond)
    return float(np.linalg.norm(place[a] - place[b]))


def _order(atom: Atom) -> int:
    return int(sum(bond.GetBondTypeAsDouble() for bond in atom.GetBonds()))


def _is_lone_oxygen(atom: Atom) -> bool:
    return bool(atom.GetAtomicNum() == 8 and atom.GetDegree() == 1)


def _nitro_oxygens(atom: Atom) -> list[Atom]:
    """Of a nitrogen with three neighbours, those that are its alone."""
    if atom.GetAtomicNum() != 7 or atom.GetDegree() != 3:
        return []
    return [one for one in atom.GetNeighbors() if _is_lone_oxygen(one)]


def _nitro_or_quaternary(atom: Atom) -> None:
    """Charges that four bonds of nitrogen, one to the second oxygen of a nitro group, ask for."""
    if atom.GetAtomicNum() != 7 or _order(atom) != 4:
        return
    atom.SetFormalCharge(1)
    for one in _nitro_oxygens(atom):
        if _order(one) == 1:
            one.SetFormalCharge(-1)


def _hydrogens(atom: Atom) -> int:
    """Those that it lacks."""
    number, used = atom.GetAtomicNum(), _order(atom)
    if number == 16:
        return int(used == 1)
    if number == 15:
        return max(0, 3 - used) if used < 3 else 0
    charge = atom.GetFormalCharge()
    return max(0, VALENCES.get(number, 0) - used + (charge if number in (7, 8) else -abs(charge)))


def _charge_groups(molecule: Mol) -> None:
    Chem.SanitizeMol(molecule, catchErrors=True)
    for pattern, charge in CHARGED:
        for match in molecule.GetSubstructMatches(Chem.MolFromSmarts(pattern)):
            atom = molecule.GetAtomWithIdx(match[0])
            is_free = (charge < 0 and atom.GetNumExplicitHs()) or (charge > 0 and _is_far(atom))
            if atom.GetFormalCharge() == 0 and is_free:
                atom.SetFormalCharge(charge)
                atom.SetNumExplicitHs(atom.GetNumExplicitHs() + charge)
        Chem.SanitizeMol(molecule, catchErrors=True)


def _is_far(atom: Atom) -> bool:
    """Whether no cation is within NEAR bonds: two so near are not both charged."""
    molecule = atom.GetOwningMol()
    apart = Chem.GetDistanceMatrix(molecule)[atom.GetIdx()]
    near = (one for one in molecule.GetAtoms() if apart[one.GetIdx()] <= NEAR)
    return all(one.GetFormalCharge() <= 0 for one in near)
