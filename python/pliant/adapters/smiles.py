# SPDX-License-Identifier: MIT
"""SMILES: a molecule drawn as text, made into a structure by RDKit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._checked import checked, whole
from pliant._core import InputError, Structure
from pliant._extras import need
from pliant.adapters.rdkit import from_rdkit

if TYPE_CHECKING:
    from rdkit.Chem import Mol

#: Angstrom; a bond is never that long
_LONGEST = 4.0


@checked(seed=whole(0, 2**31 - 1))
def from_smiles(smiles: str, seed: int = 0) -> Structure:
    """Return the molecule of a SMILES as a structure: 3-D, with all its hydrogens.

    RDKit makes it: ETKDGv3 (S. Wang et al., J. Chem. Inf. Model. 60 (2020) 2044), then a
    minimisation by MMFF94s, or by UFF of atoms that MMFF94s does not know.

    Parameters
    ----------
    smiles : str
        Of one molecule, such as ``"CC(=O)Oc1ccccc1C(=O)O"``.
    seed : int
        Of the embedding.

    Raises
    ------
    ImportError
        RDKit is not installed; the message says how to install it.
    InputError
        Not a SMILES, several molecules, or no 3-D structure was found.
    """
    return from_rdkit(embedded(smiles, seed))


def embedded(smiles: str, seed: int = 0) -> Mol:
    """The RDKit molecule of `from_smiles`, with one conformer."""
    need("a SMILES", "rdkit")
    from rdkit import Chem

    parsed = parsed_smiles(smiles)
    if len(Chem.GetMolFrags(parsed)) > 1:
        raise InputError(f"SMILES '{smiles}': expected one molecule, found several ('.')")
    molecule = Chem.AddHs(parsed)
    if not embed(molecule, seed):
        raise InputError(f"SMILES '{smiles}': RDKit found no 3-D structure")
    molecule.SetProp("_Name", smiles)
    return molecule


def parsed_smiles(smiles: str) -> Mol:
    """The RDKit molecule of a SMILES. Raises InputError where RDKit cannot read it."""
    from rdkit import Chem, rdBase

    with rdBase.BlockLogs():
        parsed = Chem.MolFromSmiles(smiles)
    if parsed is None or parsed.GetNumAtoms() == 0:
        raise InputError(f"SMILES '{smiles}': expected a molecule, RDKit cannot read it")
    return parsed


def embed(molecule: Mol, seed: int = 0) -> bool:
    """Gives a molecule with all its hydrogens one conformer; whether its bonds are whole."""
    from rdkit import rdBase
    from rdkit.Chem import rdDistGeom, rdForceFieldHelpers

    options: Any = rdDistGeom.ETKDGv3()
    options.randomSeed = seed + 1  # 0 is not a seed
    with rdBase.BlockLogs():
        if rdDistGeom.EmbedMolecule(molecule, options) != 0:
            return False
        if rdForceFieldHelpers.MMFFOptimizeMolecule(molecule, "MMFF94s", maxIters=2000) < 0:
            rdForceFieldHelpers.UFFOptimizeMolecule(molecule, maxIters=2000)
    return _longest_bond(molecule) < _LONGEST


def _longest_bond(molecule: Mol) -> float:
    """Angstrom; force fields tear complexes of metals apart."""
    x = molecule.GetConformer().GetPositions()
    ends = [(one.GetBeginAtomIdx(), one.GetEndAtomIdx()) for one in molecule.GetBonds()]
    return max((float(np.linalg.norm(x[a] - x[b])) for a, b in ends), default=0.0)
