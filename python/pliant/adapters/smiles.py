# SPDX-License-Identifier: MIT
"""SMILES: a molecule drawn as text, made into a structure by RDKit."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant._core import InputError, PliantWarning, Structure
from pliant.adapters.open_stereo import open_stereo
from pliant.adapters.rdkit import from_rdkit
from pliant.base.checked import checked, whole
from pliant.base.extras import late, need
from pliant.base.refusals import shown

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")
rdBase = late("rdkit.rdBase")
rdDistGeom = late("rdkit.Chem.rdDistGeom")
rdForceFieldHelpers = late("rdkit.Chem.rdForceFieldHelpers")

#: Angstrom; a bond is never that long
_LONGEST = 4.0
MOST_ATOMS = 500  #: with hydrogens; the time of one try of an embedding grows as their cube
MOST_LETTERS = 20_000  #: of a SMILES: more are too many atoms, and fill the memory
#: Elements that RDKit embeds; all others are metals.
_NO_METALS = frozenset("H He B C N O F Ne Si P S Cl Ar Ge As Se Br Kr Sb Te I Xe At Rn".split())


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

    Warns
    -----
    PliantWarning
        Stereo centres or double bonds are not given: one isomer is made.
    """
    return from_rdkit(embedded(smiles, seed))


def embedded(smiles: str, seed: int = 0) -> Mol:
    """The RDKit molecule of `from_smiles`, with one conformer."""
    need("a SMILES", "rdkit")
    parsed = parsed_smiles(smiles)
    if len(Chem.GetMolFrags(parsed)) > 1:
        raise InputError(f"SMILES '{smiles}': expected one molecule, found several ('.')")
    molecule: Mol = Chem.AddHs(parsed)
    place = f"SMILES '{smiles}'"
    if left_open := embed(molecule, place, seed):
        warnings.warn(f"{place}: {left_open}", PliantWarning, stacklevel=4)
    molecule.SetProp("_Name", smiles)
    return molecule


def parsed_smiles(smiles: str) -> Mol:
    """The RDKit molecule of a SMILES. Raises InputError where RDKit cannot read all of it."""
    if len(smiles) > MOST_LETTERS:
        raise InputError(
            f"SMILES {shown(smiles)}: expected at most {MOST_LETTERS} letters, found {len(smiles)}"
        )
    if (words := len(smiles.split())) > 1:  # RDKit leaves out all but the first
        raise InputError(f"SMILES {shown(smiles)}: expected one word, found {words}")
    with rdBase.BlockLogs():
        parsed: Mol = Chem.MolFromSmiles(smiles)
    if parsed is None or parsed.GetNumAtoms() == 0:
        raise InputError(f"SMILES '{smiles}': expected a molecule, RDKit cannot read it")
    return parsed


def metals_in(symbols: Iterable[str]) -> list[str]:
    """The metals among elements, each once."""
    return [one for one in dict.fromkeys(symbols) if one not in _NO_METALS]


def embed(molecule: Mol, place: str, seed: int = 0) -> str:
    """Gives a molecule with all its hydrogens one conformer; returns which stereo was not given.

    Raises InputError, which begins with `place`, where it holds a metal, has more than MOST_ATOMS
    atoms, or no structure is found in a number of tries that depends on its size alone.
    """
    count = molecule.GetNumAtoms()
    if metals := metals_in(atom.GetSymbol() for atom in molecule.GetAtoms()):
        raise InputError(f"{place}: RDKit makes no 3-D structure of the metal {', '.join(metals)}")
    if count > MOST_ATOMS:
        raise InputError(
            f"{place}: expected at most {MOST_ATOMS} atoms to make 3-D, hydrogens included, "
            f"found {count}"
        )
    tries = max(1, min(10 * count, 10**6 // count**2))
    more = max(1, tries // 10)
    with rdBase.BlockLogs():
        if not (_placed(molecule, tries, seed) or _placed(molecule, more, seed, at_random=True)):
            raise InputError(f"{place}: RDKit found no 3-D structure in {tries + more} tries")
        if rdForceFieldHelpers.MMFFOptimizeMolecule(molecule, "MMFF94s", maxIters=2000) < 0:
            rdForceFieldHelpers.UFFOptimizeMolecule(molecule, maxIters=2000)
    if _longest_bond(molecule) >= _LONGEST:
        raise InputError(f"{place}: RDKit found no 3-D structure: a force field tore bonds apart")
    return open_stereo(molecule)


def _placed(molecule: Mol, tries: int, seed: int, *, at_random: bool = False) -> bool:
    options: Any = rdDistGeom.ETKDGv3()
    options.randomSeed = seed + 1  # 0 is not a seed
    options.maxIterations = tries
    options.useRandomCoords = at_random
    return bool(rdDistGeom.EmbedMolecule(molecule, options) == 0)


def _longest_bond(molecule: Mol) -> float:
    """Angstrom."""
    x = molecule.GetConformer().GetPositions()
    ends = [(one.GetBeginAtomIdx(), one.GetEndAtomIdx()) for one in molecule.GetBonds()]
    return max((float(np.linalg.norm(x[a] - x[b])) for a, b in ends), default=0.0)
