# SPDX-License-Identifier: MIT
"""Small libraries of molecules, made by RDKit."""

from __future__ import annotations

from functools import cache

from rdkit import Chem
from rdkit.Chem import AllChem

#: small ones, so that a test takes no time; two have handedness, one a double bond
SMILES = (
    "CCCO",
    "C[C@H](F)CO",
    "C/C=C/CO",
    "CC(=O)OCC",
    "CCN(C)C=O",
    "OCC1CC1",
    "C[C@@H](N)C(=O)O",
    "CCc1ccccc1",
)


def embedded(smiles, seed=7):
    """RDKit's molecule with hydrogens and one conformer."""
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    assert AllChem.EmbedMolecule(made, randomSeed=seed) == 0
    AllChem.MMFFOptimizeMolecule(made)
    return made


def record(made, name, **tags):
    """The text of an SDF record."""
    made.SetProp("_Name", name)
    items = "".join(f"> <{key}>\n{value}\n\n" for key, value in tags.items())
    return Chem.MolToMolBlock(made) + items + "$$$$\n"


@cache
def library(count):
    """The text of a library, with names and two data items."""
    made = [embedded(smiles) for smiles in SMILES]
    return "".join(
        record(made[k % len(made)], f"molecule {k + 1}", pIC50=f"{k}.5", note="two\nlines")
        for k in range(count)
    )


def molecules(path):
    """All records of an SDF, as RDKit reads them."""
    return list(Chem.SDMolSupplier(str(path), removeHs=False))
