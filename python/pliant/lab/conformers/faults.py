# SPDX-License-Identifier: MIT
"""What conformers of a molecule must not have: other stereo, atoms in each other, high energy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from rdkit import Chem
from rdkit.Chem import Mol, rdForceFieldHelpers

from pliant.lab.conformers.symmetric_rmsd import heavy_atoms

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

CLOSE = 2.6  #: Angstrom between heavy atoms
BONDS_APART = 4
_STEPS = 200  #: of a minimisation
_SMALL_RING = 8  #: members up to which an amide is cis for ever
_AMIDE = "[O,S]=[#6;X3]-[#7;X3;H1]-[#6]"


@dataclass(frozen=True)
class Faults:
    """Which of the conformers (F,) have one."""

    handedness: Bools
    double_bonds: Bools  #: E and Z
    amides: Bools  #: secondary ones, cis and trans
    contacts: Bools  #: heavy atoms nearer than CLOSE


def faults_of(molecule: Mol, frames: Floats) -> Faults:
    """Stereo is compared with that of the molecule's own conformer."""
    own = molecule.GetConformer().GetPositions()[None]

    def changed(signs: Floats, first: Floats) -> Bools:
        different: Bools = (signs != first).any(1)
        return different

    centres, bonds, amides = _centres(molecule), _double_bonds(molecule), _amides(molecule)
    return Faults(
        changed(_volume_signs(frames, centres), _volume_signs(own, centres)),
        changed(_side_signs(frames, bonds), _side_signs(own, bonds)),
        changed(_side_signs(frames, amides), _side_signs(own, amides)),
        _has_contact(molecule, frames),
    )


def _centres(molecule: Mol) -> npt.NDArray[np.int64]:
    """(C, 4) neighbours of the atoms with a handedness; of three the atom itself is the fourth."""
    found = []
    for atom in molecule.GetAtoms():
        if atom.GetChiralTag() in (Chem.CHI_TETRAHEDRAL_CW, Chem.CHI_TETRAHEDRAL_CCW):
            around = [one.GetIdx() for one in atom.GetNeighbors()]
            found.append([*around, atom.GetIdx()][:4])
    return np.array(found, dtype=np.int64).reshape(-1, 4)


def _double_bonds(molecule: Mol) -> npt.NDArray[np.int64]:
    """(B, 4) chains of four atoms about the bonds that are E or Z."""
    found = []
    for bond in molecule.GetBonds():
        if bond.GetStereo() > Chem.BondStereo.STEREOANY:
            a, b = bond.GetStereoAtoms()
            found.append((a, bond.GetBeginAtomIdx(), bond.GetEndAtomIdx(), b))
    return np.array(found, dtype=np.int64).reshape(-1, 4)


def _amides(molecule: Mol) -> npt.NDArray[np.int64]:
    """(A, 4) O, C, N, C of secondary amides that no small ring holds."""
    pattern = Chem.MolFromSmarts(_AMIDE)
    rings = molecule.GetRingInfo().AtomRings()
    matches = molecule.GetSubstructMatches(pattern)
    free = [
        m
        for m in matches
        if not any(len(r) <= _SMALL_RING and {m[1], m[2]} <= set(r) for r in rings)
    ]
    return np.array(free, dtype=np.int64).reshape(-1, 4)


def _volume_signs(frames: Floats, centres: npt.NDArray[np.int64]) -> Floats:
    """(F, C) sign of the volume that the four points span."""
    corners = frames[:, centres]
    signs: Floats = np.sign(np.linalg.det(corners[:, :, :3] - corners[:, :, 3:]))
    return signs


def _side_signs(frames: Floats, chains: npt.NDArray[np.int64]) -> Floats:
    """(F, B) 1 where the ends of a chain are on one side of its middle bond, -1 where on two."""
    a, b, c, d = np.moveaxis(frames[:, chains], 2, 0)
    signs: Floats = np.sign((np.cross(a - b, c - b) * np.cross(d - c, b - c)).sum(-1))
    return -signs


def _has_contact(molecule: Mol, frames: Floats) -> Bools:
    heavy = heavy_atoms(molecule)
    apart = Chem.GetDistanceMatrix(molecule)[np.ix_(heavy, heavy)]
    first, second = np.nonzero(np.triu(apart >= BONDS_APART))
    between = frames[:, heavy[first]] - frames[:, heavy[second]]
    near: Bools = ((between**2).sum(-1) < CLOSE**2).any(1)
    return near


def energies(molecule: Mol, frames: Floats) -> tuple[Floats, Floats]:
    """(F,) kcal/mol of MMFF94s as they are, and minimised; empty where it has no parameters."""
    if not rdForceFieldHelpers.MMFFHasAllMoleculeParams(molecule):
        return np.zeros(0), np.zeros(0)
    work = Chem.Mol(molecule)
    properties = rdForceFieldHelpers.MMFFGetMoleculeProperties(work, mmffVariant="MMFF94s")
    raw, minimised = [], []
    for positions in frames:
        work.GetConformer().SetPositions(np.ascontiguousarray(positions))
        field = rdForceFieldHelpers.MMFFGetMoleculeForceField(work, properties)
        raw.append(field.CalcEnergy())
        field.Minimize(maxIts=_STEPS)
        minimised.append(field.CalcEnergy())
    return np.array(raw), np.array(minimised)
