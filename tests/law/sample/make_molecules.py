#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes tests/law/sample/molecules: what laws of samples take besides data/molecules.

Conformers of RDKit (distance geometry with a fixed seed, then the MMFF94 force field). The version
that made a file stands in it.

    python tests/law/sample/make_molecules.py [FOLDER]
"""

import sys
from pathlib import Path

import rdkit
from rdkit import Chem
from rdkit.Chem import AllChem

SEED = 20240607
IN_WATER = (("[NX3;H2,H1;+0;$(NCC=O)!$(NC=O)]", 1), ("[OX2H1;$(OC=O)]", -1), ("[OX2H1]P", -1))


def embedded(molecule):
    """With hydrogens, at a minimum of MMFF94."""
    molecule = Chem.AddHs(molecule, addResidueInfo=True)
    assert AllChem.EmbedMolecule(molecule, randomSeed=SEED) == 0
    assert AllChem.MMFFOptimizeMolecule(molecule, maxIters=20000) == 0
    return molecule


def charged_as_in_water(molecule):
    """Ends of chains, acids and phosphates."""
    for pattern, charge in IN_WATER:
        for match in molecule.GetSubstructMatches(Chem.MolFromSmarts(pattern)):
            atom = molecule.GetAtomWithIdx(match[0])
            atom.SetFormalCharge(charge)
            atom.SetNoImplicit(False)
            atom.UpdatePropertyCache()
    return molecule


def polymer(sequence: str, flavour: int = 0, disulphide: bool = False) -> str:
    """A PDB file with the names of the Protein Data Bank."""
    molecule = Chem.RWMol(Chem.MolFromSequence(sequence, flavor=flavour))
    if disulphide:
        one, other = (a.GetIdx() for a in molecule.GetAtoms() if a.GetSymbol() == "S")
        molecule.AddBond(one, other, Chem.BondType.SINGLE)
    molecule = charged_as_in_water(molecule.GetMol())
    Chem.SanitizeMol(molecule)
    molecule = embedded(molecule)
    title = f"TITLE     {sequence} BY RDKIT {rdkit.__version__}\n"
    lines = Chem.MolToPDBBlock(molecule, flavor=2 | 4 | 8).splitlines()
    atoms = sorted((line for line in lines if line[:6] in ("ATOM  ", "HETATM")), key=place)
    atoms = [f"ATOM  {k:5}{line[11:]}" for k, line in enumerate(atoms, 1)]
    return title + "\n".join([*atoms, "TER", "END"]) + "\n"


def place(line: str) -> tuple[int, bool]:
    """Hydrogens of a residue come after its heavy atoms."""
    return int(line[22:26]), line[76:78].strip() == "H"


def small(smiles: str) -> str:
    """An SDF file."""
    molecule = embedded(Chem.MolFromSmiles(smiles))
    lines = Chem.MolToMolBlock(molecule).splitlines()
    lines[:2] = [smiles, f"  RDKit {rdkit.__version__}"]
    return "\n".join([*lines, "$$$$"]) + "\n"


MOLECULES = {
    "pentenol.sdf": lambda: small("C[C@@H](O)/C=C/C"),
    "biphenyl.sdf": lambda: small("c1ccccc1-c1ccccc1"),
    "proline.pdb": lambda: polymer("APG"),
    "disulphide.pdb": lambda: polymer("CGGC", disulphide=True),
    "dinucleotide.pdb": lambda: polymer("AU", flavour=2),
    "zwitterion.pdb": lambda: polymer("SE"),
}


def main(folder: Path) -> None:
    """Writes all files."""
    for name, text in MOLECULES.items():
        (folder / name).write_text(text())


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "molecules")
