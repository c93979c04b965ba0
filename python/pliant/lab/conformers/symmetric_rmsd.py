# SPDX-License-Identifier: MIT
"""RMSD of the heavy atoms of a small molecule, the least over its symmetries, superposed.

Atoms that the graph cannot tell apart may be exchanged: the two sides of a phenyl, the methyls of
an isopropyl. So may the ends of carboxylates, nitro, sulfonyl, phosphate and amidinium groups,
which differ only in how their bonds are drawn.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from rdkit import Chem
from rdkit.Chem import Mol

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]

#: Ways to exchange atoms that are tried.
MAX_MAPS = 64

_ENDS = (7, 8, 16)  # N, O, S


def heavy_atoms(molecule: Mol) -> Ints:
    """(H,) indices of the atoms that are not hydrogens."""
    numbers = [atom.GetAtomicNum() for atom in molecule.GetAtoms()]
    return np.flatnonzero(np.array(numbers) > 1)


def symmetry_maps(molecule: Mol, limit: int = MAX_MAPS) -> Ints:
    """(M, H) atoms of the molecule, in each row in the order of one way to lay it onto itself."""
    heavy = heavy_atoms(molecule)
    plain = Chem.RWMol(molecule)
    for k in reversed(range(molecule.GetNumAtoms())):
        if plain.GetAtomWithIdx(k).GetAtomicNum() <= 1:
            plain.RemoveAtom(k)
    _make_ends_alike(plain)
    found = plain.GetSubstructMatches(plain, uniquify=False, maxMatches=limit)
    return heavy[np.array(found, dtype=np.int64)]


def _make_ends_alike(molecule: Mol) -> None:
    """Terminal N, O and S of one kind on one atom, one of them doubly bonded, get equal bonds."""
    for centre in molecule.GetAtoms():
        ends = [
            bond
            for bond in centre.GetBonds()
            if bond.GetOtherAtom(centre).GetDegree() == 1
            and bond.GetOtherAtom(centre).GetAtomicNum() in _ENDS
        ]
        doubles = {
            bond.GetOtherAtom(centre).GetAtomicNum()
            for bond in ends
            if bond.GetBondType() == Chem.BondType.DOUBLE
        }
        for bond in ends:
            end = bond.GetOtherAtom(centre)
            if end.GetAtomicNum() in doubles:
                bond.SetBondType(Chem.BondType.SINGLE)
                end.SetFormalCharge(0)


def nearest_rmsd(known: Floats, frames: Floats, maps: Ints) -> Floats:
    """(F,) Angstrom: RMSD of each frame (F, N, 3) from known positions (N, 3), best of the maps.

    Superposition by the singular values of the covariance (Kabsch 1976), without reflections.
    """
    target = _centred(known[maps[0]])
    size = len(target)
    best = np.full(len(frames), np.inf)
    for row in maps:
        moved = _centred(frames[:, row])
        covariance = np.einsum("fni,nj->fij", moved, target)
        singular = np.linalg.svd(covariance, compute_uv=False)
        singular[:, 2] *= np.sign(np.linalg.det(covariance))
        squares = (moved**2).sum((1, 2)) + (target**2).sum() - 2 * singular.sum(1)
        best = np.minimum(best, squares / size)
    found: Floats = np.sqrt(np.maximum(best, 0))
    return found


def _centred(positions: Floats) -> Floats:
    centred: Floats = positions - positions.mean(-2, keepdims=True)
    return centred


def nearest(molecule: Mol, frames: Floats) -> Floats:
    """(F,) Angstrom: symmetric RMSD of frames (F, N, 3) from the molecule's own first conformer."""
    known = molecule.GetConformer().GetPositions()
    return nearest_rmsd(known, np.asarray(frames, dtype=np.float64), symmetry_maps(molecule))
